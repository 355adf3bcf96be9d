; phi <= Dmax is kept by one sample of zero-order-hold sliding: no counterexample.
(declare-const phi Real) (declare-const next Real)
(declare-const D Real) (declare-const Dmax Real) (declare-const G Real)
(assert (<= D Dmax)) (assert (>= Dmax 0.0)) (assert (<= Dmax G))
(assert (<= phi Dmax))
(assert (= next (+ phi D (ite (>= phi 0.0) (- G) 0.0))))
(assert (> next Dmax))
(check-sat)
