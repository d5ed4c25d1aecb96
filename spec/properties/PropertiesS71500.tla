-------------------------- MODULE PropertiesS71500 --------------------------
(***************************************************************************)
(* What holds of an S7-1500 where it differs from S7-300/400, in other     *)
(* words than the actions. MCS71500 checks it.                             *)
(*                                                                         *)
(* Left out: what holds of every family (Properties).                      *)
(***************************************************************************)
EXTENDS Properties

(* By how much this step sets the clock. *)
Forward == Did("clock") /\ Before(clock, clock')
Distance20 == IF Before(clock, clock') THEN Span(clock, clock')
                                       ELSE Span(clock', clock)

(* New requests for OB 80 with this fault. *)
\* @type: Int => Bool;
Reports(fault) == \E r \in Fresh : r.ob = TimeErrorOb /\ r.fault = fault

(* [T15-30] [T15-35] [T15-60] .. [T15-66] The class of a running OB is the *)
(* one that is set for it, or that of its kind, in every mode.             *)
KindInv ==
    \A i \in DOMAIN stack :
      LET o == stack[i].ob
          c == stack[i].class
      IN  IF o \in DOMAIN cpu.priority THEN c = cpu.priority[o]
          ELSE /\ o \in {1, 100} => c = 1
               /\ o \in (10..17) \cup {123} => c = 2
               /\ o \in 20..23 => c = 3
               /\ o = 35 => c = 13
               /\ o \in (40..47) \cup {124} => c \in {16, 18}
               /\ o = 80 => c = 22
               /\ o = 82 => c = 5
               /\ o = 83 => c = 6
               /\ o \in {121, 122} => c = 7

(* [T15-61] OB 80 interrupts no OB of class 22 or above. *)
TimeErrorTurnProp ==
    [][ Started(TimeErrorOb) => Running.class < 22 ]_vars

(* [T15-40] [T15-110] .. [T15-114] The CPU stops by rule for a missing OB  *)
(* 121 or for the cycle time alone, and never calls OB 85.                 *)
OnlyTwoStopsProp ==
    [][ /\ ~Started(ProgramErrorOb)
        /\ Did("stop") =>
             \/ step'.value = NoProgrammingErrorOb /\ 121 \notin loaded
             \/ step'.value = NoTimeErrorOb /\ TimeErrorOb \notin loaded ]_vars

(* [T15-114] The cycle time stops it. *)
CycleTimeProp ==
    [][ Did("interrupt") /\ step'.ob = TimeErrorOb /\ mode \in {"RUN"}
          /\ step'.value = CycleTimeExceeded /\ TimeErrorOb \notin loaded
          => stopCause' # NoCause ]_vars

(* [T15-90] [T15-91] [T15-95] A clock set forward by less than 20 s calls  *)
(* no OB 80; by more it does, if a point was skipped and OB 80 is there.   *)
JumpProp ==
    [][ /\ Forward /\ Distance20 < 20000 => ~Reports(SkippedByClock)
        /\ Forward /\ Distance20 > 20000 /\ mode = "RUN"
             /\ SkippedNow # {} /\ TimeErrorOb \in loaded
             => \E r \in requests' : /\ r.ob = TimeErrorOb
                                     /\ r.fault = SkippedByClock ]_vars

(* [T15-90] Every skipped interrupt is caught up, where its OB does not    *)
(* wait or run already.                                                    *)
SmallJumpProp ==
    [][ Forward /\ Distance20 < 20000 /\ mode = "RUN" =>
          \A o \in SkippedNow :
            ~OnStack(o) /\ ~PendingIn(requests, o) =>
              \E r \in requests' : r.ob = o /\ ~r.open ]_vars

(* [T15-91] [T15-119] OB 80 with 05 or 06 reports skipped interrupts. The  *)
(* first of them is caught up. [A15-08] By (a) all others are, by (b) none,*)
(* by (c) the first of each class, else any. A blocked one is not, and one *)
(* whose OB waits or runs need not be [AMB-52]. A run that waits for the   *)
(* same point already counts.                                              *)
CaughtUpProp ==
    [][ \A e \in Fresh : e.ob = TimeErrorOb /\ e.fault \in {5, 6} =>
          LET runs == { r.ob : r \in { q \in requests' :
                            /\ q.ob \in e.late /\ q.follows = e.fault
                            /\ q.since = At(tod[q.ob].next) } }
              free == { o \in e.late : ~Blocked(o) }
              busy == { o \in free : \/ OnStack(o)
                                    \/ \E r \in requests : r.ob = o }
              kin(o) == { p \in free : ClassOf(p) = ClassOf(o) }
              first(o, obs) == \A p \in obs : tod[o].next <= tod[p].next
              letter == ReadingOf(cpu, "A15-08")
          IN  \E merged \in SUBSET busy :
                LET obs == free \ merged
                IN  /\ runs \subseteq obs
                    /\ obs # {} => \E o \in runs : first(o, obs)
                    /\ letter = "a" => runs = obs
                    /\ letter = "b" => Cardinality(runs) <= 1
                    /\ letter = "c" =>
                         /\ \A o \in obs : Cardinality(runs \cap kin(o)) = 1
                         /\ \A o \in runs : first(o, kin(o) \ merged) ]_vars

(* [T15-91] A run that follows an OB 80 comes after it, whatever the class *)
(* of its OB: it does not interrupt OB 80.                                 *)
LateRunWaitsProp ==
    [][ Dispatched =>
          \E r \in requests :
            /\ r.ob = step'.ob /\ r.class = step'.value
            /\ r.follows # 0 =>
                 /\ Top(stack).ob # TimeErrorOb
                 /\ ~\E q \in requests : /\ q.ob = 80 /\ r.ob \in q.late
                                          /\ q.fault = r.follows
      ]_vars

(* [T15-93] [T15-94] Set back by less than 20 s, the clock arms no point   *)
(* that was served; by more, the first point from the new time on.         *)
SetBackProp ==
    [][ Did("clock") /\ mode = "RUN" /\ Before(clock', clock) =>
          \A o \in TodObs : tod[o].active /\ ~HasOnePoint(tod[o].period) =>
            /\ Distance20 < 20000 =>
                 ~\E i \in tod[o].served :
                    i.from <= tod'[o].next /\ tod'[o].next <= i.to
            /\ Distance20 > 20000 =>
                 tod'[o].next = PointFrom(tod[o], FirstMinute(tod[o], clock'))
      ]_vars

(* [T15-93] [A15-17] Set back by less than 20 s, the clock arms the first  *)
(* point that was not served; under (a) the first that also lies behind    *)
(* the last one that was.                                                  *)
LastServedProp ==
    [][ Did("clock") /\ mode = "RUN" /\ Before(clock', clock)
          /\ Distance20 < 20000 =>
          \A o \in TodObs : tod[o].active =>
            LET t == tod'[o]
                was(p) == \E i \in t.served : i.from <= p /\ p <= i.to
                over(p) == /\ cpu'.readings["A15-17"] = "a"
                           /\ \E i \in t.served : p <= i.to
                now == FirstMinute(t, clock')
                ahead == { PointFrom(t, m) : m \in now..(now + 4) }
                free == { p \in ahead : ~was(p) /\ ~over(p) }
            IN  \A p \in free : t.next <= p /\ t.next \in free ]_vars

(* [T15-94] The points that come for the second time end with one that     *)
(* the OB served: what small steps alone repeated does not count.          *)
SecondTimeProp ==
    [][ Did("clock") /\ Before(clock', clock) /\ Distance20 > 20000 =>
          \A o \in TodObs :
            LET t    == tod[o]
                over == tod'[o].overTo
            IN  \/ over = -1
                \/ \E i \in t.served : over = i.to
                \/ \E i \in t.earlier : over = i.to
                \/ over = t.overTo /\ over > t.repeatTo ]_vars

(* [T15-93] [T15-94] A clock that is set back arms a one-shot interrupt    *)
(* that ran only over its point, and only by 20 s or more.                 *)
OnceAgainProp ==
    [][ Did("clock") => \A o \in TodObs : ~tod[o].active /\ tod'[o].active =>
          /\ Before(clock', clock) /\ Distance20 >= 20000
          /\ tod'[o].period = 0 /\ tod'[o].next >= clock'.min
          /\ \E i \in tod[o].earlier : i.from = tod'[o].next ]_vars

(* [T15-120] [A15-12] After STOP, OB 80 reports with 06 interrupts of STEP *)
(* 7 whose point has passed, and those alone.                              *)
StopPointsProp ==
    [][ /\ Did("restart") => \A o \in TodObs : tod'[o].held =>
             cpu.step7[o].active /\ Before(At(tod'[o].next), clock)
        /\ Did("noticed") /\ (\E o \in TodObs : tod[o].held)
             => Reports(SkippedInHold) \/ TimeErrorOb \notin loaded
        /\ Reports(SkippedInHold) => Did("noticed") \/ mode = "HOLD"
      ]_vars

(* [T15-08] [T15-09] [T15-20] [T15-99] [T15-141] SET_TINTL sets and, if it *)
(* is told so, activates. Its points are those of its start by local time; *)
(* a one-shot start is past by the clock.                                  *)
SetLocalProp ==
    [][ Did("SET_TINTL") =>
          LET o == step'.ob
              t == tod'[o]
              sdt == MinuteOf(step'.sdt)
          IN  /\ step'.value \in {0, \h8090, \h8091, \h8092, \h80A1}
              /\ step'.value = \h80A1 => /\ step'.operand = Once
                                        /\ \E z \in {0, cpu.zone} :
                                             Before(At(sdt - z), clock)
              /\ step'.value = 0 =>
                   /\ t.set /\ t.active = (step'.sign = 1)
                   /\ t.period = step'.operand
                   /\ t.zone = IF t.local THEN cpu.zone ELSE 0
                   /\ t.start \in {sdt, IF t.period = EndOfMonth
                                        THEN sdt % 1440 ELSE sdt}
                   /\ t.active /\ t.period = Once => t.next = sdt - t.zone
                   /\ t.active /\ t.period # Once =>
                        IsFirst(t.start, t.period, t.next + t.zone,
                                t.zone + Ahead) ]_vars

(* [T15-141] [A15-20] Where LOCAL is true in every call: a local time that *)
(* daylight saving skipped is refused, taken or either; of one that it     *)
(* doubled, the first is past for a one-shot interrupt.                    *)
TwiceOrNeverProp ==
    [][ /\ Did("zone") =>
             cpu'.hour = IF step'.operand = 0 THEN [from |-> 0, to |-> 0]
                         ELSE [ from |-> clock.min + cpu.zone,
                                to   |-> clock.min + step'.value ]
        /\ Did("SET_TINTL") =>
          LET sdt     == MinuteOf(step'.sdt)
              ret     == step'.value
              letter  == cpu.readings["A15-20"]
              skipped == cpu.hour.from <= sdt /\ sdt < cpu.hour.to
              doubled == cpu.hour.to <= sdt /\ sdt < cpu.hour.from
              past    == /\ step'.operand = Once
                         /\ Before(At(sdt - cpu.zone), clock)
          IN  /\ skipped /\ letter = "a" => ret # 0
              /\ ret = \h80A0 => letter = "a"
                                  \/ (skipped /\ letter # "b")
              /\ ret = 0 => ~past
              /\ ret = \h80A1 /\ ~past =>
                   \/ letter = "a"
                   \/ skipped /\ letter # "b"
                   \/ doubled /\ letter # "e" /\ step'.operand = Once
              /\ doubled /\ letter = "d" /\ step'.operand = Once =>
                   ret = \h80A1 ]_vars

(* [T15-21] [A15-01] SDT of SET_TINT is system time; local time under (b); *)
(* under (c) that which STEP 7 gives the OB.                               *)
SetBaseProp ==
    [][ Did("SET_TINT") =>
          LET o == step'.ob
              zone == CASE cpu.readings["A15-01"] = "a" -> 0
                        [] cpu.readings["A15-01"] = "b" -> cpu.zone
                        [] cpu.step7[o].local           -> cpu.zone
                        [] OTHER                        -> 0
              past == Before(At(MinuteOf(step'.sdt) - zone), clock)
          IN  /\ step'.value = 0 => tod'[o].zone = zone
              /\ step'.operand = Once => (step'.value = \h80A1 <=> past)
      ]_vars

(* [T15-10] [T15-11] A call takes an OB from 123 on that has its event     *)
(* class, here OB 123, and no other. [T15-54] [A15-21] What a class number *)
(* means of them is the CPU's to say; a number means its OB.               *)
NumberedProp ==
    [][ LET o == step'.ob
            blocks == { b \in {123, 124} : b \in irt'.blocked }
            mine == IF o = 10 THEN {123} ELSE {124}
        IN  /\ step'.event \in {"SET_TINT", "ACT_TINT", "CAN_TINT"} =>
                 (step'.value = \h8090 <=> o \notin {10, 123})
            /\ Did("DIS_IRT") /\ step'.value = 0 =>
                 /\ step'.operand = 2 => o \in irt'.blocked
                 /\ step'.operand = 1 /\ cpu.readings["A15-21"] = "a" =>
                      mine \subseteq blocks
                 /\ step'.operand = 1 /\ cpu.readings["A15-21"] = "b" =>
                      irt.blocked \cap {123, 124} = blocks ]_vars

(* The events of OB o, and those of them that wait.                        *)
\* @type: (Set($request), Int) => Int;
WaitingNow(q, o) == Cardinality({ r \in q : r.ob = o /\ ~r.open })
\* @type: Int => Int;
ThereNow(o) == WaitingNow(requests, o) + (IF OnStack(o) THEN 1 ELSE 0)

(* [T15-68] [T15-69] [T15-76] [A15-07] One more event of OB 40 waits, or   *)
(* it is dropped where its queue is full.                                  *)
QueueSizeProp ==
    [][ Did("interrupt") /\ step'.ob = 40 /\ mode \in {"RUN", "STARTUP"} =>
          LET size == cpu.queues[40].size
              held == IF cpu.readings["A15-07"] = "b" THEN ThereNow(40)
                      ELSE WaitingNow(requests, 40)
          IN  WaitingNow(requests', 40) - WaitingNow(requests, 40)
                = IF held < size THEN 1 ELSE 0 ]_vars

(* [T15-73] [T15-74] [A15-15] An event calls OB 80 if as many are there as *)
(* the threshold says; of an overload that OB 80 was called for already,   *)
(* perhaps; as where nothing waits that could tell. [T15-72] Each dropped  *)
(* event, or the first, may be entered.                                    *)
ThresholdProp ==
    [][ Did("interrupt") /\ step'.ob = 40 /\ mode \in {"RUN", "STARTUP"} =>
          LET limit == cpu.queues[40].limit
              told  == \E r \in requests : r.ob = 40 /\ 2 \in r.late
              ran   == \E i \in DOMAIN stack :
                         stack[i].ob = 40 /\ 2 \in stack[i].told
              calls == IF 80 \in loaded
                       THEN \E e \in Fresh : e.ob = 80 /\ e.fault = 2
                       ELSE \h3502 \in EnteredNow
          IN  /\ calls => limit > 0 /\ ThereNow(40) >= limit
              /\ /\ limit > 0 /\ ThereNow(40) = limit /\ ~told /\ ~ran
                 /\ WaitingNow(requests', 40) > 0
                 => calls
              /\ \h3502 \in EnteredNow => calls /\ ~told /\ ~ran
              /\ (told \/ ran) /\ cpu.readings["A15-15"] = "a" => ~calls
              /\ \h3507 \in EnteredNow =>
                   WaitingNow(requests', 40) = WaitingNow(requests, 40) ]_vars

(* [T15-72] [T15-73] What was told is forgotten when the OB is idle, and   *)
(* not before: the last event of an overload still tells of it.            *)
ToldProp ==
    [][ LET told(q, s) == UNION { r.late : r \in { p \in q : p.ob = 40 } }
                            \cup UNION { s[i].told : i \in DOMAIN s }
        IN  mode \in {"RUN", "STARTUP"} /\ mode' = mode =>
              IF WaitingNow(requests', 40) > 0 \/ (OnStack(40))'
              THEN told(requests, stack) \subseteq told(requests', stack')
              ELSE told(requests', stack') = {} ]_vars

(* [T15-39] [A15-04] Under (b) a delay stands still while DIS_AIRT holds.  *)
StandsStillProp ==
    [][ Did("time") => \A o \in DintObs : dint[o].started =>
          dint'[o].left = IF delay > 0 /\ cpu.readings["A15-04"] = "b"
                          THEN dint[o].left
                          ELSE dint[o].left - Span(clock, clock') ]_vars

(* [T15-121] HOLD goes back to where it came from.                         *)
HoldReturnsProp ==
    [][ Did("release") => mode' = IF startup = "none" THEN "RUN"
                                                      ELSE "STARTUP" ]_vars

(* [T15-20] What STEP 7 sets by local time counts by it.                   *)
LocalByStep7Prop ==
    [][ Did("restart") => \A o \in TodObs : tod'[o].active /\ ~tod'[o].held =>
          /\ tod'[o].zone = IF cpu.step7[o].local THEN cpu.zone ELSE 0
          /\ IsFirst(tod'[o].start, tod'[o].period,
                     tod'[o].next + tod'[o].zone,
                     tod'[o].zone + FirstMinute(tod'[o], clock)) ]_vars

(* [T15-98] [T15-99] [T15-103] Local time is set: the clock goes on, and   *)
(* so do the interrupts that count by it. [T15-96] Points that local time  *)
(* skips are caught up; daylight saving alone may call OB 80 [A15-10].     *)
LocalTimeProp ==
    [][ Did("zone") =>
          LET d == step'.value - cpu.zone
              skips(o) == /\ tod[o].active /\ tod[o].local
                          /\ Before(At(tod[o].next - d), clock)
              skipped == { o \in TodObs : skips(o) }
              late == { r \in Fresh : r.ob = TimeErrorOb }
          IN  /\ clock' = clock /\ cpu'.zone = step'.value
              /\ UNCHANGED <<mode, stack, delay, dint>>
              /\ \A o \in TodObs : tod[o].active /\ ~tod[o].local =>
                   tod'[o].next = tod[o].next /\ tod'[o].zone = 0
              /\ d < 0 \/ mode = "STOP" => requests' = requests
              /\ mode = "RUN" /\ d > 0 => \A o \in TodObs :
                   IF o \in skipped THEN OnStack(o) \/ PendingIn(requests', o)
                   ELSE ~\E r \in Fresh : r.ob = o
              /\ \A r \in late : r.fault = 4 /\ r.late \subseteq skipped
              /\ late # {} => /\ step'.operand = 1 /\ mode # "HOLD"
                             /\ cpu.readings["A15-10"] = "b"
              /\ /\ step'.operand = 1 /\ mode = "RUN" /\ 80 \in loaded
                 /\ cpu.readings["A15-10"] = "b" /\ skipped # {}
                 => \E r \in requests' : r.ob = TimeErrorOb /\ r.fault = 4
      ]_vars

(* [T15-97] [T15-98] By the new local time the first point that is not     *)
(* past comes next; if a zone sets it back, perhaps the first of these     *)
(* that was not served.                                                    *)
LocalPointsProp ==
    [][ Did("zone") /\ mode = "RUN" =>
          \A o \in TodObs : tod[o].active /\ tod[o].local =>
            LET t == tod'[o]
                by == t.next + step'.value
                was(p) == \E i \in tod[o].served :
                            i.from <= p - cpu.zone /\ p - cpu.zone <= i.to
                first == IsFirst(t.start, t.period, by,
                                 FirstMinute(t, clock) + step'.value)
            IN  /\ t.zone = step'.value
                /\ \/ first
                   \/ /\ step'.value < cpu.zone /\ step'.operand = 0
                      /\ ~was(by)
                   \/ tod[o].repeatTo >= 0 ]_vars

(* [T15-117] In STARTUP OB 80 does not run. *)
HeldBackProp == [][ Started(TimeErrorOb) => mode = "RUN" ]_vars

(* [T15-118] A start event of STARTUP waits. *)
KeptProp ==
    [][ Did("interrupt") /\ mode = "STARTUP" /\ step'.ob = 40 =>
          PendingIn(requests', 40) ]_vars

(* [T15-26] [T15-27] A point that comes while the OB runs leaves a run.    *)
LateRunProp ==
    [][ Did("reached") /\ OnStack(step'.ob) =>
          PendingIn(requests', step'.ob) ]_vars

(* [T15-73] A point while the OB runs calls OB 80 if none did in this      *)
(* overload; it remembers that until no event of the OB waits or runs.     *)
(* [A15-15] Under (a) OB 80 is not called again. The models have no call   *)
(* that withdraws what waits while the OB runs: it makes that forgotten.   *)
PointToldProp ==
    [][ LET told(o, q, s) ==
              \/ \E r \in q : r.ob = o /\ 2 \in r.late
              \/ \E i \in DOMAIN s : s[i].ob = o /\ 2 \in s[i].told
        IN  /\ Did("reached") /\ OnStack(step'.ob) /\ 80 \in loaded =>
                 /\ ~told(step'.ob, requests, stack) => Reports(StillRunning)
                 /\ told(step'.ob, requests, stack)
                      /\ cpu.readings["A15-15"] = "a" => ~Reports(StillRunning)
            /\ mode' = mode => \A o \in TodObs :
                 /\ \/ told(o, requests, stack)
                    \/ \E r \in Fresh : r.ob = 80 /\ r.fault = 2 /\ r.cause = o
                 /\ (PendingIn(requests, o) \/ OnStack(o))'
                 => told(o, requests', stack') ]_vars

(* [T15-27] [A15-03] Where a run of the OB waits already, the point is     *)
(* beyond the queue: an entry 3507 alone under (a), OB 80 with 07 under    *)
(* (b). [A15-15] (a) OB 80 is not called with 02 again.                    *)
OverflowCallsProp ==
    [][ Did("reached") /\ OnStack(step'.ob) /\ 80 \in loaded
          /\ PendingIn(requests, step'.ob) =>
          /\ \/ Reports(BufferOverflow) \/ Reports(StillRunning)
             \/ /\ cpu.readings["A15-03"] # "b"
                /\ \E n \in entered' : n.id = \h3507
          /\ cpu.readings["A15-03"] = "a" => ~Reports(BufferOverflow)
          /\ cpu.readings["A15-15"] = "a" => ~Reports(StillRunning) ]_vars

(* [T15-27] [T15-118] A point of STARTUP whose OB waits already is kept or *)
(* is an overflow, and OB 80 may come in RUN.                              *)
StartupPointProp ==
    [][ Did("reached") /\ mode = "STARTUP" /\ 80 \in loaded
          /\ PendingIn(requests, step'.ob) =>
          /\ PendingIn(requests', step'.ob)
          /\ \h3507 \in { n.id : n \in entered' }
          /\ Reports(StillRunning) /\ Reports(BufferOverflow) ]_vars

(* [T15-68] OB 80 with 07 needs another event of the same OB.              *)
OwnQueueProp ==
    [][ Did("interrupt") /\ step'.ob # TimeErrorOb /\ Reports(BufferOverflow)
        => OnStack(step'.ob) \/ \E r \in requests : r.ob = step'.ob ]_vars

(* [T15-115] *)
WarmProp == [][ Did("restart") => startup' = "warm" ]_vars

(* [T15-63] A missing OB 122 changes nothing; [T15-111] a missing OB 121   *)
(* stops the CPU.                                                          *)
AccessErrorProp ==
    [][ Did("interrupt") /\ step'.ob \in SyncErrorObs \ loaded =>
          IF step'.ob = 122 THEN UNCHANGED <<stack, stopCause>>
          ELSE stopCause' # NoCause ]_vars
=============================================================================
