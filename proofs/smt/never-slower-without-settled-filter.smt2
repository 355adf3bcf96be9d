; Twin of never-slower: the filter is still rising, f = a after the first sample from rest. One joint.
(set-option :pp.decimal true)
(set-option :pp.decimal_precision 20)
(set-logic QF_NRA)
(declare-const v Real)
(declare-const d Real)
(declare-const a Real)
(declare-const s Real) ; path rate of natural motion, limit 1
(assert (and (<= 0.25 v) (<= v 1.0) (<= 1.0 d) (<= d 4.0) (<= 0.0625 a) (<= a 0.5)))
(assert (<= (* a d v) 1.0))
(assert (and (<= 0.0 s) (<= s d) (<= (* s v) 1.0)))
(assert (>= s (+ (* a d) 0.1)))
(check-sat)
(get-value (v d a s))
