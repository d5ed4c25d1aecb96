---------------------------- MODULE MCLifeAlone ----------------------------
(***************************************************************************)
(* LifeCycle by itself: every step from every state. System refines        *)
(* LifeCycle (MCRefineTod), but LifeCycle allows more than System. This    *)
(* model checks all that it allows.                                        *)
(***************************************************************************)
EXTENDS LifeCycle

Most == 2
Settings == {"unset", "set", "active", "called"}
Pasts == {"none", "served", "cancelled", "lost", "missed", "cleared"}

(* Next of LifeCycle. A variable that it leaves open may take any value of *)
(* its type.                                                               *)
AnyNext ==
    /\ doomed' \in BOOLEAN
    /\ \/ Set \/ Cancel \/ Activate \/ Lost \/ Excuse \/ End \/ Fade
       \/ Stop \/ Restart \/ Doom
       \/ perhaps' \in BOOLEAN /\ (Due \/ Start \/ Miss)
       \/ blocked' \in BOOLEAN /\ BlockOrFree
       \/ loaded' \in BOOLEAN /\ LoadOrDelete
    /\ Fated

AtMost == waiting <= Most

AloneSpec == Init /\ [][AnyNext]_lifeVars

(* Nothing waits and nothing runs in STOP [OBS-41]. *)
OffInv == ~on => waiting = 0 /\ ~perhaps /\ ~running /\ ~doomed

(* A waiting interrupt is active [TINT-09]. *)
ActiveInv == waiting > 0 => setting = "active"

Starts == running' /\ ~running

(* An OB starts only if it is loaded, and its interrupt is active and      *)
(* waits [TINT-09] [TINT-23].                                              *)
StartStep ==
    Starts => loaded /\ setting = "active" /\ (waiting > 0 \/ perhaps)

(* A one-shot interrupt runs once [TINT-08]: its call uses it up [AMB-71]. *)
(* It is no longer set after its OB ends.                                  *)
OnceStep ==
    /\ Starts /\ once => /\ setting' \in {"unset", "called"}
                         /\ waiting' = 0 /\ ~perhaps'
    /\ setting = "called" /\ on => setting' \in {"unset", "called", "set"}
    /\ setting = "called" /\ past' = "served" /\ running /\ ~running'
         => setting' = "unset"

(* A start event waits until its OB starts or is missing, until its        *)
(* interrupt is cancelled or set anew, or until STOP.                      *)
StaysStep ==
    waiting' < waiting =>
      Starts \/ ~loaded \/ ~on' \/ setting' \in {"unset", "set"}

(* After SET_TINT in RUN a call has to activate the interrupt [TINT-33]. *)
ActivateStep == on /\ setting' = "active" => setting # "unset"

(* A blocked interrupt does not begin to wait [IRT-01]. *)
BlockedStep == on /\ blocked => waiting' <= waiting

(* A call or a point does not end a running OB [TINT-53]. *)
RunsOnStep == running /\ ~running' => past' \in {"served", "cleared"}

(* A start event of a blocked interrupt is lost; it uses a one-shot        *)
(* interrupt up unless another one waits [IRT-18], and nothing else        *)
(* [IRT-01].                                                               *)
LostStep ==
    past # "lost" /\ past' = "lost" =>
      /\ blocked /\ setting = "active"
      /\ setting' = IF once /\ waiting = 0 /\ ~perhaps THEN "unset"
                                                        ELSE "active"

(* A life that forbids too much violates no step. A call may set, activate *)
(* and cancel; a point may be due; what waits starts; an OB ends; STOP may *)
(* come, and has to where the CPU is doomed [OBS-22] [OBS-47].             *)
PossibleInv ==
    /\ ENABLED (AnyNext /\ on' # on)
    /\ on =>
         /\ ENABLED (AnyNext /\ setting' = "set")
         /\ setting = "set" => ENABLED (AnyNext /\ setting' = "active")
         /\ setting # "unset" => ENABLED (AnyNext /\ on' /\ setting' = "unset")
         /\ setting = "active" /\ ~blocked =>
              ENABLED (AnyNext /\ waiting' > waiting)
         /\ setting = "active" /\ blocked =>
              ENABLED (AnyNext /\ past' = "lost")
         /\ (waiting > 0 \/ perhaps) /\ setting = "active" =>
              IF loaded THEN running \/ ENABLED (AnyNext /\ Starts)
                        ELSE ENABLED (AnyNext /\ past' = "missed")
         /\ running => ENABLED (AnyNext /\ past' = "served" /\ ~running')

StartProp    == [][StartStep]_lifeVars
LostProp     == [][LostStep]_lifeVars
OnceProp     == [][OnceStep]_lifeVars
StaysProp    == [][StaysStep]_lifeVars
ActivateProp == [][ActivateStep]_lifeVars
BlockedProp  == [][BlockedStep]_lifeVars
RunsOnProp   == [][RunsOnStep]_lifeVars
=============================================================================
