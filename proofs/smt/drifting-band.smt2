; Claim drifting-band, inductive step: zero error, m = g f.
; With d = L Ts lambda_dot_max, one sample changes ln g by at most d m. The exponentials enter as reals:
;   e_release >= exp(d m) wherever m <= 1, that is e_release = exp(d);
;   e_brake   >= exp(d m) wherever m <= M, that is e_brake = exp(d M); reaching condition: (1 - a) e_brake <= 1.
(set-logic QF_NRA)
(declare-const a Real)         ; filter step, 1
(declare-const f Real)         ; factor, 1
(declare-const g Real)         ; overspeed now, 1
(declare-const g_next Real)    ; overspeed at the next sample, 1
(declare-const g_max Real)     ; largest overspeed of the path, 1
(declare-const ratio Real)     ; g_next / g, 1
(declare-const e_release Real) ; exp(d), 1
(declare-const e_brake Real)   ; exp(d M), 1
(define-fun m () Real (* g f))
(define-fun u () Real (ite (<= m 1.0) 1.0 0.0))
(define-fun f_next () Real (+ f (* a (- u f))))
(define-fun band () Real (+ (* (- 1.0 a) e_release) (* a g_max)))
(assert (and (< 0.0 a) (<= a 1.0)))
(assert (and (<= 0.0 f) (<= f 1.0)))
(assert (and (< 0.0 g) (<= g g_max) (< 0.0 g_next) (<= g_next g_max)))
(assert (and (< 0.0 ratio) (= g_next (* ratio g))))
(assert (>= e_release 1.0))
(assert (=> (<= m 1.0) (<= ratio e_release)))
(assert (=> (<= m band) (<= ratio e_brake)))
(assert (<= (* (- 1.0 a) e_brake) 1.0))
(assert (>= band 1.0))
(assert (<= m band))
(assert (not (<= (* g_next f_next) band)))
(check-sat)
