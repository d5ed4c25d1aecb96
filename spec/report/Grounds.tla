------------------------------ MODULE Grounds -------------------------------
(***************************************************************************)
(* The requirements by which a line is possible: the answer to the         *)
(* question why it is. They follow from the state just before the line,    *)
(* from the line e, and from the lines before it, `past'.                  *)
(*                                                                         *)
(* No action uses this module.                                             *)
(* Source: the requirement IDs.                                            *)
(* Left out: a line that is not possible (Reasons).                        *)
(***************************************************************************)
EXTENDS Reasons

(* The requests by which the OB of the line starts. *)
\* @type: $event => Set($request);
Starting(e) ==
    { r \in requests : /\ r.ob = e.ob /\ MayStart(r)
                       /\ FitsFault(r.fault, e.info.flt_id) }

\* @type: ($event, Seq($event)) => Set(Str);
OfOrdinaryStart(e, past) ==
    CASE e.ob = CycleOb        -> {"OBS-01"}
      [] e.ob \in StartupObs   -> {"OBS-42"}
      [] e.ob \in ExternalObs \ {TimeErrorOb, ProgramErrorOb} ->
           {"OBS-01", "OBS-07"}
      [] OTHER -> UNION { LateRequirement(r, past) : r \in Starting(e) }

\* @type: $event => Set(Str);
OfInterrupt(e) ==
    CASE mode = "STOP"    -> {"OBS-41"}
      [] Deselected(e.ob) -> {"OBS-06"}
      [] Blocked(e.ob)    ->
           {"IRT-01", "IRT-04"} \cup When(Silenced(e.ob), {"IRT-09"})
      [] mode = "HOLD"    -> {"OBS-45"}
      [] mode = "STARTUP" ->
           {IF e.ob \in AsyncErrorObs THEN "OBS-43" ELSE "OBS-42"}
      [] OTHER            ->
           {"OBS-07"}
             \cup When(e.ob \in AsyncErrorObs, {"OBS-29"})
             \cup When(e.ob \notin loaded,
                       CASE e.ob = TimeErrorOb    -> {"OBS-22"}
                         [] e.ob = ProgramErrorOb -> {"OBS-21"}
                         [] e.ob \in AsyncErrorObs \cup {70, 72} -> {"OBS-23"}
                         [] OTHER                 -> {"OBS-20"})
             \cup When(~Undelayed, {"AIRT-01"})

\* @type: $moment => Set(Str);
OfClock(to) ==
    {"CLK-01"}
      \cup When(mode # "STOP" /\ SkippedBy(to) # {},
                {"CLK-02", "CLK-03"}
                  \cup When(TimeErrorOb \notin loaded, {"CLK-05"}))
      \cup When(mode # "STOP" /\ IsBack(to)
                  /\ \E o \in TodObs : tod[o].active,
                IF Family.repeats THEN {"CLK-10"} ELSE {"CLK-09"})

\* @type: ($event, Seq($event)) => Set(Str);
Grounds(e, past) ==
    CASE e.event \in CallEvents -> AnswerRequirements(e, e.ret)
      [] e.event = "start"      -> OfOrdinaryStart(e, past)
      [] e.event = "end"        -> {"OBS-03"} \cup When(delay > 0, {"AIRT-04"})
      [] e.event = "interrupt"  -> OfInterrupt(e)
      [] e.event = "clock"      -> OfClock(e.to)
      [] e.event = "restart"    -> {"OBS-40", "OBS-50"}
                                     \cup When(e.type = "cold", {"OBS-57"})
      [] e.event = "run"        -> {"OBS-42"}
      [] e.event = "hold"       -> {"OBS-45"}
      [] e.event = "release"    ->
           {"OBS-45"} \cup When(SkippedBy(clock) # {}, {"OBS-46"})
      [] e.event = "stop"       -> IF stopCause # NoCause THEN StopRequirements
                                   ELSE {"OBS-47"}
      [] e.event = "load"       -> {"OBS-20"}
      [] e.event = "delete"     -> IF PendingIn(requests, e.ob) THEN {"AMB-66"}
                                   ELSE {"OBS-20"}
      [] e.event = "diag"       -> OfEntry(e, past)
      [] OTHER                  -> {"OBS-60"}
=============================================================================
