; Claim acceleration-box, one joint: the command is the demand brought into the box.
(set-logic QF_NRA)
(declare-const T Real)       ; sampling period, s
(declare-const lower Real)   ; speed limits, rad/s
(declare-const upper Real)
(declare-const a_lower Real) ; acceleration limits, rad/s^2
(declare-const a_upper Real)
(declare-const p Real)       ; previous command, rad/s
(declare-const demand Real)  ; anything, rad/s
(define-fun least ((x Real) (y Real)) Real (ite (<= x y) x y))
(define-fun most ((x Real) (y Real)) Real (ite (>= x y) x y))
(define-fun low () Real (least (most (+ p (* T a_lower)) lower) upper))
(define-fun high () Real (least (most (+ p (* T a_upper)) lower) upper))
(define-fun command () Real (least (most demand low) high))
(assert (> T 0.0))
(assert (and (< lower 0.0) (< 0.0 upper) (< a_lower 0.0) (< 0.0 a_upper)))
(assert (and (<= lower p) (<= p upper)))
(assert (not (and
  (<= low p) (<= p high)
  (<= lower command) (<= command upper)
  (<= (* T a_lower) (- command p)) (<= (- command p) (* T a_upper)))))
(check-sat)
