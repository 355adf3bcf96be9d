; Claim time-with-feedback, inductive step of z >= 1 - y: the factor's own recursion, both switches, and the implicit form.
(set-logic QF_NRA)
(declare-const a Real)        ; filter step, 1
(declare-const f Real)        ; factor, 1
(declare-const f_next Real)   ; factor at the next sample, 1
(declare-const b Real)        ; feedforward's use of a limit, 1
(declare-const b_next Real)   ; at the next sample, 1
(declare-const ratio Real)    ; b_next / b, 1
(declare-const m Real)        ; the demand's use of a limit, 1
(declare-const m_next Real)   ; at the next sample, 1
(declare-const e Real)        ; the feedback's use of a limit, 1
(declare-const e_next Real)   ; at the next sample, 1
(declare-const y Real)        ; z >= 1 - y, 1
(declare-const implicit Bool)
(define-fun z () Real (* f b))
(define-fun z_next () Real (* f_next b_next))
(define-fun u () Real (ite (<= m 1.0) 1.0 0.0))
(define-fun left () Real (ite (<= y 1.0) (- 1.0 y) 0.0))
(define-fun risen () Real (- 1.0 (+ (* (- 1.0 a) (* left ratio)) (* a b_next))))
(define-fun braked () Real (- 1.0 (* (- 1.0 a) (* (- 1.0 e) ratio))))
(assert (and (< 0.0 a) (<= a 1.0) (<= 0.0 f) (<= 0.0 b) (<= 0.0 b_next) (<= 0.0 ratio) (= b_next (* ratio b))))
(assert (and (<= 0.0 e) (<= 0.0 e_next) (>= z (- 1.0 y)) (<= m (+ z e))))
(assert (=> (not implicit) (= f_next (+ f (* a (- u f))))))
; The implicit factor is the filter's, or the one at which the demand just reaches a limit: then m' = 1 <= z' + E'.
(assert (=> implicit (or (= f_next (+ f (* a (- 1.0 f)))) (and (= m_next 1.0) (<= m_next (+ z_next e_next))))))
(assert (not (or (>= z_next (- 1.0 risen)) (and (not implicit) (>= z_next (- 1.0 braked))) (and implicit (>= z_next (- 1.0 e_next))))))
(check-sat)
