------------------------------ MODULE MCS71500 ------------------------------
(***************************************************************************)
(* An S7-1500: a minute interrupt whose clock is set by 10 s, 20 s and     *)
(* more, forward and back; a hardware interrupt above OB 80; OB 80 loaded  *)
(* or missing; STARTUP, HOLD.                                              *)
(***************************************************************************)
EXTENDS MCBase, PropertiesS71500

MCTodObs == {10}
(* In its place where two interrupts are skipped. *)
TwoTodObs == {10, 11}
MCFamilies == {"S7-1500"}
MCLoads == {{10, 11, 40, 80, 82, 100}}
(* In its place: OB 80 and others may be missing. *)
FewLoads == MCLoads \cup {{10, 11, 40}}
MCStep7Settings ==
    { [ o \in TodObs |-> IF o = 10 THEN Activated("minute", 0)
                         ELSE Activated("once", 1) ] }
MCPriorities == { [o \in {40} |-> 23] }
MCMoments == { Moment(0, 30000), Moment(0, 55000), Moment(1, 0),
               Moment(1, 5000), Moment(1, 15000) }
MCPowerOnMoments == {Moment(0, 55000)}
MCClockTargets == { Moment(0, 30000), Moment(0, 55000), Moment(1, 5000),
                    Moment(1, 15000) }
MCInterrupts == {<<40, 0>>, <<82, 0>>, <<80, 1>>, <<121, 0>>, <<122, 0>>}
MCRestartTypes == {"warm", "cold"}
FarMoments == {Moment(0, 30000), Moment(1, 0), Moment(1, 15000)}
FarTargets == {Moment(0, 30000), Moment(1, 15000)}
JustWarm == {"warm"}
(* [T15-62] [T15-63] [T15-66] *)
EventsOfKinds == {<<35, 0>>, <<83, 0>>, <<121, 0>>}
LoadsOfKinds == {{35, 83, 121}}
KindsBounded == Cardinality(requests) <= 1 /\ Len(stack) <= 2
MayBeHeld == TRUE
NestedRetVals == {0, 1, 2, NotDelayed}
JustOb40 == {<<40, 0>>}
NothingSet == {[o \in TodObs |-> NotConfigured]}

Bounded == /\ delay = 0
           /\ Waiting(2)
           /\ mode = "STOP" => clock \in PowerOnMoments

(* In its place where SFC 41 and 42 are called. *)
Nested == /\ delay <= 2
          /\ Waiting(2)
          /\ mode = "STOP" => clock \in PowerOnMoments
(* In their place where local time is 61 minutes ahead. The starts are     *)
(* 06:01, and 07:02, which is 06:01 where it is local time.                *)
AnHourAhead == {61}
ClockAndLocal == {FALSE, TRUE}
LocalSdts == {Date(1), [Date(2) EXCEPT !.hour = 7]}
LocalPeriods == {Once, Daily, EndOfMonth}
LocalMoments == {Moment(0, 55000), Moment(1, 0), Moment(1, 15000)}
JustOb10 == {10}
LocalRetVals == {OK, PastStart, NotSet}
(* By the clock or by local time, as the letter has it.                    *)
DailyByBoth ==
    { [o \in TodObs |-> [Activated("daily", 62) EXCEPT !.local = local]]
      : local \in BOOLEAN }
LettersOfBase ==
    { [ a \in DOMAIN l \cup {"A15-01"} |->
          IF a = "A15-01" THEN m ELSE l[a] ]
      : l \in LettersOf1500, m \in {"a", "b", "c"} }
OnceOrDaily == {Once, Daily}
\* @type: Set(Bool);
NoLocals == {}
(* In its place where SET_TINTL names a local time that daylight saving    *)
(* skips or doubles, or one behind it.                                     *)
JustLocal == {TRUE}
HourSdts == { [Date(30) EXCEPT !.hour = h] : h \in {7, 8} }
LettersOfHours ==
    { [ a \in DOMAIN l \cup {"A15-20"} |->
          IF a = "A15-20" THEN m ELSE l[a] ]
      : l \in LettersOf1500, m \in {"a", "b", "d", "e", "f"} }
HourLoads == {{10}}
HourBounded == /\ delay = 0 /\ requests = {} /\ Len(stack) <= 1
               /\ \A o \in TodObs : ~tod[o].set
(* In its place where the clock is set back step by step, over a point     *)
(* that was never served.                                                  *)
MinuteByStep7 == {[o \in TodObs |-> Activated("minute", 0)]}
BackMoments == {Moment(1, 0), Moment(1, 5000), Moment(2, 0)}
BackTargets == { Moment(0, 50000), Moment(1, 5000), Moment(1, 20000),
                 Moment(1, 35000), Moment(1, 50000), Moment(2, 5000) }
BackPowerOn == {Moment(1, 5000)}
LettersOfBack ==
    { [ a \in DOMAIN l \cup {"A15-17"} |->
          IF a = "A15-17" THEN m ELSE l[a] ]
      : l \in LettersOf1500, m \in {"a", "c"} }
BackBounded == /\ delay = 0 /\ Waiting(1)
               /\ (mode = "STOP" => clock \in PowerOnMoments)
(* In their place where local time changes between one and two hours       *)
(* ahead: OB 10 is hourly by it, or by the clock.                          *)
OneOrTwoHours == {60, 120}
HourlyByBoth ==
    { [o \in TodObs |-> [Activated("hourly", 1) EXCEPT !.local = local]]
      : local \in BOOLEAN }
ZoneMoments == {Moment(0, 55000), Moment(1, 0)}
ZoneBounded == /\ delay = 0
               /\ Waiting(2) /\ Cardinality(requests) <= 2
               /\ Len(stack) <= 2
               /\ mode = "STOP" => clock \in PowerOnMoments
ZoneLoads == {{10, 80}}
LettersOfZones ==
    { [ a \in DOMAIN l \cup {"A15-10"} |-> IF a = "A15-10" THEN m ELSE l[a] ]
      : l \in LettersOf1500, m \in {"a", "b"} }
(* In their place where the clock skips two interrupts at once, of which   *)
(* either has the first point.                                             *)
TwoPoints ==
    { [ p \in TodObs |-> IF p = o THEN Activated("minute", 0)
                         ELSE Activated("once", 2) ] : o \in TodObs }
OneOrTwoClasses == { [o \in {40} |-> 23], [o \in {11} |-> 3] }
BeforeBoth == {Moment(0, 30000)}
BehindBoth == {Moment(2, 15000)}
LettersOfCatchUps ==
    { [ a \in DOMAIN l \cup {"A15-08"} |-> IF a = "A15-08" THEN m ELSE l[a] ]
      : l \in LettersOf1500, m \in ABCD }
(* In their place where points pass in STOP. *)
StopMoments == {Moment(0, 30000), Moment(1, 0), Moment(1, 5000)}
StopTargets == {Moment(0, 30000), Moment(0, 55000)}
AnyStop == delay = 0 /\ Waiting(2)
(* In its place where OBs have numbers from 123 on: a time-of-day OB and a *)
(* hardware OB.                                                            *)
NumberedTods == {10} \cup Numbered(10)
NumberedClasses == {[o \in {123, 124} |-> IF o = 123 THEN 10 ELSE 40]}
NumberedLoads == {{10, 80, 123, 124}}
NumberedStep7 == {[o \in {10, 123} |-> NotConfigured]}
AnyNumberedStep7 == {[o \in {10, 123, 124} |-> NotConfigured]}
NumberedCalls == {10, 123, 124}
NumberedBlocks == {10, 123, 124}
NumberedSdts == {Date(1)}
NumberedPeriods == {Minutely}
NumberedEvents == {<<124, 0>>}
NumberedMoments == {Moment(0, 55000), Moment(1, 0)}
NumberedRetVals == {OK, BadOb, NotSet}
OneClassOrOb == {1, 2}
LettersOfClasses ==
    { [ a \in DOMAIN l \cup {"A15-21", "A15-24"} |->
          CASE a = "A15-21" -> m [] a = "A15-24" -> "a" [] OTHER -> l[a] ]
      : l \in LettersOf1500, m \in {"a", "b"} }
NumberedBounded == delay = 0 /\ Waiting(1)
                     /\ (mode = "STOP" => clock \in PowerOnMoments)
(* In its place where the queue of OB 40 has parameters. OB 41 is above it. *)
Queue40 ==
    { [o \in {40} |-> [size |-> p[1], limit |-> p[2], told |-> 1]]
      : p \in {<<1, 1>>, <<2, 0>>, <<2, 1>>, <<2, 2>>} }
QueueLoads == {{40, 41, 80, 100}, {40, 41, 100}}
QueueEvents == {<<40, 0>>, <<41, 0>>}
QueueClasses == {[o \in {41} |-> 23]}
LettersOfQueues ==
    { [ a \in DOMAIN l \cup {"A15-07", "A15-15"} |->
          CASE a = "A15-07" -> m [] a = "A15-15" -> n [] OTHER -> l[a] ]
      : l \in LettersOf1500, m \in {"a", "b"}, n \in {"a", "c"} }
QueueBounded == /\ delay = 0 /\ Waiting(4)
                /\ Cardinality({ r \in requests : r.ob \in {41, 80} }) <= 1
                /\ (mode = "STOP" => clock \in PowerOnMoments)
(* In their places where OB 121, of a lower class, interrupts OB 40.       *)
TwiceLoads == {{40, 80, 100, 121}}
TwiceEvents == {<<40, 0>>, <<121, 0>>}
TwiceBounded == QueueBounded /\ Len(stack) <= 4
(* In its place where a delay runs under DIS_AIRT.                         *)
DelayObs == {20}
DelayLoads == {{20, 80}}
DelayTime == {20000}
DelaySigns == {1}
DelayMoments == {Moment(0, 55000), Moment(1, 5000), Moment(1, 15000)}
DelayRetVals == {0, 1, NotDelayed}
LettersOfDelays ==
    { [ a \in DOMAIN l \cup {"A15-04"} |->
          IF a = "A15-04" THEN m ELSE l[a] ]
      : l \in LettersOf1500, m \in {"a", "b"} }
DelayBounded == delay <= 1 /\ Waiting(1)
                  /\ (mode = "STOP" => clock \in PowerOnMoments)
(* In its place where OB 10 has the class of OB 80, or the next one.       *)
AboveLoads == {{10, 80, 82}}
AboveEvents == {<<82, 0>>}
AboveClasses == { [o \in {10, 82} |-> c] : c \in {22, 23} }
AboveMoments == {Moment(0, 30000)}
AboveTargets == {Moment(1, 15000)}
(* Another point behind the jump: OB 80 with 02 beside a catch-up.         *)
AboveAndLater == {Moment(0, 30000), Moment(2, 0)}
Above10 == {[o \in {10} |-> 23]}
AboveBounded == /\ delay <= 1 /\ Waiting(3)
                /\ Cardinality({ r \in requests : r.ob = 82 }) <= 1
                /\ (mode = "STOP" => clock \in PowerOnMoments)
(* In its place where OB 10 runs from point to point.                      *)
OverflowMoments == { Moment(m, 0) : m \in 1..3 }
LettersOfOverflow ==
    { [ a \in DOMAIN l \cup {"A15-03", "A15-15"} |->
          CASE a = "A15-03" -> m [] a = "A15-15" -> n [] OTHER -> l[a] ]
      : l \in LettersOf1500, m \in {"a", "b", "c"}, n \in {"a", "c"} }
OverflowBounded == /\ delay = 0 /\ Waiting(4)
                   /\ (mode = "STOP" => clock \in PowerOnMoments)
(* In its place where EN_IRT names OBs that the CPU knows, or not.         *)
IrtObs == {82, 85}
JustOneOb == {2}

(* [T15-12] [T15-147] EN_IRT may refuse an OB that the CPU does not know,  *)
(* and it may take it.                                                     *)
UnknownObInv ==
    LET answers(o, ret) == ENABLED ( /\ Call
                                     /\ step'.event = "EN_IRT"
                                     /\ step'.ob = o /\ step'.value = ret )
    IN  Settled /\ Called => /\ answers(82, OK) /\ ~answers(82, BadOb)
                            /\ answers(85, OK) /\ answers(85, BadOb)

(* In their place where the point of a one-shot interrupt passed in STOP,  *)
(* whose OB may be missing.                                                *)
PassedOnce == {[o \in TodObs |-> Activated("once", 1)]}
PassedLoads == {{}, {10}}
PassedTargets == {Moment(0, 30000), Moment(0, 55000)}
PassedPowerOn == {Moment(1, 5000)}
PassedRetVals == {OK, BadOb, NotSet, PastStart, \h80B0}
LettersOfPassed ==
    { [ a \in DOMAIN l \cup {"A15-13", "A15-24", "AMB-60"} |->
          CASE a = "A15-13" -> m[1] [] a = "A15-24" -> m[2]
            [] a = "AMB-60" -> m[3] [] OTHER -> l[a] ]
      : l \in LettersOf1500,
        m \in { <<"a", "a", "c">>, <<"b", "a", "a">>, <<"c", "c", "c">> } }
PassedBounded == /\ delay = 0
                 /\ \A o \in TodObs : /\ tod[o].active = (mode # "STOP")
                                      /\ tod[o].served = {}

(* [T15-143] [A15-13] [A15-24] ACT_TINT of a one-shot interrupt whose      *)
(* point passed in STOP: it is over, or still active; its OB is missing;   *)
(* [AMB-60] or its start is past. Any code where no text of it counts.     *)
ActPassedInv ==
    \A o \in TodObs :
      LET \* @type: Int => Bool;
          answers(ret) == ret \in ActAnswers(o) /\ ENABLED ActTint(o, ret)
          missing == o \notin loaded
          refused == missing /\ cpu.readings["A15-13"] = "a"
          anyCode == cpu.readings["A15-24"] # "a"
      IN  /\ Settled /\ Called /\ requests = {} /\ ~OnStack(o)
          /\ tod[o].active /\ tod[o].next = Never
          => /\ answers(OK) <=> ~refused
             /\ answers(BadOb) <=>
                  anyCode \/ (missing /\ cpu.readings["A15-13"] # "b")
             /\ answers(NotSet) <=> anyCode \/ ~refused
             /\ answers(PastStart) <=>
                  \/ anyCode
                  \/ /\ ~refused /\ cpu.readings["AMB-60"] # "a"
                     /\ Before(At(tod[o].start), clock)
             /\ answers(\h80B0) <=> anyCode

(* Daily by local time, at 06:01 of the clock.                             *)
DailyByLocal ==
    {[o \in TodObs |-> [Activated("daily", 62) EXCEPT !.local = TRUE]]}
=============================================================================
