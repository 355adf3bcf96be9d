; Claim queue-continuity, sums: the acceleration r^2 Q'' + w Q' of a set-point, its two products within their intervals, keeps the
; limit if the sums of the intervals' ends do.
(set-logic QF_LRA)
(declare-const p Real) (declare-const p0 Real) (declare-const p1 Real)
(declare-const k Real) (declare-const k0 Real) (declare-const k1 Real)
(declare-const A Real)
(assert (and (<= p0 p) (<= p p1) (<= k0 k) (<= k k1)))
(assert (and (<= (- A) (+ p0 k0)) (<= (+ p1 k1) A)))
(assert (not (and (<= (- A) (+ p k)) (<= (+ p k) A))))
(check-sat)
