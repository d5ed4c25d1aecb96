------------------------------- MODULE Calls --------------------------------
(***************************************************************************)
(* The common part of all calls of system functions: the caller, the       *)
(* possible answers, the STATUS of SFC 31 and SFC 34 (sections 1.5, 2,     *)
(* 7.4). The action of a call says what an answer leads to; System and     *)
(* Lines take it where the call is possible, with one of its answers.      *)
(*                                                                         *)
(* Left out: what earns a general error code [TINT-22]: faults of          *)
(* addressing, which no call of a log can express.                         *)
(***************************************************************************)
EXTENDS Codes, Cpu, Readings

(* A system function is called by the running OB; in HOLD none runs        *)
(* [OBS-45], and one whose instruction failed waits [OBS-61].              *)
Called == stack # <<>> /\ mode # "HOLD" /\ ~Failed

(* [AMB-63] Any of several errors in a call may be answered; under (a) the *)
(* first in the order of the operands, which is the order of the codes.    *)
\* @type: Set(Int) => Set(Int);
Usual(errors) ==
    IF errors = {} THEN {OK}
    ELSE IF FirstErrorIsAnswered
    THEN { e \in errors : \A f \in errors : e <= f }
    ELSE errors

(* [AMB-61] A call for a deselected OB. *)
\* @type: (Int, Set(Int)) => Set(Int);
Answers(o, errors) ==
    IF o \notin TodObs \cup DintObs \/ ~Deselected(o) THEN Usual(errors)
    ELSE CASE DeselectedIsRefused  -> {BadOb}
           [] DeselectedIsOrdinary -> Usual(errors)
           [] OTHER                -> Usual(errors) \cup {BadOb}

(* [T15-41] [T15-140] [A15-13] A call that sets or starts an interrupt,    *)
(* whose OB may be missing.                                                *)
\* @type: (Bool, Int, Set(Int)) => Set(Int);
SettingAnswersIf(missing, o, errors) ==
    IF ~missing \/ Family.stops THEN Answers(o, errors)
    ELSE IF MissingIsRefused THEN {BadOb}
    ELSE IF MissingIsNotRefused THEN Answers(o, errors)
    ELSE Answers(o, errors) \cup {BadOb}
\* @type: (Int, Set(Int)) => Set(Int);
SettingAnswers(o, errors) == SettingAnswersIf(o \notin loaded, o, errors)

(* [T15-143] [T15-144] [T15-145] [T15-148] [A15-24] Where no text of a     *)
(* call was found, an error may have any code.                             *)
AnyCode == \h8080..\h80FF
\* @type: Set(Int) => Set(Int);
OpenCodes(answers) ==
    IF Family.openCodes /\ CodesAreOpen /\ answers # {OK}
    THEN answers \cup AnyCode ELSE answers

(* [TINT-22] The second digit is the number of the wrong parameter.        *)
\* @type: Int => Bool;
IsGeneralError(ret) == /\ ret \in \h8100..\h8FFF
                       /\ ret % 256 \in {\h7F} \cup (\h22..\h45)

(* [AMB-81] A call that answers a general error has no effect.             *)
\* @type: Int => Bool;
Fails(ret) ==
    /\ CallsMayFail
    /\ IsGeneralError(ret)
    /\ NothingEntered
    /\ UNCHANGED cpuVars

-----------------------------------------------------------------------------
(* STATUS *)

(* [TINT-72] By default bit 0 of a deselected OB in RUN is not judged      *)
(* [AMB-03].                                                               *)
\* @type: Int => Set(Int);
StartupBit(o) ==
    LET bit == IF mode = "STARTUP" /\ ~Bit0IsZeroInStartup THEN 1 ELSE 0
    IN  IF ~Deselected(o) THEN {bit}
        ELSE IF Bit0ShowsDeselection THEN {1} ELSE {bit, 1}

(* [TINT-73] [T15-53] Bit 1 where the OB is blocked, or all are delayed.   *)
\* @type: (Bool, Bool) => Set(Int);
BlockedBitIf(blocked, delayed) ==
    IF Family.showsDelay /\ CodesAreOpen THEN {0, 2}
    ELSE LET shows == IF Family.showsDelay THEN delayed ELSE blocked
         IN  {IF shows THEN 2 ELSE 0}
\* @type: Int => Set(Int);
BlockedBit(o) == BlockedBitIf(Blocked(o), delay > 0)

(* [TINT-76] *)
\* @type: Int => Set(Int);
LoadedBit(o) == {IF o \in loaded THEN 16 ELSE 0}

(* [TINT-75] [AMB-82] *)
Bit3 == IF Bit3IsOpen THEN {0, 8} ELSE {0}

(* [TINT-77] No test function blocks an OB here [AMB-04].                  *)
Bit5 == IF Bit5MeansNoTest THEN 32 ELSE 0

(* [TINT-78] [AMB-80] SFC 34 has no such bit [DINT-16]. *)
\* @type: Int => Set(Int);
ReferenceBit(o) == IF o \notin TodObs THEN {0}
                   ELSE IF Family.openCodes /\ CodesAreOpen
                   THEN {0, 64}  \* [T15-144]
                   ELSE IF ReferenceIsBaseTime THEN {0}
                   ELSE IF ReferenceIsLocalTime THEN {64} ELSE {0, 64}

(* [TINT-72] .. [TINT-79] [DINT-16] STATUS of an OB with these values of   *)
(* bits 0, 1, 2 and 4. A delay by SFC 41 does not show [AIRT-13].          *)
\* @type: (Int, Set(Int), Set(Int), Set(Int), Set(Int)) => Set(Int);
StatusOf(o, bit0, bit1, bit2, bit4) ==
    { a + b + c + d + e + f + Bit5
      : a \in bit0, b \in bit1, c \in bit2, d \in Bit3, e \in bit4,
        f \in ReferenceBit(o) }

(* bit2: its possible values.                                              *)
\* @type: (Int, Set(Int)) => Set(Int);
StatusWithBit2(o, bit2) ==
    StatusOf(o, StartupBit(o), BlockedBit(o), bit2, LoadedBit(o))
=============================================================================
