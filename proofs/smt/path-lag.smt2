; Claim path-lag, inductive step: a convex combination of two numbers that are at most m.
(set-logic QF_NRA)
(declare-const e Real) ; exp(-T / K)
(declare-const sigma Real)
(declare-const mean Real) ; of phi over the interval, weighted by the lag
(declare-const m Real) ; largest phi so far, or sigma at the start
(define-fun next () Real (+ (* e sigma) (* (- 1.0 e) mean)))
(assert (and (<= sigma m) (<= mean m)))
(assert (and (< 0.0 e) (< e 1.0)))
(assert (not (<= next m)))
(check-sat)
