------------------------------ MODULE MCMissing -------------------------------
(***************************************************************************)
(* OBs that are not loaded: what is called in their place, and when the CPU *)
(* stops (section 5.2).                                                    *)
(***************************************************************************)
EXTENDS MCBase

MCTodObs == {10}
MCFamilies == TwoFamilies
MCLoads == { {80} \cup l : l \in SUBSET {10, 85} }
MCChangingObs == {80}
MCStep7Settings == {[o \in TodObs |-> Activated("minute", 0)],
                    [o \in TodObs |-> Activated("once", 1)]}
MCMoments == HalfMinutes(0, 2)
MCPowerOnMoments == {Moment(0, 30000)}
MCInterrupts == {<<40, 0>>, <<81, 0>>, <<82, 0>>}
MCRestartTypes == {"warm"}

Bounded == delay <= 1 /\ Waiting(1)
=============================================================================
