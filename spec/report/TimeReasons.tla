----------------------------- MODULE TimeReasons ----------------------------
(***************************************************************************)
(* Reasons of time: the series of a time-of-day interrupt, the delay of a  *)
(* job, a clock that was set, a HOLD, a STARTUP that is over.              *)
(*                                                                         *)
(* Source: requirements, sections 1, 2, 5.4 and 6.                         *)
(* Left out: the starts that these reasons concern (UncausedReasons,       *)
(* LateReasons).                                                           *)
(***************************************************************************)
EXTENDS BlockReasons

(* The requirements of STEP 7's setting of an interrupt. *)
\* @type: (Int, Seq($event)) => Set(Str);
Step7Requirements(o, past) ==
    LET call == LastWith(past, {"SET_TINT", "CAN_TINT", "ACT_TINT"}, o)
    IN  When(cpu.step7[o].execution # "none",
             IF LastOf(past, {"restart"}) > call THEN {"OBS-50"}
             ELSE IF call = 0 THEN {"TINT-06"} ELSE {"TINT-38"})

(* The rules that say when an interrupt of this PERIOD is due. *)
\* @type: (Int, Int, Seq($event)) => Set(Str);
SeriesRequirements(o, period, past) ==
    LET set == LastWith(past, {"SET_TINT"}, o)
    IN  {"TINT-32"}
          \cup (CASE period = Hourly     -> {"TINT-34"}
                  [] period = EndOfMonth -> {"TINT-19"}
                  [] period = Monthly    -> {"TINT-18"}
                  [] OTHER               -> {"TINT-24"})
          \cup When(period \in Weekly \cup {Hourly, Yearly, Minutely, Daily},
                    {"TINT-33"})
          \cup When(/\ set > 0
                    /\ past[set].sdt.second # 0 \/ past[set].sdt.ms # 0,
                    {"TINT-11"})

(* The rules that say when the delay of a job is over. *)
\* @type: (Int, Seq($event)) => Set(Str);
OfDelay(o, past) ==
    LET srt == LastWith(past, {"SRT_DINT"}, o)
    IN  When(LastOf(past, {"clock"}) > srt \/ Unseen("clock"), {"DINT-18"})
          \cup When(LastOf(past, {"hold"}) > srt, {"DINT-19"})
          \cup When(TimesSince(past, {"SRT_DINT"}, o, LastStart(past, o)) > 1,
                    {"DINT-07"}
                      \cup When(DintCallsWithdrawRuns(cpu), {"DINT-15"}))

-----------------------------------------------------------------------------
(* Since a line *)

(* Since position `last' the CPU has gone on to RUN, or HOLD has come.     *)
\* @type: (Seq($event), Int, Int) => Set(Str);
SinceRun(past, o, last) ==
    When(LastOf(past, {"run"}) > last,
             {"OBS-44"} \cup When(o \in TodObs, {"TINT-13"})
                        \cup When(o \in DintObs, {"DINT-11"})
                        \cup When(o \in ExternalObs, {"OBS-42"}))
          \cup When(LastOf(past, {"hold", "release"}) > last,
                    {"OBS-45"} \cup When(o \in TodObs, {"OBS-46"})
                               \cup When(o \in DintObs, {"DINT-19"}))

(* Since position `last' the clock was set.                                *)
\* @type: (Seq($event), Int) => Set(Str);
SinceClock(past, last) ==
    LET how == ClockWasSet(past, last)
    IN  IF how = 0 THEN {}
        ELSE IF how > 0 THEN {"CLK-03"}
        ELSE IF ~Family.repeats THEN {"CLK-09"}
        ELSE IF Remembers THEN {"CLK-11"} ELSE {"CLK-10"}
=============================================================================
