; Claim acceleration-recovery, one joint: command = Kp e brought into the box, e the error, positive.
(set-logic QF_NRA)
(declare-const T Real)        ; sampling period, s
(declare-const Kp Real)       ; gain, 1/s
(declare-const lower Real)    ; speed limits, rad/s
(declare-const upper Real)
(declare-const D Real)        ; deceleration limit, rad/s^2
(declare-const a_upper Real)  ; acceleration limit, rad/s^2
(declare-const p Real)        ; previous command, rad/s
(declare-const e_before Real) ; error before the previous command, rad
(define-fun least ((x Real) (y Real)) Real (ite (<= x y) x y))
(define-fun most ((x Real) (y Real)) Real (ite (>= x y) x y))
(define-fun e () Real (- e_before (* T p)))
(define-fun low () Real (most lower (- p (* T D))))
(define-fun high () Real (least upper (+ p (* T a_upper))))
(define-fun command () Real (least (most (* Kp e) low) high))
(assert (and (> T 0.0) (> Kp 0.0) (<= (* Kp T) 1.0)))
(assert (and (< lower 0.0) (< 0.0 upper) (> D 0.0) (> a_upper 0.0)))
(assert (<= (* Kp upper) D))
(assert (and (<= 0.0 p) (<= p upper) (<= p (* Kp e_before))))
(assert (not (and (<= 0.0 e) (<= 0.0 command) (<= command (* Kp e)))))
(check-sat)
