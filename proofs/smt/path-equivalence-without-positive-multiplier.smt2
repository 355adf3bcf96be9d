; Twin: a negative multiplier, and a shorter admissible control exists.
(declare-const a1 Real) (declare-const b1 Real) (declare-const a2 Real) (declare-const b2 Real)
(declare-const m1 Real) (declare-const m2 Real) (declare-const v1 Real) (declare-const v2 Real)
(define-fun u1 () Real (- (+ (* m1 a1) (* m2 a2))))
(define-fun u2 () Real (- (+ (* m1 b1) (* m2 b2))))
; d = v - u, and the inner product u.d written through the multipliers.
(define-fun d1 () Real (- v1 u1))
(define-fun d2 () Real (- v2 u2))
(declare-const gd1 Real) (declare-const gd2 Real) (declare-const ud Real) (declare-const dd Real)
(assert (= gd1 (+ (* a1 d1) (* b1 d2))))
(assert (= gd2 (+ (* a2 d1) (* b2 d2))))
(assert (= ud (- (+ (* m1 gd1) (* m2 gd2)))))
(assert (>= dd 0.0))
(assert (<= gd1 0.0)) (assert (<= gd2 0.0))
(assert (>= m1 0.0))
; |v|^2 - |u|^2 = 2 u.d + |d|^2, with |d|^2 = dd
(assert (< (+ (* 2.0 ud) dd) 0.0))
(check-sat)
