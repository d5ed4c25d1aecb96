------------------------------ MODULE MCRestart -------------------------------
(***************************************************************************)
(* STOP, warm and cold restart with every kind of STEP 7 parameters,       *)
(* STARTUP with calls, points and errors (sections 5.4, 5.5).              *)
(***************************************************************************)
EXTENDS MCBase

MCTodObs == {10, 11}
MCFamilies == {"S7-400"}
MCLoads == {{10, 80, 82, 100}, {10, 11, 85, 102}}
MCStep7Settings ==
    { [o \in TodObs |-> IF o = 10 THEN s
        ELSE [NotConfigured EXCEPT !.deselected = TRUE, !.execution = "minute",
                                   !.start = Six, !.active = TRUE]]
      : s \in {NotConfigured, Activated("once", 0), Activated("minute", 1),
               [Activated("minute", 1) EXCEPT !.active = FALSE]} }
MCObNumbers == {10}
MCSdts == {Date(1)}
MCWords == {Once}
MCMoments == HalfMinutes(0, 1)
MCPowerOnMoments == {Moment(0, 30000)}
MCClockTargets == {Moment(1, 30000)}
MCInterrupts == {<<82, 0>>}

(* Settings of OB 10 for single letters; OB 11 has none. *)
\* @type: $step7 => Set(Int -> $step7);
Only(s) == {[o \in TodObs |-> IF o = 10 THEN s ELSE NotConfigured]}
OnlyWeekly == Only(Activated("weekly", 1))
OnlyOnce == Only(Activated("once", 0))
OnlyADate == Only(Activated("none", 1))
OnTheMinute == {Moment(0, 0)}
(* A past one-shot interrupt, and a point of each minute. *)
OnceAndMinutes ==
    {[o \in TodObs |-> IF o = 10 THEN Activated("once", -1)
                                 ELSE Activated("minute", -1)]}

MCRestartTypes == {"warm", "cold"}

Bounded == delay <= 1 /\ Waiting(1)
=============================================================================
