; Claim path-equivalence in the plane, two constraints: u = -(m1 g1 + m2 g2) with m >= 0 is no longer than any v that the
; same two constraints admit, g_i.v <= g_i.u.
(declare-const m1 Real) ; multipliers
(declare-const m2 Real)
(declare-const gd1 Real) ; g_i.d with d = v - u
(declare-const gd2 Real)
(declare-const dd Real) ; |d|^2
(define-fun ud () Real (- (+ (* m1 gd1) (* m2 gd2)))) ; u.d
(assert (>= dd 0.0))
(assert (and (<= gd1 0.0) (<= gd2 0.0)))
(assert (and (<= 0.0 m1) (<= 0.0 m2)))
; |v|^2 - |u|^2 = 2 u.d + |d|^2
(assert (not (>= (+ (* 2.0 ud) dd) 0.0)))
(check-sat)
