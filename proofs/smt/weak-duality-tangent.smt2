; Claim weak-duality, convexity of the travel time of one interval (2 h / (p + q), p and q the square roots of the unknowns): it lies
; above its tangent at (s, 1 - s). Units in which the tangent point's roots add up to 1.
(set-logic QF_NRA)
(declare-const p Real)
(declare-const q Real)
(declare-const s Real)
(assert (and (< 0.0 s) (< s 1.0) (<= 0.0 p) (<= 0.0 q) (< 0.0 (+ p q))))
; 2 / (p + q) >= 2 - (p^2 - s^2) / s - (q^2 - t^2) / t with t = 1 - s, that is 2 / (p + q) + p^2 / s + q^2 / t >= 3; times (p + q) s t
(define-fun t () Real (- 1.0 s))
(assert (not (>= (+ (* 2.0 s t) (* (+ p q) (+ (* p p t) (* q q s)))) (* 3.0 (+ p q) s t))))
(check-sat)
