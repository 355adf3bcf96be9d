; Twin: with a memory above 1 it is no lag.
(declare-const e Real) (declare-const sigma Real) (declare-const mean Real) (declare-const m Real)
(assert (and (> e 0.0) (< e 2.0)))
(assert (<= sigma m))
(assert (<= mean m))
(assert (> (+ (* e sigma) (* (- 1.0 e) mean)) m))
(check-sat)
