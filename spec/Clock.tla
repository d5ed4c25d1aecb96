-------------------------------- MODULE Clock -------------------------------
(***************************************************************************)
(* The CPU clock: time passes, and the clock is set by SFC 0, a programming *)
(* device or synchronisation, one rule for all [CLK-01] (catalogue section *)
(* 6, and 1.1).                                                            *)
(*                                                                         *)
(* Left out: the limits of synchronisation, OB 87 [CLK-15].                *)
(***************************************************************************)
EXTENDS StartPoints

(* No start point is left behind: one that equals the clock must have been  *)
(* dealt with, and the clock stops at the next one.                        *)
\* @type: $moment => Bool;
PassesNoPoint(t) ==
    Watching => \A o \in DOMAIN tod :
                  tod[o].active => /\ tod[o].next >= t.min
                                   /\ tod[o].next = t.min => t.ms = 0
                                   /\ clock # At(tod[o].next)

\* @type: $moment => Bool;
TimePasses(t) ==
    /\ Before(clock, t)
    /\ PassesNoPoint(t)
    /\ clock' = t
    /\ UNCHANGED <<cpu, loaded, mode, startup, tod, requests, stack, delay,
                   stopCause>>

-----------------------------------------------------------------------------

(* The active interrupts with points between the old and the new time.  A   *)
(* point that equals the new time is reached, not skipped [AMB-37].        *)
\* @type: $moment => Set(Int);
SkippedBy(to) == { o \in DOMAIN tod : /\ tod[o].active
                                      /\ ~Deselected(o)
                                      /\ Before(At(tod[o].next), to) }

\* @type: ($tod, $moment) => $tod;
Repeating(t, to) ==
    IF Remembers /\ Before(to, clock) /\ clock.min > t.repeatTo
    THEN [t EXCEPT !.repeatTo = clock.min] ELSE t

(* The interrupts after the clock was set. *)
\* @type: ($moment, Str) => (Int -> $tod);
Rearmed(to, reading) ==
    [ o \in DOMAIN tod |->
        LET t    == Repeating(tod[o], to)
            next == NextPoint(t, to, reading)
            last == FirstPoint(t.start, t.period, t.next + 1)
        IN  IF ~t.active \/ next = t.next THEN t
            ELSE IF o \notin SkippedBy(to) THEN [t EXCEPT !.next = next]
            ELSE IF Before(At(last), to)
            THEN [ServedOnce(t, t.next, next) EXCEPT !.next = next]
            ELSE [Served(t, t.next) EXCEPT !.next = next] ]

(* [AMB-56] [AMB-57] Set back, the clock makes the CPU show how it reads    *)
(* what no source decides.                                                 *)
\* @type: (Str, Bool) => Set(Str);
Shown(a, asked) == IF asked /\ Reading(a) = "c" THEN {"a", "b"} ELSE {Reading(a)}

\* @type: (Str, Str) => (Str -> Str);
ReadingsWith(unserved, anew) ==
    [ a \in DOMAIN cpu.readings \cup {"AMB-56", "AMB-57"} |->
        IF a = "AMB-56" THEN unserved
        ELSE IF a = "AMB-57" THEN anew ELSE cpu.readings[a] ]

(* [CLK-02] [CLK-03] [CLK-06] [OBS-46] One OB 80 for all, then one catch-up  *)
(* each, in any order [AMB-54].  Whether an OB that waits or runs gets one  *)
(* of its own is open [AMB-52], and so are all after HOLD [AMB-55].        *)
\* @type: (Int, $moment, Set(Int)) => Bool;
Skip(fault, since, skipped) ==
    \E merged \in SUBSET { o \in skipped : OnStack(o) \/ PendingIn(requests, o) } :
      LET error == [TimeError(fault, skipped, 0, 0) EXCEPT !.since = since]
          runs  == { [ TodRequest(o, At(tod[o].next), fault) EXCEPT
                         !.open = fault = SkippedInHold ]
                     : o \in skipped \ merged }
      IN  /\ requests'  = WithTimeError(EnterAll(requests, runs), error)
          /\ stopCause' = StopOfTimeError

(* [AMB-53] In STARTUP the runs may also be deferred without OB 80. *)
\* @type: Set(Int) => Bool;
Defer(skipped) ==
    /\ requests' = EnterAll(requests,
                     { TodRequest(o, At(tod[o].next), 0)
                       : o \in { s \in skipped : ~PendingIn(requests, s) } })
    /\ UNCHANGED stopCause

(* [AMB-53] In HOLD the points that are skipped may also wait for release.  *)
\* @type: $moment => Bool;
ClockSet(to) ==
    LET skipped == IF mode = "STOP" THEN {} ELSE SkippedBy(to)
        back    == Remembers /\ Before(to, clock)
    IN  /\ to # clock
        /\ clock' = to
        /\ \E unserved \in Shown("AMB-56", back), anew \in Shown("AMB-57", back),
              deferred \in IF mode = "HOLD" THEN BOOLEAN ELSE {FALSE} :
             /\ tod' = [ o \in DOMAIN tod |->
                          IF mode = "STOP" THEN Repeating(tod[o], to)
                          ELSE IF deferred /\ o \in skipped THEN tod[o]
                          ELSE Rearmed(to, unserved)[o] ]
             /\ IF back
                THEN cpu' = [cpu EXCEPT !.readings = ReadingsWith(unserved, anew)]
                ELSE UNCHANGED cpu
             /\ IF skipped = {} \/ deferred THEN Nothing
                ELSE \/ Skip(SkippedByClock, to, skipped)
                     \/ mode = "STARTUP" /\ Defer(skipped)
        /\ UNCHANGED <<loaded, mode, startup, stack, delay>>
=============================================================================
