-------------------------- MODULE PropertiesSeries --------------------------
(***************************************************************************)
(* An active interrupt waits for the first point of its series that is     *)
(* ahead (section 1.1).                                                    *)
(*                                                                         *)
(* Left out: what a point is (Series).                                     *)
(***************************************************************************)
EXTENDS Steps, Series

(* The first minute that is not before the clock. *)
Ahead == IF clock.ms = 0 THEN clock.min ELSE clock.min + 1

(* [TINT-10] [TINT-24] [TINT-32] [AMB-39] The first point after activation *)
(* is the next one of the series, never a past one.  In an interval that   *)
(* the clock repeats it may be a later one [AMB-57].                       *)
FirstPointProp ==
    [][ Did("ACT_TINT") /\ step'.value = 0 /\ ~tod[step'.ob].active =>
          LET t == tod'[step'.ob]
          IN  IF t.repeatTo < clock.min
              THEN IsFirst(t.start, t.period, t.next, Ahead)
              ELSE t.next >= Ahead ]_vars

(* [TINT-09] [TINT-10] [CLK-08] An active interrupt waits for the next     *)
(* point of its series. The point that equals the clock may have been      *)
(* reached. A one-shot interrupt has its start and no other point. In a    *)
(* time that the clock repeats, points may be left out [CLK-09] [AMB-56]   *)
(* [AMB-57].                                                               *)
NextPointInv ==
    mode \in {"RUN", "STARTUP"} =>
      \A o \in TodObs :
        LET t == tod[o]
        IN  t.active =>
              IF t.period = Once THEN t.next \in {t.start, Never}
              ELSE IF clock.min <= t.repeatTo
              THEN t.next = Never \/ OnSeries(t.start, t.period, t.next)
              ELSE \/ IsFirst(t.start, t.period, t.next, Ahead)
                   \/ IsFirst(t.start, t.period, t.next, clock.min + 1)
=============================================================================
