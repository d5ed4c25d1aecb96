------------------------------ MODULE Merging -------------------------------
(***************************************************************************)
(* The engine merges or shrinks explanations when there are many. The      *)
(* result allows at least as much: every line that an explanation allowed  *)
(* is still allowed. The report says from which line on.                   *)
(*                                                                         *)
(* Crowd: many open requests of one OB that differ only in their moment    *)
(* become one, which may start its OB as many times, with any time in its  *)
(* start information.                                                      *)
(* Meet: explanations that differ only in waiting start events from        *)
(* outside become one. A start event is open afterwards unless it is       *)
(* definite in all of them.                                                *)
(* Loosen, LastResort: when there are too many explanations to follow,     *)
(* each is reduced to the facts that hold regardless.                      *)
(*                                                                         *)
(* Source: docs/checking/log-format.md, fine points 9 and 11.              *)
(* Left out: how a log is judged by such facts (LooseLogs).                *)
(***************************************************************************)
EXTENDS Modes, Elapsing

-----------------------------------------------------------------------------
(* Many open requests of one OB *)

(* Up to so many equal requests are kept apart: fewer where many wait.     *)
Few == IF Cardinality(requests) > 40 THEN 1 ELSE 8

\* @type: $request => Bool;
MayRepeat(r) == /\ r.open /\ r.ob \in loaded
                /\ {r.fault, r.follows} \cap Skips = {}

(* The requests of this kind, if there are many and no definite request    *)
(* stands behind the first of them. The one for them takes the last place: *)
(* the start of a request that stands between ends those before it.        *)
\* @type: $request => Set($request);
CrowdOf(kind) ==
    LET alike == { r \in requests : MayRepeat(r) /\ Kind(r) = kind }
    IN  IF /\ Cardinality(alike) > Few
           /\ ~\E r \in alike, s \in requests :
                 s.class = r.class /\ s.rank > r.rank /\ ~s.open
        THEN alike ELSE {}

\* @type: Set($request) => $request;
OneFor(crowd) ==
    LET last == CHOOSE r \in crowd : \A s \in crowd : s.rank <= r.rank
    IN  [last EXCEPT !.since = NoMoment]

(* For how many starts a crowd stands; 0: for any number. Of a start point *)
(* nobody knows how many others have passed with it (Repeats).             *)
\* @type: Set($request) => Int;
RunsOfCrowd(crowd) ==
    LET several == { r \in crowd : IsCrowd(r) }
        \* @type: $request => Int;
        n(r)    == terms.crowds[AsItCame(r)]
    IN  IF \E r \in crowd : r.ob \in TodObs \cup {TimeErrorOb} THEN 0
        ELSE IF several = {} THEN Cardinality(crowd)
        ELSE IF Cardinality(several) > 1 \/ \E r \in several : n(r) = 0
        THEN 0
        ELSE Cardinality(crowd) - 1 + n(CHOOSE r \in several : TRUE)

Crowded == Cardinality(requests) > 8

Crowd ==
    LET crowds == { CrowdOf(k) : k \in { Kind(r) : r \in requests } } \ {{}}
        ones   == { OneFor(c) : c \in crowds }
        kept   == DOMAIN arrivals \cap DOMAIN terms.crowds
        \* @type: $request => Int;
        starts(k) ==
          LET its == { c \in crowds : AsItCame(OneFor(c)) = k }
          IN  IF its = {} THEN terms.crowds[k]
              ELSE RunsOfCrowd(CHOOSE c \in its : TRUE)
    IN  /\ Crowded /\ crowds # {}
        /\ requests' = Close((requests \ UNION crowds) \cup ones)
        /\ terms' = [ terms EXCEPT
                         !.crowds = [ k \in kept \cup { AsItCame(r) :
                                                      r \in ones } |->
                                        starts(k) ] ]
        /\ arrivals' = [ r \in { AsItCame(q) : q \in requests' } |->
                           IF r \in DOMAIN arrivals THEN arrivals[r] ELSE up ]
        /\ NothingEntered
        /\ UNCHANGED <<deviceVars, modeVars, clock, settingVars, stopCause,
                       runVars, up, waiting, first, overruns, changes, pace,
                       reports>>

-----------------------------------------------------------------------------
(* Explanations that differ in their waiting start events *)

Others == { r \in requests : ~Outside(r) }

(* Two explanations can meet if these values are equal. *)
MeetingPlace ==
    LET came == { [of |-> AsItCame(r), r |-> r] : r \in Others }
    IN << cpu.readings, loaded, mode, startup, resume, clock, tod, dint, irt,
       stack, delay, stopCause, up, first, overruns, changes,
       [terms EXCEPT !.crowds = [k \in DOMAIN @ |-> 0]], pace,
       { << [c.r EXCEPT !.rank = 0],
            Cardinality({ d \in came : d.of = c.of }) >> : c \in came },
       DOMAIN waiting \cap
         (UNION { {r.class, r.class + 100} : r \in Others }
          \cup {StopDuty, CallDuty}) >>

(* The values in which they may differ. *)
Waits == [requests |-> requests, waiting |-> waiting, arrivals |-> arrivals,
          reports |-> reports, crowds |-> terms.crowds]

(* A request without its place. What was told of its overload stays.       *)
\* @type: $request => $request;
Unplaced(r) == [r EXCEPT !.rank = 0, !.open = FALSE]

(* A request without its place, and its number among equal requests. *)
\* @type: (Set($request), $request) => $tag;
Tag(q, r) ==
    LET of == Unplaced(r)
    IN  [ of  |-> of,
          nth |-> Cardinality({ s \in q : /\ s.since = of.since
                                         /\ s.rank <= r.rank
                                         /\ Unplaced(s) = of }) ]

\* @type: Set($request) => Set({ tag: $tag, r: $request });
Tagged(q) == { [tag |-> Tag(q, r), r |-> r] : r \in q }

(* The tags below the tags below each tag. *)
\* @type: ($tag -> Set($tag)) => ($tag -> Set($tag));
Farther(below) ==
    [ g \in DOMAIN below |-> UNION { below[h] : h \in below[g] } ]

(* Paths 16 times as long. If paths twice as long lead to no further tag,  *)
(* no path does.                                                           *)
\* @type: ($tag -> Set($tag)) => ($tag -> Set($tag));
Far(below) ==
    LET next == Farther(below)
    IN  IF next = below THEN below ELSE Farther(Farther(Farther(next)))

(* Places that contradict none of these queues: a request stands before    *)
(* another if it does so in some queue, also by way of others, and stands  *)
(* behind it in none. A path passes a tag once at most: 256 steps suffice  *)
(* for 256 requests in a class. More wait only if an OB is requested again *)
(* and again, and then the queues agree on the order. The engine evaluates *)
(* no recursion.                                                           *)
\* @type: Set(Set({ tag: $tag, r: $request })) => ($tag -> Int);
Places(queues) ==
    LET tags  == UNION { { t.tag : t \in q } : q \in queues }
        parts == [ c \in { g.of.class : g \in tags } |->
                     { { t \in q : t.r.class = c } : q \in queues } ]
        (* @type: (Set({ tag: $tag, r: $request }),                        *)
        (*         { tag: $tag, r: $request }) => Set($tag);               *)
        upTo(q, u) == { t.tag : t \in { v \in q : v.r.rank <= u.r.rank } }
        once  == [ g \in tags |->
                     UNION { UNION { upTo(q, u)
                                     : u \in { t \in q : t.tag = g } }
                             : q \in parts[g.of.class] } ]
        all   == Far(Far(once))
    IN  [ g \in tags |-> Cardinality(all[g]) ]

(* Equal requests have places of their own; otherwise one request stands   *)
(* for all of them.                                                        *)
\* @type: ($tag, $tag -> Int) => Bool;
Apart(g, places) ==
    { h \in DOMAIN places : h.of = g.of /\ places[h] = places[g] } = {g}

(* The classes in which some explanations have an OB that may start, and   *)
(* others have none.                                                       *)
\* @type: Set($waits) => Set(Int);
Unequal(all) ==
    { c \in UNION { DOMAIN w.waiting : w \in all } :
        \E w \in all : c \notin DOMAIN w.waiting }

(* How long class or key c has waited in an explanation.                   *)
\* @type: ($waits, Int) => Int;
WaitedIn(w, c) ==
    LET known == { k \in {c, c - 100} : k \in DOMAIN w.waiting }
        times == { w.waiting[k] : k \in known }
    IN  IF times = {} THEN 0 ELSE CHOOSE m \in times : \A n \in times : m <= n

\* @type: Set($waits) => Set($report);
ReportsOf(all) ==
    LET sure == { r \in UNION { w.reports : w \in all } :
                    \A w \in all : r \in w.reports }
        some == UNION { w.reports : w \in all } \ sure
    IN  IF DiagRecorded
        THEN sure \cup { [r EXCEPT !.entry.open = TRUE] : r \in some }
        ELSE { r \in sure \cup some :
                 ~\E s \in some : s.entry = r.entry /\ s.times > r.times }

(* The explanations that differ in these `Waits' become one. *)
\* @type: Set($waits) => Bool;
Meet(all) ==
    LET queues  == { Tagged(w.requests) : w \in all }
        places  == Places(queues)
        \* @type: $tag => Bool;
        definite(g) ==
          /\ g.of.class \notin Unequal(all)
          /\ \A q \in queues : \E t \in q : t.tag = g /\ ~t.r.open
        \* @type: $request => $moment;
        latest(r) ==
          LET know == { w \in all : r \in DOMAIN w.arrivals }
              came == { w.arrivals[r] : w \in know }
          IN  IF came = {} THEN up
              ELSE CHOOSE m \in came : \A n \in came : ~Before(m, n)
        together == { AsItCame(g.of) : g \in { h \in DOMAIN places :
                                                 ~Apart(h, places) } }
        \* @type: $request => Int;
        starts(k) ==
          LET most == { w.crowds[k] : w \in all }
          IN  IF k \in together \/ 0 \in most THEN 0
              ELSE CHOOSE m \in most : \A n \in most : n <= m
        \* Waits that have begun in all explanations go on under a delay.
        goOn == { c \in { WaitsAs(r) : r \in { q \in requests' :
                                            MayGoOnWaiting(q)' } } :
                    \A w \in all : {c, c - 100} \cap DOMAIN w.waiting # {} }
                  \cup (DOMAIN waiting \cap {StopDuty})
    IN  /\ requests' = Close({ [ g.of EXCEPT !.rank = places[g],
                                              !.open = ~definite(g) ]
                               : g \in DOMAIN places })
        /\ arrivals' = [ r \in { AsItCame(q) : q \in requests' } |->
                           latest(r) ]
        /\ NothingEntered
        /\ UNCHANGED <<deviceVars, modeVars, clock, settingVars, stopCause,
                       runVars, up, first, overruns, changes, pace>>
        /\ waiting' = [ c \in Awaited' \cup goOn |->
                          LET times == { WaitedIn(w, c) : w \in all }
                          IN  CHOOSE m \in times : \A n \in times : m <= n ]
        /\ reports' = ReportsOf(all)
        /\ terms' = [ terms EXCEPT
                         !.unsure = @ \cup
                           { r.ob : r \in { q \in requests' : q.open } },
                         !.crowds = [ k \in DOMAIN @ \cup together |->
                                         starts(k) ] ]

-----------------------------------------------------------------------------
(* Definite facts alone *)

(* From this line on only definite facts count. Earlier calls and start    *)
(* events count as unseen, and a running OB may have ended.                *)
\* @type: Set(Str) => Bool;
OnlyFacts(records) ==
    /\ terms' = [ terms EXCEPT !.loose = TRUE, !.records = records,
                                !.crowds = [r \in {} |-> 0],
                                !.unsure = {}, !.early = {} ]
    /\ tod' = [o \in TodObs |-> NoSetting]
    /\ dint' = NoJobs /\ irt' = NoneBlocked
    /\ requests' = {} /\ stopCause' = NoCause /\ delay' = 0
    /\ waiting' = [c \in {} |-> 0] /\ reports' = {}
    /\ first' = "unknown" /\ overruns' = 0 /\ changes' = {}
    /\ arrivals' = [r \in {} |-> up]
    /\ LET seen == IF Unseen("ob") \/ stack = <<>> THEN <<>>
                   ELSE [stack EXCEPT ![Len(stack)].error = 0]
       IN  stack' = IF mode = "STOP" THEN <<>>
                    ELSE IF /\ seen # <<>>
                            /\ seen[1].ob \in CycleObs \cup StartupObs
                    THEN seen
                    ELSE << IF mode = "STARTUP" THEN Frame(100, StartupClass)
                            ELSE Frame(CycleOb, 1) >> \o seen
    /\ resume' = [ resume EXCEPT !.dint = NoJobs, !.requests = {},
                                !.due = FALSE ]
    /\ NothingEntered
    /\ UNCHANGED <<deviceVars, mode, startup, clock, up, pace>>

(* For a log that leaves kinds out and has too many explanations.          *)
Loosen == /\ Partial
          /\ ~terms.loose
          /\ OnlyFacts(terms.records \ {"call", "interrupt"})

(* For any log with too many explanations, also where only facts count     *)
(* already. An OB that is loaded now may have been missing before, and     *)
(* that may still have to be reported.                                     *)
LastResort == /\ terms.loose => "call" \in terms.records
              /\ OnlyFacts(terms.records \ {"call", "interrupt", "load"})
=============================================================================
