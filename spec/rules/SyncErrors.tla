----------------------------- MODULE SyncErrors -----------------------------
(***************************************************************************)
(* Synchronous errors [IRT-23]: an instruction of the running OB fails,    *)
(* and its error OB, OB 121 or OB 122, is called at once, on top of it and *)
(* in its class (section 5.2). No block of SFC 39 [IRT-05] and no delay    *)
(* [AIRT-10] holds it back; an OB of a higher class may come first. What   *)
(* it calls counts for the delay of the OB below [AMB-24].                 *)
(*                                                                         *)
(* Left out: SFC 36 to 38. An error that they mask is no event.            *)
(***************************************************************************)
EXTENDS StartEvents, Calls

(* [AMB-85] An error OB fails itself.                                      *)
\* @type: Int => Bool;
MayCall(o) == /\ o \in loaded
              /\ Running.ob \in SyncErrorObs =>
                   o # Running.ob /\ OtherErrorObIsCalled
\* @type: Int => Bool;
MayStopFor(o) ==
    \/ o \notin loaded
    \/ Running.ob \in SyncErrorObs /\ (o = Running.ob \/ OtherErrorStops)

\* @type: Int => Int;
CauseOf(o) == IF o = 121 THEN NoProgrammingErrorOb ELSE NoAccessErrorOb

(* The first cause of a STOP counts, unless it waits for the end of a      *)
(* delay [AMB-49].                                                         *)
\* @type: Int => Set(Int);
FirstCauses(cause) ==
    IF StopIsDue THEN {stopCause}
    ELSE IF stopCause = NoCause \/ StopAwaitsTheDelay THEN {cause}
    ELSE {stopCause, cause}

(* [OBS-27] [OBS-63] *)
\* @type: Int => Bool;
StopsForError(cause) ==
    /\ stopCause' \in FirstCauses(cause)
    /\ entered' = IF stopCause' = stopCause THEN {} ELSE {Entry(cause)}
    /\ UNCHANGED <<requests, stack>>

(* [OBS-61] An instruction of the running OB fails. *)
\* @type: Int => Bool;
InstructionFails(o) ==
    /\ Called
    /\ \/ /\ MayCall(o)
          /\ stack' = [stack EXCEPT ![Len(stack)].error = o]
          /\ Nothing
       \/ MayStopFor(o) /\ StopsForError(CauseOf(o))
    /\ UNCHANGED <<deviceVars, modeVars, clock, settingVars, delay>>

(* The error OB is still to start. *)
ErrorObIsDue == Failed /\ Watching

(* [OBS-61] [OBS-62] [IRT-05] [AIRT-10] The error OB starts.               *)
\* @type: Int => Bool;
ErrorObStarts(o) ==
    /\ ErrorObIsDue /\ Running.error = o
    /\ stack' = Append([stack EXCEPT ![Len(stack)].error = 0],
                       Frame(o, Running.class))
    /\ NothingEntered
    /\ UNCHANGED <<deviceVars, modeVars, clock, settingVars, outcomeVars,
                   delay>>
=============================================================================
