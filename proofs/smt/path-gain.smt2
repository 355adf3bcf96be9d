; Claim path-gain, three constraints: dV/dt = sum phi_i (mu_i - u s_i) < 0 while a phi_i is positive.
(set-logic QF_NRA)
(declare-const p1 Real) ; phi_i
(declare-const p2 Real)
(declare-const p3 Real)
(declare-const m1 Real) ; mu_i
(declare-const m2 Real)
(declare-const m3 Real)
(declare-const u Real) ; gain
(define-fun s ((p Real)) Real (ite (>= p 0.0) 1.0 0.0))
(define-fun term ((p Real) (m Real)) Real (* p (- m (* u (s p)))))
(define-fun falls () Bool (< (+ (term p1 m1) (term p2 m2) (term p3 m3)) 0.0))
(assert (and (<= 0.0 m1) (<= 0.0 m2) (<= 0.0 m3)))
(assert (or (> p1 0.0) (> p2 0.0) (> p3 0.0)))
(assert (and (> u m1) (> u m2) (> u m3)))
(assert (not falls))
(check-sat)
