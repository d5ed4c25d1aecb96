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

(* [T15-63] The class in which an error OB runs.                           *)
\* @type: Int => Int;
ClassOfErrorOb(o) == IF Family.inherits THEN Running.class ELSE ClassOf(o)

(* [T15-63] [A15-23] An error OB of its own class, which is not above that *)
(* of the OB at fault: it runs at once, or waits for its turn.             *)
\* @type: Int => Bool;
IsNotAbove(o) == ~Family.inherits /\ ClassOf(o) <= Running.class
\* @type: Int => Bool;
AwaitsItsTurn(o) == IsNotAbove(o) /\ LowErrorObAwaitsItsTurn
\* @type: Int => Bool;
MayAwaitItsTurn(o) ==
    o \in loaded /\ IsNotAbove(o) /\ ~LowErrorObRunsAtOnce

(* [T15-111] Without OB 122 an access error is ignored.                    *)
\* @type: Int => Bool;
IsIgnored(o) == ~Family.stops /\ o = 122 /\ o \notin loaded

(* [AMB-85] An error OB fails itself.                                      *)
\* @type: Int => Bool;
MayCall(o) == /\ o \in loaded
              /\ ~AwaitsItsTurn(o)
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
            /\ ~IsIgnored(o)
       \/ IsIgnored(o) /\ Nothing /\ UNCHANGED stack
       \/ /\ MayAwaitItsTurn(o)
          /\ Ordinary(ExternalRequest(o, 0)) /\ UNCHANGED stack
    /\ UNCHANGED <<deviceVars, modeVars, clock, settingVars, delay>>

(* The error OB is still to start. *)
ErrorObIsDue == Failed /\ Watching

(* [OBS-61] [OBS-62] [IRT-05] [AIRT-10] The error OB starts.               *)
\* @type: Int => Bool;
ErrorObStarts(o) ==
    /\ ErrorObIsDue /\ Running.error = o
    /\ stack' = Append([stack EXCEPT ![Len(stack)].error = 0],
                       Frame(o, ClassOfErrorOb(o)))
    /\ NothingEntered
    /\ UNCHANGED <<deviceVars, modeVars, clock, settingVars, outcomeVars,
                   delay>>
=============================================================================
