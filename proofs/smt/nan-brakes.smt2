; Claim nan-brakes, bit by bit in IEEE 754 double precision.
; 1. A speed that is not finite is not inside finite limits, so u = 0.
; 2. u = 0 does not raise the factor (the product is represented as in factor-range-float64).
; 3. A factor set through max(0) and min(1) lies in [0, 1] whatever came in.
(set-logic QF_FP)
(declare-const lower (_ FloatingPoint 11 53))
(declare-const upper (_ FloatingPoint 11 53))
(declare-const speed (_ FloatingPoint 11 53))
(declare-const f (_ FloatingPoint 11 53))
(declare-const p (_ FloatingPoint 11 53)) ; rounded a (0 - f)
(declare-const x (_ FloatingPoint 11 53)) ; anything
(define-fun zero () (_ FloatingPoint 11 53) ((_ to_fp 11 53) RNE 0.0))
(define-fun one () (_ FloatingPoint 11 53) ((_ to_fp 11 53) RNE 1.0))
(define-fun inside () Bool (and (fp.leq lower speed) (fp.leq speed upper)))
(define-fun set () (_ FloatingPoint 11 53) (fp.min (fp.max x zero) one))
(assert (and (fp.lt lower zero) (not (fp.isInfinite lower))))
(assert (and (fp.lt zero upper) (not (fp.isInfinite upper))))
(assert (or (fp.isNaN speed) (fp.isInfinite speed)))
(assert (and (fp.leq zero f) (fp.leq f one)))
(assert (and (fp.leq (fp.sub RNE zero f) p) (fp.leq p zero)))
(assert (not (and (not inside) (fp.leq (fp.add RNE f p) f) (fp.leq zero set) (fp.leq set one))))
(check-sat)
