---------------------------- MODULE MCLifeAlone ----------------------------
(***************************************************************************)
(* LifeCycle by itself: whatever one step may change, from every state.    *)
(* System refines it (MCRefineTod); that says nothing of what LifeCycle    *)
(* allows beyond System.  Here it is.                                      *)
(***************************************************************************)
EXTENDS LifeCycle

Most == 2
Settings == {"unset", "set", "active", "called"}
Pasts == {"none", "served", "cancelled", "lost", "cleared"}

(* LifeCycle leaves open some of what follows: every next state is tried.  *)
AnyNext == /\ on' \in BOOLEAN
           /\ setting' \in Settings
           /\ once' \in BOOLEAN
           /\ blocked' \in BOOLEAN
           /\ waiting' \in 0..Most
           /\ perhaps' \in BOOLEAN
           /\ running' \in BOOLEAN
           /\ past' \in Pasts
           /\ Next

AloneSpec == Init /\ [][AnyNext]_lifeVars

(* Nothing waits and nothing runs in STOP [OBS-41]. *)
OffInv == ~on => waiting = 0 /\ ~perhaps /\ ~running

(* What waits is active [TINT-09]. *)
ActiveInv == waiting > 0 => setting = "active"

Starts == running' /\ ~running

(* Only what is active and waits starts [TINT-09] [TINT-23]. *)
StartStep == Starts => setting = "active" /\ (waiting > 0 \/ perhaps)

(* A once interrupt runs once [TINT-08]: its call uses it up [AMB-71], and *)
(* its OB, when it ends, leaves nothing set.                               *)
OnceStep ==
    /\ Starts /\ once => /\ setting' \in {"unset", "called"}
                         /\ waiting' = 0 /\ ~perhaps'
    /\ setting = "called" /\ on => setting' \in {"unset", "called", "set"}
    /\ setting = "called" /\ past' = "served" /\ running /\ ~running'
         => setting' = "unset"

(* What waits stays, until it starts, is cancelled or set anew, or STOP.   *)
StaysStep ==
    waiting' < waiting =>
      Starts \/ ~on' \/ setting' \in {"unset", "set"}

(* What is set in RUN has to be activated by a call [TINT-33]. *)
ActivateStep == on /\ setting' = "active" => setting # "unset"

(* Nothing that is blocked comes to wait [IRT-01]. *)
BlockedStep == on /\ blocked => waiting' <= waiting

(* A call or a point does not end a program that runs [TINT-53]. *)
RunsOnStep == running /\ ~running' => past' \in {"served", "cleared"}

StartProp    == [][StartStep]_lifeVars
OnceProp     == [][OnceStep]_lifeVars
StaysProp    == [][StaysStep]_lifeVars
ActivateProp == [][ActivateStep]_lifeVars
BlockedProp  == [][BlockedStep]_lifeVars
RunsOnProp   == [][RunsOnStep]_lifeVars
=============================================================================
