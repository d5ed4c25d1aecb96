-------------------------------- MODULE MCHot ---------------------------------
(***************************************************************************)
(* Hot and warm restarts of an S7-400: a delay count, a job, a block, a    *)
(* hardware and a diagnostic interrupt that wait, interrupted OBs, points  *)
(* that pass in STOP, with OB 80 and without it (section 5.5).             *)
(***************************************************************************)
EXTENDS MCBase

MCTodObs == {10}
MCDintObs == {20}
MCFamilies == {"S7-400"}
MCLoads == {{10, 20, 40, 80, 82, 101}}
WithOrWithoutOb80 == {{10, 80, 101}, {10}}
MCStep7Settings == { [o \in TodObs |-> Activated("minute", 1)] }
NotSetUp == { [o \in TodObs |-> NotConfigured] }
MCObNumbers == {20}
MCBlockable == {20}
MCIrtModes == {2}
MCDtimes == {30000}
MCSigns == {0}
MCMoments == {Moment(1, 0), Moment(1, 30000)}
ALaterMinute == MCMoments \cup {Moment(2, 0)}
MCPowerOnMoments == {Moment(0, 30000)}
MCInterrupts == {<<40, 0>>, <<82, 0>>}
MCRestartTypes == {"warm", "hot"}
(* An error that a hot restart keeps. *)
WithOb81 == {{81, 101}}
PowerErrors == {<<81, 0>>}
MCRetVals == {0, 1}
JustOK == {OK}

Bounded == /\ delay <= 1 /\ Waiting(1) /\ Len(stack) <= 2
           /\ Cardinality(resume.requests) <= 1

(* [AMB-26] (b). *)
Letter26b == { [a \in {"AMB-26"} |-> "b"] }

(* [OBS-42] [OBS-57] In STOP a hot restart is possible, and the points of  *)
(* the STOP may be noticed at once and in RUN, or be lost.                 *)
HotRestartInv ==
    mode = "STOP" =>
      LET may(held, due) ==
            ENABLED ( /\ Restart("hot") /\ resume'.due = due
                      /\ (\E o \in TodObs : tod'[o].held) = held )
          passed == { o \in TodObs : /\ tod[o].active
                                     /\ Before(At(tod[o].next), clock) }
      IN  /\ may(FALSE, FALSE)
          /\ passed # {} /\ Reading("AMB-26") = "a" => may(TRUE, TRUE)
NoticedInv ==
    resume.due /\ mode \in {"STARTUP", "RUN"} /\ ~StopIsDue =>
      ENABLED (NoticesPassed /\ resume'.due = FALSE)
=============================================================================
