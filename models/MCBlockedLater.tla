---------------------------- MODULE MCBlockedLater ---------------------------
(***************************************************************************)
(* Time errors and program errors that wait, held back by SFC 41, while    *)
(* SFC 39 blocks their OB, which is missing or is deleted meanwhile        *)
(* (sections 3, 4 and 5.2).  They came before they were blocked [AMB-72].  *)
(***************************************************************************)
EXTENDS MCBase

MCTodObs == {10}
MCBlockable == {80, 85}
MCFamilies == TwoFamilies
MCLoads == {{80}, {80, 85}}
MCChangingObs == {80}
MCStep7Settings == {[o \in TodObs |-> NotConfigured]}
MCObNumbers == {80, 85}
MCIrtModes == {2}
MCMoments == {Moment(0, 0)}
MCInterrupts == {<<80, 1>>, <<85, 1>>}
MCRestartTypes == {"warm"}
MCRetVals == {0, 1, NotDelayed}

(* Several errors of an OB wait, in STARTUP and under a delay, too. *)
OneFamily == {"S7-400"}
ClassOf85 == {[o \in {85} |-> 24]}
ErrorLoads == {{80, 85, 100}}
Errors == {<<80, 1>>, <<85, 1>>, <<85, 2>>}
CountRetVals == {0, 1}
(* OB 82 is missing, and OB 81 and OB 40 may wait before it.               *)
WithoutOb82 == {{40, 81, 85, 100}}
Diagnoses == {<<40, 0>>, <<81, 0>>, <<82, 0>>}
(* OB 80 is missing until it is loaded. OB 82 has the class of its errors; *)
(* OB 72 has that of an overflow, and OB 81 that of neither.               *)
OnlyOb80 == {80}
WithoutOb80 == {{72, 81, 82, 100}}
ClassOf82 == {[o \in {82} |-> 26]}
TimeErrors == {<<72, 0>>, <<80, 1>>, <<81, 0>>, <<82, 0>>}
OneWaits == delay <= 1 /\ Cardinality(requests) <= 1
TwoWait == delay <= 1 /\ Cardinality(requests) <= 2

Bounded == delay <= 1 /\ Waiting(2)
=============================================================================
