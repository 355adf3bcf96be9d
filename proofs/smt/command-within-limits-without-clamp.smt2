; Twin of command-within-limits: the scaled speed is commanded as it is. Three roundings (ratio, reciprocal, product)
; end one unit beyond the limit. The limit is 3 rad/s, and the search is kept to the neighbourhood of a speed that an
; unrestricted run of the solver found in half a minute.
(set-logic QF_FP)
(declare-const speed (_ FloatingPoint 11 53))
(define-fun one () (_ FloatingPoint 11 53) ((_ to_fp 11 53) RNE 1.0))
(define-fun upper () (_ FloatingPoint 11 53) ((_ to_fp 11 53) RNE 3.0))
(define-fun ratio () (_ FloatingPoint 11 53) (fp.div RNE speed upper))
(define-fun scaled () (_ FloatingPoint 11 53) (fp.mul RNE speed (fp.div RNE one ratio)))
(assert (fp.leq (fp #b0 #b10000000001 #x4044be80f22f8) speed))
(assert (fp.leq speed (fp #b0 #b10000000001 #x4044be80f22ff)))
(assert (fp.gt scaled upper))
(check-sat)
(get-value (speed))
