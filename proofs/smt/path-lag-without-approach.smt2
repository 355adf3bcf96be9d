; Twin of path-lag: K > 0, that is e < 1, is dropped.
(set-option :pp.decimal true)
(set-option :pp.decimal_precision 20)
(set-logic QF_NRA)
(declare-const e Real) ; exp(-T / K)
(declare-const sigma Real)
(declare-const mean Real) ; of phi over the interval, weighted by the lag
(declare-const m Real) ; largest phi so far, or sigma at the start
(define-fun next () Real (+ (* e sigma) (* (- 1.0 e) mean)))
(assert (and (<= sigma m) (<= mean m)))
(assert (and (<= 1.01 e) (<= e 2.0)))
(assert (and (<= (- 1.0) sigma) (<= (- 1.0) mean) (<= m 1.0)))
(assert (>= next (+ m 0.05)))
(check-sat)
(get-value (e sigma mean m))
