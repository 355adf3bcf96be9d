; Claim natural-speed, two joints: the joints' speed b adj(J) t moves the tool along the path at one speed only, b det J.
(set-logic QF_NRA)
(declare-const a Real)
(declare-const b Real)
(declare-const c Real)
(declare-const d Real)
(declare-const t1 Real)
(declare-const t2 Real)
(declare-const k Real) ; the independent variable
(declare-const s Real) ; path speed
(define-fun n1 () Real (- (* d t1) (* b t2)))
(define-fun n2 () Real (- (* a t2) (* c t1)))
(define-fun det () Real (- (* a d) (* b c)))
(assert (or (not (= t1 0.0)) (not (= t2 0.0))))
(assert (= (* k (+ (* a n1) (* b n2))) (* t1 s)))
(assert (= (* k (+ (* c n1) (* d n2))) (* t2 s)))
(assert (not (= s (* k det))))
(check-sat)
