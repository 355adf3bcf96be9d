; Claim chattering-band: qd = A + f B, one sample apart; the change of f is the filter's.
(set-logic QF_NRA)
(declare-const a Real)      ; filter step, 1
(declare-const u Real)      ; switch, 0 or 1
(declare-const f Real)      ; factor, 1
(declare-const A Real)      ; feedback part, rad/s
(declare-const B Real)      ; feedforward part at full rate, rad/s
(declare-const A_next Real)
(declare-const B_next Real)
(define-fun abs_of ((x Real)) Real (ite (< x 0.0) (- x) x))
(define-fun f_next () Real (+ f (* a (- u f))))
(define-fun change () Real (- (+ A_next (* f_next B_next)) (+ A (* f B))))
(define-fun share () Real (ite (= u 1.0) (- 1.0 f) f))
(define-fun drift () Real (+ (* f (abs_of (- B_next B))) (abs_of (- A_next A))))
(assert (and (< 0.0 a) (<= a 1.0)))
(assert (or (= u 0.0) (= u 1.0)))
(assert (and (<= 0.0 f) (<= f 1.0)))
(assert (not (<= (abs_of change) (+ (* (abs_of B_next) a share) drift))))
(check-sat)
