; Claim never-slower, two joints: v_i = |q'_i| joint speed per unit of path rate, l_i limits, d target rate, f settled factor.
(set-logic QF_NRA)
(declare-const v1 Real)
(declare-const v2 Real)
(declare-const l1 Real)
(declare-const l2 Real)
(declare-const d Real)
(declare-const f Real)
(declare-const s Real) ; path rate of natural motion
(assert (and (<= 0.0 v1) (<= 0.0 v2) (< 0.0 l1) (< 0.0 l2) (< 0.0 d)))
(assert (and (<= 0.0 f) (<= f 1.0) (<= (* f d v1) l1) (<= (* f d v2) l2)))
; Settled: nothing but a limit or the target holds the factor down.
(assert (or (= f 1.0) (= (* f d v1) l1) (= (* f d v2) l2)))
(assert (and (<= 0.0 s) (<= s d) (<= (* s v1) l1) (<= (* s v2) l2)))
(assert (not (<= s (* f d))))
(check-sat)
