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

\* @type: Int => Bool;
Skipped(o) == /\ tod[o].active /\ ~Deselected(o)
              /\ Before(At(tod[o].next), clock')

SkippedNow == { o \in TodObs : Skipped(o) }

(* [CLK-02] [CLK-05] [CLK-06] [OBS-32] A skip in RUN is one time error     *)
(* with fault 05, which names the skipped interrupts; without OB 80 it is  *)
(* STOP.                                                                   *)
SkipProp ==
    [][ Did("clock") /\ mode = "RUN" /\ SkippedNow # {} /\ irt.blocked = {} =>
          IF 80 \in loaded
          THEN /\ Cardinality({ r \in requests' : r.ob = 80 })
                    = Cardinality({ r \in requests : r.ob = 80 }) + 1
               /\ \E r \in requests' \ requests :
                    /\ r.ob = 80 /\ r.fault = 5 /\ r.late = SkippedNow
                    /\ r.since = clock'
          ELSE stopCause' # NoCause ]_vars

(* An open request may have been confirmed; it is not new. *)
\* @type: Int => Set($request);
NewOf(o) == { r \in requests' \ requests :
                r.ob = o /\ [r EXCEPT !.open = TRUE] \notin requests }

(* [CLK-03] [CLK-07] Each skipped interrupt runs once, for its first       *)
(* skipped point, after the OB 80; an OB that waits or runs may get no     *)
(* run. Without OB 80 none gets a run [CLK-05].                            *)
CatchUpProp ==
    [][ Did("clock") /\ mode = "RUN" /\ irt.blocked = {} =>
          \A o \in TodObs :
            LET new == NewOf(o)
            IN  IF TimeErrorOb \notin loaded THEN new = {} ELSE
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

(* [OBS-46] [AMB-55] On release one time error with fault 06 reports the   *)
(* points that passed in HOLD; the catch-ups are open.                     *)
HoldSkipProp ==
    [][ Did("release") /\ SkippedNow # {} /\ irt.blocked = {} =>
          IF 80 \in loaded
          THEN \E r \in requests' \ requests :
                 r.ob = 80 /\ r.fault = 6 /\ r.late = SkippedNow /\ ~r.open
          ELSE stopCause' # NoCause ]_vars

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
