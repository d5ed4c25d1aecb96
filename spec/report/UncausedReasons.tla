--------------------------- MODULE UncausedReasons --------------------------
(***************************************************************************)
(* Reasons why an OB that starts has no start event.                       *)
(*                                                                         *)
(* Source: requirements, sections 1 to 6.                                  *)
(* Left out: a start whose start event is there (StartReasons).            *)
(***************************************************************************)
EXTENDS TimeReasons

-----------------------------------------------------------------------------
(* Time-of-day interrupts *)

(* The program has changed the catch-up in OB 80 [CLK-04].                 *)
\* @type: (Int, Seq($event)) => Bool;
TouchedInOb80(o, past) ==
    LastWith(past, {"SET_TINT", "CAN_TINT", "ACT_TINT", "DIS_IRT"}, o)
      > LastStart(past, TimeErrorOb)
    /\ LastStart(past, TimeErrorOb) > 0

(* The OB has just run, and no start point has come since. *)
\* @type: (Int, Seq($event)) => Bool;
RanForPoint(o, past) ==
    LET last == LastStart(past, o)
    IN  /\ last > 0 /\ past[last].at.min < tod[o].next
        /\ clock.min - past[last].at.min \in {0, 1}
        /\ PointFrom(tod[o], past[last].at.min + 1) = tod[o].next

(* Why a point of a time-of-day interrupt has not led to a start event.    *)
\* @type: (Int, Seq($event)) => Set(Str);
NoTodRequest(o, past) ==
    LET last == LastWith(past, {"SET_TINT", "CAN_TINT", "start"}, o)
    IN  IF Deselected(o) THEN {"TINT-02", "OBS-25"}
        ELSE IF LostMeanwhile(past, o) THEN {"IRT-04", "IRT-18"}
        ELSE IF OnStack(o) THEN {"OBS-02", "TINT-14"}
        ELSE IF ~tod[o].active /\ LastOf(past, {"restart"}) > last
        THEN {"TINT-02", "OBS-50"}
        ELSE IF ~tod[o].set
        THEN IF last = 0 THEN {"TINT-02", "TINT-05"}
             ELSE IF past[last].event = "start" THEN {"TINT-08", "CLK-12"}
             ELSE IF past[last].event = "SET_TINT" THEN {"TINT-31"}
             ELSE {"TINT-02", "TINT-50", "TINT-54"}
        ELSE IF ~tod[o].active THEN {"TINT-02", "TINT-05", "TINT-31"}
        ELSE LET again == RanForPoint(o, past)
                 from  == IF again THEN StartBefore(past, o)
                          ELSE LastStart(past, o)
                 moved == SinceClock(past, from) \cup SinceRun(past, o, from)
                 special ==
                   moved
                     \cup When(Blocked(TimeErrorOb), {"OBS-33"})
                     \cup When(ClockWasSet(past, from) # 0
                                 /\ TouchedInOb80(o, past),
                               {"CLK-04", "TINT-54"})
                     \cup When(clock.min <= tod[o].repeatTo
                                 /\ WasServed(tod[o], clock.min, cpu),
                               {"CLK-09"})
                     \cup When(again, {"OBS-07"})
                     \cup When(again /\ moved = {}, {"TINT-10", "TINT-32"})
                     \cup When(again /\ moved = {}
                                 /\ LastStart(past, TimeErrorOb) > from,
                               {"TINT-14"})
             IN  IF special # {} THEN special
                 ELSE SeriesRequirements(o, tod[o].period, past)
                        \cup Step7Requirements(o, past)
                        \cup When(~HasOnePoint(tod[o].period), {"TINT-10"})

-----------------------------------------------------------------------------
(* Time-delay interrupts *)

\* @type: (Int, Seq($event)) => Set(Str);
NoDintRequest(o, past) ==
    LET last == LastWith(past, {"SRT_DINT", "CAN_DINT", "start"}, o)
    IN  IF LostMeanwhile(past, o) THEN {"IRT-04", "DINT-20"}
        ELSE IF OnStack(o) THEN {"OBS-02", "DINT-10"}
        ELSE IF dint[o].started
        THEN {"DINT-03", "DINT-06"} \cup OfDelay(o, past)
        ELSE IF LastOf(past, {"restart"}) > last THEN {"DINT-02", "DINT-13"}
        ELSE IF last = 0 THEN {"DINT-02"}
        ELSE IF past[last].event = "CAN_DINT" THEN {"DINT-02", "DINT-14"}
        ELSE {"DINT-02"}
               \cup When(LastStart(past, TimeErrorOb) > StartBefore(past, o),
                         {"DINT-10"})

-----------------------------------------------------------------------------
(* OB 80 and OB 85 *)

(* The fault in the line decides; without a fault, the lines before it. *)
\* @type: ($event, Seq($event)) => Set(Str);
NoTimeError(e, past) ==
    LET fault == e.info.flt_id
        last  == LastStart(past, TimeErrorOb)
    IN  IF TimeErrorOb \notin loaded THEN {"OBS-22", "OBS-30"}
        ELSE {"OBS-30"}
          \cup When(LostMeanwhile(past, TimeErrorOb), {"OBS-33", "IRT-04"})
          \cup When(/\ fault \in {-1, SkippedByClock}
                    /\ LastOf(past, {"clock"}) > last,
                    {"CLK-02", "OBS-32"})
          \cup When(/\ fault \in {-1, SkippedInHold}
                    /\ LastOf(past, {"release"}) > last,
                    {"OBS-46"})
          \cup When(fault = StillRunning,
                    When(\E o \in TodObs : OnStack(o), {"TINT-14"})
                      \cup When(\E o \in DintObs : OnStack(o), {"DINT-10"}))
          \cup When(fault = SkippedByClock, {"CLK-02"})
          \cup When(fault = SkippedInHold, {"OBS-46"})
          \cup When(fault = BufferOverflow, {"OBS-08"})
          \cup When(/\ fault \in {-1, SkippedByClock}
                    /\ ~\E o \in TodObs : tod[o].active, {"CLK-14"})
          \cup When(/\ fault = SkippedByClock
                    /\ LastOf(past, {"DIS_AIRT"}) > LastOf(past, {"clock"}),
                    {"CLK-18"})

(* The missing OBs whose interrupt was activated or started. *)
\* @type: Seq($event) => Set(Str);
NoProgramError(past) ==
    LET tods  == { o \in TodObs \ loaded : LastWith(past, {"ACT_TINT"}, o) > 0
                                          \/ tod[o].active }
        dints == { o \in DintObs \ loaded :
                     LastWith(past, {"SRT_DINT"}, o) > 0 }
    IN  {"OBS-20"}
          \cup When(tods # {}, {"TINT-16", "TINT-17"})
          \cup When(dints # {}, {"DINT-09"})
          \cup When(\E o \in tods \cup dints : Blocked(o), {"IRT-01"})
          \cup When(delay > 0 /\ { r \in requests : r.ob \notin loaded } # {},
                    {"AIRT-01", "AIRT-09"})
          \cup When(MissingObEndsItsSource, {"OBS-28"})
          \cup When(MissingIsTimeError, {"OBS-24"})

-----------------------------------------------------------------------------

\* @type: ($event, Seq($event)) => Set(Str);
WithoutRequest(e, past) ==
    LET o == e.ob
    IN  CASE mode = "STOP"                -> {"OBS-41"}
          [] mode = "HOLD"                -> {"OBS-45"}
          [] ClassOf(o) = 0               -> {"OBS-06", "TINT-02", "OBS-25"}
          [] Blocked(o)                   -> ThoughBlocked(past, o)
          [] mode = "STARTUP" /\ o \in TodObs  -> {"OBS-42", "TINT-13"}
          [] mode = "STARTUP" /\ o \in DintObs ->
               {"OBS-42", "DINT-12", "DINT-11"}
          [] o \in TodObs                 -> NoTodRequest(o, past)
          [] o \in DintObs                -> NoDintRequest(o, past)
          [] o = TimeErrorOb              -> NoTimeError(e, past)
          [] o = ProgramErrorOb           -> NoProgramError(past)
          [] o \in {CycleOb} \cup StartupObs ->
               IF mode = "STARTUP"
               THEN {"OBS-42"} \cup When(e.info.time # NoMoment, {"OBS-10"})
               ELSE {"OBS-03"} \cup When(stack = <<>>, {"OBS-10"})
          [] LostMeanwhile(past, o)       -> {"IRT-04", "IRT-15"}
          [] OTHER                        ->
               {"OBS-01", "OBS-07"} \cup SinceRun(past, o, LastStart(past, o))
                 \cup When(LastOf(past, {"restart"})
                             > LastWith(past, {"interrupt"}, o), {"OBS-52"})
=============================================================================
