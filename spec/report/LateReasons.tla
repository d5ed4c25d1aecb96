----------------------------- MODULE LateReasons ----------------------------
(***************************************************************************)
(* Reasons why a line comes too late: something had to come before it. The *)
(* engine asks for them in the states in which time could not go on.       *)
(*                                                                         *)
(* Source: requirements, sections 1 to 6;                                  *)
(* docs/checking/log-format.md, fine point 1.                              *)
(* Left out: nothing.                                                      *)
(***************************************************************************)
EXTENDS TimeReasons

Due == { r \in requests : MayStart(r) /\ ~r.open }

(* The due requests that are late by this line. *)
\* @type: $event => Set($request);
Late(e) ==
    { r \in Due : /\ WaitsAs(r) \in DOMAIN waiting
                  /\ waiting[WaitsAs(r)] + Span(up, e.up) > terms.latency }

\* @type: $event => Set($report);
ReportsLate(e) == EntriesLate(Span(up, e.up))

-----------------------------------------------------------------------------
(* Late OBs *)

(* The OB was held back until now, or was held back wrongly. *)
\* @type: ($request, Seq($event)) => Set(Str);
HeldBack(r, past) ==
    LET last  == LastStart(past, r.ob)
        delayed == LastOf(past, {"DIS_AIRT"})
    IN  ThoughNotBlocked(past, r.ob)
          \cup When(delayed > last, {"AIRT-02", "AIRT-08"})
          \cup When(/\ delayed > last
                    /\ LastOf(past, {"EN_AIRT"}) < LastOf(past, {"end"}),
                    {"AIRT-04"})
          \cup When(r.ob \in DOMAIN cpu.priority, {"OBS-05"})
          \cup When(Running.ob \notin {0, CycleOb} \cup StartupObs, {"OBS-01"})
          \cup When(/\ past # <<>> /\ past[Len(past)].event = "end"
                    /\ ~Before(past[Len(past)].at, r.since), {"OBS-03"})

\* @type: ($request, Seq($event)) => Set(Str);
LateTod(r, past) ==
    LET o    == r.ob
        last == LastStart(past, o)
        act  == LastWith(past, {"ACT_TINT"}, o)
        special ==
          SinceRun(past, o, last)
            \cup When(ClockWasSet(past, last) < 0, SinceClock(past, last))
            \cup When(cpu.step7[o].execution = "once" /\ last = 0, {"OBS-56"})
            \cup When(Blocked(o) \/ LastIn(IrtLines(past, o)) > last,
                      {"IRT-18"})
            \cup When(~TodCallsWithdrawRuns, {"TINT-50"})
            \cup When(~SecondRequestIsOpen, {"OBS-07"})
            \cup When(act > 0 /\ past[act].ret = -1, {"TINT-60"})
            \cup HeldBack(r, past)
    IN  special \cup Step7Requirements(o, past)
          \cup (IF HasOnePoint(r.word) THEN {"TINT-23"} ELSE {"TINT-09"})
          \cup When(special = {},
                    {"TINT-23"} \cup SeriesRequirements(o, r.word, past))

\* @type: ($request, Seq($event)) => Set(Str);
LateDint(r, past) ==
    {"DINT-06"} \cup (SinceRun(past, r.ob, LastStart(past, r.ob))
                       \ {"DINT-19"})
                \cup OfDelay(r.ob, past)
                \cup When(dint[r.ob].started
                            \/ LastWith(past, {"CAN_DINT"}, r.ob) > 0,
                          {"DINT-15"})
                \cup When(dint[r.ob].started, {"DINT-08"})
                \cup When(OfDelay(r.ob, past) = {}, {"DINT-03"})

\* @type: ($request, Seq($event)) => Set(Str);
LateRequirement(r, past) ==
    CASE r.ob \notin loaded          ->
           IF r.ob \in AsyncErrorObs THEN {"OBS-23", "OBS-21"}
           ELSE {"OBS-20"} \cup When(r.ob \in TodObs, {"TINT-16"})
                  \cup When(r.ob \in DintObs, {"DINT-09"})
                  \cup When(ProgramErrorOb \notin loaded, {"OBS-21"})
      [] r.follows = SkippedInHold   -> {"CLK-03", "OBS-46"}
      [] r.follows = SkippedByClock  -> {"CLK-03"}
      [] r.follows = StillRunning    ->
           When(r.ob \in TodObs, {"TINT-14"})
             \cup When(r.ob \in DintObs, {"DINT-10"})
             \cup When(LastIn(IrtLines(past, TimeErrorOb)) > 0, {"OBS-33"})
      [] r.ob \in DintObs            ->
           LateDint(r, past) \cup HeldBack(r, past)
      [] r.ob \in TodObs             -> LateTod(r, past)
      [] r.fault = SkippedByClock    -> {"CLK-02"} \cup HeldBack(r, past)
      [] r.fault = SkippedInHold     -> {"OBS-46"}
      [] r.ob = TimeErrorOb          ->
           {"OBS-30"} \cup When(r.cause \in TodObs, {"TINT-14"})
             \cup When(r.cause \in DintObs, {"DINT-10"}) \cup HeldBack(r, past)
      [] r.ob = ProgramErrorOb       -> {"OBS-20"} \cup HeldBack(r, past)
           \cup When(r.cause \in TodObs, {"TINT-16"})
           \cup When(r.cause \in DintObs, {"DINT-09"})
      [] OTHER                       ->
           SinceRun(past, r.ob, LastStart(past, r.ob))
             \cup (IF HeldBack(r, past) = {} THEN {"OBS-01", "OBS-03"}
                   ELSE HeldBack(r, past))

(* The requirements of a STOP that is due. *)
StopRequirements ==
    CASE stopCause = NoTimeErrorOb    -> {"OBS-22", "CLK-05"}
      [] stopCause = NoProgramErrorOb -> {"OBS-21"}
      [] stopCause = DeselectedLoaded -> {"OBS-25"}
      [] OTHER                        -> {"OBS-23"}

-----------------------------------------------------------------------------
(* Late entries *)

\* @type: ($entry, Seq($event)) => Set(Str);
EntryRequirements(entry, past) ==
    CASE entry.id = EntriesDisabled  -> {"IRT-09"}
      [] entry.id = NoTimeErrorOb    -> {"OBS-22"}
      [] entry.id = NoProgramErrorOb -> {"OBS-21"}
      [] entry.of.ob = TimeErrorOb   ->
           {"OBS-30"}
             \cup When(Blocked(TimeErrorOb),
                       {"OBS-33"} \cup BlockRequirements(past, TimeErrorOb))
      [] OTHER                       -> {"OBS-20"}

-----------------------------------------------------------------------------

\* @type: ($event, Seq($event)) => Set(Str);
LateRequirements(e, past) ==
    UNION { LateRequirement(r, past) : r \in Late(e) }
      \cup UNION { EntryRequirements(r.entry, past) : r \in ReportsLate(e) }
      \cup When(StopDuty \in DOMAIN waiting, StopRequirements)
=============================================================================
