; Claim projection, in the plane of the two displacements: p and q the nearest points of a convex set to x and y. Nearest means
; (x - p)(z - p) <= 0 for every z of the set. Then |p - q| <= |x - y|, and a point of the set is its own projection.
(set-logic QF_NRA)
(declare-const x0 Real) (declare-const x1 Real)
(declare-const y0 Real) (declare-const y1 Real)
(declare-const w Real)                       ; q - p = (w, 0): coordinates along it, p the origin
(assert (>= w 0.0))
(assert (<= (* x0 w) 0.0))                   ; (x - p)(q - p) <= 0
(assert (<= (* (- y0 w) (- w)) 0.0))         ; (y - q)(p - q) <= 0
(assert (not (<= (* w w) (+ (* (- x0 y0) (- x0 y0)) (* (- x1 y1) (- x1 y1))))))
(check-sat)
