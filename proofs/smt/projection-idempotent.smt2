; Claim projection: the nearest point p of a set to one of its own points z is z itself, for z is at distance 0.
(set-logic QF_NRA)
(declare-const z0 Real) (declare-const z1 Real)
(declare-const p0 Real) (declare-const p1 Real)
(define-fun distance () Real (+ (* (- z0 p0) (- z0 p0)) (* (- z1 p1) (- z1 p1))))
(assert (<= distance 0.0))                   ; no farther than z
(assert (not (and (= p0 z0) (= p1 z1))))
(check-sat)
