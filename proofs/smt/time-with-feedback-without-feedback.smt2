; Twin of time-with-feedback: the feedback is left out. One joint with limit 1, the path's own overspeed g constant, the form that waits:
; the feedback opposes the feedforward, and the reference goes faster than the limits.
(set-option :pp.decimal true)
(set-option :pp.decimal_precision 20)
(set-logic QF_NRA)
(declare-const f Real)
(declare-const g Real)
(declare-const e Real)
(define-fun m () Real (- (* g f) e))
(assert (and (<= 0.1 f) (<= f 1.0) (<= 1.0 g) (<= g 5.0) (<= 0.1 e) (<= e 0.9)))
(assert (and (<= m 1.0) (>= m 0.0)))
(assert (>= (* g f) 1.1))
(check-sat)
(get-value (f g e))
