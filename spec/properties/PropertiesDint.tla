--------------------------- MODULE PropertiesDint ---------------------------
(***************************************************************************)
(* Properties of time-delay interrupts, SFC 32-34 (section 2), said of     *)
(* states and of steps.                                                    *)
(*                                                                         *)
(* Left out: the order of runs, which Properties has for every OB.         *)
(***************************************************************************)
EXTENDS Steps

DintCalls == {"SRT_DINT", "CAN_DINT", "QRY_DINT"}

(* [DINT-03] [DINT-04] [DINT-13] A job has at most its delay left; none    *)
(* outlives a STOP.                                                        *)
JobInv ==
    \A o \in DintObs :
      /\ dint[o].started => /\ dint[o].dtime \in 1..60000
                            /\ dint[o].left \in 0..dint[o].dtime
      /\ ~dint[o].started => dint[o] = NoJob
      /\ mode = "STOP" => ~dint[o].started

(* [DINT-04] [DINT-05] [DINT-07] [DINT-08] [DINT-22] In its own OB, too. *)
SrtProp ==
    [][ Did("SRT_DINT") =>
          LET o == step'.ob
              v == step'.value
              fits == 1 <= step'.operand /\ step'.operand <= 60000
          IN  /\ v \in {\h0000, \h8090, \h8091}
              /\ v = \h8090 => o \notin DintObs \/ Deselected(o)
              /\ v = \h8091 => ~fits
              /\ v = 0 => /\ o \in DintObs /\ fits
                          /\ dint'[o].started
                          /\ dint'[o].left = step'.operand
                          /\ dint'[o].dtime = step'.operand
                          /\ dint'[o].sign = step'.sign
                          /\ \A p \in DintObs \ {o} : dint'[p] = dint[p] ]_vars

(* [DINT-14] [DINT-15] *)
CanDintProp ==
    [][ Did("CAN_DINT") =>
          LET o == step'.ob
              v == step'.value
          IN  /\ v \in {\h0000, \h8090, \h80A0}
              /\ v = \h8090 => o \notin DintObs \/ Deselected(o)
              /\ v = \h80A0 => o \in DintObs /\ ~dint[o].started
              /\ v = 0 => /\ o \in DintObs /\ ~dint'[o].started
                         /\ \/ dint[o].started
                            \/ PendingIn(requests, o)
                            \/ OpenIn(requests, o) ]_vars

(* [DINT-16] [IRT-17] [AIRT-13] *)
QryDintProp ==
    [][ Did("QRY_DINT") =>
          LET o == step'.ob
              status == step'.operand
              bit(n) == (status \div n) % 2 = 1
          IN  /\ step'.value = 0 => o \in DintObs
              /\ step'.value = 0 /\ status # -1 =>
                   /\ status < 32 /\ (bit(8) => Bit3IsOpen)
                   /\ \/ Deselected(o)
                      \/ bit(1) <=> mode = "STARTUP" /\ ~Bit0IsZeroInStartup
                   /\ bit(2) <=> o \in irt.blocked
                   /\ dint[o].started => bit(4)
                   /\ bit(4) => \/ dint[o].started
                                 \/ PendingIn(requests, o)
                                 \/ OpenIn(requests, o)
                   /\ bit(16) <=> o \in loaded
              /\ step'.value # 0 => step'.value = \h8090 ]_vars

(* An error and a query change nothing; a call takes no request away but   *)
(* one of its OB that waits [DINT-15]; behind an open one that it takes    *)
(* away, others move up.                                                   *)
DintCallProp ==
    [][ step'.event \in DintCalls =>
          /\ UNCHANGED <<stack, mode, clock, delay, stopCause>>
          /\ step'.value # 0 \/ Did("QRY_DINT") => UNCHANGED dint
          /\ Did("QRY_DINT") \/ ~PendingIn(requests, step'.ob) =>
               { Content(r) : r \in { q \in requests : ~q.open } }
                 = { Content(r) : r \in { q \in requests' : ~q.open } }
          /\ { q.ob : q \in requests } \ {step'.ob}
               \subseteq { q.ob : q \in requests' } ]_vars

(* [DINT-14] [DINT-15] [AMB-11] While the OB waits, CAN_DINT withdraws the *)
(* run and works, or leaves the run and fails. A CPU keeps to one way.     *)
CanWaitingProp ==
    [][ /\ Did("CAN_DINT")
        /\ step'.ob \in DintObs /\ PendingIn(requests, step'.ob)
        /\ ~dint[step'.ob].started
        => /\ step'.value = 0 <=> ~PendingIn(requests', step'.ob)
           /\ "AMB-11" \in DOMAIN cpu'.readings
           /\ cpu'.readings["AMB-11"]
                = (IF step'.value = 0 THEN "b" ELSE "c") ]_vars

(* [DINT-03] [DINT-06] [DINT-20] [OBS-10] A delay ends when it has         *)
(* elapsed, at most 1 ms early, and leads to its OB, with DTIME, SIGN and  *)
(* the time at which it ends, unless it is blocked.                        *)
ElapsedProp ==
    [][ Did("elapsed") =>
          LET o == step'.ob
              new == { r \in requests' \ requests : r.ob = o /\ ~r.open }
          IN  /\ dint[o].started /\ dint[o].left \in 0..1
              /\ ~dint'[o].started
              /\ mode \in {"RUN", "STARTUP"}
              /\ o \in irt.blocked => UNCHANGED <<requests, stopCause>>
              /\ /\ o \notin irt.blocked /\ ~Deselected(o) /\ ~OnStack(o)
                 /\ { q \in requests : q.ob = o } = {}
                 => \E r \in new : /\ r.word = dint[o].sign
                                  /\ r.dtime = dint[o].dtime
                                  /\ r.since = clock ]_vars

(* [DINT-10] [AMB-47] The delay ends while its OB runs: a time error, and  *)
(* at most one more run.                                                   *)
DintOverlapProp ==
    [][ /\ Did("elapsed") /\ OnStack(step'.ob)
        /\ ~Blocked(step'.ob) /\ ~Blocked(80) /\ stopCause = NoCause
        => /\ IF 80 \in loaded
              THEN \E r \in requests' \ requests :
                     r.ob = 80 /\ r.fault = 2 /\ r.cause = step'.ob
              ELSE stopCause' = \h4568
           /\ Cardinality({ r \in requests' :
                              r.ob = step'.ob /\ r.follows = 2 }) <= 1 ]_vars

(* [DINT-02] Nothing else asks for the OB. Its request may move up, if     *)
(* another of its class is withdrawn.                                      *)
DintSourceProp ==
    [][ \A o \in DintObs :
          \/ { Content(r) : r \in { q \in requests' : q.ob = o } }
               \subseteq { Content(r) : r \in { q \in requests : q.ob = o } }
          \/ step'.event \in {"elapsed", "start", "missing", "dropped",
                             "end"} ]_vars

(* [DINT-18] [DINT-19] Elapsed time is taken from every job, but not in    *)
(* HOLD; a clock that is set takes nothing.                                *)
DintTimeProp ==
    [][ /\ step'.event \in {"clock", "hold", "release"} => UNCHANGED dint
        /\ Did("time") =>
             \A o \in DintObs : dint[o].started =>
               dint'[o].left = IF mode = "HOLD" THEN dint[o].left
                               ELSE dint[o].left - Span(clock, clock') ]_vars

(* [DINT-07] [DINT-08] A job changes only by its calls, by time, by its    *)
(* end, and by the end of RUN.                                             *)
JobStaysProp ==
    [][ \A o \in DintObs : dint'[o] # dint[o] =>
          \/ /\ step'.event \in {"SRT_DINT", "CAN_DINT", "elapsed"}
             /\ step'.ob = o
          \/ step'.event \in {"time", "stop", "switch", "restart"} ]_vars

(* [DINT-01] [DINT-11] [DINT-12] The OB runs in RUN alone, in the class    *)
(* that is set for it [OBS-05], or else in that of table 7.1.              *)
DintRunProp ==
    [][ \A o \in DintObs :
          Started(o) =>
            /\ mode = "RUN"
            /\ step'.value = IF o \in DOMAIN cpu.priority
                             THEN cpu.priority[o] ELSE o - 17 ]_vars

(* [DINT-13] [OBS-52] *)
DintRestartProp ==
    [][ Did("restart") /\ startup' # "hot" => \A o \in DintObs :
          ~dint'[o].started /\ ~\E r \in requests' : r.ob = o ]_vars
=============================================================================
