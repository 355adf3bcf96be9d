; Claim time-with-feedback, what one sample adds: the share of the path's own rate, advance * z, lies between 1 - max(y, E) and
; 1 + E + (m - 1)+; in the form that waits, and in the implicit one, at most 1 + E.
(set-logic QF_NRA)
(declare-const m Real)        ; the demand's use of a limit, 1
(declare-const z Real)        ; f b, 1
(declare-const e Real)        ; the feedback's use of a limit, 1
(declare-const y Real)        ; z >= 1 - y, 1
(declare-const advance Real)  ; 1 (published, implicit) or 1 / max(1, m), 1
(declare-const waits Bool)
(define-fun over () Real (ite (<= m 1.0) 0.0 (- m 1.0)))
(define-fun held () Real (ite (<= y e) e y))
(assert (and (<= 0.0 m) (<= 0.0 z) (<= 0.0 e)))
(assert (and (<= z (+ m e)) (<= m (+ z e)) (>= z (- 1.0 y))))
(assert (=> waits (ite (<= m 1.0) (= advance 1.0) (= (* advance m) 1.0))))
(assert (=> (not waits) (= advance 1.0)))
(assert (not (and (>= (* advance z) (- 1.0 held))
                  (<= (* advance z) (+ 1.0 e over))
                  (=> waits (<= (* advance z) (+ 1.0 e))))))
(check-sat)
