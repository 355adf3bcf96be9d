; A convex combination of two numbers that are at most m is at most m: no counterexample.
(declare-const e Real) (declare-const sigma Real) (declare-const mean Real) (declare-const m Real)
(assert (and (> e 0.0) (< e 1.0)))
(assert (<= sigma m))
(assert (<= mean m))
(assert (> (+ (* e sigma) (* (- 1.0 e) mean)) m))
(check-sat)
