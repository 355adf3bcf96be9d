; Claim signal-band by vector, inductive step for one joint and one of its limits, w > 0; n <= w is its smaller one.
; The change c is split: part of the feedback, part of the feedforward.
(set-logic QF_NRA)
(declare-const a Real)           ; filter step, 1
(declare-const f Real)           ; factor, 1
(declare-const u Real)           ; switch, 1
(declare-const fb Real)          ; A now, rad/s
(declare-const fb_next Real)     ; A at the next sample, rad/s
(declare-const ff Real)          ; B now, rad/s
(declare-const ff_next Real)     ; B at the next sample, rad/s
(declare-const w Real)           ; the limit, rad/s
(declare-const n Real)           ; the joint's smaller limit, rad/s
(declare-const m Real)           ; use of a limit now, 1
(declare-const g Real)           ; largest use of a smaller limit by B, 1
(declare-const c_fb Real)        ; |A' - (1 - a) A| in smaller limits, 1
(declare-const c_ff Real)        ; f |B' - B| in smaller limits, 1
(declare-const c_released Real)  ; sup c over released samples, 1
(declare-const c_braked Real)    ; sup c over braked samples, 1
(declare-const band Real)        ; M, 1
(define-fun x () Real (+ fb (* f ff)))
(define-fun f_next () Real (+ f (* a (- u f))))
(define-fun x_next () Real (+ fb_next (* f_next ff_next)))
(define-fun c () Real (+ c_fb (* (- 1.0 a) c_ff)))
(assert (and (< 0.0 a) (<= a 1.0) (<= 0.0 f) (<= f 1.0)))
(assert (or (= u 1.0) (= u 0.0)))
(assert (and (< 0.0 n) (<= n w) (<= 0.0 g) (<= 0.0 c_fb) (<= 0.0 c_ff)))
(assert (<= x (* m w)))
(assert (<= (- fb_next (* (- 1.0 a) fb)) (* c_fb n)))
(assert (<= (* f (- ff_next ff)) (* c_ff n)))
(assert (<= ff_next (* g n)))
(assert (=> (= u 1.0) (and (<= m 1.0) (<= c c_released))))
(assert (=> (= u 0.0) (and (<= m band) (<= c c_braked))))
(assert (and (<= 1.0 band) (<= (+ (- 1.0 a) (+ c_released (* a g))) band) (<= c_braked (* a band))))
(assert (not (<= x_next (* band w))))
(check-sat)
