; Twin of projection: the outside of the unit circle. The nearest points to x = (s, 0) and y = (-s, 0) are 2 apart.
(set-option :pp.decimal true)
(set-option :pp.decimal_precision 20)
(set-logic QF_NRA)
(declare-const s Real)
(declare-const p Real)
(declare-const q Real)
(assert (and (<= 0.1 s) (<= s 2.0)))
(assert (and (= (* p p) 1.0) (= (* q q) 1.0)))
; nearest of the two points of the circle on the line
(assert (and (<= (* (- p s) (- p s)) (* (+ p s) (+ p s))) (<= (* (+ q s) (+ q s)) (* (- q s) (- q s)))))
(assert (>= (* (- p q) (- p q)) (+ 0.5 (* 4.0 s s))))
(check-sat)
(get-value (s))
