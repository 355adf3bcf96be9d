; Claim factor-range, bit by bit in IEEE 754 double precision, round to nearest even.
; The product a (u - f) is represented by any double p between 0 and the rounded u - f: with 0 < a <= 1 the exact
; product lies there, both ends are doubles, and rounding is monotonic.
(set-logic QF_FP)
(declare-const f (_ FloatingPoint 11 53))      ; factor before
(declare-const p_rise (_ FloatingPoint 11 53)) ; rounded a (1 - f), for u = 1
(declare-const p_fall (_ FloatingPoint 11 53)) ; rounded a (0 - f), for u = 0
(define-fun zero () (_ FloatingPoint 11 53) ((_ to_fp 11 53) RNE 0.0))
(define-fun one () (_ FloatingPoint 11 53) ((_ to_fp 11 53) RNE 1.0))
(define-fun rise () (_ FloatingPoint 11 53) (fp.add RNE f p_rise))
(define-fun fall () (_ FloatingPoint 11 53) (fp.add RNE f p_fall))
(assert (and (fp.leq zero f) (fp.leq f one)))
(assert (and (fp.leq zero p_rise) (fp.leq p_rise (fp.sub RNE one f))))
(assert (and (fp.leq (fp.sub RNE zero f) p_fall) (fp.leq p_fall zero)))
(assert (not (and (fp.leq zero rise) (fp.leq rise one) (fp.leq zero fall) (fp.leq fall one))))
(check-sat)
