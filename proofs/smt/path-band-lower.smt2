; Claim path-band, lower end, inductive step: drifts that are not negative.
(set-logic QF_NRA)
(declare-const phi Real)
(declare-const D Real)
(declare-const Dmin Real) ; smallest drift
(declare-const G Real)
(define-fun next () Real (+ phi D (ite (>= phi 0.0) (- G) 0.0)))
(define-fun lower () Real (ite (>= G Dmin) (- Dmin G) 0.0))
(assert (<= Dmin D))
(assert (<= 0.0 Dmin))
(assert (< 0.0 G))
(assert (<= lower phi))
(assert (not (<= lower next)))
(check-sat)
