------------------------------ MODULE APSystem ------------------------------
(***************************************************************************)
(* One step of System from ANY state in which Ind holds, for Apalache.     *)
(*                                                                         *)
(* The world: two time-of-day OBs, two time-delay OBs, a hardware OB, OB   *)
(* 80, OB 85 and the startup OBs, each loaded or missing; no synchronous   *)
(* errors (OB 121, 122) and no hot restart; the three families; the class  *)
(* of each OB by default or, except on S7-300 and where it can be set, any *)
(* that OBS-05 allows. The clock, the delay count, settings, jobs, fields  *)
(* of requests and operands of calls are any integers; the fault id of an  *)
(* event from outside is a byte that no rule gives (FaultsOfRules).        *)
(* Before the step at most four start events wait, and a time-of-day OB    *)
(* remembers two runs of points of each kind: bounds, which a step may     *)
(* leave, so that nothing is said of the steps that follow it. Up to nine  *)
(* OBs run, and there cannot be more (DepthInv). SomeState and FewState    *)
(* are smaller.                                                            *)
(*                                                                         *)
(* The calendar: CalendarLemma stands for the first point of a series;     *)
(* models/MCCalendarLemma checks it. NextPointLemma follows from it and    *)
(* stands for the next point of a setting.                                 *)
(*                                                                         *)
(* The tables: Apalache builds a table anew at each use. So the formula    *)
(* stands for it; models/MCTables checks that they agree.                  *)
(*                                                                         *)
(* models/proofs.json has the queries; `s7spec prove' asks them.           *)
(***************************************************************************)
EXTENDS Inductive, APCalendar, Apalache

CONSTANTS
    (* The CPU at hand, the operands of a call, the moment of an event of  *)
    (* the world, an event from outside: any.                              *)
    \* @type: $cpu;
    AnyCpu,
    \* @type: $date;
    AnySdt,
    \* @type: $moment;
    AnyMoment,
    \* @type: Int;
    AnyOb,
    \* @type: Int;
    AnyFault

APTodObs == {10, 11}
APDintObs == {20, 21}
APExternalObs == {40, 80, 85}
(* In its place where a formula is about the numbers of OBs: all of them.  *)
AllExternalObs == (30..38) \cup (40..47) \cup (55..57) \cup {60, 70, 72}
                    \cup (80..87)
APAsyncErrorObs == {80, 85}
\* @type: Set(Int);
NoSyncErrorObs == {}
APBlockable == (10..17) \cup (20..23) \cup APExternalObs
APRestartTypes == {"warm", "cold"}
APObs == {10, 11, 20, 21, 40, 80, 85, 100, 102}
APNumbers == Int
APSdts == {AnySdt}
APMoments == {AnyMoment}
\* @type: Set(<<Int, Int>>);
APInterrupts == {<<AnyOb, AnyFault>>}
(* The readings that a CPU may show when it is at work. *)
APAmbiguities == {"AMB-11", "AMB-56", "AMB-57"}

-----------------------------------------------------------------------------
(* The tables *)

\* @type: Str => $family;
UntabledFamily(name) == CHOOSE f \in KnownFamilies : f.name = name

\* @type: Int => Int;
UntabledClass(o) == DefaultClassOf(Family, Kin(o))

(* Any number is a status word here, and Apalache cannot intersect that    *)
(* set with another.                                                       *)
\* @type: Int => Set(Int);
AnyStatusFor(ret) == IF ret = OK THEN StatusWords ELSE {-1}

-----------------------------------------------------------------------------
(* The calendar *)

(* In place of FirstPoint: any point that the lemma allows. If the drawn   *)
(* point is not allowed, an allowed point replaces it.                     *)
\* @type: (Int, Int, Int) => Int;
AnyFirstPoint(start, period, m) ==
    CHOOSE point \in
      { IF CalendarLemma(start, period, m, q) THEN q
        ELSE IF period = Once THEN NotBefore(start, m)
        ELSE IF m > LastMinute THEN Never
        ELSE IF period # EndOfMonth /\ m <= start THEN start
        ELSE IF period = Minutely THEN m
        ELSE Never
        : q \in {Gen(1)} } : TRUE

(* The lemma: q may be the next point of a setting from moment m on.       *)
\* @type: ($tod, $moment, Int) => Bool;
NextPointLemma(t, m, q) ==
    LET from == FirstMinute(t, m)
    IN  /\ q = Never \/ (from <= q /\ t.start <= q /\ q <= LastMinute)
        /\ t.period = Once => q \in {t.start, Never}
        /\ from > t.repeatTo => CalendarLemma(t.start, t.period, from, q)

(* In place of NextPoint, in the same way; next-point proves the lemma. *)
\* @type: ($tod, $moment, $cpu) => Int;
AnyNextPoint(t, m, c) ==
    CHOOSE point \in
      { IF NextPointLemma(t, m, q) THEN q
        ELSE LET from == FirstMinute(t, m)
             IN  IF from <= t.repeatTo THEN Never
                 ELSE IF t.period = Once THEN NotBefore(t.start, from)
                 ELSE IF from > LastMinute THEN Never
                 ELSE IF t.period # EndOfMonth /\ from <= t.start THEN t.start
                 ELSE IF t.period = Minutely THEN from
                 ELSE Never
        : q \in {Gen(1)} } : TRUE

-----------------------------------------------------------------------------
(* Any CPU, any operands *)

\* @type: Set(Str);
Executions == { "none", "once", "minute", "hourly", "daily", "weekly",
                "monthly", "yearly", "end_of_month" }

\* @type: (Str, Int, Bool, Bool) => $step7;
Setting(execution, start, active, deselected) ==
    [ execution |-> execution, start |-> start, active |-> active,
      deselected |-> deselected, local |-> FALSE ]

(* [OBS-05] A class that an OB can be given; 0 deselects it [OBS-06].      *)
\* @type: Int => Bool;
IsClass(c) == c = 0 \/ (2 <= c /\ c <= 23)

(* [AMB-57] STOP leaves the runs that it has dropped, to a CPU that        *)
(* remembers served points. No hot restart brings anything back. APS71500  *)
(* has BOOLEAN in the place of NotDue.                                     *)
NotDue == {FALSE}
\* @type: Set($request) => Set($resume);
LeftByStop(dropped) ==
    { [NothingKept EXCEPT !.requests = dropped, !.due = due] : due \in NotDue }
\* @type: Set($request) => Bool;
AreDropped(q) ==
    q = {} \/ (mode = "STOP" /\ Remembers /\ \A r \in q : r.ob \in TodObs)

ChosenCpu ==
    \E family \in {"S7-300", "S7-400", "CPU 318"},
       set \in SUBSET {10, 11, 20, 21, 40, 85}, c, d, e, f, g, h \in Nat,
       x, y \in Executions, s, t \in Nat, a, b, m, n \in BOOLEAN,
       shown \in SUBSET APAmbiguities,
       u \in {"b", "c"}, v \in {"a", "b", "d"}, w \in {"a", "b"} :
      /\ s <= LastMinute /\ t <= LastMinute
      /\ IsClass(c) /\ IsClass(d) /\ IsClass(e) /\ IsClass(f) /\ IsClass(g)
      /\ 24 <= h /\ h <= 26
      /\ family = "S7-300" => set = {}
      /\ AnyCpu =
           [ family |-> family,
             priority |->
               [ o \in set |-> IF o = 10 THEN c ELSE IF o = 11 THEN d
                               ELSE IF o = 20 THEN e ELSE IF o = 21 THEN f
                               ELSE IF o = 40 THEN g ELSE h ],
             step7 |-> [ o \in TodObs |-> IF o = 10 THEN Setting(x, s, a, m)
                                                   ELSE Setting(y, t, b, n) ],
             readings |-> [ r \in shown |-> IF r = "AMB-11" THEN u
                              ELSE IF r = "AMB-56" THEN v ELSE w ],
             classes |-> [o \in {} |-> 0],
             queues |-> [o \in {} |-> [size |-> 1, limit |-> 0, told |-> 0]],
             zone |-> 0, hour |-> NoHour ]

AnyConstants ==
    /\ ChosenCpu
    /\ AnySdt = Gen(1)
    /\ AnyMoment = Gen(1)
    /\ IsMoment(AnyMoment)
    /\ AnyOb \in {40, 80, 85}
    /\ AnyFault \in (0..255) \ FaultsOfRules

APFamilies == {AnyCpu.family}
APPriorities == {AnyCpu.priority}
APStep7Settings == {AnyCpu.step7}
APLoads == SUBSET APObs

-----------------------------------------------------------------------------

(* A state with these settings of OB 10 and OB 11, in which at most so     *)
(* many start events wait, and so many OBs run.                            *)
\* @type: ($tod, $tod, Int, Int) => Bool;
StateWith(t, u, waiting, running) ==
    /\ cpu = AnyCpu
    /\ loaded \in SUBSET APObs
    /\ mode \in {"STOP", "STARTUP", "RUN", "HOLD"}
    /\ startup \in {"none", "warm", "cold", "begun"}
    /\ \E q \in {Gen(waiting)} :
         /\ requests = IF mode = "STOP" THEN {} ELSE q
         /\ resume \in LeftByStop(IF mode = "STOP" THEN q ELSE {})
    /\ AreDropped(resume.requests)
    /\ clock = Gen(1)
    /\ tod = [o \in TodObs |-> IF o = 10 THEN t ELSE u]
    /\ \E j, k \in {Gen(1)} :
         dint = [o \in DintObs |-> IF o = 20 THEN j ELSE k]
    /\ irt \in [blocked : SUBSET APBlockable, silent : SUBSET APBlockable]
    /\ stack = Gen(running)
    /\ delay \in Int
    /\ stopCause \in Int
    /\ entered = {}
    /\ step = Step("any", 0, 0)

AnyState == \E t \in {Gen(2)}, u \in {Gen(2)} : StateWith(t, u, 4, 9)

(* In its place in the queries that take longer.                           *)
SomeState == \E t \in {Gen(2)}, u \in {Gen(2)} : StateWith(t, u, 3, 3)

(* In its place where a formula is to be refuted: a counterexample in a    *)
(* smaller world is one, and is found in less time.                        *)
FewState == \E t \in {Gen(1)}, u \in {Gen(1)} : StateWith(t, u, 2, 2)

(* next-point: any setting, with the runs that a step may have added to    *)
(* those of AnyState.                                                      *)
\* @type: ($tod, $tod) => $tod;
ServedAs(t, s) == [t EXCEPT !.served = s.served]
\* @type: ($tod, $tod) => $tod;
SetAnewAfter(t, s) == [ t EXCEPT !.served = {}, !.merged = {},
                                 !.earlier = s.earlier ]

\* @type: ($tod, $tod, $tod) => Bool;
Remembering(t, s, e) ==
    \/ StateWith(ServedAs(t, s), t, 1, 1)
    \/ StateWith(SetAnewAfter(t, e), t, 1, 1)

AnySetting == /\ \E t \in {Gen(2)}, s \in {Gen(5)}, e \in {Gen(6)} :
                   Remembering(t, s, e)
              /\ SettingDataInv
              /\ 0 <= clock.min /\ clock.min <= LastMinute
NextPointFollows ==
    \A q \in {NextPoint(tod[10], clock, cpu)} :
      NextPointLemma(tod[10], clock, q)

(* Every step keeps the assumptions of AnyState. *)
InWorld ==
    /\ cpu.family = AnyCpu.family
    /\ cpu.priority = AnyCpu.priority
    /\ cpu.step7 = AnyCpu.step7
    /\ \A a \in DOMAIN cpu.readings :
         /\ a \in APAmbiguities
         /\ cpu.readings[a] \in CASE a = "AMB-11" -> {"b", "c"}
                                  [] a = "AMB-56" -> {"a", "b", "d"}
                                  [] OTHER        -> {"a", "b"}
    /\ loaded \subseteq APObs
    /\ mode \in {"STOP", "STARTUP", "RUN", "HOLD"}
    /\ startup \in {"none", "warm", "cold", "begun"}
    /\ resume \in LeftByStop(resume.requests)
    /\ AreDropped(resume.requests)
    /\ DOMAIN tod = APTodObs
    /\ DOMAIN dint = APDintObs
    /\ irt.blocked \subseteq APBlockable
    /\ irt.silent \subseteq APBlockable

AnyInit == AnyState /\ Ind

(* depth: no more OBs can run than in AnyState, since each has its class.  *)
DeeperInit == /\ \E t \in {Gen(2)}, u \in {Gen(2)} : StateWith(t, u, 7, 10)
              /\ Ind
DepthInv == Len(stack) <= 9

(* The control: violated by every action that can take a step. *)
NoStep == step' = step
=============================================================================
