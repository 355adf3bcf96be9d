; Claim time-bracket, the approach: while u = 1, 1 - f shrinks by 1 - a a sample, so a power p >= (1 - a)^k (1 - f0) bounds it, and
; m >= r as soon as p <= 1 - r / g_min.
(set-logic QF_NRA)
(declare-const a Real)
(declare-const f Real)
(declare-const p Real)
(declare-const g Real)
(declare-const g_min Real)
(declare-const r Real)
(assert (and (< 0.0 a) (< a 1.0) (<= 1.0 g_min) (<= g_min g) (< 0.0 r) (<= r 1.0)))
(assert (<= (- 1.0 f) p))
(assert (not (and (<= (- 1.0 (+ f (* a (- 1.0 f)))) (* (- 1.0 a) p)) (=> (<= (* p g_min) (- g_min r)) (<= r (* g f))))))
(check-sat)
