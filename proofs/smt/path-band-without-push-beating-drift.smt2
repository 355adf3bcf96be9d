; Twin: without Dmax <= G the push does not win, and phi leaves the band.
(declare-const phi Real) (declare-const next Real)
(declare-const D Real) (declare-const Dmax Real) (declare-const G Real)
(assert (<= D Dmax)) (assert (>= Dmax 0.0))
(assert (<= phi Dmax))
(assert (= next (+ phi D (ite (>= phi 0.0) (- G) 0.0))))
(assert (> next Dmax))
(check-sat)
