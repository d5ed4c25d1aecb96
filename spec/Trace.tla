-------------------------------- MODULE Trace -------------------------------
(***************************************************************************)
(* The specification as the explanation of a log, one line at a time:      *)
(* Begin takes the header.  Before each further line time elapses to it    *)
(* (Towards), then hidden steps may happen (HiddenBefore), then the line   *)
(* is observed (Shows).                                                    *)
(*                                                                         *)
(* Source: docs/checking/log-format.md with its fine points; AMB-69.       *)
(* Left out: kinds of event that the log does not have completely, which   *)
(* module PartialLogs adds.                                                *)
(***************************************************************************)
EXTENDS LogHeader, Lines

-----------------------------------------------------------------------------
(* Hidden steps: a log never shows them *)

(* The boundaries of the cycle and of the startup OB.  The end of a cycle  *)
(* matters only where it ends a delay.                                     *)
HiddenBoundary ==
    \/ ~terms.cycle /\ CycleStarts
    \/ ~terms.cycle /\ delay > 0 /\ Len(stack) = 1 /\ End(CycleOb)
    \/ mode = "STARTUP" /\ \E o \in StartupObs : StartupStarts(o) \/ End(o)

\* @type: $event => Bool;
HiddenBefore(e) ==
    /\ UNCHANGED <<lineVars, up>>
    /\ \/ \E o \in PointsNow : PointReached(o) /\ Rewait
       \/ \E o \in OverBefore(e) : DelayElapses(o) /\ Rewait
       \/ FindMissing
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
              arrivals, changes, reports>>
=============================================================================
