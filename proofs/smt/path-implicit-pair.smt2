; Claim path-implicit, two constraints: one of the four active sets meets the optimality conditions, so that the smallest
; push exists and is one of four closed forms.
(set-logic QF_NRA)
(declare-const a Real) ; g1.g1
(declare-const b Real) ; g1.g2
(declare-const c Real) ; g2.g2
(declare-const p Real) ; phi_1 of the free motion
(declare-const q Real) ; phi_2
(define-fun nobody () Bool (and (<= p 0.0) (<= q 0.0)))
; Multiplier p/a not negative, and the other constraint met: q - b p / a <= 0.
(define-fun first () Bool (and (>= p 0.0) (<= (* a q) (* b p))))
(define-fun second () Bool (and (>= q 0.0) (<= (* c p) (* b q))))
; Multipliers (c p - b q) / det and (a q - b p) / det.
(define-fun both () Bool (and (>= (* c p) (* b q)) (>= (* a q) (* b p)) (> (* a c) (* b b))))
(assert (and (> a 0.0) (> c 0.0)))
(assert (>= (* a c) (* b b)))
(assert (> (* a c) (* b b)))
(assert (not (or nobody first second both)))
(check-sat)
