; Claim path-band, upper end, inductive step: one sample of sliding under zero-order hold.
(set-logic QF_NRA)
(declare-const phi Real) ; now, units of sigma
(declare-const D Real) ; drift of this sample
(declare-const Dmax Real) ; largest drift
(declare-const G Real) ; full push of a sample
(define-fun next () Real (+ phi D (ite (>= phi 0.0) (- G) 0.0)))
(assert (and (<= D Dmax) (<= 0.0 Dmax)))
(assert (<= Dmax G))
(assert (<= phi Dmax))
(assert (not (<= next Dmax)))
(check-sat)
