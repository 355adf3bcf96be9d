; Claim switching: along a run with u = 1 the factor is 1 - (1 - f0) p, p = (1 - a)^k (induction over k), so the
; first u = 0 falls exactly where g (1 - (1 - f0) p) > 1; and with g <= 1 it never falls.
(set-logic QF_NRA)
(declare-const a Real)  ; filter step, 1
(declare-const g Real)  ; overspeed at this sample, 1
(declare-const f0 Real) ; factor at the first sample, 1
(declare-const p Real)  ; (1 - a)^k, 1
(declare-const f Real)  ; factor at sample k, 1
(define-fun released () Bool (<= (* g f) 1.0))
(define-fun f_next () Real (+ f (* a (- 1.0 f))))
(assert (and (< 0.0 a) (<= a 1.0)))
(assert (< 0.0 g))
(assert (and (<= 0.0 f0) (<= f0 1.0)))
(assert (and (<= 0.0 p) (<= p 1.0)))
(assert (= f (- 1.0 (* (- 1.0 f0) p))))
(assert (not (and
  (= f_next (- 1.0 (* (- 1.0 f0) (* (- 1.0 a) p))))
  (= (not released) (> (* g (- 1.0 (* (- 1.0 f0) p))) 1.0))
  (=> (<= g 1.0) released))))
(check-sat)
