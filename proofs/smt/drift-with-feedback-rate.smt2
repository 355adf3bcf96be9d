; Claim drift-with-feedback, the rates. At the joint that uses most of its limit for the path, in shares of the limit: v the
; feedforward per unit of path rate, slow = 1 / v_least the largest path rate the limits allow, |x| <= E the feedback.
(set-logic QF_NRA)
(declare-const a Real)
(declare-const phi Real)
(declare-const f Real)
(declare-const d Real)     ; target rate, 1/s
(declare-const v Real)     ; joint speed per path rate, in limits, s
(declare-const slow Real)  ; lambda_dot_star_max, 1/s
(declare-const x Real)
(declare-const E Real)
(declare-const m Real)
(define-fun u () Real (ite (<= m 1.0) 1.0 0.0))
(define-fun f_next () Real (+ f (* a (- u f))))
(define-fun rho () Real (* (+ 1.0 E) slow))
(define-fun P () Real (+ (* (- 1.0 a) rho) (* a d)))
(assert (and (< 0.0 a) (<= a 1.0) (<= 0.0 f) (<= f 1.0) (< 0.0 d) (< 0.0 v) (< 0.0 slow) (>= (* v slow) 1.0) (<= 0.0 E)))
(assert (and (<= (- E) x) (<= x E)))
(assert (<= (+ x (* v f d)) m))
(assert (ite (<= m 1.0) (= phi 1.0) (= (* phi m) 1.0)))
(assert (<= (* f d) P))
(assert (not (and (<= (* phi f d) rho) (<= (* f_next d) P))))
(check-sat)
