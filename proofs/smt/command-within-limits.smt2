; Claim command-within-limits, bit by bit in IEEE 754 double precision: whatever the scaling produced, NaN included,
; max(lower) and then min(upper) end inside the limits.
(set-logic QF_FP)
(declare-const lower (_ FloatingPoint 11 53))  ; rad/s
(declare-const upper (_ FloatingPoint 11 53))  ; rad/s
(declare-const scaled (_ FloatingPoint 11 53)) ; desired speed times the direction factor, rad/s
(define-fun zero () (_ FloatingPoint 11 53) ((_ to_fp 11 53) RNE 0.0))
(define-fun command () (_ FloatingPoint 11 53) (fp.min (fp.max scaled lower) upper))
(assert (and (fp.lt lower zero) (not (fp.isInfinite lower))))
(assert (and (fp.lt zero upper) (not (fp.isInfinite upper))))
(assert (not (and (fp.leq lower command) (fp.leq command upper))))
(check-sat)
