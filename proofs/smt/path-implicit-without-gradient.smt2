; Twin: with an empty row nothing moves, and no lambda does what is asked; taking any leaves phi positive.
(declare-const phi Real) (declare-const rr Real) (declare-const lambda Real) (declare-const next Real)
(assert (>= rr 0.0))
(assert (>= lambda 0.0))
(assert (= next (- phi (* lambda rr))))
(assert (> next 0.0))
(check-sat)
