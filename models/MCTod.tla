-------------------------------- MODULE MCTod ---------------------------------
(***************************************************************************)
(* SET, CAN, ACT and QRY_TINT with right and wrong operands, before and    *)
(* after start points, while the OB waits and while it runs (section 1).   *)
(***************************************************************************)
EXTENDS MCBase

MCTodObs == {10}
MCFamilies == {"S7-300"}
MCLoads == {{10, 40, 80, 85, 100}, {40, 80, 85}}
MCStep7Settings == {[o \in TodObs |-> NotConfigured]}
MCObNumbers == {10, 99}
MCSdts == {Date(0), Date(1), WrongDate, Monthly29}
MCWords == {Once, Minutely, Monthly, \hFFFF}
MCMoments == HalfMinutes(0, 1)
MCPowerOnMoments == {Moment(0, 0)}
MCInterrupts == {<<40, 0>>}
MCRestartTypes == {"warm"}

(* [AMB-79] *)
OddDates == {[Date(1) EXCEPT !.second = 60]}
JustOnce == {Once}

(* [TINT-33] [TINT-35] [TINT-18] [TINT-36] [AMB-63] SET_TINT by a table:   *)
(* for each pair of operands what it may answer beside 8090.               *)
SetTableProp ==
    [][ Did("SET_TINT") =>
          LET d == step'.sdt
              p == step'.operand
              dated == IF d = WrongDate \/ (d = Monthly29 /\ p = Monthly)
                       THEN {\h8091} ELSE {}
              coded == IF p = \hFFFF THEN {\h8092} ELSE {}
              first == IF d = Date(0) THEN Moment(0, 0) ELSE Moment(1, 0)
              past  == IF /\ p = Once
                          /\ d \in {Date(0), Date(1)}
                          /\ Before(first, clock)
                       THEN {\h80A1} ELSE {}
              wrong == dated \cup coded \cup past
          IN  \/ step'.ob = 10 /\ wrong = {} /\ step'.value = 0
              \/ step'.ob = 99 /\ step'.value = \h8090
              \/ step'.value \in wrong ]_vars

(* [TINT-18] Monthly from 31 October on, by STEP 7: SET_TINT would refuse  *)
(* the day.                                                                *)
MonthlyOnDay31 ==
    { [o \in TodObs |-> [ Activated("monthly", -21 * 1440)
                            EXCEPT !.active = active ]] : active \in BOOLEAN }

(* Behaviours after a STOP are left to MCRestart. *)
Bounded == /\ delay <= 1
           /\ Waiting(1)
           /\ mode = "STOP" => clock \in PowerOnMoments
(* Later in the minute than its half. *)
LaterInTheMinute == {[Date(0) EXCEPT !.second = 50]}
=============================================================================
