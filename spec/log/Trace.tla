-------------------------------- MODULE Trace -------------------------------
(***************************************************************************)
(* The specification explains a log one line at a time: Begin takes the    *)
(* header. Before each further line time elapses to it (Towards), then     *)
(* hidden steps may happen (HiddenBefore), then the line is observed       *)
(* (Shows).                                                                *)
(*                                                                         *)
(* Source: docs/checking/log-format.md with its fine points; AMB-69.       *)
(* Left out: kinds of event that the log does not have completely          *)
(* (PartialLogs).                                                          *)
(***************************************************************************)
EXTENDS LogHeader, Lines

-----------------------------------------------------------------------------
(* Points and delays of the moment of a line *)

(* The start event of OB o only makes it wait. *)
\* @type: Int => Bool;
OnlyWaits(o) == /\ o \in loaded /\ ~Idle(o) /\ ~OnStack(o)
                /\ ~PendingIn(requests, o) /\ ~OpenIn(requests, o)

(* Line e depends on whether OB o waits, or changes its queue. *)
\* @type: ($event, Int) => Bool;
Touches(e, o) ==
    CASE e.event \in {"DIS_IRT", "EN_IRT"} -> MarkedIn(Meant(e.mode, e.ob), o)
      [] e.event = "interrupt"            -> ClassOf(e.ob) = ClassOf(o)
      [] e.event \in CallEvents \cup {"start", "end", "load", "delete",
                                      "state"} -> e.ob = o
      [] OTHER                            -> e.event # "diag"

(* Another start event of this moment does more than wait, in the class of *)
(* OB o: their order decides which OB runs first.                          *)
\* @type: Int => Bool;
OrderMatters(o) == \E p \in PointsNow \cup OverNow :
                     ClassOf(p) = ClassOf(o) /\ ~OnlyWaits(p)

(* A start event of this moment may come before or after line e. If both   *)
(* have the same effect, it comes after: a later request allows as much.   *)
\* @type: ($event, Int) => Bool;
ComesBefore(e, o) ==
    \/ Partial \/ PointsComeByNumber
    \/ ~OnlyWaits(o) \/ OrderMatters(o) \/ Touches(e, o)

-----------------------------------------------------------------------------
(* Hidden steps: a log never shows them *)

(* The boundaries of the cycle and of the startup OB. The end of a cycle   *)
(* matters only if it ends a delay.                                        *)
HiddenBoundary ==
    \/ ~terms.cycle /\ CycleStarts
    \/ ~terms.cycle /\ delay > 0 /\ Len(stack) = 1 /\ End(CycleOb)
    \/ mode = "STARTUP" /\ \E o \in StartupObs : StartupStarts(o) \/ End(o)

(* [DINT-06] *)
\* @type: $event => Bool;
EndsEarly(e) ==
    \E o \in OverBefore(e) \ OverNow :
      /\ DelayElapses(o) /\ Rewait
      /\ terms' = [ terms EXCEPT !.early =
                       EarlyDelays \cup {[ob |-> o, since |-> clock]} ]

\* @type: $event => Bool;
HiddenBefore(e) ==
    /\ UNCHANGED <<pace, up>>
    /\ \/ EndsEarly(e)
       \/ /\ UNCHANGED terms
          /\ \/ \E o \in PointsNow :
                  ComesBefore(e, o) /\ PointReached(o) /\ Rewait
             \/ \E o \in OverNow :
                  ComesBefore(e, o) /\ DelayElapses(o) /\ Rewait
             \/ FindMissing
             \/ DropsBeforePoint
             \/ HiddenBoundary /\ Rewait

(* Cheap to evaluate: may a hidden step be possible? *)
\* @type: $event => Bool;
HidesBefore(e) == \/ stack = <<>>
                  \/ delay > 0
                  \/ requests # {}
                  \/ mode = "STARTUP"
                  \/ PointsNow # {}
                  \/ OverBefore(e) # {}

(* Two explanations of a log differ if these values differ.                *)
Distinct == <<cpu.readings, loaded, mode, startup, clock, tod, dint, irt,
              requests, stack, delay, stopCause, up, waiting, first, overruns,
              arrivals, changes, reports, terms.endless, terms.unsure,
              EarlyDelays>>

(* ... between two lines. If loading is not recorded, an OB is loaded or   *)
(* deleted unseen as soon as something depends on it. So the loaded OBs do *)
(* not matter here.                                                        *)
DistinctAfterLine ==
    <<cpu.readings,
      IF Unseen("load") /\ ~DeletedObTakesRequests THEN {} ELSE loaded,
      mode, startup, clock, tod, dint, irt, requests, stack, delay, stopCause,
      up, waiting, first, overruns, arrivals, changes, reports, terms.endless,
      terms.unsure, EarlyDelays>>
=============================================================================
