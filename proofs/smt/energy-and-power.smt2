; Claim energy-and-power, two joints: k times b gives k^2 times the kinetic energy and k^3 times the power.
; c_i(v) = ci1 v1^2 + ci2 v1 v2 + ci3 v2^2 are the centrifugal torques, n' = (a1, a2) the derivative of n along the flow.
(set-logic QF_NRA)
(declare-const m11 Real)
(declare-const m12 Real)
(declare-const m22 Real)
(declare-const c11 Real)
(declare-const c12 Real)
(declare-const c13 Real)
(declare-const c21 Real)
(declare-const c22 Real)
(declare-const c23 Real)
(declare-const n1 Real)
(declare-const n2 Real)
(declare-const a1 Real)
(declare-const a2 Real)
(declare-const b Real)
(declare-const k Real)
(define-fun energy ((b Real)) Real
  (* 0.5 (+ (* m11 (* b n1) (* b n1)) (* 2.0 m12 (* b n1) (* b n2)) (* m22 (* b n2) (* b n2)))))
(define-fun centrifugal ((c1 Real) (c2 Real) (c3 Real) (v1 Real) (v2 Real)) Real
  (+ (* c1 v1 v1) (* c2 v1 v2) (* c3 v2 v2)))
(define-fun torque1 ((b Real)) Real
  (+ (* m11 b b a1) (* m12 b b a2) (centrifugal c11 c12 c13 (* b n1) (* b n2))))
(define-fun torque2 ((b Real)) Real
  (+ (* m12 b b a1) (* m22 b b a2) (centrifugal c21 c22 c23 (* b n1) (* b n2))))
(define-fun power ((b Real)) Real (+ (* (torque1 b) b n1) (* (torque2 b) b n2)))
(assert (not (and (= (energy (* k b)) (* k k (energy b)))
                  (= (power (* k b)) (* k k k (power b))))))
(check-sat)
