; Claim curve-end. u and w are place and rate of a curve at a sample, w2 the rate at the next one; between them the rate is linear in
; time. The unit of time is the sampling period. t is any instant between the samples.
(set-logic QF_NRA)
(declare-const u Real)
(declare-const w Real)
(declare-const w2 Real)
(declare-const t Real)
(define-fun stop () Real (+ u (/ w 2.0)))
(define-fun u2 () Real (+ u (/ (+ w w2) 2.0)))
(define-fun stop2 () Real (+ u2 (/ w2 2.0)))
(define-fun between () Real (+ u (* w t) (/ (* (- w2 w) t t) 2.0)))
(assert (and (<= 0.0 w) (<= stop 1.0)))
(assert (and (<= 0.0 w2) (<= w2 (- 1.0 stop))))
(assert (and (<= 0.0 t) (<= t 1.0)))
(assert (not (and
  ; the same holds at the next sample
  (<= stop2 1.0)
  ; the place never runs back and never passes the end
  (<= u between) (<= between u2) (<= u2 1.0)
  ; where the rate used up what was left, a stand leads to the end itself
  (=> (= w2 (- 1.0 stop)) (= stop2 1.0)))))
(check-sat)
