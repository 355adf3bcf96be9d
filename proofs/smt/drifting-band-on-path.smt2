; Claim drifting-band with a weaker reaching condition, inductive step. The path rate is f times the target rate, so one
; sample changes ln g by at most r f, r = L Ts lambda_dot_d. The exponentials enter as reals:
;   e_release >= exp(r f) wherever f <= 1 / g_min, that is e_release = exp(r / g_min) = exp(d);
;   e_brake   >= exp(r f) wherever f <= f_max, that is e_brake = exp(r f_max); reaching condition: (1 - a) e_brake <= 1.
(set-logic QF_NRA)
(declare-const a Real)         ; filter step, 1
(declare-const f Real)         ; factor, 1
(declare-const g Real)         ; overspeed now, 1
(declare-const g_next Real)    ; overspeed at the next sample, 1
(declare-const slowest Real)   ; 1 / g_min, 1
(declare-const g_max Real)     ; largest overspeed of the path, 1
(declare-const ratio Real)     ; g_next / g, 1
(declare-const e_release Real) ; exp(r / g_min), 1
(declare-const e_brake Real)   ; exp(r f_max), 1
(define-fun m () Real (* g f))
(define-fun u () Real (ite (<= m 1.0) 1.0 0.0))
(define-fun f_next () Real (+ f (* a (- u f))))
(define-fun f_max () Real (+ slowest (* a (- 1.0 slowest))))
(define-fun band () Real (+ (* (- 1.0 a) e_release) (* a g_max)))
(assert (and (< 0.0 a) (<= a 1.0)))
(assert (and (<= 0.0 f) (<= f f_max)))
(assert (and (< 0.0 slowest) (<= slowest 1.0)))
(assert (and (>= (* g slowest) 1.0) (<= g g_max) (>= (* g_next slowest) 1.0) (<= g_next g_max)))
(assert (and (< 0.0 ratio) (= g_next (* ratio g))))
(assert (>= e_release 1.0))
(assert (=> (<= f slowest) (<= ratio e_release)))
(assert (<= ratio e_brake))
(assert (<= (* (- 1.0 a) e_brake) 1.0))
(assert (<= m band))
(assert (not (and (<= f_next f_max) (<= (* g_next f_next) band))))
(check-sat)
