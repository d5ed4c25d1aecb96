----------------------------- MODULE TodSettings ------------------------------
(***************************************************************************)
(* The setting of a time-of-day interrupt, apart from the calls that make  *)
(* it: its start, its PERIOD, the series of its points (section 1.1), the  *)
(* points that its OB has served, and the next point that it will serve.   *)
(* Calendar has the series itself.                                         *)
(*                                                                         *)
(* Served points matter when the clock is set back: an S7-400 does not     *)
(* serve a point again [CLK-09], an S7-300 does [CLK-10]. Points are kept  *)
(* as runs: from one point to another without an unserved point of the     *)
(* series between.                                                         *)
(*                                                                         *)
(* Left out: runs of earlier settings beyond the latest LongestMemory.     *)
(***************************************************************************)
EXTENDS Calendar, Requests

\* @type: $tod;
NoSetting == [ set |-> FALSE, active |-> FALSE, start |-> 0,
               local |-> FALSE, zone |-> 0,
               offset |-> 0, period |-> Once, next |-> Never, served |-> {},
               merged |-> {}, earlier |-> {}, repeatTo |-> -1,
               overTo |-> -1, called |-> FALSE, held |-> FALSE ]

(* The next point. *)
\* @type: $tod => $moment;
NextMoment(t) == [min |-> t.next, ms |-> t.offset]

-----------------------------------------------------------------------------
(* The series of points *)

(* [AMB-37] A moment that equals the clock is not past; under (b) it is. *)
\* @type: ($moment, $moment) => Bool;
IsPast(point, now) ==
    Before(point, now) \/ (point = now /\ EqualIsPast)

(* The first minute with a point that is not past at moment m. *)
\* @type: ($tod, $moment) => Int;
FirstMinute(t, m) == IF IsPast([min |-> m.min, ms |-> t.offset], m)
                     THEN m.min + 1 ELSE m.min

(* [AMB-05] [AMB-38] [AMB-43] The series that belongs to a PERIOD. *)
\* @type: Int => Int;
SeriesOf(period) ==
    CASE period = Monthly /\ MonthlyFallsOnLastDay -> MonthlyOrLast
      [] period = Yearly /\ YearlyFallsOnDayBefore -> YearlyOrDayBefore
      [] period = Yearly /\ YearlyFallsOnDayAfter  -> YearlyOrDayAfter
      [] period = Hourly /\ Period0401IsDaily      -> Daily
      [] OTHER                                     -> period

(* [TINT-08] [AMB-32] A PERIOD with one point. *)
\* @type: Int => Bool;
HasOnePoint(period) == \/ period = Once
                       \/ period = EndOfMonth /\ EndOfMonthIsOnce

(* [TINT-10] [TINT-24] The first point of the series at or after minute m, *)
(* both by the time of its start.                                          *)
(* It may be one period after the start [AMB-36]; the start of an          *)
(* end-of-month interrupt may be a point as well [AMB-39].                 *)
\* @type: ($tod, Int) => Int;
InSeries(t, m) ==
    IF m <= t.start /\ t.period = EndOfMonth /\ EndOfMonthRunsAtStart
    THEN t.start
    ELSE FirstPoint(t.start, SeriesOf(t.period),
                    IF /\ m <= t.start /\ ~HasOnePoint(t.period)
                       /\ SeriesBeginsAPeriodLater
                    THEN t.start + 1 ELSE m)

(* [T15-20] A minute of local time, by the clock.                          *)
\* @type: (Int, Int) => Int;
ByTheClock(local, zone) == IF local = Never THEN Never ELSE local - zone

\* @type: ($tod, Int) => Int;
PointFrom(t, m) ==
    LET local == m + t.zone
        once  == t.period = EndOfMonth /\ EndOfMonthIsOnce
        point == InSeries(t, IF once THEN t.start ELSE local)
    IN  ByTheClock(IF once THEN NotBefore(point, local) ELSE point, t.zone)

(* The first start point of a setting with one point. *)
\* @type: $tod => $moment;
FirstMoment(t) ==
    LET start == t.start - t.zone
    IN  [ min |-> IF t.period = Once THEN start ELSE PointFrom(t, start),
          ms  |-> t.offset ]

-----------------------------------------------------------------------------
(* The points that were served *)

LongestMemory == 8

(* [CLK-10] [CLK-11] An S7-300 serves points again after the clock was set *)
(* back; other CPUs remember the points that were served [AMB-17].         *)
Remembers == ~Family.repeats \/ S7300RemembersServed

(* A run of points joins those beside it.                                  *)
\* @type: ($tod, Set($run), $run) => Set($run);
Joined(t, runs, r) ==
    LET before == { i \in runs :
                      i.to < r.from /\ PointFrom(t, i.to + 1) >= r.from }
        after  == { i \in runs :
                      r.to < i.from /\ i.from <= PointFrom(t, r.to + 1) }
        begins == { i.from : i \in before \cup {r} }
        ends   == { i.to : i \in after \cup {r} }
    IN  (runs \ (before \cup after)) \cup
          {[ from |-> CHOOSE b \in begins : \A c \in begins : b <= c,
             to   |-> CHOOSE e \in ends : \A f \in ends : f <= e ]}

(* Runs that lie beside each other become one: each ends before the next   *)
(* run that begins behind an unserved point.                               *)
\* @type: ($tod, Set($run)) => Set($run);
JoinedAll(t, runs) ==
    LET begins == { j.from : j \in { k \in runs :
                      ~\E i \in runs : /\ i.from < k.from
                                       /\ k.from <= PointFrom(t, i.to + 1) } }
        \* @type: Int => Set(Int);
        ends(b) == { i.to : i \in { k \in runs :
                       b <= k.from /\ ~\E c \in begins :
                                         b < c /\ c <= k.from } }
    IN  { [ from |-> b,
            to   |-> CHOOSE e \in ends(b) : \A f \in ends(b) : f <= e ]
          : b \in begins }

(* [CLK-09] The OB is called for point p. A lost point [IRT-18] is over    *)
(* but not served; so is a skipped point without a run of its own.         *)
\* @type: ($tod, Int) => $tod;
Served(t, p) ==
    IF ~Remembers THEN t
    ELSE [t EXCEPT !.served = Joined(t, @, [from |-> p, to |-> p])]

(* [AMB-56] The OB has no run for these points for sure: served or not, as *)
(* the clock is set back. Where there are too many, the first are served.  *)
\* @type: ($tod, $run) => $tod;
Merged(t, r) ==
    LET runs  == Joined(t, t.merged, r)
        excess == { i \in runs :
                     Cardinality({ j \in runs : j.to > i.to })
                       >= LongestMemory }
    IN  IF ~Remembers THEN t
        ELSE [ t EXCEPT
                 !.merged = runs \ excess,
                 !.served = IF excess = {} THEN @
                            ELSE Joined(t, @, CHOOSE i \in excess : TRUE) ]

(* Point p has a run of its own after all, and so have those before it.    *)
\* @type: ($tod, Int) => $tod;
Confirms(t, p) ==
    LET hit == { i \in t.merged : i.from <= p /\ p <= i.to }
        run == CHOOSE i \in hit : TRUE
    IN  IF hit = {} THEN t
        ELSE [ t EXCEPT
                 !.served = Joined(t, @, [from |-> run.from, to |-> p]),
                 !.merged = (@ \ hit) \cup
                   (IF p = run.to THEN {}
                    ELSE {[from |-> p + 1, to |-> run.to]}) ]

(* [AMB-57] [AMB-59] (b) The runs for these points are withdrawn: no point *)
(* of them was served.                                                     *)
\* @type: ($tod, Set(Int)) => $tod;
NotServed(t, points) ==
    LET ends   == { p - 1 : p \in points }
        starts == { p + 1 : p \in points }
        \* @type: (Int, Int) => Bool;
        whole(a, b) == a <= b /\ ~\E p \in points : a <= p /\ p <= b
        \* @type: { from: Int, to: Int } => Set({ from: Int, to: Int });
        rest(i) ==
            UNION { { [from |-> a, to |-> b]
                      : b \in { e \in {i.to} \cup ends :
                                  e <= i.to /\ whole(a, e) } }
                    : a \in {i.from} \cup { s \in starts : i.from < s } }
    IN  [t EXCEPT !.served = UNION { rest(i) : i \in t.served }]

(* The points for which the OB of these requests is called. *)
\* @type: (Set($request), Int) => Set(Int);
PointsOf(q, o) == { r.since.min : r \in { s \in q : s.ob = o } }

-----------------------------------------------------------------------------
(* A new setting *)

(* [AMB-57] The points that this setting and earlier ones have served,     *)
(* each run with its series.                                               *)
\* @type: $tod => Set($memory);
Memory(t) ==
    LET runs == t.earlier \cup
                  { [ from |-> i.from, to |-> i.to, start |-> t.start,
                      local |-> t.local, zone |-> t.zone,
                      period |-> t.period ]
                    : i \in t.served \cup t.merged }
    IN  IF NewSettingForgets(cpu) THEN {}
        ELSE { i \in runs :
                 Cardinality({ j \in runs : j.to > i.to }) < LongestMemory }

(* [AMB-57] A setting made in repeated time was not active when the clock  *)
(* was set back, so AMB-56 does not count its points as past.              *)
\* @type: ($tod, $tod) => $tod;
WithMemory(new, old) ==
    LET repeats == clock.min <= old.repeatTo
    IN  [ new EXCEPT !.served = {}, !.merged = {}, !.earlier = Memory(old),
                     !.overTo = -1,
                     !.repeatTo = IF repeats THEN old.repeatTo ELSE -1 ]

\* @type: $tod => $tod;
Unset(t) == WithMemory(NoSetting, t)

(* [AMB-08] A one-shot interrupt that has been called is no longer set. *)
\* @type: $tod => $tod;
UsedUp(t) == IF OnceIsUnsetByItsRun THEN Unset(t)
             ELSE [ t EXCEPT !.active = FALSE, !.next = Never,
                             !.called = FALSE, !.held = FALSE ]

(* [CLK-12] [AMB-71] A one-shot interrupt whose call waits or runs is used *)
(* up by it: setting the clock back does not arm it again.                 *)
\* @type: Int => Bool;
CallUsesUp(o) ==
    /\ tod[o].active /\ HasOnePoint(tod[o].period) /\ tod[o].next = Never
    /\ tod[o].called \/ PendingIn(requests, o)

(* An active one-shot interrupt whose point has passed, and no run is      *)
(* definite: there is no catch-up, or it is open [AMB-48] [AMB-55]. No     *)
(* source says whether the interrupt is still active.                      *)
\* @type: Int => Bool;
Spent(o) ==
    /\ o \in TodObs /\ tod[o].active /\ ~Deselected(o)
    /\ HasOnePoint(tod[o].period) /\ tod[o].next = Never
    /\ ~PendingIn(requests, o) /\ ~tod[o].called
    /\ LostEventEndsItsSource

-----------------------------------------------------------------------------
(* The next point, for a CPU c with its readings of AMB-56 and AMB-57 *)

(* [AMB-57] The memory of earlier settings, if it counts. *)
\* @type: ($tod, $cpu) => Set($memory);
Remembered(t, c) == IF NewSettingForgets(c) THEN {} ELSE t.earlier

\* @type: ($memory, Int) => Bool;
IsPointOf(i, p) ==
    PointFrom([ NoSetting EXCEPT !.start = i.start, !.zone = i.zone,
                                 !.period = i.period ], p) = p

\* @type: ($tod, Int, $cpu) => Bool;
WasServed(t, p, c) ==
    \/ \E i \in t.served : i.from <= p /\ p <= i.to
    \/ \E i \in Remembered(t, c) : i.from <= p /\ p <= i.to /\ IsPointOf(i, p)

(* The last point of each run. *)
\* @type: ($tod, $cpu) => Set(Int);
LastCalls(t, c) ==
    { i.to : i \in t.served } \cup { i.to : i \in Remembered(t, c) }

(* [AMB-56] [A15-17] Unserved points up to this minute are over, too, if   *)
(* the interrupt was active when the clock was set back.                   *)
\* @type: ($tod, $cpu) => Int;
OverUntil(t, c) ==
    LET calls == LastCalls(t, c)
        last  == CHOOSE p \in calls : \A q \in calls : q <= p
    IN  IF UnservedAreOver(c) THEN t.overTo
        ELSE IF /\ \/ UnservedAreOverToLastCall(c)
                   \/ Family.jump # 0 /\ SmallJumpEndsUnserved(c)
                /\ calls # {}
        THEN IF last < t.overTo THEN last ELSE t.overTo
        ELSE -1

(* The first unserved point from p on: p, one of the two points after it,  *)
(* which may lie between points of another series, or the point behind a   *)
(* run.                                                                    *)
\* @type: ($tod, Int, $cpu) => Int;
FirstUnserved(t, p, c) ==
    LET second == PointFrom(t, p + 1)
        ends   == { q \in LastCalls(t, c) : q >= p }
        points == {p, second, PointFrom(t, second + 1)}
                    \cup { PointFrom(t, q + 1) : q \in ends }
        free   == { q \in points : ~WasServed(t, q, c) }
    IN  IF ~WasServed(t, p, c) THEN p
        ELSE CHOOSE q \in free : \A r \in free : q <= r

(* The first point at or after moment m that the OB will serve. In         *)
(* repeated time served points are not served again [CLK-09]; unserved     *)
(* points may be over [AMB-56].                                            *)
\* @type: ($tod, $moment, $cpu) => Int;
NextPoint(t, m, c) ==
    LET p     == PointFrom(t, FirstMinute(t, m))
        over  == OverUntil(t, c)
        begin == IF p > over THEN p ELSE PointFrom(t, over + 1)
    IN  IF p > t.repeatTo THEN p ELSE FirstUnserved(t, begin, c)

\* @type: ($tod, $moment, $cpu) => $tod;
Armed(t, m, c) == [t EXCEPT !.next = NextPoint(t, m, c)]

(* [AMB-56] [AMB-57] Settings are armed at moment m. If the readings lead  *)
(* to different points, the CPU shows its reading.                         *)
\* @type: (Set($tod), $moment) => Set($cpu);
CpusThatShow(settings, m) ==
    IF \E t \in settings :
         /\ m.min <= t.repeatTo
         /\ Cardinality({ NextPoint(t, m, c) : c \in CpusByMemory }) > 1
    THEN CpusByMemory ELSE {cpu}
=============================================================================
