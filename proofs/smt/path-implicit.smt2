; Claim path-implicit, one constraint: after the push u = -lambda g, phi is at most zero. rr = g.g.
(set-logic QF_NRA)
(declare-const phi Real) ; of the free motion
(declare-const rr Real)
(declare-const lambda Real)
(define-fun next () Real (- phi (* lambda rr)))
(assert (> rr 0.0))
(assert (= (* lambda rr) (ite (> phi 0.0) phi 0.0)))
(assert (not (<= next 0.0)))
(check-sat)
