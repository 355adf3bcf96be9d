; Claim frozen-band, inductive step: g constant, zero error, m = g f.
(set-logic QF_NRA)
(declare-const a Real) ; filter step, 1
(declare-const g Real) ; overspeed, 1
(declare-const f Real) ; factor, 1
(define-fun m () Real (* g f))
(define-fun u () Real (ite (<= m 1.0) 1.0 0.0))
(define-fun f_next () Real (+ f (* a (- u f))))
(define-fun band () Real (+ 1.0 (* a (- g 1.0))))
(assert (and (< 0.0 a) (<= a 1.0)))
(assert (>= g 1.0))
(assert (and (<= 0.0 f) (<= f 1.0)))
(assert (<= m band))
(assert (not (<= (* g f_next) band)))
(check-sat)
