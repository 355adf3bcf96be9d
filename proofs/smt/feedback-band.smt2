; Claim feedback-band, inductive step for one joint in units of the limit it moves towards: qd = x + f b with b >= 0, upper limit 1,
; lower limit -lower. The joints' largest use of a limit is m, at least this joint's own; phi = min(1, 1/m).
(set-logic QF_NRA)
(declare-const a Real)     ; filter step, 1
(declare-const k Real)     ; gain step Kp Ts, 1
(declare-const g Real)     ; overspeed, 1
(declare-const b Real)     ; this joint's feedforward at full rate, 1
(declare-const x Real)     ; this joint's feedback, 1
(declare-const f Real)     ; factor, 1
(declare-const m Real)     ; largest use of a limit over all joints, 1
(declare-const phi Real)   ; direction factor, 1
(declare-const late Real)  ; 1 in the paper's advance, 0 in the synchronised one
(define-fun u () Real (ite (<= m 1.0) 1.0 0.0))
(define-fun f_next () Real (+ f (* a (- u f))))
(define-fun speed () Real (+ x (* f b)))
; the lag gains what the robot falls behind: (1 - phi) Ts q_d' f, times Kp
(define-fun x_next () Real (+ (* (- 1.0 (* k phi)) x) (* late k (- 1.0 phi) f b)))
(define-fun band () Real (+ 1.0 (- (* a g) k)))
(assert (and (< 0.0 a) (<= a 1.0) (<= 0.0 k) (<= k a)))
(assert (or (= late 0.0) (= late 1.0)))
(assert (and (<= 0.0 b) (<= b g) (>= g 1.0)))
(assert (and (<= 0.0 f) (<= f 1.0)))
(assert (>= x 0.0))                                    ; the robot trails
(assert (and (<= speed m) (<= m band)))
(assert (ite (<= m 1.0) (= phi 1.0) (= (* phi m) 1.0)))
(assert (not (and (>= x_next 0.0) (<= (+ x_next (* f_next b)) band))))
(check-sat)
