---------------------------- MODULE StartReasons ----------------------------
(***************************************************************************)
(* Reasons why a start is rejected although its start event has come.      *)
(*                                                                         *)
(* Source: requirements, sections 4 and 5, table 7.2.                      *)
(* Left out: a start without a start event (UncausedReasons).              *)
(***************************************************************************)
EXTENDS UncausedReasons

-----------------------------------------------------------------------------
(* Start information that does not fit the request *)

\* @type: ($request, $event) => Set(Str);
InterruptInfo(r, e) ==
    LET i == e.info
    IN  When(~Fits(i.priority, r.class),
             IF r.ob = TimeErrorOb THEN {"OBS-31"}
             ELSE {"OBS-04"}
                    \cup When(r.ob \in DOMAIN cpu.priority, {"OBS-05"})
                    \cup When(r.ob \in AsyncErrorObs /\ mode = "STARTUP",
                              {"OBS-43"}))
          \cup When(/\ r.ob \notin AsyncErrorObs
                    /\ ~FitsNumber(i.strt_info, r.ob),
                    {"OBS-10"} \cup When(r.ob \in TodObs, {"TINT-23"})
                      \cup When(r.ob \in DintObs, {"DINT-03"})
                      \cup When(r.ob \in ExternalObs, {"OBS-04"}))
          \cup When(r.ob \in TodObs /\ ~FitsPeriod(i.period, r.word),
                    {"TINT-25", "TINT-33"})
          \cup When(/\ r.ob \in DintObs
                    /\ ~(Fits(i.sign, r.word) /\ FitsDtime(i.dtime, r.dtime)),
                    {"DINT-03", "DINT-07", "DINT-22"})
          \cup When(~FitsTime(r, e),
                    CASE r.follows \in Skips -> {"CLK-07"}
                      [] r.fault \in Skips   -> {"CLK-06"}
                      [] r.ob \in TodObs     -> {"TINT-09", "TINT-24"}
                      [] OTHER               -> {"OBS-10"})

(* OB 80 and OB 85. *)
\* @type: ($request, $info) => Set(Str);
ErrorInfo(r, i) ==
    LET rule == IF r.ob = TimeErrorOb THEN {"OBS-30"} ELSE {"OBS-20"}
    IN  When(~FitsFault(r.fault, i.flt_id) \/ ~FitsFault(r.fault, i.strt_info),
             rule \cup When(r.fault = SkippedByClock, {"CLK-02"})
                  \cup When(r.fault = SkippedInHold, {"OBS-46"})
                  \cup When(r.fault = BufferOverflow, {"OBS-08"})
                  \cup When(r.fault = StillRunning,
                            When(r.cause \in TodObs, {"TINT-14"})
                              \cup When(r.cause \in DintObs, {"DINT-10"})))
          \cup When(~FitsCause(r, i), rule \cup {"OBS-10"})
          \cup When(~Fits(i.priority, r.class),
                    When(r.fault = BufferOverflow, {"OBS-08"})
                      \cup When(r.fault = SkippedInHold, {"OBS-46"}))
          \cup When(~FitsMask(r, i.error_info),
                    {"CLK-06", "OBS-32"}
                      \cup When(r.fault = SkippedInHold, {"OBS-46"}))

\* @type: ($request, $event) => Set(Str);
InfoRequirements(r, e) ==
    LET ids == InterruptInfo(r, e)
                 \cup When(r.ob \in AsyncErrorObs, ErrorInfo(r, e.info))
    IN  IF ids = {} THEN {"OBS-10"} ELSE ids

-----------------------------------------------------------------------------

(* The first condition of a start that the request does not meet.          *)
\* @type: ($request, $event, Seq($event)) => Set(Str);
StartRequirements(r, e, past) ==
    IF ~ModeAllows(r)
    THEN CASE mode = "STARTUP" -> {"OBS-42"}
                \cup When(r.ob \in TodObs, {"TINT-13"})
                \cup When(r.ob \in DintObs, {"DINT-11", "DINT-12"})
           [] mode = "HOLD" -> {"OBS-45"}
           [] OTHER         -> {"OBS-41"}
    ELSE IF r.ob \notin loaded
    THEN {"OBS-20"} \cup When(r.ob \in TodObs, {"TINT-16"})
                    \cup When(r.ob \in DintObs, {"DINT-02", "DINT-09"})
                    \cup When(r.ob \in AsyncErrorObs, {"OBS-23"})
                    \cup When(r.ob = ProgramErrorOb, {"OBS-21"})
                    \cup When(r.ob = TimeErrorOb, {"OBS-22"})
    ELSE IF Blocked(r.ob) /\ r \notin requests THEN ThoughBlocked(past, r.ob)
    ELSE IF ~Undelayed
    THEN {"AIRT-01", "AIRT-03"} \cup When(r.ob \in AsyncErrorObs, {"AIRT-09"})
    ELSE IF r.class = Running.class
    THEN {"OBS-02"} \cup When(r.ob \in TodObs, {"TINT-12"})
                    \cup When(r.ob \in AsyncErrorObs, {"OBS-11"})
    ELSE IF ~Preempts(r)
    THEN {"OBS-01"}
           \cup When(/\ LastOf(past, {"DIS_IRT"}) > LastStart(past, Running.ob)
                     /\ Blocked(Running.ob), {"IRT-08", "OBS-03"})
    ELSE IF ~Reported(r)
    THEN IF r.follows \in Skips THEN {"CLK-02", "CLK-03"} ELSE {"TINT-15"}
    ELSE IF ~InTurn(r)
    THEN {"OBS-02"} \cup When(r.ob \in TodObs, {"TINT-12"})
                    \cup When(r.follows \in Skips, {"CLK-03"})
    ELSE IF ~HighestFirst(r) THEN {"AIRT-08", "OBS-03"}
    ELSE InfoRequirements(r, e)

(* How many of these conditions the request meets. *)
\* @type: ($request, Int) => Int;
Depth(r, fault) ==
    IF ~ModeAllows(r) THEN 1 ELSE IF r.ob \notin loaded THEN 2
    ELSE IF ~Undelayed THEN 3 ELSE IF ~Preempts(r) THEN 4
    ELSE IF ~Reported(r) THEN 5 ELSE IF ~InTurn(r) THEN 6
    ELSE IF ~HighestFirst(r) THEN 7
    ELSE IF ~FitsFault(r.fault, fault) THEN 8 ELSE 9

(* The requests by which the OB of the line might start; a request may     *)
(* have come unseen.                                                       *)
\* @type: $event => Set($request);
Candidates(e) ==
    IF terms.loose THEN LooseRequests(e)
    ELSE { r \in requests : r.ob = e.ob }
           \cup (IF Unseen("interrupt") THEN MayHaveOccurred(e) ELSE {})

\* @type: ($event, Seq($event)) => Set(Str);
OfStart(e, past) ==
    LET all  == Candidates(e)
        fault == e.info.flt_id
        best == { r \in all :
                    \A q \in all : Depth(q, fault) <= Depth(r, fault) }
    IN  IF all = {} \/ mode = "STOP" THEN WithoutRequest(e, past)
        ELSE UNION { StartRequirements(r, e, past) : r \in best }
               \cup When(e.info.dtime \notin {-1} \cup DelayTimes, {"DINT-04"})
=============================================================================
