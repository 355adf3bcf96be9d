; Claim implicit-chattering, a falling factor. Joint i has reached its limit w with the new factor; joint j is any other, its limits at
; most kappa times its smaller one, which is 1. X bounds |A' - A| + f |B' - B| and E |A'|, both in smaller limits.
(set-logic QF_NRA)
(declare-const f Real)        ; factor before, 1
(declare-const f_next Real)   ; factor now, 1
(declare-const fb Real)       ; A_i before, rad/s
(declare-const fb_next Real)  ; A_i now, rad/s
(declare-const ff Real)       ; B_i before, rad/s
(declare-const ff_next Real)  ; B_i now, rad/s
(declare-const w Real)        ; the limit that joint i has reached, rad/s
(declare-const n Real)        ; its smaller limit, rad/s
(declare-const other_fb Real) ; A_j now, rad/s
(declare-const other_ff Real) ; B_j now, rad/s
(declare-const kappa Real)    ; largest ratio of a joint's two limits, 1
(declare-const x Real)        ; X, 1
(declare-const e Real)        ; E, 1
(assert (and (< 0.0 f_next) (< f_next f) (<= f 1.0)))
(assert (and (< 0.0 n) (<= n w) (<= 1.0 kappa) (<= 0.0 x) (<= 0.0 e) (< e 1.0)))
(assert (<= (+ fb (* f ff)) w))
(assert (= (+ fb_next (* f_next ff_next)) w))
(assert (<= (+ (- fb_next fb) (* f (- ff_next ff))) (* x n)))
(assert (<= fb_next (* e n)))
(assert (and (<= 0.0 other_ff) (>= other_fb (- e)) (<= (+ other_fb (* f_next other_ff)) kappa)))
(assert (not (<= (* (* other_ff (- f f_next)) (- 1.0 e)) (* x (* kappa (+ 1.0 e))))))
(check-sat)
