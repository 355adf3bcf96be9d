; Twin of queue-continuity: the limit is checked at the ends of a span alone. The pace falls from 1 to 0 while the planned
; acceleration rises from 0 to a: at both ends their product is 0.
(set-option :pp.decimal true)
(set-option :pp.decimal_precision 20)
(set-logic QF_NRA)
(declare-const a Real)
(declare-const A Real)
(declare-const t Real)
(assert (and (<= 1.0 A) (<= A 10.0) (<= 1.0 a) (<= a 200.0) (<= 0.1 t) (<= t 0.9)))
(assert (>= (* (- 1.0 t) (- 1.0 t) t a) (* 1.05 A)))
(check-sat)
(get-value (a A t))
