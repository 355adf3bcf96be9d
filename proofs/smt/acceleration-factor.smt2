; Claim acceleration-factor, one joint; the others leave the factors between other_least and other_greatest.
(set-logic QF_NRA)
(declare-const low Real)   ; the box, rad/s
(declare-const high Real)
(declare-const A Real)     ; feedback part, rad/s
(declare-const B Real)     ; feedforward part at full rate, rad/s
(declare-const first Real) ; (end of the box met first - A) / B, 1
(declare-const last Real)  ; the same of the other end
(declare-const other_least Real)
(declare-const other_greatest Real)
(declare-const risen Real) ; what the filter allows, 1
(declare-const g Real)     ; any factor
(define-fun least ((x Real) (y Real)) Real (ite (<= x y) x y))
(define-fun most ((x Real) (y Real)) Real (ite (>= x y) x y))
(define-fun f_least () Real (most 0.0 (most other_least (ite (= B 0.0) 0.0 first))))
(define-fun f_greatest () Real (least 1.0 (least other_greatest (ite (= B 0.0) 1.0 last))))
(define-fun f () Real (most f_least (least risen f_greatest)))
(define-fun inside ((x Real)) Bool (and (<= low (+ A (* x B))) (<= (+ A (* x B)) high)))
(assert (<= low high))
(assert (and (<= 0.0 risen) (<= risen 1.0)))
(assert (=> (= B 0.0) (inside 0.0)))
(assert (=> (> B 0.0) (and (= (* first B) (- low A)) (= (* last B) (- high A)))))
(assert (=> (< B 0.0) (and (= (* first B) (- high A)) (= (* last B) (- low A)))))
(assert (<= f_least f_greatest))
(assert (not (and
  (<= 0.0 f) (<= f 1.0) (inside f)
  ; no admissible factor lies outside the interval, and none that the filter allows above f
  (=> (and (<= 0.0 g) (<= g 1.0) (<= other_least g) (<= g other_greatest) (inside g))
      (and (<= f_least g) (<= g f_greatest) (=> (<= g risen) (<= g f)))))))
(check-sat)
