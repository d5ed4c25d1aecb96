------------------------------- MODULE Lines --------------------------------
(***************************************************************************)
(* The action that a line of a log stands for.                             *)
(*                                                                         *)
(* Source: docs/checking/log-format.md, events; fine points 6 to 8 and 10. *)
(* Left out: lines of kinds that the log does not have completely          *)
(* (PartialLogs).                                                          *)
(***************************************************************************)
EXTENDS Airt, Irt, TimeOfDay, TimeDelay, Modes, Elapsing

-----------------------------------------------------------------------------
(* Calls *)

CallEvents == {"SET_TINT", "SET_TINTL", "CAN_TINT", "ACT_TINT", "QRY_TINT",
               "SRT_DINT", "CAN_DINT", "QRY_DINT",
               "DIS_IRT", "EN_IRT", "DIS_AIRT", "EN_AIRT"}

(* The values that RET_VAL may have.                                       *)
\* @type: $event => Set(Int);
AnswersTo(e) ==
    CASE e.event = "SET_TINT" ->
           SetTintAnswers(e.ob, e.sdt, e.period)
      [] e.event = "SET_TINTL" ->
           SetLocalAnswers(e.ob, e.sdt, e.local = 1, e.period)
      [] e.event = "CAN_TINT" -> CanAnswers(e.ob)
      [] e.event = "ACT_TINT" -> ActAnswers(e.ob)
      [] e.event = "QRY_TINT" -> QryAnswers(e.ob)
      [] e.event = "SRT_DINT" -> SrtAnswers(e.ob, e.dtime)
      [] e.event = "CAN_DINT" -> CanDintAnswers(e.ob)
      [] e.event = "QRY_DINT" -> QryDintAnswers(e.ob)
      [] e.event = "DIS_IRT"  -> DisIrtAnswers(e.mode, e.ob)
      [] e.event = "EN_IRT"   -> EnIrtAnswers(e.mode, e.ob)
      [] e.event = "DIS_AIRT" -> DisAirtAnswers(delay)
      [] OTHER                -> EnAirtAnswers(delay)

(* The values that STATUS may have.                                        *)
\* @type: $event => Set(Int);
StatusesOf(e) == IF e.event = "QRY_TINT" THEN Statuses(e.ob)
                                         ELSE DintStatuses(e.ob)

(* The call of the line, with this RET_VAL.                                *)
\* @type: ($event, Int) => Bool;
Answered(e, ret) ==
    CASE e.event = "SET_TINT" -> SetTint(e.ob, e.sdt, e.period, ret)
      [] e.event = "SET_TINTL" ->
           SetTintL(e.ob, e.sdt, e.local = 1, e.period, e.activate = 1, ret)
      [] e.event = "CAN_TINT" -> CanTint(e.ob, ret)
      [] e.event = "ACT_TINT" -> ActTint(e.ob, ret)
      [] e.event = "QRY_TINT" -> QryTint(e.ob, ret, e.status)
      [] e.event = "SRT_DINT" -> SrtDint(e.ob, e.dtime, e.sign, ret)
      [] e.event = "CAN_DINT" -> CanDint(e.ob, ret)
      [] e.event = "QRY_DINT" -> QryDint(e.ob, ret, e.status)
      [] e.event = "DIS_IRT"  -> DisIrt(e.mode, e.ob, ret)
      [] e.event = "EN_IRT"   -> EnIrt(e.mode, e.ob, ret)
      [] e.event = "DIS_AIRT" -> DisAirt
      [] OTHER                -> EnAirt

(* [AMB-81] A general error; where the answer is not in the log, one of    *)
(* them stands for any.                                                    *)
\* @type: $event => Set(Int);
FailuresOf(e) == IF ~CallsMayFail THEN {}
                 ELSE {IF IsGeneralError(e.ret) THEN e.ret ELSE \h8122}

\* @type: $event => Bool;
IsCall(e) ==
    /\ Called
    /\ \E ret \in Given(e.ret, AnswersTo(e) \cup FailuresOf(e)) :
         IF IsGeneralError(ret) THEN Fails(ret)
         ELSE ret \in AnswersTo(e) /\ Answered(e, ret)

-----------------------------------------------------------------------------
(* Starts, and events from outside *)

(* Table 7.5: the first OB 1 after a restart has another event than the    *)
(* following ones. After a hot restart it may also follow the cycle that   *)
(* has gone on. If a log begins in RUN, its first OB 1 may have any, but   *)
(* not behind an end of OB 1.                                              *)
(* [T15-134] An S7-1500 has two of them, one for the first OB 1.           *)
CycleEvents == CASE first = "warm" -> {1}
                 [] first = "cold" -> {4}
                 [] first = "hot"  -> {2, 3}
                 [] first = "none" -> {3}
                 [] Family.byKind  -> {1, 3}
                 [] OTHER          -> 1..4

(* The OB starts by one of many open requests; others may remain. *)
\* @type: $request => Bool;
StartsAgain(r) ==
    IF LastCall(r) \/ terms.crowds[AsItCame(r)] = 1 THEN Start(r)
    ELSE /\ MayStart(r) /\ r.ob \in loaded
         /\ stack' = Append(stack, Frame(r.ob, r.class))
         /\ requests' = (requests \ {r}) \cup {[r EXCEPT !.open = TRUE]}
         /\ NothingEntered
         /\ UNCHANGED <<deviceVars, modeVars, clock, settingVars, delay,
                        stopCause>>

(* OB 1 starts, or another cycle OB, of whose event nothing is told.       *)
\* @type: $event => Bool;
IsCycleStart(e) ==
    /\ Fits(e.info.priority, 1)
    /\ e.info.strt_info \in {-1} \cup (IF e.ob = CycleOb THEN CycleEvents
                                      ELSE {1, 3})
    /\ e.info.time = NoMoment \/ JustBefore(e.info.time, e)
    /\ \/ CycleStarts(e.ob)
       \* The end of the cycle before lies unseen, but not in HOLD [OBS-45].
       \/ /\ ~terms.cycle /\ stack = <<Frame(CycleOb, 1)>>
          /\ e.ob = CycleOb /\ mode = "RUN"
          /\ delay' = 0
          /\ NothingEntered
          /\ UNCHANGED <<deviceVars, modeVars, clock, settingVars,
                         outcomeVars, stack>>

(* [OBS-61] The error came before the line, perhaps before the clock was   *)
(* set.                                                                    *)
\* @type: $event => Bool;
FitsFailed(e) == /\ Fits(e.info.priority, ClassOfErrorOb(e.ob))
                 /\ changes # {} \/ ~Before(EndOfStep(e), e.info.time)

\* @type: $event => Bool;
IsStart(e) ==
    CASE e.ob \in CycleObs -> IsCycleStart(e)
      [] e.ob \in StartupObs ->
           /\ Fits(e.info.priority, StartupClass)
           /\ e.info.strt_info \in {-1} \cup (CASE e.ob = 101 -> \h83..\h84
                                                [] e.ob = 102 -> \h85..\h86
                                                [] OTHER      -> \h81..\h82)
           /\ e.info.time = NoMoment \/ JustBefore(e.info.time, e)
           /\ StartupStarts(e.ob)
      [] e.ob \in SyncErrorObs ->
           \/ ErrorObStarts(e.ob) /\ FitsFailed(e)
           \/ \E r \in { q \in requests : q.ob = e.ob /\ FitsRequest(q, e) } :
                HighestFirst(r) /\ Start(r)  \* [T15-63]
      [] OTHER ->
           \E r \in FirstAndLast({ q \in requests :
                                  q.ob = e.ob /\ FitsRequest(q, e) }) :
             HighestFirst(r) /\ IF IsCrowd(r) THEN StartsAgain(r) ELSE Start(r)

(* [OBS-61] An error OB starts, and its error is unseen.                   *)
\* @type: $event => Bool;
ErrorObStartsUnseen(e) ==
    /\ e.ob \in SyncErrorObs /\ Called
    /\ e.ob \in loaded \/ Unseen("load")
    /\ \/ Unseen("ob") \/ Unseen("mode")
       \/ FitsFailed(e) /\ Running.ob # e.ob
    /\ stack' = IF Unseen("ob") THEN stack
                ELSE Append(stack, Frame(e.ob, ClassOfErrorOb(e.ob)))
    /\ NothingEntered
    /\ UNCHANGED <<deviceVars, modeVars, clock, settingVars, outcomeVars,
                   delay>>

(* A line that sets the clock to its own reading changes nothing.          *)
\* @type: $event => Bool;
IsClock(e) ==
    IF e.to = clock THEN UNCHANGED cpuVars /\ NothingEntered
    ELSE ClockSet(e.to)

(* So does one that sets local time to what it is.                         *)
\* @type: $event => Bool;
IsZone(e) ==
    IF e.zone = cpu.zone THEN UNCHANGED cpuVars /\ NothingEntered
    ELSE LocalTimeSet(e.zone, e.reason = "daylight")

(* Nobody knows whether the OB waits already. All outcomes are possible:   *)
(* those of a waiting OB and those of an idle one.                         *)
\* @type: Int => Bool;
AgainOrNot(o) ==
    LET new == ExternalRequest(o, 0)
    IN  /\ \/ AnyEffect(new)
           \/ /\ TimeErrorOb \notin loaded \/ Blocked(TimeErrorOb)
              /\ Overflows(new)
        /\ UNCHANGED <<deviceVars, modeVars, clock, settingVars, runVars>>

\* @type: Int => Bool;
NotSureToWait(o) ==
    /\ o \in terms.unsure /\ OpenIn(requests, o) /\ ~PendingIn(requests, o)
    /\ mode = "RUN" /\ o \notin AsyncErrorObs /\ TakesEvents(o) /\ ~OnStack(o)

(* A fault that only the rules cause does not come from outside, unless    *)
(* the log may miss its cause. [T15-11] Nor does the start event of an OB  *)
(* from 123 on, but of a cyclic or hardware OB.                            *)
\* @type: $event => Bool;
IsInterrupt(e) ==
    /\ e.ob \in NumberedObs => e.ob \in ExternalObs
    /\ e.flt_id \in FaultsOfRules => Partial
    /\ IF e.ob \in SyncErrorObs THEN InstructionFails(e.ob)
       ELSE IF NotSureToWait(e.ob) THEN AgainOrNot(e.ob)
       ELSE Interrupt(e.ob, IF e.flt_id = -1 THEN 0 ELSE e.flt_id)

(* The CPU has to stop for this cause, or had to before this delay.        *)
(* [OBS-26] The cycle time may be exceeded twice in a cycle if OB 80 is    *)
(* loaded.                                                                 *)
\* @type: Int => Bool;
CauseHolds(cause) ==
    \/ /\ stopCause = cause
       /\ StopIsDue \/ ~StopAwaitsTheDelay \/ StopDuty \in DOMAIN waiting
    \/ cause = NoTimeErrorOb /\ overruns = 2
    \/ Partial /\ stopCause \in {NoCause, OtherErrorOb}

(* The switch may be turned at any time; in STOP it has no effect.         *)
\* @type: $event => Bool;
IsStop(e) ==
    /\ e.cause \in CausesOfRules => CauseHolds(e.cause)
    /\ IF mode = "STOP" THEN UNCHANGED cpuVars /\ NothingEntered
       ELSE Stop \/ (ExceededTwice /\ StopForCycleTime)

-----------------------------------------------------------------------------
(* Lines that show the state of an OB *)

\* @type: (Int, Bool) => Bool;
FitsTruth(given, value) == given \in {-1, IF value THEN 1 ELSE 0}

(* [OBS-60] As bit 2 of STATUS.                                            *)
\* @type: $event => Bool;
FitsActive(e) ==
    CASE e.active = -1     -> TRUE
      [] e.ob \in TodObs  ->
           e.active \in { (s \div 4) % 2 : s \in Statuses(e.ob) }
      [] e.ob \in DintObs ->
           /\ Ended(e.ob)
           /\ e.active \in { (s \div 4) % 2 : s \in DintStatuses(e.ob) }
      [] OTHER            -> TRUE

(* [DINT-17] While a delay runs; as exact as its end [DINT-06].            *)
\* @type: $event => Bool;
FitsLeft(e) ==
    IF e.left = -1 \/ e.ob \notin DintObs THEN TRUE
    ELSE \/ ~dint[e.ob].started \/ dint[e.ob].left < 0
         \/ dint[e.ob].left - e.left \in (1 - e.step)..e.step

(* [OBS-60] [IRT-20] The state of an OB, as the CPU reports it. *)
\* @type: $event => Bool;
FitsState(e) ==
    /\ FitsTruth(e.loaded, e.ob \in loaded)
    /\ mode # "STOP" /\ ~Unseen("call") =>
         /\ FitsTruth(e.blocked, Blocked(e.ob))
         /\ FitsTruth(e.entries_off, Silenced(e.ob))
         /\ FitsActive(e)
         /\ FitsLeft(e)

\* @type: $event => Bool;
IsState(e) == FitsState(e) /\ UNCHANGED cpuVars /\ NothingEntered

-----------------------------------------------------------------------------
(* The clock and the counter of elapsed time *)

(* Two oscillators differ by at most 1 % and a second; a clock that is     *)
(* written in seconds or minutes by one step more.                         *)
\* @type: (Int, Int, Int) => Bool;
Agree(a, b, step) ==
    /\ a - b <= a \div 100 + 1000 + step
    /\ b - a <= b \div 100 + 1000 + step

(* [CLK-01] Only a `clock' event makes the clock jump. Beyond 11 days      *)
(* minutes are compared: TLC's integers have 32 bits.                      *)
\* @type: $event => Bool;
KeepsPace(e) ==
    \/ e.counter = NoMoment \/ pace.up = NoMoment \/ Unseen("clock")
    \/ LET step == IF pace.step > e.step THEN pace.step ELSE e.step
           ms   == Agree(Span(pace.clock, e.at), Span(pace.up, e.counter),
                         IF step = 1 THEN 0 ELSE step)
           a    == e.at.min - pace.clock.min
           b    == e.counter.min - pace.up.min
       IN  IF a <= 16000 /\ b <= 16000 THEN ms
           ELSE a - b <= a \div 100 + 1 /\ b - a <= b \div 100 + 1

\* @type: $event => Bool;
NextPace(e) ==
    pace' = IF e.counter # NoMoment
            THEN [ clock |-> clock', up |-> e.counter, step |-> e.step,
                   reads |-> IF e.event = "clock" THEN e.to
                             ELSE ByCounter(e) ]
            ELSE IF e.event # "clock" THEN pace
            ELSE [ pace EXCEPT
                     !.clock = IF pace.up = NoMoment THEN @
                               ELSE Shifted(@, e.at, e.to),
                     !.step  = IF e.step > @ THEN e.step ELSE @,
                     !.reads = Shifted(@, e.at, e.to) ]

-----------------------------------------------------------------------------

(* The crowd by one of whose requests the OB has started.                  *)
\* @type: $event => Set($request);
StartedAgain(e) ==
    IF e.event # "start" \/ DOMAIN terms.crowds = {} THEN {}
    ELSE { r \in requests :
             /\ r.ob = e.ob /\ IsCrowd(r) /\ FitsRequest(r, e)
             /\ terms.crowds[AsItCame(r)] > 1
             /\ requests' = (requests \ {r}) \cup {[r EXCEPT !.open = TRUE]} }

(* It stands for one request less, if only one crowd comes into question.  *)
(* [T15-69] A queue drops a start event, or may drop it; a run shows how   *)
(* many were dropped.                                                      *)
\* @type: $event => Bool;
NextTerms(e) ==
    LET again == StartedAgain(e)
        \* @type: Set($request) => Int;
        held(q) == Cardinality({ r \in q : r.ob = e.ob /\ ~r.open })
        drops == \/ OpenIn(requests, e.ob)
                 \/ held(requests') = held(requests)
    IN  CASE Cardinality(again) = 1 ->
               terms' = [ terms EXCEPT !.crowds =
                            [ k \in DOMAIN @ |->
                                IF \E r \in again : k = AsItCame(r)
                                THEN @[k] - 1 ELSE @[k] ] ]
          [] e.event = "interrupt" /\ HasQueue(e.ob) ->
               terms' = [ terms EXCEPT !.dropped[e.ob] =
                            @ + (IF drops THEN 1 ELSE 0) ]
          [] e.event = "start" /\ e.info.event_count > 0 /\ HasQueue(e.ob) ->
               terms' = [ terms EXCEPT !.dropped[e.ob] =
                            @ - e.info.event_count ]
          [] OTHER -> UNCHANGED terms

(* [AMB-69] (b) A call or the start of OB 1 while another OB may start.    *)
\* @type: $event => Bool;
StandsBefore(e) ==
    /\ NothingStandsBefore
    /\ e.event \in CallEvents \/ (e.event = "start" /\ e.ob \in CycleObs)
    /\ \E r \in requests : ~r.open /\ MayStart(r)

\* @type: $event => Bool;
Shows(e) ==
    /\ ~StandsBefore(e)
    /\ CASE e.event \in CallEvents -> IsCall(e)
         [] e.event = "start"      -> IsStart(e)
         [] e.event = "end"        -> End(e.ob)
         [] e.event = "interrupt"  -> IsInterrupt(e)
         [] e.event = "clock"      -> IsClock(e)
         [] e.event = "zone"       -> IsZone(e)
         [] e.event = "load"       -> LoadedAre(loaded \cup {e.ob})
         [] e.event = "delete"     -> LoadedAre(loaded \ {e.ob})
         [] e.event = "restart"    -> Restart(e.type)
         \* [OBS-22] [OBS-25]
         [] e.event = "run"        -> Run /\ stopCause = NoCause
         [] e.event = "hold"       -> Hold
         [] e.event = "release"    -> Release
         [] e.event = "stop"       -> IsStop(e)
         [] e.event = "diag"       -> IsEntry(e)
         [] e.event = "state"      -> IsState(e)
         \* The log ends: nothing is missing up to this moment.
         [] e.event = "done"       -> UNCHANGED cpuVars /\ NothingEntered
    /\ IF e.event = "diag" THEN UNCHANGED <<waiting, eventVars>> ELSE Rewait
    /\ NextTerms(e)
    /\ UNCHANGED up
=============================================================================
