; Claim path-reserve, inductive step from outside: the excess above the band falls by the recovery of a sample, or is gone.
(set-logic QF_NRA)
(declare-const over Real) ; phi plus margin above its band at the last sample
(declare-const band Real) ; this band, which may differ from the last one
(declare-const free Real) ; phi plus margin now, before the reserve: whatever push, walk and drift made of it
(declare-const fall Real) ; what the recovery takes off in one sample
(define-fun pos ((x Real)) Real (ite (>= x 0.0) x 0.0))
(define-fun limit () Real (+ band (pos (- over fall))))
(assert (and (<= 0.0 band) (< 0.0 fall)))
(define-fun next () Real (ite (<= free limit) free limit))
(assert (> over 0.0))
(assert (not (<= (- next band) (pos (- over fall)))))
(check-sat)
