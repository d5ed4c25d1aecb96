------------------------------ MODULE LifeCycle -----------------------------
(***************************************************************************)
(* The life of one time-of-day interrupt (section 1): unset, set or active *)
(* by SFC 28-30; due, and then waiting, running and served; or cancelled   *)
(* by a call, lost under DIS_IRT, missed without its OB, cleared by STOP.  *)
(*                                                                         *)
(* An abstract specification: System implements it, see models/APRefine    *)
(* and models/MCRefineTod.  There is no clock here: an active interrupt    *)
(* may be due at any time, at its point or since the clock was set past    *)
(* it.                                                                     *)
(* Left out: deselected OBs; which points are served.                      *)
(***************************************************************************)
EXTENDS Integers

VARIABLES
    (* The CPU is not in STOP. *)
    \* @type: Bool;
    on,
    (* It is going to stop by a rule: a start event may have no effect.    *)
    \* @type: Bool;
    doomed,
    (* The OB is loaded. *)
    \* @type: Bool;
    loaded,
    (* "unset", "set", "active" or, of a one-shot interrupt that its run    *)
    (* uses up, "called"; and whether PERIOD is "once".                     *)
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
    (* "served", "cancelled", "lost", "missed" or "cleared".               *)
    \* @type: Str;
    past

interruptVars == <<setting, once, blocked, waiting, perhaps, running, past>>
lifeVars == <<on, doomed, loaded, interruptVars>>

Init == /\ on = FALSE /\ doomed = FALSE
        /\ loaded \in BOOLEAN
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
             /\ UNCHANGED <<on, loaded, blocked, running>>

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
            /\ UNCHANGED <<on, loaded, once, blocked, waiting, perhaps,
                           running, past>>

(* [TINT-05] [TINT-09] Only an active interrupt has a start event.  The    *)
(* event waits, or perhaps waits, or is merged with another that waits or  *)
(* runs, or the CPU is going to stop.                                      *)
Due == /\ on /\ setting = "active" /\ ~blocked
       /\ \/ waiting' = waiting + 1
          \/ /\ waiting' = waiting
             /\ waiting > 0 \/ perhaps \/ perhaps' \/ running \/ doomed'
       /\ UNCHANGED <<on, loaded, setting, once, blocked, running, past>>

(* [IRT-01] [IRT-04] [IRT-18] A lost start event uses a one-shot interrupt *)
(* up, unless an earlier one still waits.                                  *)
Lost == /\ on /\ setting = "active" /\ blocked
        /\ IF once /\ waiting = 0 /\ ~perhaps
           THEN setting' = "unset" /\ once' = FALSE
           ELSE UNCHANGED <<setting, once>>
        /\ past' = "lost"
        /\ UNCHANGED <<on, loaded, blocked, waiting, perhaps, running>>

(* The OB is called for a waiting start event: a one-shot interrupt has no *)
(* other.                                                                  *)
\* @type: Set(Str) => Bool;
Taken(after) == /\ on /\ setting = "active"
                /\ IF once
                   THEN /\ waiting > 0 \/ perhaps
                        /\ waiting' = 0 /\ perhaps' = FALSE
                        /\ setting' \in after
                        /\ once' = (setting' = "called")
                   ELSE /\ \/ waiting > 0 /\ waiting' = waiting - 1
                           \/ perhaps /\ waiting' = waiting
                        /\ UNCHANGED <<setting, once>>

(* [TINT-23] [TINT-08] A one-shot interrupt is no longer set when its OB   *)
(* starts, or when it ends [AMB-71].                                       *)
Start == /\ loaded /\ ~running /\ running' = TRUE
         /\ Taken({"unset", "called"})
         /\ UNCHANGED <<on, loaded, blocked, past>>

(* [TINT-16] [AMB-46] Its OB is missing. *)
Miss == /\ ~loaded
        /\ Taken({"unset"})
        /\ past' = "missed"
        /\ UNCHANGED <<on, loaded, blocked, running>>

(* [AMB-45] One OB 85 may be for all start events of missing OBs. *)
Excuse == /\ on /\ ~loaded /\ waiting > 0
          /\ waiting' = 0 /\ perhaps' = TRUE
          /\ UNCHANGED <<on, loaded, setting, once, blocked, running, past>>

End == /\ on /\ running /\ running' = FALSE
       /\ past' = "served"
       /\ IF setting = "called" THEN setting' = "unset" /\ once' = FALSE
                                ELSE UNCHANGED <<setting, once>>
       /\ UNCHANGED <<on, loaded, blocked, waiting, perhaps>>

(* The merged start event has had no effect. *)
Fade == /\ on /\ perhaps /\ perhaps' = FALSE
        /\ UNCHANGED <<on, loaded, setting, once, blocked, waiting, running,
                       past>>

(* [IRT-01] [IRT-13] [IRT-16] A start event that waits already stays. *)
BlockOrFree == /\ on /\ blocked' # blocked
               /\ UNCHANGED <<on, loaded, setting, once, waiting, perhaps,
                              running, past>>

(* [AMB-66] A start event that waits already stays. *)
LoadOrDelete == /\ loaded' # loaded /\ doomed' = doomed
                /\ UNCHANGED <<on, interruptVars>>

Doom == on /\ doomed' /\ UNCHANGED <<on, loaded, interruptVars>>

(* [OBS-41] *)
Stop == /\ on /\ on' = FALSE /\ ~doomed'
        /\ waiting' = 0 /\ perhaps' = FALSE /\ running' = FALSE
        /\ past' = PastIf(waiting > 0 \/ running, "cleared")
        /\ UNCHANGED <<loaded, setting, once, blocked>>

(* [OBS-50] [OBS-53] [OBS-56] STEP 7 sets the interrupt or does not; a     *)
(* one-shot interrupt of the past waits.                                   *)
Restart == /\ ~on /\ on' = TRUE
           /\ blocked' = FALSE
           /\ setting' \in {"unset", "set", "active"} /\ once' \in BOOLEAN
           /\ \/ UNCHANGED waiting
              \/ waiting' = 1 /\ setting' = "active" /\ once'
           /\ UNCHANGED <<loaded, perhaps, running, past>>

(* [OBS-22] A STOP that has to come comes. *)
Fated == doomed => doomed' \/ ~on'

Next == /\ Fated
        /\ \/ Set \/ Cancel \/ Activate
           \/ Due \/ Lost \/ Start \/ Miss \/ Excuse \/ End \/ Fade
           \/ BlockOrFree \/ LoadOrDelete \/ Doom \/ Stop \/ Restart

Spec == Init /\ [][Next]_lifeVars
=============================================================================
