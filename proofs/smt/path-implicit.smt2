; One linear constraint in three dimensions: after the push, phi is min(phi, 0): no counterexample.
(declare-const phi Real) (declare-const rr Real) (declare-const lambda Real) (declare-const next Real)
; rr = g.g, u = -lambda g, g.u = -lambda rr
(assert (> rr 0.0))
(assert (>= lambda 0.0))
(assert (= (* lambda rr) (ite (> phi 0.0) phi 0.0)))
(assert (= next (- phi (* lambda rr))))
(assert (> next 0.0))
(check-sat)
