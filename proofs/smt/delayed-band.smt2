; Claim delayed-band, inductive step: g constant, zero error, u arrives D samples late.
; n counts the samples since the last one with m <= 1; p = (1 - a)^min(n, D + 1), p_end = (1 - a)^(D + 1).
; Invariant: g (1 - f) >= p (g - 1) and p >= p_end. While n <= D the delayed u may be anything (and p has a factor left,
; p (1 - a) >= p_end); from n = D + 1 on it was decided at a sample with m > 1, so it is 0.
(set-logic QF_NRA)
(declare-const a Real)     ; filter step, 1
(declare-const g Real)     ; overspeed, 1
(declare-const f Real)     ; factor, 1
(declare-const u Real)     ; delayed switch, 0 or 1
(declare-const p Real)     ; 1
(declare-const p_end Real) ; 1
(declare-const late Bool)  ; n > D
(define-fun f_next () Real (+ f (* a (- u f))))
(define-fun p_next () Real (ite (<= (* g f_next) 1.0) 1.0 (ite late p (* (- 1.0 a) p))))
(assert (and (< 0.0 a) (<= a 1.0)))
(assert (>= g 1.0))
(assert (and (<= 0.0 f) (<= f 1.0)))
(assert (or (= u 0.0) (= u 1.0)))
(assert (and (<= 0.0 p_end) (<= p_end p) (<= p 1.0)))
(assert (=> late (= u 0.0)))
(assert (=> (not late) (>= (* (- 1.0 a) p) p_end)))
(assert (>= (* g (- 1.0 f)) (* p (- g 1.0))))
(assert (not (and
  (>= (* g (- 1.0 f_next)) (* p_next (- g 1.0)))
  (>= p_next p_end)
  (<= (* g f_next) (+ 1.0 (* (- 1.0 p_end) (- g 1.0)))))))
(check-sat)
