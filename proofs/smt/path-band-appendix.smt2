; Claim path-band-appendix, inductive step: a push takes effect over three samples, 1/4, 1/2 and 1/4 of it.
(declare-const phi Real)
(declare-const D Real)
(declare-const Dmax Real)
(declare-const G Real)
(declare-const r Int) ; samples since phi was last negative: 0, 1, 2, or 3 for three and more
(declare-const s1 Real) ; switch one sample ago, 0 or 1
(declare-const s2 Real) ; switch two samples ago
(define-fun pos ((x Real)) Real (ite (>= x 0.0) x 0.0))
(define-fun bound ((k Int)) Real
  (ite (= k 0) 0.0 (ite (= k 1) Dmax (ite (= k 2) (+ Dmax (pos (- Dmax (/ G 4.0))))
    (+ Dmax (pos (- Dmax (/ G 4.0))) (pos (- Dmax (/ (* 3.0 G) 4.0))))))))
(define-fun s0 () Real (ite (>= r 1) 1.0 0.0))
(define-fun next () Real (+ phi (- D (* G (+ (/ s0 4.0) (/ s1 2.0) (/ s2 4.0))))))
(define-fun r_next () Int (ite (< next 0.0) 0 (ite (>= r 3) 3 (+ r 1))))
(assert (and (<= D Dmax) (<= 0.0 Dmax)))
(assert (and (<= 0 r) (<= r 3)))
(assert (or (= s1 0.0) (= s1 1.0)))
(assert (or (= s2 0.0) (= s2 1.0)))
; A sample with phi >= 0 had its switch on.
(assert (=> (>= r 2) (= s1 1.0)))
(assert (=> (>= r 3) (= s2 1.0)))
(assert (=> (= r 0) (< phi 0.0)))
(assert (=> (>= r 1) (and (>= phi 0.0) (<= phi (bound r)))))
(assert (<= 0.0 G))
(assert (<= Dmax G))
(assert (not (=> (>= r_next 1) (<= next (bound r_next)))))
(check-sat)
