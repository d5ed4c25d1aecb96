-------------------------- MODULE PropertiesClock ---------------------------
(***************************************************************************)
(* Properties of steps: time passes, and the clock is set (section 6).     *)
(*                                                                         *)
(* Left out: that no point is served twice on an S7-400, which needs a     *)
(* history and is in models/MCClockBack.                                   *)
(***************************************************************************)
EXTENDS Steps

(* The clock runs forward, and only a clock event sets it, as all          *)
(* requirements of section 6 assume.                                       *)
ForwardProp ==
    [][ clock' # clock => \/ Did("clock")
                          \/ Did("time") /\ Before(clock, clock') ]_vars

(* The interrupts that OB 80 may name, and those that it has to: a blocked *)
(* one may be left out [AMB-50].                                           *)
\* @type: Set(Int) => Bool;
NamesSkipped(late) == /\ SkippedNow \ BlockedNow \subseteq late
                      /\ late \subseteq SkippedNow

(* [CLK-02] [CLK-05] [CLK-06] [OBS-32] In RUN the clock skips points, of   *)
(* one interrupt at least that is not blocked, and OB 80 is not blocked:   *)
(* one more start event of OB 80 waits, with fault 05, the new time and    *)
(* the skipped interrupts, of which blocked ones may lack; if OB 80 is not *)
(* loaded, the CPU has to stop.                                            *)
SkipProp ==
    [][ /\ Did("clock") /\ mode = "RUN" /\ SkippedNow \ BlockedNow # {}
        /\ ~Blocked(80)
        => IF 80 \in loaded
           THEN /\ Cardinality({ r \in requests' : r.ob = 80 })
                     = Cardinality({ r \in requests : r.ob = 80 }) + 1
                /\ \E r \in requests' \ requests :
                     /\ r.ob = 80 /\ r.fault = 5 /\ NamesSkipped(r.late)
                     /\ r.since = clock'
           ELSE stopCause' # NoCause ]_vars

(* An open request may have been confirmed; it is not new. *)
\* @type: Int => Set($request);
NewOf(o) == { r \in requests' \ requests :
                r.ob = o /\ [r EXCEPT !.open = TRUE] \notin requests }

(* [CLK-03] [CLK-07] The clock is set in RUN and OB 80 is not blocked. At  *)
(* most one new run of a time-of-day OB waits, and only of a skipped one:  *)
(* for its first skipped point and behind the OB 80. If the OB neither     *)
(* waited, perhaps, nor ran, it has one; if it only did not run, it waits. *)
(* A blocked OB has none [IRT-18], and none has one if OB 80 is not loaded *)
(* [CLK-05].                                                               *)
CatchUpProp ==
    [][ Did("clock") /\ mode = "RUN" /\ ~Blocked(80) =>
          \A o \in TodObs :
            LET new == NewOf(o)
            IN  IF TimeErrorOb \notin loaded \/ Blocked(o) THEN new = {} ELSE
                /\ o \notin SkippedNow => new = {}
                /\ /\ o \in SkippedNow /\ ~OnStack(o)
                   /\ { r \in requests : r.ob = o } = {}
                   => Cardinality(new) = 1
                /\ o \in SkippedNow /\ ~OnStack(o) => PendingIn(requests', o)
                /\ Cardinality(new) <= 1
                /\ \A r \in new : /\ r.since = At(tod[o].next)
                                  /\ r.follows = 5 ]_vars

(* [CLK-18] [OBS-32] [OBS-46] Fault 05 comes by a setting of the clock,    *)
(* fault 06 by HOLD; both name the late OBs. A late start is no such       *)
(* fault. A fault from outside names no OB.                                *)
SkipFaultProp ==
    [][ \A r \in Fresh : r.ob = TimeErrorOb /\ r.fault \in {5, 6} =>
          IF r.late = {} THEN Did("interrupt")
          ELSE Did(IF r.fault = 5 THEN "clock" ELSE "release") ]_vars

(* [AMB-37] [AMB-58] [CLK-14] Without a skip the clock may be set freely:  *)
(* nothing is requested and nothing is lost.                               *)
NoSkipProp ==
    [][ Did("clock") /\ (mode = "STOP" \/ SkippedNow = {})
          => UNCHANGED <<requests, stopCause>> ]_vars

(* [CLK-08] [CLK-09] [CLK-10] After the clock was set every active         *)
(* interrupt waits for a point that is not before the new time; on an      *)
(* S7-300 for the first one of its series, if there is one before 2090     *)
(* [TINT-19].                                                              *)
RearmProp ==
    [][ Did("clock") =>
          \A o \in TodObs : tod[o].active /\ mode \notin {"STOP", "HOLD"} =>
            /\ ~Before(At(tod'[o].next), clock')
            /\ /\ Family.repeats /\ tod[o].period = Minutely
               /\ ~Before(clock', At(tod[o].start))
               => IsFirstMinute(tod'[o].next, clock') ]_vars

(* [OBS-46] On release, if points have passed in HOLD, of one interrupt at *)
(* least that is not blocked, and OB 80 is not blocked: a start event of   *)
(* OB 80 waits that is new and definite, with fault 06 and the interrupts  *)
(* that were skipped, of which blocked ones may lack; if OB 80 is not      *)
(* loaded, the CPU has to stop. A point that equals the clock may have     *)
(* passed, and no other [AMB-83]. New runs of these OBs: SkipTimeProp.     *)
HoldSkipProp ==
    [][ Did("release") /\ ~Blocked(80) =>
          LET passed == SkippedNow \cup { o \in TodObs : tod[o].held }
              said   == { o \in passed : ~Blocked(o) }
              equal  == { o \in TodObs : /\ tod[o].active /\ ~Deselected(o)
                                         /\ At(tod[o].next) = clock }
              errors == { r \in requests' \ requests :
                            r.ob = 80 /\ r.fault = 6 /\ ~r.open }
          IN  /\ said # {} =>
                   IF 80 \in loaded
                   THEN \E r \in errors : said \subseteq r.late
                   ELSE stopCause' # NoCause
              /\ \A r \in errors : r.late \ passed \subseteq equal
              /\ passed \cup equal = {} => UNCHANGED stopCause ]_vars

(* [AMB-83] Only HOLD, and a clock that is set back in it, keep a point    *)
(* that has passed for the release, and only one that has passed.          *)
HeldProp ==
    [][ \A o \in TodObs : tod'[o].held =>
          \/ tod[o].held /\ tod'[o].next = tod[o].next
          \/ /\ Did("clock") /\ mode = "HOLD" /\ Before(clock', clock)
             /\ tod[o].active /\ ~Before(clock, At(tod[o].next))
             /\ tod'[o].next = tod[o].next ]_vars

(* [CLK-07] [OBS-46] [AMB-16] After a skip, by the clock or in HOLD, OB 80 *)
(* gives the time at which it was noticed, and a run that catches up its   *)
(* first skipped point; after HOLD the run is open [AMB-55].               *)
SkipTimeProp ==
    [][ step'.event \in {"clock", "release"} =>
          \A r \in Fresh :
            /\ r.ob = 80 /\ r.late # {} /\ SkipGivesNewTime =>
                 r.since = clock'
            /\ r.ob \in TodObs /\ r.follows \in {5, 6} =>
                 /\ r.since = At(tod[r.ob].next) \/ ServedPointsAreSkipped
                 /\ r.follows = 6 /\ CatchUpAfterHoldIsOpen => r.open ]_vars

-----------------------------------------------------------------------------
(* The memory of served points *)

(* The OB was called for point p of its setting. *)
\* @type: ($tod, Int) => Bool;
CountsAsServed(t, p) == \E i \in t.served : i.from <= p /\ p <= i.to

(* ... or this call was perhaps merged with another one.                   *)
\* @type: ($tod, Int) => Bool;
MayCount(t, p) == \/ CountsAsServed(t, p)
                  \/ \E i \in t.merged : i.from <= p /\ p <= i.to

(* The runs of OB o for point p that wait. *)
\* @type: (Int, Int) => Set($request);
RunsFor(o, p) == { r \in requests' : r.ob = o /\ r.since.min = p }

(* Point p is served by these runs: definitely by a definite one, while    *)
(* there is room for points that may count. It may have been served before *)
(* the clock was set back in HOLD.                                         *)
\* @type: (Int, Int, Bool) => Bool;
ServedByRun(o, p, called) ==
    /\ MayCount(tod'[o], p) <=> MayCount(tod[o], p) \/ called
    /\ Cardinality(tod[o].merged) < LongestMemory =>
         ( CountsAsServed(tod'[o], p)
             <=> \/ CountsAsServed(tod[o], p)
                 \/ called /\ \E r \in RunsFor(o, p) : ~r.open )

(* The interrupts whose served points the CPU remembers. *)
RememberedObs == { o \in TodObs : Remembers /\ tod'[o].set }

(* [CLK-08] [CLK-09] [IRT-18] [AMB-56] On a CPU that remembers them a      *)
(* point that is reached counts as served, unless its OB is blocked or the *)
(* call is merged with another one; a skipped point, if a run for it       *)
(* waits. A merged call that leads to a run after all counts from then on. *)
ServedProp ==
    [][ /\ Did("reached") => \A o \in RememberedObs \cap {step'.ob} :
             ServedByRun(o, tod[o].next, ~Blocked(o))
        /\ Did("start") => \A o \in RememberedObs \cap {step'.ob} :
             \E r \in requests \ requests' :
               /\ r.ob = o
               /\ MayCount(tod[o], r.since.min) =>
                    CountsAsServed(tod'[o], r.since.min)
        /\ /\ Did("release") \/ (Did("clock") /\ mode = "RUN")
           /\ ~ServedPointsAreSkipped
           => \A o \in SkippedNow \cap RememberedObs :
                LET p == tod[o].next
                IN  ServedByRun(o, p, RunsFor(o, p) # {}) ]_vars

(* [AMB-56] When the clock is set back, either all merged calls count, or  *)
(* those alone whose run waits then. A setting whose skip waits for the    *)
(* release stays [AMB-53], and a point that HOLD has passed and this step  *)
(* skips may be merged by it.                                              *)
MergedProp ==
    [][ /\ Did("clock") /\ Before(clock', clock) /\ Remembers
        /\ ~SetBackWithdrawsRuns
        => LET \* @type: (Int, Int) => Bool;
               counts(o, p) == CountsAsServed(tod'[o], p)
               \* @type: (Int, Int) => Bool;
               skipped(o, p) == o \in SkippedNow /\ p = tod[o].next
               left == { o \in TodObs : tod'[o].set /\
                           ~(/\ mode = "HOLD" /\ o \in SkippedNow
                             /\ tod'[o] = tod[o]) }
           IN  /\ \A o \in left : \A i \in tod'[o].merged :
                    skipped(o, i.from) /\ skipped(o, i.to)
               /\ \/ \A o \in left :
                       \A i \in tod[o].merged : \A p \in {i.from, i.to} :
                         counts(o, p) \/ skipped(o, p)
                  \/ \A o \in left :
                       \A i \in tod[o].merged : \A p \in {i.from, i.to} :
                         \/ skipped(o, p)
                         \/ counts(o, p) <=>
                              \/ CountsAsServed(tod[o], p)
                              \/ \E r \in requests : /\ r.ob = o /\ ~r.open
                                                    /\ r.since.min = p ]_vars

(* [CLK-09] [AMB-57] Nothing makes the CPU forget served points, no        *)
(* restart and no new setting either, while it has room for more of them.  *)
MemoryStaysProp ==
    [][ \A o \in TodObs :
          \/ Cardinality(tod'[o].earlier) >= LongestMemory
          \/ NewSettingForgets(cpu) \/ SetBackWithdrawsRuns
          \/ /\ tod[o].earlier \subseteq tod'[o].earlier
             /\ \A i \in tod[o].served :
                  \/ \E r \in requests \cup resume.requests :  \* UncalledProp
                       r.ob = o /\ i.from <= r.since.min /\ r.since.min <= i.to
                  \/ \E j \in tod'[o].served : j.from <= i.from /\ i.to <= j.to
                  \/ \E j \in tod'[o].earlier :
                       /\ j.from <= i.from /\ i.to <= j.to
                       /\ j.start = tod[o].start
                       /\ j.period = tod[o].period ]_vars

(* [AMB-57] A run that a call or STOP took away did not serve its point,   *)
(* unless that was perhaps merged [AMB-56]. A missing OB counts as called. *)
UncalledProp ==
    [][ \A r \in requests \cup resume.requests :
          LET q == requests' \cup resume'.requests
              has(from, to) == from <= r.since.min /\ r.since.min <= to
          IN  /\ r.ob \in TodObs /\ ~Started(r.ob) /\ ~FoundMissing(r.ob)
              /\ { s \in q : Content(s) = Content(r) } = {}
              /\ ~\E i \in tod[r.ob].merged : has(i.from, i.to)
              => ~\E i \in tod'[r.ob].earlier \ tod[r.ob].earlier :
                    has(i.from, i.to) ]_vars

(* [CLK-09] [AMB-56] A CPU that remembers knows how far the clock had come *)
(* when it was set back: over the last minute, and over its own as well,   *)
(* unless the interrupt waits for the point of this minute, and it did not *)
(* pass in HOLD.                                                           *)
RepeatProp ==
    [][ Did("clock") /\ mode # "HOLD" /\ Before(clock', clock) /\ Remembers =>
          \A o \in TodObs : tod'[o].set =>
            LET last == IF tod[o].next = clock.min /\ ~tod[o].held
                        THEN clock.min - 1 ELSE clock.min
            IN  /\ tod'[o].repeatTo
                     = IF tod[o].repeatTo > last THEN tod[o].repeatTo ELSE last
                /\ tod'[o].overTo
                     = IF tod[o].overTo > last THEN tod[o].overTo
                                               ELSE last ]_vars

-----------------------------------------------------------------------------

(* Setting the clock changes no setting, except of a blocked one-shot      *)
(* interrupt that is skipped [AMB-12], and no OB starts or ends by it.     *)
ClockOnlyProp ==
    [][ Did("clock") => /\ clock' # clock
                        /\ UNCHANGED <<mode, stack, delay, startup>>
                        /\ \A o \in TodObs \ irt.blocked :
                             /\ tod'[o].set = tod[o].set
                             /\ tod'[o].active = tod[o].active
                             /\ tod'[o].start = tod[o].start
                             /\ tod'[o].period = tod[o].period ]_vars
=============================================================================
