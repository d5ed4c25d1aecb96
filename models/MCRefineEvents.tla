--------------------------- MODULE MCRefineEvents ---------------------------
(***************************************************************************)
(* System implements Conservation for the start events of a time-of-day    *)
(* OB, a hardware OB and OB 80 on an S7-300 and an S7-400, with DIS_IRT,   *)
(* CAN_TINT, the clock set forward, and STOP.                              *)
(*                                                                         *)
(* The history counts as an observer can: start events as they occur, of   *)
(* OB 80 by its entries in the diagnostic buffer; ends; blocked start      *)
(* events; start events that a call or STOP removes. Waiting, open and     *)
(* running ones are counted in the state. The rest is "merged": the model  *)
(* shows that only start events that may be merged are.                    *)
(***************************************************************************)
EXTENDS MCBase

MCTodObs == {10}
MCFamilies == TwoFamilies
MCLoads == {{10, 40, 80, 85}}
MCBlockable == {10, 40}
MCIrtModes == {0}
MCStep7Settings == { [o \in TodObs |-> Activated("minute", 1)],
                     [o \in TodObs |-> Activated("once", 0)] }
MCObNumbers == {0, 10}
(* Calls with an error change nothing: MCTod. *)
MCRetVals == {OK}
MCMoments == {Moment(1, 0), Moment(2, 0)}
MCPowerOnMoments == {Moment(0, 30000)}
MCClockTargets == {Moment(2, 30000)}
MCInterrupts == {<<40, 0>>}
MCRestartTypes == {"warm"}

MCObs == {10, 40, 80}
NoneYet == [o \in MCObs |-> 0]

VARIABLES
    \* @type: Int -> Int;
    occurred,
    \* @type: Int -> Int;
    served,
    \* @type: Int -> Int;
    lost,
    \* @type: Int -> Int;
    withdrawn,
    \* @type: Int -> Int;
    cleared

history == <<occurred, served, lost, withdrawn, cleared>>

\* @type: Int => Int;
Waits(o) == Cardinality({ r \in requests : r.ob = o /\ ~r.open })
\* @type: Int => Int;
Runs(o) == Cardinality({ i \in DOMAIN stack : stack[i].ob = o })

(* How many start events of an OB occur in this step. *)
\* @type: Int => Int;
Occurring(o) ==
    CASE o = 80 -> Cardinality({ n \in entered' : n.of.ob = 80 })
      [] o = 40 -> IF Did("interrupt") /\ mode # "STOP" THEN 1 ELSE 0
      [] OTHER  -> IF \/ Did("reached")
                      \/ Did("clock") /\ mode # "STOP" /\ Skipped(o)
                      \/ Did("restart") /\ PendingIn(requests', o)
                   THEN 1 ELSE 0

(* How many of them waiting are withdrawn: by a call, or since the OB of a *)
(* once interrupt is called for one.                                       *)
\* @type: Int => Int;
Withdrawing(o) ==
    IF Did("CAN_TINT") /\ step'.ob = o THEN Waits(o)
    ELSE IF o = 10 /\ Started(o) /\ tod[o].period = Once /\ Waits(o) > 0
    THEN Waits(o) - 1 ELSE 0

\* @type: (Int -> Int, Int -> Int) => (Int -> Int);
Plus(f, g) == [o \in MCObs |-> f[o] + g[o]]

EventsInit == /\ Init
              /\ occurred = NoneYet /\ served = NoneYet /\ lost = NoneYet
              /\ withdrawn = NoneYet /\ cleared = NoneYet
EventsNext ==
    /\ Next
    /\ occurred'  = Plus(occurred, [o \in MCObs |-> Occurring(o)])
    /\ served'    = Plus(served, [o \in MCObs |->
                      IF Did("end") /\ step'.ob = o THEN 1 ELSE 0])
    /\ lost'      = Plus(lost, [o \in MCObs |->
                      IF Blocked(o) /\ ~Did("restart") THEN Occurring(o)
                                                       ELSE 0])
    /\ withdrawn' = Plus(withdrawn, [o \in MCObs |-> Withdrawing(o)])
    /\ cleared'   = Plus(cleared, [o \in MCObs |->
                      IF step'.event \in {"stop", "switch"}
                      THEN Waits(o) + Runs(o) ELSE 0])
EventsSpec == EventsInit /\ [][EventsNext]_<<vars, history>>

\* @type: Int => (Str -> Int);
FatesOf(o) ==
    LET open == Cardinality({ r \in requests : r.ob = o /\ r.open })
        rest == occurred[o] - Waits(o) - open - Runs(o) - served[o] - lost[o]
                  - withdrawn[o] - cleared[o]
    IN  [ f \in { "waiting", "open", "running", "served", "lost", "withdrawn",
                  "cleared", "merged" } |->
            CASE f = "waiting"   -> Waits(o)
              [] f = "open"      -> open
              [] f = "running"   -> Runs(o)
              [] f = "served"    -> served[o]
              [] f = "lost"      -> lost[o]
              [] f = "withdrawn" -> withdrawn[o]
              [] f = "cleared"   -> cleared[o]
              [] OTHER           -> rest ]

Events == INSTANCE Conservation WITH
              Obs <- MCObs, fates <- [o \in MCObs |-> FatesOf(o)]

ConservationSpec == Events!Spec

EventsView == <<cpuVars, history>>

(* At most two start events, OB 80 not counted; nothing after a STOP. *)
Bounded == /\ occurred[10] + occurred[40] <= 2
           /\ mode = "STOP" => clock \in PowerOnMoments /\ occurred = NoneYet

(* The full lane: three. *)
Wide == /\ occurred[10] + occurred[40] <= 3
        /\ mode = "STOP" => clock \in PowerOnMoments /\ occurred = NoneYet
=============================================================================
