----------------------------- MODULE Unrecorded -----------------------------
(***************************************************************************)
(* Logs that leave kinds of event out (`records' of the header): what is   *)
(* not recorded may happen unseen at any point.                            *)
(*                                                                         *)
(* OBs and modes that change unseen are the actions of the specification,  *)
(* tried at every point.  Start events from outside and blocks that are    *)
(* loaded or deleted are tried just before a line that they may explain:   *)
(* earlier would not explain more.  Where calls are not recorded, what the *)
(* program has set is unknown, and what holds whatever it was is judged:   *)
(* modes, classes, loaded OBs, fault ids and their causes.                 *)
(*                                                                         *)
(* Left out: several changes of the clock between two lines; a block that  *)
(* is loaded or deleted and has no effect on the next line.                *)
(***************************************************************************)
EXTENDS Trace

(* Whether lines of this kind may be missing. *)
\* @type: Str => Bool;
Unseen(kind) == kind \notin terms.records

Kinds == {"call", "ob", "clock", "mode", "interrupt", "load"}
Partial == ~(Kinds \subseteq terms.records)

-----------------------------------------------------------------------------
(* OBs and modes *)

UnseenOb == \/ \E r \in requests : Start(r)
            \/ End(Running.ob)

UnseenMode == \/ \E type \in {"warm", "cold"} : Restart(type)
              \/ Run /\ stopCause = NoCause
              \/ Stop \/ Hold \/ Release

-----------------------------------------------------------------------------
(* Start events from outside *)

(* The fault ids that a line about OB 80 or OB 85 tells, or the unknown one. *)
\* @type: $event => Int;
ToldFault(e) == IF e.event = "diag" THEN e.id - ErrorEntry
                ELSE IF e.info.flt_id # -1 THEN e.info.flt_id ELSE UnknownFault

(* Of OBs that would explain the line alike one is enough. *)
\* @type: ($event, Set(Int)) => Set(Int);
OneOf(e, obs) == IF e.info.ev # -1 THEN { o \in obs : EventOf(o) = e.info.ev }
                 ELSE IF obs = {} THEN {} ELSE {Least(obs)}

(* The start events that may have led to the line: that of its own OB, and  *)
(* those whose OB is missing, runs or waits, which lead to an error.       *)
\* @type: $event => Set(<<Int, Int>>);
MayHaveCome(e) ==
    LET faulty  == {TimeErrorOb, ProgramErrorOb}
        others  == ExternalObs \ faulty
        telling == \/ e.event \in {"stop", "diag"}
                   \/ e.event = "start" /\ e.ob \in faulty
    IN  (IF e.event \in {"start", "diag"} /\ e.ob \in others THEN {e.ob} \X {0} ELSE {})
          \cup (IF ~telling THEN {}
                ELSE (faulty \X {ToldFault(e)})
                       \cup (OneOf(e, IF Unseen("load") THEN others
                                      ELSE others \ loaded) \X {0})
                       \cup (OneOf(e, { o \in others :
                                          OnStack(o) \/ PendingIn(requests, o) })
                              \X {0}))

\* @type: $event => Bool;
UnseenInterrupt(e) ==
    \E i \in { j \in MayHaveCome(e) :
                 /\ { r \in requests : r.ob = j[1] \/ r.cause = j[1] } = {}
                 /\ { r \in reports : FitsEntry(r.entry, e) } = {}
                 /\ stopCause = NoCause } :
      Interrupt(i[1], i[2])

-----------------------------------------------------------------------------
(* Blocks that are loaded or deleted *)

(* The OBs on which the line depends. *)
\* @type: $event => Set(Int);
DependsOn(e) ==
    CASE e.event = "start"  ->
           {e.ob} \cup (IF e.ob = ProgramErrorOb THEN { r.ob : r \in requests }
                        ELSE {})
      [] e.event \in {"QRY_TINT", "QRY_DINT"} -> {e.ob}
      [] e.event \in {"stop", "diag"} ->
           { r.ob : r \in requests } \cup {TimeErrorOb, ProgramErrorOb}
      [] e.event = "run"    -> StartupObs
      [] OTHER              -> {}

\* @type: $event => Bool;
UnseenLoad(e) ==
    \E o \in DependsOn(e) :
      LoadedAre(IF o \in loaded THEN loaded \ {o} ELSE loaded \cup {o})

-----------------------------------------------------------------------------
(* Calls *)

(* What waits may have been cancelled, and a STOP blocked. *)
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

(* Interrupts that the program may have set or started, and those of them   *)
(* whose OB is missing.                                                    *)
SetByCalls == { o \in TodObs \cup DintObs : ~Deselected(o) }
SetAndAbsent == IF Unseen("load") THEN SetByCalls ELSE SetByCalls \ loaded

(* A start event that a call may have led to, or an error that follows it;  *)
(* what is not known of it fits whatever the line says.                    *)
\* @type: $event => Set($request);
MayHaveBeenSet(e) ==
    LET f == ToldFault(e)
        known == [ NoRequest EXCEPT !.ob = e.ob, !.fault = f, !.word = -1,
                                    !.dtime = -1, !.during = -1 ]
        error == [known EXCEPT !.class = ErrorClass(e.ob, f)]
    IN  IF e.ob \in SetByCalls
        THEN { [known EXCEPT !.class = ClassOf(e.ob), !.fault = 0] }
        ELSE IF e.ob = TimeErrorOb
                  /\ f \in {UnknownFault, StillRunning, BufferOverflow}
        THEN { [error EXCEPT !.cause = o] : o \in SetByCalls }
        ELSE IF e.ob = ProgramErrorOb /\ f \in {UnknownFault} \cup ObNotLoaded
        THEN { [error EXCEPT !.cause = o] : o \in SetAndAbsent }
        ELSE {}

\* @type: $event => Bool;
StartsByCall(e) ==
    \E r \in { q \in MayHaveBeenSet(e) : FitsRequest(q, e.info) } :
      /\ e.event = "start"
      /\ ModeAllows(r) /\ Preempts(r)
      /\ r.ob \in loaded
      /\ stack' = Append(stack, Frame(r.ob, r.class))
      /\ NothingEntered
      /\ UNCHANGED <<cpu, loaded, mode, startup, clock, tod, dint, irt, requests,
                     delay, stopCause>>

(* A clock set forward, or a HOLD, may have passed points that a call set.   *)
\* @type: $event => Bool;
SkipsByCall(e) ==
    LET held  == e.event = "release"
        to    == IF held THEN clock ELSE e.to
        fault == IF held THEN SkippedInHold ELSE SkippedByClock
        error == [TimeError(fault, {}, 0, 0) EXCEPT !.since = to, !.open = TRUE]
    IN  /\ \/ held /\ mode = "HOLD"
           \/ e.event = "clock" /\ Before(clock, to) /\ mode # "STOP"
        /\ mode'  = IF held THEN "RUN" ELSE mode
        /\ clock' = to
        /\ tod'   = Rearmed(to, "a")
        /\ requests'  = IF TimeErrorOb \in loaded THEN Enter(requests, error)
                        ELSE requests
        /\ stopCause' = IF TimeErrorOb \in loaded THEN stopCause
                        ELSE StopFor(NoTimeErrorOb)
        /\ entered'   = OpenEntries({error})
        /\ UNCHANGED <<cpu, loaded, startup, dint, irt, stack, delay>>

(* The answers that some setting allows; wrong operands are wrong whatever   *)
(* is set.                                                                 *)
\* @type: $event => Set(Int);
PossibleAnswers(e) ==
    LET tod1  == Answers(e.ob, ObErrors(e.ob))
        dint1 == Answers(e.ob, DintErrors(e.ob))
        ifSet(answers, more) == IF OK \in answers THEN answers \cup more ELSE answers
    IN  CASE e.event = "SET_TINT" -> Answers(e.ob, SetErrors(e.ob, e.sdt, e.period))
          [] e.event = "CAN_TINT" -> ifSet(tod1, {NotSet})
          [] e.event = "ACT_TINT" -> ifSet(tod1, {NotSet, PastStart})
          [] e.event = "QRY_TINT" -> tod1
          [] e.event = "SRT_DINT" -> Answers(e.ob, SrtErrors(e.ob, e.dtime))
          [] e.event = "CAN_DINT" -> ifSet(dint1, {NotStarted})
          [] e.event = "QRY_DINT" -> dint1
          [] e.event = "DIS_IRT"  -> Usual(IrtErrors(e.mode, e.ob, DisModes))
          [] e.event = "EN_IRT"   -> Usual(IrtErrors(e.mode, e.ob, EnModes))
          [] e.event = "DIS_AIRT" -> 1..32767
          [] OTHER                -> (0..32767) \cup {NotDelayed}

(* Bits 1 and 2 of STATUS depend on calls. *)
\* @type: Int => Set(Int);
PossibleStatuses(o) ==
    { s + blocked : s \in StatusWithBit2(o, {0, 4}), blocked \in {0, 2} }

CallEvents == {"SET_TINT", "CAN_TINT", "ACT_TINT", "QRY_TINT", "SRT_DINT",
               "CAN_DINT", "QRY_DINT", "DIS_IRT", "EN_IRT", "DIS_AIRT", "EN_AIRT"}

(* What a call sets is not noted: another may have changed it unseen. *)
\* @type: $event => Bool;
SomeCall(e) ==
    /\ Called
    /\ e.ret = -1 \/ e.ret \in PossibleAnswers(e)
    /\ e.ret = OK /\ e.status # -1 => e.status \in PossibleStatuses(e.ob)
    /\ NothingEntered
    /\ UNCHANGED cpuVars

\* @type: $event => Bool;
EntersByCall(e) ==
    /\ e.event = "diag"
    /\ \/ e.id \in {EntriesDisabled, ErrorEntry + StillRunning,
                    ErrorEntry + BufferOverflow}
       \/ e.id - ErrorEntry \in ObNotLoaded /\ SetAndAbsent # {}
       \/ e.id = NoTimeErrorOb /\ TimeErrorOb \notin loaded
       \/ e.id = NoProgramErrorOb /\ ProgramErrorOb \notin loaded
    /\ NothingEntered
    /\ UNCHANGED cpuVars

(* A STOP for a missing OB does not come where the OB is loaded. *)
\* @type: $event => Bool;
CauseIsPossible(e) ==
    e.event = "stop" =>
      /\ e.cause = NoTimeErrorOb => TimeErrorOb \notin loaded
      /\ e.cause = NoProgramErrorOb => ProgramErrorOb \notin loaded

\* @type: $event => Bool;
ShowsByCall(e) ==
    \/ /\ \/ e.event \in CallEvents /\ SomeCall(e)
          \/ StartsByCall(e)
          \/ SkipsByCall(e)
          \/ EntersByCall(e)
       /\ Rewait
       /\ UNCHANGED <<terms, up>>
    \/ /\ e.event \notin CallEvents
       /\ CauseIsPossible(e)
       /\ Shows(e)

-----------------------------------------------------------------------------
(* The clock *)

(* What the clock would show at the line, had it not been set.  Readings of  *)
(* two clocks may differ by a millisecond.                                 *)
\* @type: $event => $moment;
Undisturbed(e) == Shifted(clock, up, e.up)

\* @type: $event => Bool;
Jumps(e) == /\ Unseen("clock")
            /\ e.at # Undisturbed(e)
            /\ After(e.at, 1) # Undisturbed(e) /\ After(Undisturbed(e), 1) # e.at

\* @type: $event => Bool;
UnseenClock(e) == ClockSet(Shifted(e.at, e.up, up))

-----------------------------------------------------------------------------
(* The operators of the trace checker's engine *)

\* @type: $event => Bool;
Elapse(e) ==
    IF ~Partial THEN Towards(e)
    ELSE \/ IF ~Jumps(e) THEN Towards(e)
            ELSE up # e.up /\ Towards([e EXCEPT !.at = Undisturbed(e)])
         \/ /\ \/ Jumps(e) /\ UnseenClock(e)
               \/ Unseen("ob") /\ UnseenOb
               \/ Unseen("mode") /\ UnseenMode
            /\ Rewait
            /\ UNCHANGED <<terms, up>>

\* @type: $event => Bool;
Silent(e) ==
    \/ HiddenBefore(e)
    \/ /\ Partial
       /\ \/ Unseen("ob") /\ UnseenOb
          \/ Unseen("mode") /\ UnseenMode
          \/ Unseen("interrupt") /\ UnseenInterrupt(e)
          \/ Unseen("load") /\ UnseenLoad(e)
          \/ Unseen("call") /\ UnseenCall(e)
       /\ Rewait
       /\ UNCHANGED <<terms, up>>

(* Cheap to evaluate: may a silent step be possible? *)
\* @type: $event => Bool;
Stirs(e) == HidesBefore(e) \/ Partial

\* @type: $event => Bool;
Observe(e) == IF Unseen("call") THEN ShowsByCall(e) ELSE Shows(e)

Next == Silent(NoEvent)
=============================================================================
