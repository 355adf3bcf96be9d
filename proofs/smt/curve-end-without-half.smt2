; Twin of curve-end: the rate may be such that the next sample, in motion, is at the end.
(set-option :pp.decimal true)
(set-option :pp.decimal_precision 20)
(set-logic QF_LRA)
(declare-const u Real)
(declare-const w Real)
(declare-const w2 Real)
(assert (and (<= 0.0 u) (<= 0.0 w) (<= (+ u (/ w 2.0)) 0.9)))
(assert (and (<= 0.0 w2) (<= w2 (* 2.0 (- 1.0 (+ u (/ w 2.0)))))))
; with the smallest rate that follows, 0, the place still passes the end
(assert (>= (+ u (/ (+ w w2) 2.0) (/ w2 2.0)) 1.01))
(check-sat)
(get-value (u w w2))
