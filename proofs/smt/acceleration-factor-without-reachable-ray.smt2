; Twin of acceleration-factor: a joint that moves at p while the path goes on without it, A = B = 0; T = 1/1024 s, 2 rad/s^2.
(set-option :pp.decimal true)
(set-option :pp.decimal_precision 20)
(set-logic QF_NRA)
(declare-const p Real) ; rad/s
(declare-const f Real) ; any factor
(define-fun demand () Real (+ 0.0 (* f 0.0)))
(assert (and (<= (- 1.0) p) (<= p 1.0) (<= 0.0 f) (<= f 1.0)))
(assert (or (< demand (- p (/ 4.0 1024.0))) (> demand (+ p (/ 4.0 1024.0)))))
(check-sat)
(get-value (p f))
