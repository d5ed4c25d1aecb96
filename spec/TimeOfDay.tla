----------------------------- MODULE TimeOfDay ------------------------------
(***************************************************************************)
(* SFC 28 SET_TINT, SFC 29 CAN_TINT, SFC 30 ACT_TINT and SFC 31 QRY_TINT:  *)
(* what they answer and what they change (catalogue sections 1.2 to 1.5).  *)
(*                                                                         *)
(* Of several errors in one call any may be answered [AMB-63]; a call on a *)
(* deselected OB may be answered 8090 or as usual [AMB-61].                *)
(* Left out: the library function S_LTINT [TINT-40]; a CPU whose reference *)
(* is local time, STATUS bit 6 [TINT-78]; test functions, bit 5 [AMB-04].  *)
(***************************************************************************)
EXTENDS Airt

NoSetting == [ set |-> FALSE, active |-> FALSE, start |-> 0, period |-> Once,
               next |-> Never, servedFrom |-> 0, servedTo |-> -1,
               gapFrom |-> 0, gapTo |-> -1, repeatTo |-> -1 ]

(* [AMB-57] Inside a repeated interval the OB may keep the memory of the    *)
(* points that were served; elsewhere it has no meaning.                   *)
\* @type: ($tod, $tod) => $tod;
WithMemory(new, old) ==
    IF Reading("AMB-57") = "b" /\ clock.min <= old.repeatTo
    THEN [ new EXCEPT !.servedFrom = old.servedFrom,
                      !.servedTo   = old.servedTo,
                      !.gapFrom    = old.gapFrom,
                      !.gapTo      = old.gapTo,
                      !.repeatTo   = old.repeatTo ]
    ELSE new

\* @type: $tod => $tod;
Forgotten(t) ==
    [ t EXCEPT !.servedFrom = 0, !.servedTo = -1, !.gapFrom = 0, !.gapTo = -1,
               !.repeatTo = -1 ]

\* @type: $tod => $tod;
Unset(t) == WithMemory(NoSetting, t)

(* [AMB-08] A once interrupt that has been called is no longer set. *)
\* @type: $tod => $tod;
UsedUp(t) == IF Reading("AMB-08") = "a" THEN Unset(t)
             ELSE [t EXCEPT !.active = FALSE, !.next = Never]

-----------------------------------------------------------------------------
(* The next start point *)

(* The first point at or after moment m that is served.  In an interval     *)
(* that the clock repeats, points that were served are not served again     *)
(* [CLK-09]; whether the others are is a matter of reading [AMB-56].       *)
\* @type: ($tod, $moment, Str) => Int;
NextPoint(t, m, reading) ==
    LET p == FirstPoint(t.start, t.period, MinuteFrom(m))
    IN  IF p > t.repeatTo THEN p
        ELSE IF reading = "b"
        THEN FirstPoint(t.start, t.period, t.repeatTo + 1)
        ELSE IF t.servedFrom > p \/ p > t.servedTo
                  \/ (t.gapFrom <= p /\ p <= t.gapTo)
        THEN p
        ELSE FirstPoint(t.start, t.period,
               IF p < t.gapFrom /\ t.gapFrom <= t.gapTo THEN t.gapFrom
                                                           ELSE t.servedTo + 1)

\* @type: ($tod, $moment) => $tod;
Armed(t, m) == [t EXCEPT !.next = NextPoint(t, m, Reading("AMB-56"))]

-----------------------------------------------------------------------------
(* Start events that wait are withdrawn with their setting [AMB-11]. *)

\* @type: Int => Set($request);
Withdrawn(o) == IF Reading("AMB-11") = "a" THEN requests
                                           ELSE Withdraw(requests, o)

(* [AMB-37] Equal is not past. *)
\* @type: (Int, $moment) => Bool;
IsPast(start, now) == Before(At(start), now)

\* @type: Int => Set(Int);
ObErrors(o) == IF o \notin TodObs THEN {BadOb} ELSE {}

(* [AMB-61] *)
\* @type: (Int, Set(Int)) => Set(Int);
Answers(o, errors) ==
    (IF errors = {} THEN {OK} ELSE errors)
      \cup (IF o \in TodObs /\ Deselected(o) THEN {BadOb} ELSE {})

-----------------------------------------------------------------------------
(* SFC 28 *)

(* [TINT-33] [AMB-01] *)
ValidPeriods ==
    CASE Reading("AMB-01") = "a" -> PeriodCodes \ {\h1202}
      [] Reading("AMB-01") = "b" -> PeriodCodes \ {\h1201}
      [] OTHER                   -> PeriodCodes

(* [TINT-18] [TINT-39] [AMB-05] *)
\* @type: ($date, Int) => Bool;
ValidSdt(sdt, period) ==
    /\ ValidDate(sdt)
    /\ period = Monthly /\ Reading("AMB-05") = "a" => sdt.day <= 28

(* [TINT-35] [TINT-36] [TINT-37]; seconds are dropped first [AMB-14]. *)
\* @type: (Int, $date, Int) => Set(Int);
SetErrors(o, sdt, period) ==
    LET judged == period = Once \/ Reading("AMB-02") = "a"
        past   == IsPast(MinuteOf(sdt), clock)
    IN  ObErrors(o)
          \cup (IF ValidSdt(sdt, period) THEN {} ELSE {BadSdt})
          \cup (IF period \in ValidPeriods THEN {} ELSE {BadPeriod})
          \cup (IF judged /\ ValidDate(sdt) /\ past THEN {PastStart} ELSE {})

(* [TINT-30] [TINT-31] [TINT-05] [TINT-38] On an error nothing changes      *)
(* [AMB-20].                                                               *)
\* @type: (Int, $date, Int, Int) => Bool;
SetTint(o, sdt, period, ret) ==
    /\ Called
    /\ ret \in Answers(o, SetErrors(o, sdt, period))
    /\ IF ret = OK
       THEN /\ tod' = [tod EXCEPT ![o] =
                         [ Unset(tod[o]) EXCEPT !.set    = TRUE,
                                                !.start  = MinuteOf(sdt),
                                                !.period = period ]]
            /\ requests' = Withdrawn(o)
       ELSE IF o \in TodObs /\ Reading("AMB-20") = "b"
       THEN /\ tod' = [tod EXCEPT ![o] = Unset(tod[o])]
            /\ requests' = Withdrawn(o)
       ELSE UNCHANGED <<tod, requests>>
    /\ UNCHANGED <<cpu, loaded, mode, startup, clock, stack, delay,
                   stopCause>>

-----------------------------------------------------------------------------
(* SFC 29 *)

(* [TINT-51] [TINT-52] [AMB-09] *)
\* @type: Int => Set(Int);
CanErrors(o) ==
    IF o \notin TodObs THEN {BadOb}
    ELSE IF \/ ~tod[o].set
            \/ Reading("AMB-09") = "b" /\ ~tod[o].active
         THEN {NotSet} ELSE {}

(* [TINT-50] [TINT-54]; an OB that runs is not stopped [TINT-53]. *)
\* @type: (Int, Int) => Bool;
CanTint(o, ret) ==
    /\ Called
    /\ ret \in Answers(o, CanErrors(o))
    /\ IF ret = OK THEN /\ tod' = [tod EXCEPT ![o] = Unset(tod[o])]
                        /\ requests' = Withdrawn(o)
                   ELSE UNCHANGED <<tod, requests>>
    /\ UNCHANGED <<cpu, loaded, mode, startup, clock, stack, delay,
                   stopCause>>

-----------------------------------------------------------------------------
(* SFC 30 *)

(* [TINT-61] [TINT-62] *)
\* @type: Int => Set(Int);
ActErrors(o) ==
    IF o \notin TodObs THEN {BadOb}
    ELSE IF ~tod[o].set THEN {NotSet}
    ELSE IF /\ ~tod[o].active
            /\ tod[o].period = Once
            /\ IsPast(tod[o].start, clock)
         THEN {PastStart} ELSE {}

(* An active once whose start event waits: open [AMB-60]. *)
\* @type: Int => Set(Int);
ActAnswers(o) ==
    Answers(o, ActErrors(o))
      \cup (IF /\ o \in TodObs /\ tod[o].active /\ tod[o].period = Once
               /\ PendingIn(requests, o)
            THEN {PastStart} ELSE {})

(* [TINT-60] [TINT-10] [TINT-24]; on an active interrupt no effect          *)
(* [TINT-63].                                                              *)
\* @type: (Int, Int) => Bool;
ActTint(o, ret) ==
    /\ Called
    /\ ret \in ActAnswers(o)
    /\ IF ret = OK /\ ~tod[o].active
       THEN tod' = [tod EXCEPT ![o] =
                      Armed(WithMemory([ Forgotten(@) EXCEPT !.active = TRUE ], @),
                            clock)]
       ELSE UNCHANGED tod
    /\ UNCHANGED <<cpu, loaded, mode, startup, clock, requests, stack,
                   delay, stopCause>>

-----------------------------------------------------------------------------
(* SFC 31 *)

(* [TINT-72] .. [TINT-79]; bit 0 of a deselected OB in RUN is not judged     *)
(* [AMB-03],                                                               *)
(* nor bit 2 of an interrupt without a further point [AMB-68].             *)
\* @type: Int => Set(Int);
Statuses(o) ==
    LET startingUp == IF mode = "STARTUP" THEN 1 ELSE 0
        bit0 == IF Deselected(o) /\ mode = "RUN" THEN {0, 1} ELSE {startingUp}
        bit2 == IF ~tod[o].active THEN {0}
                ELSE IF tod[o].next = Never /\ tod[o].period # Once
                THEN {0, 4} ELSE {4}
        bit4 == IF o \in loaded THEN 16 ELSE 0
    IN  { b + c + bit4 : b \in bit0, c \in bit2 }

(* [TINT-70] [TINT-71]; status is -1 where it is not given. *)
\* @type: (Int, Int, Int) => Bool;
QryTint(o, ret, status) ==
    /\ Called
    /\ ret \in Answers(o, ObErrors(o))
    /\ ret = OK => status = -1 \/ status \in Statuses(o)
    /\ UNCHANGED cpuVars

=============================================================================
