; Claim look-ahead-tail, one joint. v is linear in x with slope dv; w and w2 are the rates of consecutive samples of constant
; path acceleration s; the unit of time is the sampling period, T = 1.
(set-logic QF_NRA)
(declare-const lambda Real)
(declare-const v Real)
(declare-const dv Real)
(declare-const w Real)
(declare-const w2 Real)
(declare-const a_lower Real)
(declare-const a_upper Real)
(declare-const c Real)
(define-fun s () Real (- w2 w))
(define-fun x () Real (+ lambda (/ w 2.0)))
(define-fun x2 () Real (+ lambda w (/ w2 2.0)))
(define-fun v2 () Real (+ v (* dv (- x2 x))))
(define-fun near () Real (+ (* v s) (* dv w w)))
(define-fun far () Real (+ (* v2 s) (* dv w2 w2)))
(assert (and (<= 0.0 w) (<= 0.0 w2)))
(assert (and (< a_lower 0.0) (< 0.0 a_upper) (<= 0.0 c) (<= c 1.0)))
(assert (and (<= a_lower near) (<= near a_upper) (<= a_lower far) (<= far a_upper)))
(assert (not (and
  ; the squared rates lie on one line over x, of slope 2 s
  (= (- (* w2 w2) (* w w)) (* 2.0 s (- x2 x)))
  ; the joint speed changes by no more than the limits allow in one sample
  (<= a_lower (- (* v2 w2) (* v w))) (<= (- (* v2 w2) (* v w)) a_upper)
  ; a profile scaled towards rest keeps the rows
  (<= a_lower (* c near)) (<= (* c near) a_upper))))
(check-sat)
