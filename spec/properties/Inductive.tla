------------------------------ MODULE Inductive -------------------------------
(***************************************************************************)
(* Inductive invariants: whatever state they hold in, reachable or not,    *)
(* they hold after every step of System.                                   *)
(*                                                                         *)
(* On IndInv rest the rules of priority classes, delays, queues, settings  *)
(* and modes. models/MCInductive checks the step for all states of small   *)
(* domains. By Ind Apalache proves the properties of System for every      *)
(* clock, delay count and operand; `s7spec prove' proves this, and         *)
(* models/APSystem has the states that it begins with.                     *)
(*                                                                         *)
(* Left out of IndInv: times, points served, and the classes of settable   *)
(* priorities. Left out of Ind: readings other than the defaults;          *)
(* synchronous errors, of which any number may be nested (OBS-61).         *)
(***************************************************************************)
EXTENDS Properties

(* [OBS-41] In STOP no OB runs or waits, no delay is active and no STOP is *)
(* due.                                                                    *)
StoppedInv == mode = "STOP" => /\ stack = <<>> /\ requests = {} /\ delay = 0
                               /\ stopCause = NoCause /\ startup = "none"

(* [OBS-42] [OBS-43] STARTUP and its OB belong together. Behind the OB no  *)
(* delay is on, so that no error of STARTUP waits when RUN begins.         *)
(* [T15-121] An S7-1500 may be held in STARTUP.                            *)
StartingInv ==
    /\ mode = "STARTUP" => startup # "none"
    /\ startup # "none" =>
         /\ mode = "STARTUP" \/ (mode = "HOLD" /\ Family.holdsStartup)
         /\ stack = <<>> => delay = 0
    /\ \A i \in DOMAIN stack :
         IF startup # "none"
         THEN stack[i].ob \in StartupObs \cup AsyncErrorObs \cup SyncErrorObs
         ELSE stack[i].ob \notin StartupObs

(* [TINT-05] [TINT-31] [TINT-50] An active interrupt is set; an inactive   *)
(* interrupt is not watched and does not wait.                             *)
ActiveInv ==
    \A o \in TodObs :
      /\ tod[o].active => tod[o].set
      /\ ~tod[o].active => /\ tod[o].next = Never
                           /\ \/ MissingObEndsItsSource  \* [AMB-46]
                              \/ { r \in requests : r.ob = o } = {}

(* [TINT-02] (c) [OBS-06] A deselected OB does not wait. *)
DeselectedWaitsInv == \A r \in requests : ~Deselected(r.ob)

(* [OBS-07] A request has its place in the queue of its class. *)
PlaceInv == \A r \in requests : r.rank >= 1 /\ r.class >= 1

(* [OBS-01] [AIRT-12] [OBS-02] [IRT-20] and all of the above. *)
IndInv == /\ StackInv
          /\ AirtInv
          /\ delay >= 0
          /\ StoppedInv
          /\ StartingInv
          /\ QueueInv
          /\ PlaceInv
          /\ ActiveInv
          /\ DeselectedWaitsInv
          /\ SilentInv

-----------------------------------------------------------------------------
(* For any clock, count and operand *)

\* @type: Int => Bool;
IsPoint(p) == p = Never \/ p \in 0..LastMinute

(* Runs of served points lie between the years of the clock. *)
\* @type: (Int, Int) => Bool;
IsRun(from, to) == 0 <= from /\ from <= to /\ to <= LastMinute

(* [TINT-30] [TINT-33] [AMB-14] The data of a setting, by the clock. *)
SettingDataInv ==
    \A o \in TodObs :
      /\ tod[o].start \in 0..LastMinute
      /\ tod[o].offset = 0 /\ tod[o].zone = 0
      /\ tod[o].period \in Periods
      /\ IsPoint(tod[o].next)
      /\ tod[o].period = Once => tod[o].next \in {tod[o].start, Never}
      /\ \A i \in tod[o].served \cup tod[o].merged : IsRun(i.from, i.to)
      /\ \A i \in tod[o].earlier : /\ IsRun(i.from, i.to)
                                    /\ i.start \in 0..LastMinute
                                    /\ i.period \in Periods /\ i.zone = 0
      /\ tod[o].repeatTo >= -1
      /\ tod[o].held => /\ mode \in {"HOLD", "STOP"} \/ resume.due
                        /\ tod[o].active /\ tod[o].next # Never
                        /\ ~Deselected(o)

(* [CLK-09] [CLK-10] Only a CPU that does not serve a point again remembers. *)
MemoryInv ==
    Remembers \/ \A o \in TodObs : /\ tod[o].repeatTo = -1
                                   /\ tod[o].served = {}
                                   /\ tod[o].merged = {}
                                   /\ tod[o].earlier = {}

(* [AMB-71] A one-shot interrupt that its call uses up is not watched for, *)
(* and no other run of its OB waits.                                       *)
CalledInv ==
    \A o \in TodObs :
      tod[o].called => /\ tod[o].active /\ tod[o].period = Once
                       /\ tod[o].next = Never
                       /\ mode = "STOP" \/ OnStack(o)
                       /\ { r \in requests : r.ob = o } = {}

(* [TINT-08] A one-shot interrupt has one point, its start. *)
OnceInv ==
    \A r \in requests :
      r.ob \in TodObs /\ tod[r.ob].period = Once =>
        r.since = FirstMoment(tod[r.ob])

(* [OBS-04] [OBS-05] [OBS-43] [AMB-13] The class of a start event and of   *)
(* its OB. In STARTUP an asynchronous error has class 28, by two letters.  *)
\* @type: (Int, Int) => Bool;
HasClass(o, c) ==
    IF o \notin AsyncErrorObs \/ ~Family.raises THEN c = ClassOf(o)
    ELSE \/ c = 28
         \/ /\ c = ClassOf(o)
            /\ mode # "STARTUP" \/ (o = TimeErrorOb /\ ~Class28InStartup)

RequestDataInv ==
    \A r \in requests :
      /\ r.ob \in TodObs \cup DintObs \cup ExternalObs
      /\ HasClass(r.ob, r.class)
      /\ r.ob \in AsyncErrorObs => r.follows = 0

(* [OBS-43] An error of STARTUP definitely waits, and no longer than until *)
(* RUN: its OB can start there. OB 80 may also have class 28 in RUN.       *)
StartupErrorInv ==
    Family.raises =>
      \A r \in requests :
        r.ob \in AsyncErrorObs \ {TimeErrorOb} /\ r.class = 28 =>
          mode = "STARTUP" /\ ~r.open

FrameDataInv ==
    \A i \in DOMAIN stack :
      LET o == stack[i].ob
          c == stack[i].class
      IN  /\ stack[i].error = 0
          /\ \/ o = CycleOb /\ c = 1
             \/ o \in StartupObs /\ c = StartupClass
             \/ /\ o \in TodObs \cup DintObs \cup ExternalObs
                /\ HasClass(o, c)
                /\ ~Deselected(o)

(* [DINT-10] [AMB-47] OverlapInv for a time-delay OB. *)
LaterDelayInv ==
    \A o \in DintObs :
      Cardinality({ r \in requests :
                      r.ob = o /\ r.follows = StillRunning }) <= 1

(* [OBS-02] Two start events of an OB have two places. Two time errors may *)
(* share one.                                                              *)
OwnPlaceInv ==
    \A r, s \in requests :
      /\ r.ob = s.ob /\ r.ob # TimeErrorOb
      /\ r.class = s.class /\ r.rank = s.rank
      => r = s

Ind == /\ IndInv
       /\ IsMoment(clock)
       /\ JobInv
       /\ SettingDataInv
       /\ MemoryInv
       /\ CalledInv
       /\ OnceInv
       /\ RequestDataInv
       /\ StartupErrorInv
       /\ OwnPlaceInv
       /\ FrameDataInv
       /\ DueInv
       /\ OverlapInv
       /\ LaterDelayInv
=============================================================================
