; Claim drift-with-feedback, the lag. One joint in shares of its limit: x = Kp eta / w, the rest by Taylor's formula.
; With D = Ts phi F the step of the path parameter and c >= |q_d''| / w:  x' = (1 - k phi) x + r,  |r| <= Kp c D^2 / 2.
(set-logic QF_NRA)
(declare-const k Real)     ; Kp Ts, 1
(declare-const phi Real)   ; direction factor, 1
(declare-const F Real)     ; requested rate f lambda_dot_d, 1/s
(declare-const rho Real)   ; largest path rate, 1/s
(declare-const P Real)     ; largest requested rate, 1/s
(declare-const h Real)     ; c Ts / 2, s^2: half the curvature times the sampling period
(declare-const E Real)     ; bound on the lag, 1
(declare-const x Real)     ; lag now, 1
(declare-const r Real)     ; remainder, 1
(define-fun abs_of ((y Real)) Real (ite (< y 0.0) (- y) y))
(assert (and (<= 0.0 k) (<= k 1.0) (< 0.0 phi) (<= phi 1.0) (<= 0.0 h)))
(assert (and (<= 0.0 F) (<= F P) (<= (* phi F) rho)))
(assert (>= E (* h rho P)))
(assert (<= (abs_of x) E))
(assert (<= (abs_of r) (* k phi h phi F F)))
(assert (not (<= (abs_of (+ (* (- 1.0 (* k phi)) x) r)) E)))
(check-sat)
