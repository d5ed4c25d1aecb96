------------------------------- MODULE Steps --------------------------------
(***************************************************************************)
(* Terms of the properties: a step as an observer sees it, new requests    *)
(* and entries, skipped points, the first minute from a moment on.         *)
(*                                                                         *)
(* Left out: the terms of the actions.                                     *)
(***************************************************************************)
EXTENDS System

Did(event) == step'.event = event

(* The OB of a start event has started in this step. *)
Started(o) == Did("start") /\ step'.ob = o
(* The CPU has found in this step that this OB is missing. *)
FoundMissing(o) == Did("missing") /\ step'.ob = o
Dispatched == /\ Did("start")
              /\ step'.ob \notin StartupObs \cup SyncErrorObs \cup CycleObs

\* @type: Seq($frame) => $frame;
Top(s) == IF s = <<>> THEN NoFrame ELSE s[Len(s)]

(* [OBS-10] A request stays as it was when its start event occurred; only  *)
(* its place changes, and an open one may be confirmed. A hot restart      *)
(* brings some back; any other restart drops them for good.                *)
\* @type: $request => $request;
Content(r) == [ r EXCEPT !.rank = 0, !.open = FALSE,
                         !.late = IF r.ob = TimeErrorOb THEN @ ELSE {} ]
Fresh ==
    LET known == IF startup' = "hot" THEN requests \cup resume.requests
                                     ELSE requests
    IN  { r \in requests' : ~\E q \in known : Content(q) = Content(r) }

(* The entries of the diagnostic buffer that are sure. *)
EnteredNow == { n.id : n \in { e \in entered' : ~e.open } }

(* The interrupts whose next point the clock has passed with this step,    *)
(* and those of them whose OB SFC 39 blocks.                               *)
\* @type: Int => Bool;
Skipped(o) == /\ tod[o].active /\ ~Deselected(o)
              /\ Before(At(tod[o].next), clock')
SkippedNow == { o \in TodObs : Skipped(o) }
BlockedNow == { o \in SkippedNow : Blocked(o) }
SkippedAndLoaded == (SkippedNow \ BlockedNow) \cap loaded

(* [AMB-83] HOLD ends, and a point of the interrupt counts as passed in it *)
(* that is not before the clock: one that passed before the clock was set  *)
(* back, or one that equals the clock.                                     *)
\* @type: Int => Bool;
PassedInHold(o) ==
    /\ Did("release") /\ tod[o].active /\ ~Deselected(o)
    /\ \/ tod[o].held
       \/ At(tod[o].next) = clock /\ tod'[o].next # tod[o].next

(* p is the first minute that is not before moment t; Never if there is    *)
(* none up to 2089.                                                        *)
\* @type: (Int, $moment) => Bool;
IsFirstMinute(p, t) == IF Before(At(LastMinute), t) THEN p = Never
                       ELSE ~Before(At(p), t) /\ Before(At(p - 1), t)
=============================================================================
