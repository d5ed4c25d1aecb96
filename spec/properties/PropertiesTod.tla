---------------------------- MODULE PropertiesTod -----------------------------
(***************************************************************************)
(* Properties of time-of-day interrupts, SFC 28-31 (section 1), said of    *)
(* states and of steps; an active interrupt waits for the first point of   *)
(* its series that is ahead (section 1.1).                                 *)
(*                                                                         *)
(* Left out: what a point is (Series).                                     *)
(***************************************************************************)
EXTENDS Steps, Series

TodCalls == {"SET_TINT", "CAN_TINT", "ACT_TINT", "QRY_TINT"}

(* The running OB calls. *)
CallerProp ==
    [][ step'.event \in TodCalls
                          \cup {"SRT_DINT", "CAN_DINT", "QRY_DINT",
                                "DIS_IRT", "EN_IRT", "DIS_AIRT", "EN_AIRT"}
          => stack # <<>> ]_vars

(* [TINT-05] [TINT-50] Only a set interrupt is active, and only an active  *)
(* interrupt has a next point or waits; an interrupt that its missing OB   *)
(* made inactive may still wait [AMB-46].                                  *)
SettingInv ==
    \A o \in TodObs :
      /\ tod[o].active => tod[o].set
      /\ ~tod[o].active => /\ tod[o].next = Never
                            /\ \/ MissingObEndsItsSource
                               \/ ~\E r \in requests : r.ob = o

(* [TINT-02] (c) [OBS-06] A deselected OB neither waits nor runs. *)
DeselectedInv ==
    \A o \in TodObs : Deselected(o) => ~PendingIn(requests, o) /\ ~OnStack(o)

(* [TINT-09] No point is left behind, but for those that passed in STOP    *)
(* until they are noticed [T15-120].                                       *)
DueInv ==
    mode \in {"RUN", "STARTUP"} =>
      \A o \in TodObs :
        tod[o].active /\ ~(tod[o].held /\ resume.due)
          => ~Before(At(tod[o].next), clock)

(* [AMB-19] Of the points that come while their OB runs one is kept. *)
OverlapInv ==
    \A o \in TodObs :
      Cardinality({ r \in requests :
                      r.ob = o /\ r.follows = StillRunning }) <= 1

-----------------------------------------------------------------------------
(* RET_VAL *)

(* [TINT-39] The last day of a month, by the calendar.                     *)
\* @type: (Int, Int) => Int;
LastDay(year, month) ==
    IF month = 2 THEN (IF year % 4 = 0 THEN 29 ELSE 28)
    ELSE IF month \in {4, 6, 9, 11} THEN 30 ELSE 31

(* [TINT-18] [TINT-39] A date for this PERIOD.                             *)
\* @type: ($date, Int) => Bool;
Fit(d, period) ==
    /\ d.year \in 1990..2089 /\ d.month \in 1..12
    /\ d.day \in 1..(IF period = Monthly THEN 28 ELSE LastDay(d.year, d.month))
    /\ d.hour \in 0..23 /\ d.minute \in 0..59

(* [TINT-35] [TINT-36] [TINT-37] [TINT-33] The answers of SET_TINT: a code *)
(* only where it applies, and 0000 only where none does. models/MCTod      *)
(* checks its operands by a table.                                         *)
SetAnswerProp ==
    [][ Did("SET_TINT") =>
          LET o == step'.ob
              v == step'.value
              past == /\ step'.operand = Once
                      /\ Before(At(MinuteOf(step'.sdt)), clock)
          IN  /\ v \in {\h0000, \h8090, \h8091, \h8092, \h80A1}
              /\ v = \h8090 => o \notin TodObs \/ Deselected(o)
              /\ v = \h80A1 => past
              /\ v = \h8091 => \/ ~Fit(step'.sdt, step'.operand)
                              \/ step'.sdt.second \notin 0..59  \* [AMB-79]
                              \/ step'.sdt.ms \notin 0..999
              /\ v = \h8092 => step'.operand \notin PeriodCodes
              /\ v = 0 => /\ o \in TodObs
                          /\ Fit(step'.sdt, step'.operand)
                          /\ step'.operand \in PeriodCodes
                          /\ ~past ]_vars

(* [TINT-30] [TINT-31] SET_TINT sets, to the minute [TINT-11], and does    *)
(* not activate.                                                           *)
SetProp ==
    [][ Did("SET_TINT") /\ step'.value = 0 =>
          /\ tod'[step'.ob].set /\ ~tod'[step'.ob].active
          /\ tod'[step'.ob].start = MinuteOf(step'.sdt)
          /\ tod'[step'.ob].period = step'.operand
          /\ tod'[step'.ob].offset = 0 /\ tod'[step'.ob].next = Never
          /\ ~PendingIn(requests', step'.ob) ]_vars

(* A one-shot interrupt whose only point is past and none of whose runs is *)
(* definite; its OB may run for an earlier setting. The sources leave open *)
(* whether it is still set [AMB-48] [AMB-55].                              *)
Over(o) == /\ tod[o].period = Once /\ tod[o].next = Never
           /\ ~PendingIn(requests, o) /\ ~tod[o].called

(* [TINT-51] [TINT-50] [TINT-52] CAN_TINT; in OB 80 of a catch-up [TINT-54]. *)
CanProp ==
    [][ Did("CAN_TINT") =>
          LET o == step'.ob
          IN  /\ step'.value \in {\h0000, \h8090, \h80A0}
              /\ step'.value = \h8090 => o \notin TodObs \/ Deselected(o)
              /\ step'.value = \h80A0 =>
                   o \in TodObs /\ (~tod[o].set \/ Over(o))
              /\ step'.value = 0 => /\ o \in TodObs
                                    /\ tod[o].set /\ ~tod'[o].set
                                    /\ ~PendingIn(requests', o) ]_vars

(* [TINT-60] [TINT-61] [TINT-62] [TINT-63] ACT_TINT. A missing OB is       *)
(* noticed later [TINT-17]: the call requests nothing and stops nothing.   *)
ActProp ==
    [][ Did("ACT_TINT") =>
          LET o == step'.ob
          IN  /\ UNCHANGED <<requests, stopCause>>
              /\ step'.value \in {\h0000, \h8090, \h80A0, \h80A1}
              /\ step'.value = \h8090 => o \notin TodObs \/ Deselected(o)
              /\ step'.value = \h80A0 =>
                   o \in TodObs /\ (~tod[o].set \/ Over(o))
              /\ step'.value = \h80A1 =>
                   /\ o \in TodObs /\ tod[o].period = Once
                   /\ \/ Before(At(tod[o].start), clock)
                      \/ PendingIn(requests, o) \/ OpenIn(requests, o)
                      \/ tod[o].called  \* AMB-60
              /\ step'.value = 0 =>
                   /\ o \in TodObs
                   /\ tod[o].set /\ tod'[o].active
                   /\ tod[o].active => tod' = tod
                   /\ ~tod[o].active /\ tod[o].period = Once =>
                        ~Before(At(tod[o].start), clock) ]_vars

(* A call that answers an error, and a query, change nothing [AMB-20]      *)
(* [TINT-70].                                                              *)
ErrorChangesNothingProp ==
    [][ \/ Did("QRY_TINT")
        \/ step'.event \in {"SET_TINT", "CAN_TINT", "ACT_TINT"}
             /\ step'.value # 0
        => UNCHANGED cpuVars ]_vars

(* [TINT-22] [AMB-81] A general error names a parameter, and its call has   *)
(* no effect.                                                              *)
GeneralErrorProp ==
    [][ Did("fails") =>
          /\ CallsMayFail
          /\ stack # <<>> /\ mode \in {"RUN", "STARTUP"}
          /\ step'.value % 256 \in {127} \cup 34..69
          /\ step'.value \div 256 \in 129..143
          /\ UNCHANGED cpuVars /\ entered' = {} ]_vars

(* [TINT-70] *)
QueryProp ==
    [][ Did("QRY_TINT") =>
          /\ step'.value \in {\h0000, \h8090}
          /\ step'.value = 0 => step'.ob \in TodObs
          /\ step'.value = \h8090 =>
               step'.ob \notin TodObs \/ Deselected(step'.ob) ]_vars

(* [TINT-72] [TINT-74] .. [TINT-79] STATUS. *)
StatusProp ==
    [][ Did("QRY_TINT") /\ step'.operand # -1 /\ step'.value = 0 =>
          LET o == step'.ob
              status == step'.operand
              bit(n) == (status \div n) % 2 = 1
          IN  /\ o \in TodObs
              /\ status < 128 /\ ~bit(32)
              /\ bit(8) => Bit3IsOpen  \* [AMB-82]
              /\ bit(64) => ~ReferenceIsBaseTime  \* [AMB-80]
              /\ bit(2) <=> o \in irt.blocked  \* [TINT-73] [IRT-17]
              /\ \/ Deselected(o)
                 \/ bit(1) <=> mode = "STARTUP" /\ ~Bit0IsZeroInStartup
              /\ bit(4) => tod[o].active
              /\ tod[o].active /\ tod[o].next # Never => bit(4)
              /\ tod[o].called => bit(4)  \* [AMB-71] in its own OB
              /\ bit(16) <=> o \in loaded ]_vars

-----------------------------------------------------------------------------
(* Points *)

(* [TINT-09] A start event of a time-of-day interrupt comes from its       *)
(* point, at its time; [CLK-03] [OBS-56] or from a skip or a restart.      *)
PointProp ==
    [][ \A o \in TodObs :
          /\ \E r \in requests' \ requests :
               r.ob = o /\ ~\E q \in requests : q.ob = o /\ q.since = r.since
          => \/ Did("reached") /\ step'.ob = o /\ clock = At(tod[o].next)
                  /\ tod[o].active /\ mode \in {"RUN", "STARTUP"}
                  /\ \A r \in Fresh : r.ob = o => r.since = clock
             \/ step'.event \in {"clock", "restart", "release"} ]_vars

(* [TINT-14] [OBS-30] A point comes while its OB runs: OB 80 with fault    *)
(* 02, and the run follows; or STOP.                                       *)
OverlapProp ==
    [][ /\ Did("reached") /\ mode = "RUN" /\ OnStack(step'.ob)
        /\ stopCause = NoCause /\ ~Blocked(step'.ob) /\ ~Blocked(80)
        => IF 80 \in loaded
           THEN /\ PendingIn(requests', step'.ob)
                /\ \E r \in requests' \ requests :
                     r.ob = 80 /\ r.fault = 2 /\ r.late = {step'.ob}
           ELSE stopCause' = \h4568 ]_vars

(* [TINT-23] [OBS-44] Otherwise a point leads to its OB, in STARTUP as     *)
(* well. If the OB may already wait, the point may be a time error, which  *)
(* stops a CPU without OB 80 [OBS-22]: the first cause of a STOP stays.    *)
OrdinaryProp ==
    [][ /\ Did("reached") /\ ~OnStack(step'.ob) /\ TakesEvents(step'.ob)
        => \/ PendingIn(requests', step'.ob)
           \/ /\ OpenIn(requests, step'.ob) /\ 80 \notin loaded
              /\ stopCause' = IF stopCause = NoCause THEN \h4568
                              ELSE stopCause ]_vars

(* [TINT-15] The run that follows comes after its OB 80. *)
AfterTimeErrorProp ==
    [][ Dispatched /\ step'.ob \in TodObs =>
          \E r \in requests :
            /\ r.ob = step'.ob
            /\ ~\E q \in requests : q.ob = r.ob /\ q.rank < r.rank /\ ~q.open
            /\ r.follows # 0 =>
                 ~\E q \in requests : q.ob = 80 /\ r.ob \in q.late ]_vars

(* [TINT-08] [TINT-64] [AMB-08] [AMB-71] A one-shot interrupt is no longer *)
(* set when its OB starts, or when it ends (it may be set anew in its OB). *)
OnceProp ==
    [][ \A o \in TodObs :
          /\ Started(o) /\ tod[o].period = Once
               => ~tod'[o].set \/ tod'[o].called
          /\ tod'[o].called => tod'[o].set /\ tod'[o].next = Never
          /\ Did("end") /\ step'.ob = o => ~tod'[o].called ]_vars

(* [CLK-12] [AMB-71] [AMB-46] Setting the clock back does not arm a        *)
(* one-shot interrupt again whose call waits or runs. A one-shot interrupt *)
(* with a missing OB is no longer set.                                     *)
OnceOverProp ==
    [][ \A o \in TodObs :
          /\ /\ Did("clock") /\ tod[o].active /\ tod[o].period = Once
             /\ tod[o].next = Never
             /\ tod[o].called \/ PendingIn(requests, o)
             => tod'[o].next = Never
          /\ Did("missing") /\ step'.ob = o /\ tod[o].period = Once
             => ~tod'[o].set ]_vars

(* Start, PERIOD and whether it is set. *)
\* @type: $tod => <<Bool, Int, Int, Int>>;
SettingOf(t) == <<t.set, t.start, t.period, t.offset>>

(* [TINT-60] A setting of STEP 7 or the program stays until SET_TINT or    *)
(* CAN_TINT for its OB or a restart [TINT-38]; ACT_TINT only activates it. *)
(* A one-shot interrupt is gone with the start of its OB, its end, or its  *)
(* lost event.                                                             *)
SettingStaysProp ==
    [][ \A o \in TodObs :
          \/ /\ SettingOf(tod'[o]) = SettingOf(tod[o])
             /\ \/ tod'[o].active = tod[o].active
                \/ Did("ACT_TINT") /\ step'.ob = o /\ step'.value = 0
                \/ Did("missing") /\ step'.ob = o /\ MissingObEndsItsSource
          \/ Did("restart")
          \/ step'.ob = o /\ step'.event \in {"SET_TINT", "CAN_TINT"}
          \/ /\ tod[o].period = Once /\ ~tod'[o].set
             /\ \/ step'.ob = o /\ step'.event \in {"start", "missing"}
                \/ Did("end") /\ step'.ob = o /\ tod[o].called
                \/ /\ o \in irt.blocked  \* [AMB-12]
                   /\ step'.event \in {"reached", "clock", "release"} ]_vars

-----------------------------------------------------------------------------
(* The series of points *)

(* The first minute that is not before the clock. *)
Ahead == IF clock.ms = 0 THEN clock.min ELSE clock.min + 1

(* [TINT-10] [TINT-24] [TINT-32] [AMB-39] The first point after activation *)
(* is the next one of the series, never a past one.  In an interval that   *)
(* the clock repeats it may be a later one [AMB-57].                       *)
FirstPointProp ==
    [][ Did("ACT_TINT") /\ step'.value = 0 /\ ~tod[step'.ob].active =>
          LET t == tod'[step'.ob]
          IN  IF t.repeatTo < clock.min
              THEN IsFirst(t.start, t.period, t.next, Ahead)
              ELSE t.next >= Ahead ]_vars

(* [TINT-09] [TINT-10] [CLK-08] An active interrupt waits for the next     *)
(* point of its series. The point that equals the clock may have been      *)
(* reached. A one-shot interrupt has its start and no other point. In a    *)
(* time that the clock repeats, points may be left out [CLK-09] [AMB-56]   *)
(* [AMB-57].                                                               *)
NextPointInv ==
    mode \in {"RUN", "STARTUP"} =>
      \A o \in TodObs :
        LET t == tod[o]
        IN  t.active =>
              IF t.period = Once THEN t.next \in {t.start, Never}
              ELSE IF clock.min <= t.repeatTo
              THEN t.next = Never \/ OnSeries(t.start, t.period, t.next)
              ELSE \/ IsFirst(t.start, t.period, t.next, Ahead)
                   \/ IsFirst(t.start, t.period, t.next, clock.min + 1)
=============================================================================
