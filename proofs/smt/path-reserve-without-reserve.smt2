; Twin of path-reserve: nothing is added to the push, and a drift greater than the push leaves the band.
(set-option :pp.decimal true)
(set-option :pp.decimal_precision 20)
(set-logic QF_NRA)
(declare-const over Real) ; phi plus margin above its band at the last sample
(declare-const band Real) ; this band, which may differ from the last one
(declare-const free Real) ; phi plus margin now, before the reserve: whatever push, walk and drift made of it
(declare-const fall Real) ; what the recovery takes off in one sample
(define-fun pos ((x Real)) Real (ite (>= x 0.0) x 0.0))
(define-fun limit () Real (+ band (pos (- over fall))))
(assert (and (<= 0.0 band) (< 0.0 fall)))
(declare-const phi Real)
(declare-const D Real)
(assert (= free (+ phi D (ite (>= phi 0.0) (- band) 0.0))))
(assert (= over (- phi band)))
(define-fun next () Real free)
(assert (<= over 0.0))
(assert (and (<= 0.1 band) (<= band 1.0) (<= (- 1.0) phi) (<= 0.0 D) (<= D 2.0)))
(assert (>= next (+ band 0.05)))
(check-sat)
(get-value (phi D band))
