------------------------------- MODULE MCSync -------------------------------
(***************************************************************************)
(* Synchronous errors (section 5.2): OB 121 loaded, OB 122 loaded or not,  *)
(* in the startup OB, in OB 1 and in a hardware OB, under a block of       *)
(* everything and under delays; errors of error OBs.                       *)
(***************************************************************************)
EXTENDS MCBase

NoTodObs == {}
MCFamilies == {"S7-300"}
MCLoads == {{40, 100, 121}, {40, 121, 122}}
MCStep7Settings == {[o \in {} |-> NotConfigured]}
MCObNumbers == {0}
MCIrtModes == {0}
MCBlockable == {35, 40, 57, 60, 72, 80}
MCRetVals == {0, 1, 2, NotDelayed}
MCPowerOnMoments == {Moment(0, 0)}
(* OB 80 is missing: under a delay its STOP may wait [AMB-49].             *)
MCInterrupts == {<<40, 0>>, <<80, 1>>, <<121, 0>>, <<122, 0>>}
MCRestartTypes == {"warm"}

Bounded == delay <= 2 /\ Waiting(1) /\ Len(stack) <= 4

(* [OBS-61] Any OB that runs may fail. [AMB-85] In the other error OB both *)
(* are possible, a call and a STOP.                                        *)
FailsInv ==
    Settled /\ stack # <<>> /\ mode \in {"STARTUP", "RUN"} =>
      \A o \in SyncErrorObs :
        LET calls == ENABLED (InstructionFails(o) /\ UNCHANGED stopCause)
            stops == ENABLED (InstructionFails(o) /\ stopCause' # stopCause)
        IN  /\ calls \/ stops
            /\ o \in loaded /\ Top(stack).ob \in SyncErrorObs \ {o} =>
                 calls /\ stops
=============================================================================
