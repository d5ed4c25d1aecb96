------------------------------ MODULE LifeCycle -----------------------------
(***************************************************************************)
(* The life of one time-of-day interrupt (section 1): unset, set or active *)
(* by SFC 28-30; due, and then waiting, running and served; or cancelled   *)
(* by a call, lost under DIS_IRT, cleared by STOP.                         *)
(*                                                                         *)
(* An abstract specification: models/MCRefineTod shows that System         *)
(* implements it.  There is no clock here: an active interrupt may be due  *)
(* at any time, at its point or since the clock was set past it.           *)
(* Left out: deselected and missing OBs; which points are served.          *)
(***************************************************************************)
EXTENDS Integers

VARIABLES
    (* The CPU is not in STOP. *)
    \* @type: Bool;
    on,
    (* "unset", "set", "active" or, of a once that its run uses up,         *)
    (* "called"; and whether PERIOD is "once".                              *)
    \* @type: Str;
    setting,
    \* @type: Bool;
    once,
    (* DIS_IRT blocks the OB. *)
    \* @type: Bool;
    blocked,
    (* The number of start events that wait; TRUE if there may be one more *)
    (* that was perhaps merged.                                            *)
    \* @type: Int;
    waiting,
    \* @type: Bool;
    perhaps,
    (* The OB runs. *)
    \* @type: Bool;
    running,
    (* The end of the start event that was over last: "none" yet,          *)
    (* "served", "cancelled", "lost" or "cleared".                         *)
    \* @type: Str;
    past

lifeVars == <<on, setting, once, blocked, waiting, perhaps, running, past>>

Init == /\ on = FALSE
        /\ setting = "unset" /\ once = FALSE
        /\ blocked = FALSE
        /\ waiting = 0 /\ perhaps = FALSE
        /\ running = FALSE
        /\ past = "none"

\* @type: (Bool, Str) => Str;
PastIf(over, how) == IF over THEN how ELSE past

(* A waiting start event is cancelled; a running program is not [TINT-53]. *)
Withdrawn == /\ waiting' = 0 /\ perhaps' = FALSE
             /\ past' = PastIf(waiting > 0, "cancelled")
             /\ UNCHANGED <<on, blocked, running>>

(* [TINT-30] [TINT-31] *)
Set == /\ on
       /\ setting' = "set" /\ once' \in BOOLEAN
       /\ Withdrawn

(* [TINT-50] [TINT-52] *)
Cancel == /\ on /\ setting # "unset"
          /\ setting' = "unset" /\ once' = FALSE
          /\ Withdrawn

(* [TINT-60] [TINT-61] *)
Activate == /\ on /\ setting # "unset"
            /\ setting' = IF setting = "called" THEN "called" ELSE "active"
            /\ UNCHANGED <<on, once, blocked, waiting, perhaps, running, past>>

(* [TINT-05] [TINT-09] Only an active interrupt has a start event.  The    *)
(* event waits, or is merged with another that waits or runs.              *)
Due == /\ on /\ setting = "active" /\ ~blocked
       /\ \/ waiting' = waiting + 1
          \/ waiting' = waiting /\ (waiting > 0 \/ running)
       /\ UNCHANGED <<on, setting, once, blocked, running, past>>

(* [IRT-01] [IRT-04] [IRT-18] A lost start event uses a once up, unless an *)
(* earlier one still waits.                                                *)
Lost == /\ on /\ setting = "active" /\ blocked
        /\ IF once /\ waiting = 0 THEN setting' = "unset" /\ once' = FALSE
                                  ELSE UNCHANGED <<setting, once>>
        /\ past' = "lost"
        /\ UNCHANGED <<on, blocked, waiting, perhaps, running>>

(* [TINT-23] [TINT-08] The OB is called for a waiting start event. A once  *)
(* is no longer set then, or when its OB ends [AMB-71].                    *)
Start == /\ on /\ ~running /\ running' = TRUE
         /\ setting = "active"
         /\ IF once
            THEN /\ waiting > 0 \/ perhaps
                 /\ waiting' = 0 /\ perhaps' = FALSE
                 /\ setting' \in {"unset", "called"}
                 /\ once' = (setting' = "called")
            ELSE /\ \/ waiting > 0 /\ waiting' = waiting - 1
                    \/ perhaps /\ waiting' = waiting
                 /\ UNCHANGED <<setting, once>>
         /\ UNCHANGED <<on, blocked, past>>

End == /\ on /\ running /\ running' = FALSE
       /\ past' = "served"
       /\ IF setting = "called" THEN setting' = "unset" /\ once' = FALSE
                                ELSE UNCHANGED <<setting, once>>
       /\ UNCHANGED <<on, blocked, waiting, perhaps>>

(* The merged start event has had no effect. *)
Fade == /\ on /\ perhaps /\ perhaps' = FALSE
        /\ UNCHANGED <<on, setting, once, blocked, waiting, running, past>>

(* [IRT-01] [IRT-13] [IRT-16] A start event that waits already stays. *)
BlockOrFree == /\ on /\ blocked' # blocked
               /\ UNCHANGED <<on, setting, once, waiting, perhaps, running,
                              past>>

(* [OBS-41] *)
Stop == /\ on /\ on' = FALSE
        /\ waiting' = 0 /\ perhaps' = FALSE /\ running' = FALSE
        /\ past' = PastIf(waiting > 0 \/ running, "cleared")
        /\ UNCHANGED <<setting, once, blocked>>

(* [OBS-50] [OBS-53] [OBS-56] STEP 7 sets the interrupt or does not; a     *)
(* once of the past waits.                                                 *)
Restart == /\ ~on /\ on' = TRUE
           /\ blocked' = FALSE
           /\ setting' \in {"unset", "set", "active"} /\ once' \in BOOLEAN
           /\ \/ UNCHANGED waiting
              \/ waiting' = 1 /\ setting' = "active" /\ once'
           /\ UNCHANGED <<perhaps, running, past>>

Next == \/ Set \/ Cancel \/ Activate
        \/ Due \/ Lost \/ Start \/ End \/ Fade
        \/ BlockOrFree \/ Stop \/ Restart

Spec == Init /\ [][Next]_lifeVars
=============================================================================
