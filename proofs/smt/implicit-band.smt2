; Claim implicit-band, one joint: f = min((1 - a) f_before + a, f_star), f_star from the closed form.
(set-logic QF_NRA)
(declare-const a Real)        ; filter step, 1
(declare-const f_before Real) ; 1
(declare-const lower Real)    ; rad/s
(declare-const upper Real)    ; rad/s
(declare-const A Real)        ; feedback part, rad/s
(declare-const B Real)        ; feedforward part at full rate, rad/s
(declare-const bound Real)    ; (limit - A) / B of the limit moved towards, 1
(declare-const other Real)    ; the same of all other joints: any number >= 0
(declare-const g Real)        ; any factor, for the maximality of f_star
(define-fun least ((x Real) (y Real)) Real (ite (<= x y) x y))
(define-fun f_star () Real (least 1.0 (least other (ite (= B 0.0) 1.0 bound))))
(define-fun risen () Real (+ f_before (* a (- 1.0 f_before))))
(define-fun f () Real (least risen f_star))
(define-fun speed () Real (+ A (* f B)))
(assert (and (< 0.0 a) (<= a 1.0)))
(assert (and (<= 0.0 f_before) (<= f_before 1.0)))
(assert (and (< lower 0.0) (< 0.0 upper)))
(assert (and (<= lower A) (<= A upper)))
(assert (=> (> B 0.0) (= (* bound B) (- upper A))))
(assert (=> (< B 0.0) (= (* bound B) (- lower A))))
(assert (>= other 0.0))
(assert (not (and
  (<= lower speed) (<= speed upper)
  (<= 0.0 f) (<= f 1.0) (<= f risen)
  ; no larger factor than f_star is admissible, unless another joint or the range [0, 1] is what limits
  (=> (and (< f_star g) (<= g 1.0) (<= g other)) (not (and (<= lower (+ A (* g B))) (<= (+ A (* g B)) upper)))))))
(check-sat)
