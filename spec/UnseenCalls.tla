----------------------------- MODULE UnseenCalls ----------------------------
(***************************************************************************)
(* Logs without every call: the program may have set, cancelled, blocked   *)
(* or delayed anything.  A rule is judged if it holds whatever was called: *)
(* modes, classes, loaded OBs, fault ids and their causes.                 *)
(*                                                                         *)
(* Source: docs/checking/log-format.md, fine point 9.                      *)
(* Left out: a call that a line shows changes nothing, since an unseen     *)
(* call may have changed it back.                                          *)
(***************************************************************************)
EXTENDS Trace

-----------------------------------------------------------------------------
(* Effects of unseen calls *)

(* A waiting request may have been cancelled, and a STOP blocked.          *)
\* @type: $event => Bool;
UnseenCall(e) ==
    /\ e.event \in {"start", "run", "stop"}
    /\ \/ \E r \in requests : /\ requests' = Close(requests \ {r})
                              /\ UNCHANGED stopCause
       \/ /\ stopCause \notin {NoCause, DeselectedLoaded}
          /\ stopCause' = NoCause
          /\ UNCHANGED requests
    /\ NothingEntered
    /\ UNCHANGED <<cpu, loaded, mode, startup, clock, tod, dint, irt, stack, delay>>

(* Interrupts that an unseen call may have set or started, and those of    *)
(* them whose OB is missing.                                               *)
SetByCalls == { o \in TodObs \cup DintObs : ~Deselected(o) }
SetAndAbsent == IF Unseen("load") THEN SetByCalls ELSE SetByCalls \ loaded

(* [TINT-11] Between now and t lies a whole minute: a possible point.      *)
\* @type: $moment => Bool;
PassesMinute(t) ==
    Before(IF SecondsAreKept THEN clock
           ELSE At(IF clock.ms = 0 THEN clock.min ELSE clock.min + 1), t)

(* A clock set forward, or a HOLD, may have passed points that an unseen   *)
(* call set.                                                               *)
\* @type: $event => Bool;
SkipsByCall(e) ==
    LET held  == e.event = "release"
        to    == IF held THEN clock ELSE e.to
        fault == IF held THEN SkippedInHold ELSE SkippedByClock
        error == [TimeError(fault, {}, 0, 0) EXCEPT !.since = to, !.open = TRUE]
    IN  /\ \/ held /\ mode = "HOLD"
           \/ e.event = "clock" /\ PassesMinute(to) /\ mode # "STOP"
        /\ mode'  = IF held THEN "RUN" ELSE mode
        /\ clock' = to
        /\ tod'   = [o \in DOMAIN tod |-> Rearmed(o, to, cpu)]
        /\ requests'  = IF TimeErrorOb \in loaded THEN Enter(requests, error)
                        ELSE requests
        /\ stopCause' = IF TimeErrorOb \in loaded THEN stopCause
                        ELSE StopFor(NoTimeErrorOb)
        /\ entered'   = OpenEntries({error})
        /\ UNCHANGED <<cpu, loaded, startup, dint, irt, stack, delay>>

-----------------------------------------------------------------------------
(* Calls that the log shows all the same *)

(* The answers that some setting allows.  Wrong operands are wrong under   *)
(* every setting.                                                          *)
\* @type: $event => Set(Int);
PossibleAnswers(e) ==
    LET ifSet(errors, more) ==
          LET answers == Answers(e.ob, errors)
          IN  IF OK \in answers THEN answers \cup more ELSE answers
    IN  CASE e.event = "CAN_TINT" -> ifSet(ObErrors(e.ob), {NotSet})
          [] e.event = "ACT_TINT" -> ifSet(ObErrors(e.ob), {NotSet, PastStart})
          [] e.event = "CAN_DINT" -> ifSet(DintErrors(e.ob), {NotStarted})
          [] e.event = "DIS_AIRT" -> 1..32767
          [] e.event = "EN_AIRT"  -> (0..32767) \cup {NotDelayed}
          [] OTHER                -> AnswersTo(e)

(* Bits 1 and 2 of STATUS depend on calls. *)
\* @type: Int => Set(Int);
PossibleStatuses(o) ==
    { s + blocked : s \in StatusWithBit2(o, {0, 4}), blocked \in {0, 2} }

\* @type: $event => Bool;
SomeCall(e) ==
    /\ Called
    /\ e.ret = -1 \/ e.ret \in PossibleAnswers(e)
    /\ e.ret = OK /\ e.status # -1 => e.status \in PossibleStatuses(e.ob)
    /\ NothingEntered
    /\ UNCHANGED cpuVars
=============================================================================
