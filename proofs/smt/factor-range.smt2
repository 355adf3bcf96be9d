; Claim factor-range, over the reals: one step of f <- f + a (u - f) keeps f in [0, 1].
(set-logic QF_NRA)
(declare-const a Real) ; filter step, 1
(declare-const f Real) ; factor before, 1
(declare-const u Real) ; input of the filter, 1
(define-fun f_next () Real (+ f (* a (- u f))))
(assert (and (< 0.0 a) (<= a 1.0)))
(assert (and (<= 0.0 f) (<= f 1.0)))
(assert (and (<= 0.0 u) (<= u 1.0)))
(assert (not (and (<= 0.0 f_next) (<= f_next 1.0))))
(check-sat)
