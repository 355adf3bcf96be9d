; Claim signal-band by length, inductive step. z = f b; the use of a limit is a gauge, so m and z differ by at most E.
; The exponentials enter as reals: rise = exp(sup D+) over released samples, p = exp of the sum of D + ln(1 - a) since the last
; released sample, gain = exp(S) >= p at every sample.
(set-logic QF_NRA)
(declare-const a Real)       ; filter step, 1
(declare-const f Real)       ; factor, 1
(declare-const b Real)       ; feedforward's use of a limit now, 1
(declare-const b_next Real)  ; and at the next sample, 1
(declare-const ratio Real)   ; b_next / b, 1
(declare-const m Real)       ; the demand's use of a limit now, 1
(declare-const m_next Real)  ; and at the next sample, 1
(declare-const e Real)       ; E, the feedback's largest use of a limit, 1
(declare-const g Real)       ; largest b, 1
(declare-const rise Real)    ; exp(sup D+), 1
(declare-const p Real)       ; run of braked samples so far, 1
(declare-const gain Real)    ; exp(S), 1
(define-fun z () Real (* f b))
(define-fun u () Real (ite (<= m 1.0) 1.0 0.0))
(define-fun f_next () Real (+ f (* a (- u f))))
(define-fun z_next () Real (* f_next b_next))
(define-fun p_next () Real (ite (<= m 1.0) 1.0 (* p (* (- 1.0 a) ratio))))
(define-fun top () Real (+ (* (- 1.0 a) (* (+ 1.0 e) rise)) (* a g)))
(assert (and (< 0.0 a) (<= a 1.0)))
(assert (and (<= 0.0 f) (<= f 1.0)))
(assert (and (<= 0.0 b) (<= b g) (<= 0.0 b_next) (<= b_next g)))
(assert (and (<= 0.0 ratio) (= b_next (* ratio b))))
(assert (and (<= 0.0 e) (<= 1.0 rise) (<= 1.0 gain)))
(assert (and (<= 0.0 m) (<= z (+ m e)) (<= m_next (+ z_next e))))
(assert (=> (<= m 1.0) (<= ratio rise)))
(assert (and (<= 0.0 p) (<= p gain) (<= p_next gain)))
(assert (<= z (* top p)))
(assert (not (and (<= z_next (* top p_next)) (<= m_next (+ e (* top gain))))))
(check-sat)
