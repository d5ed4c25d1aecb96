------------------------------- MODULE Reasons ------------------------------
(***************************************************************************)
(* The requirements that someone who knows the log would cite for a        *)
(* rejected line. They follow from the state before the line, from the     *)
(* line e, and from the lines before it, `past'.                           *)
(*                                                                         *)
(* No action uses this module.                                             *)
(* Source: the requirement IDs.                                            *)
(* Left out: the lines that are allowed instead (Explain).                 *)
(***************************************************************************)
EXTENDS CallReasons, StartReasons, LateReasons

\* @type: ($event, Seq($event)) => Set(Str);
OfEntry(e, past) ==
    LET fault == e.id - ErrorEntry
        quiet == Silenced(TimeErrorOb) \/ Silenced(ProgramErrorOb)
    IN  CASE e.id = EntriesDisabled ->
               {"IRT-09"} \cup When(LastOf(past, {"EN_IRT"}) > 0, {"IRT-19"})
          [] e.id = NoTimeErrorOb       -> {"OBS-22"}
          [] e.id = NoProgramErrorOb    -> {"OBS-21"}
          [] e.id = DeselectedLoaded    -> {"OBS-25"}
          [] fault \in ObNotLoaded      ->
               {"OBS-20"} \cup When(quiet, {"IRT-09"})
          [] fault = SkippedByClock     ->
               {"OBS-30", "CLK-02"} \cup When(quiet, {"IRT-09"})
          [] fault = SkippedInHold      -> {"OBS-30", "OBS-46"}
          [] fault = BufferOverflow     -> {"OBS-30", "OBS-08"}
          [] OTHER                      ->
               {"OBS-30"} \cup When(quiet, {"IRT-09"})

(* The fields that are wrong.                                              *)
\* @type: $event => Set(Str);
OfState(e) ==
    {"OBS-60"}
      \cup When(~FitsTruth(e.blocked, Blocked(e.ob)), {"IRT-17"})
      \cup When(~FitsTruth(e.entries_off, Silenced(e.ob)), {"IRT-20"})
      \cup When(~FitsActive(e),
                IF e.ob \in TodObs THEN {"TINT-74"} ELSE {"DINT-16"})
      \cup When(~FitsLeft(e), {"DINT-17"})

\* @type: ($event, Seq($event)) => Set(Str);
Deciding(e, past) ==
    CASE ~KeepsPace(e)           -> {"CLK-01"}
      [] e.event \in CallEvents -> OfCall(e, past)
      [] e.event = "state"       -> OfState(e)
      [] e.event = "interrupt"   -> IF e.ob = TimeErrorOb THEN {"OBS-30"}
                                    ELSE {"OBS-20"}
      [] e.event = "start"   ->
           OfStart(e, past) \cup When(stopCause # NoCause, StopRequirements)
      [] e.event = "diag"    -> OfEntry(e, past)
      [] e.event = "end"     -> IF mode = "HOLD" THEN {"OBS-45"}
                                ELSE IF mode = "STOP" THEN {"OBS-41"}
                                ELSE IF Running.ob = CycleOb \/ stack = <<>>
                                THEN {"OBS-01", "OBS-03"} ELSE {"OBS-03"}
      [] e.event = "restart" ->
           {"OBS-40"} \cup When(e.type = "cold", {"OBS-57"})
      [] e.event = "run"     -> IF stopCause # NoCause THEN StopRequirements
                                ELSE IF mode = "STARTUP" THEN {"OBS-42"}
                                ELSE {"OBS-40"}
      [] e.event = "stop"    ->
           IF mode = "STOP" THEN {"OBS-40"}
           ELSE {"OBS-21", "OBS-22"}
                  \cup When(e.cause = DeselectedLoaded, {"OBS-25"})
                  \cup When(e.cause = NoTimeErrorOb, {"OBS-26"})
      [] OTHER               -> {"OBS-40"}

(* How far this state is from one that allows the line. The reasons of the *)
(* nearest states count.                                                   *)
\* @type: $event => Int;
Distance(e) ==
    CASE e.event \in CallEvents ->
           IF ~Called THEN 3
           ELSE IF BeforeItsEnd(e) THEN 2
           ELSE IF AnswerRight(e) THEN 0 ELSE 1
      [] e.event = "start" ->
           LET all == { Depth(r, e.info.flt_id) : r \in Candidates(e) }
           IN  IF mode = "STOP" THEN 11
               ELSE IF all = {} THEN IF mode = "RUN" THEN 9 ELSE 10
               ELSE 9 - (CHOOSE d \in all : \A k \in all : k <= d)
      [] e.event = "end" -> IF OnStack(e.ob) THEN 0 ELSE 1
      [] OTHER -> 0
=============================================================================
