----------------------------- MODULE MCInductive ----------------------------
(***************************************************************************)
(* IndInv is inductive: every state of the domains below in which it holds *)
(* is an initial state, one step of System is taken from each, and IndInv  *)
(* is checked after it. The next state may be outside the domains.         *)
(*                                                                         *)
(* One time-of-day OB and one hardware OB; the clock stands at 06:01,      *)
(* where a point may be past, due or ahead; delays to 2; two start events  *)
(* that wait in any places, sure or open, that of OB 80 among them; two    *)
(* OBs that run.                                                           *)
(***************************************************************************)
EXTENDS MCBase, Inductive

MCTodObs == {10}
MCFamilies == {}
MCLoads == {}
MCBlockable == {10}
MCIrtModes == {2, 130}
MCStep7Settings == {}
MCObNumbers == {10}
MCSdts == {Date(1), Date(2)}
MCWords == {Once, Minutely}
MCRetVals == {0, 1, 2, 3, NotDelayed}
MCMoments == {Moment(1, 30000), Moment(2, 0)}
MCPowerOnMoments == {}
MCClockTargets == {Moment(0, 30000), Moment(2, 30000)}
MCInterrupts == {<<40, 0>>, <<80, 1>>}
MCRestartTypes == {"warm"}
MCChangingObs == {80}
\* @type: Bool;
Holding == TRUE

-----------------------------------------------------------------------------
(* Domains *)

\* @type: (Str, $step7) => $cpu;
Cpu(family, step7) ==
    [ family |-> family, priority |-> [o \in {} |-> 0],
      step7 |-> [o \in TodObs |-> step7], readings |-> [a \in {} |-> ""],
      classes |-> [o \in {} |-> 0],
      queues |-> [o \in {} |-> [size |-> 1, limit |-> 0, told |-> 0]],
      zone |-> 0, hour |-> NoHour ]

(* CPUs with their loaded OBs. *)
Cpus == { <<Cpu("S7-300", Activated("once", 0)), {10, 40, 80, 85}>>,
          <<Cpu("S7-400", [Activated("minute", 1) EXCEPT !.deselected = TRUE]),
            {40, 85}>> }

(* The full lane: OB 10 is missing too. *)
MoreCpus == Cpus \cup { <<Cpu("S7-300", Activated("once", 0)), {40, 80, 85}>> }

ChosenCpus == Cpus

ModesOfStart ==
    { <<"STOP", "none">>, <<"STARTUP", "warm">>, <<"STARTUP", "begun">>,
      <<"RUN", "none">>, <<"HOLD", "none">> }

(* Not set, set, or active with any point to watch for. *)
Settings ==
    { NoSetting, [NoSetting EXCEPT !.set = TRUE, !.start = Six + 1] }
      \cup { [ NoSetting EXCEPT !.set = TRUE, !.active = TRUE,
                               !.start = Six + 1, !.period = period,
                               !.next = next ]
             : period \in {Once, Minutely},
               next \in {Never} \cup (Six..Six + 2) }

(* Enough for negative controls that are not about settings. *)
FewSettings ==
    { NoSetting, [ NoSetting EXCEPT !.set = TRUE, !.active = TRUE,
                                    !.start = Six + 1, !.period = Once ] }

\* @type: (Int, Int, Int, Bool) => $request;
Waits(o, class, rank, open) ==
    [ NoRequest EXCEPT !.ob = o, !.class = class, !.rank = rank,
                       !.since = Moment(1, 0), !.open = open ]

Records ==
    { Waits(10, 2, rank, open) : rank \in 1..2, open \in BOOLEAN }
      \cup { [Waits(10, 2, 1, FALSE) EXCEPT !.follows = StillRunning],
             Waits(40, 16, 1, FALSE),
             [ Waits(80, 26, 1, FALSE) EXCEPT
                 !.fault = StillRunning, !.late = {10}, !.cause = 10 ] }

TwoWaiting == {{}} \cup { {r, s} : r \in Records, s \in Records }

Frames == { Frame(1, 1), Frame(10, 2), Frame(40, 16), Frame(100, 27) }
Stacks == {<<>>} \cup { <<f>> : f \in Frames }
            \cup { <<f, g>> : f \in Frames, g \in Frames }

-----------------------------------------------------------------------------

VARIABLE
    (* The step has been taken. *)
    \* @type: Bool;
    taken

(* Conjuncts of IndInv stand between, where they save states. *)
IndInit ==
    /\ \E c \in ChosenCpus : cpu = c[1] /\ loaded = c[2]
    /\ \E m \in ModesOfStart : mode = m[1] /\ startup = m[2]
    /\ resume = NothingKept
    /\ stack \in Stacks
    /\ StackInv /\ StartingInv
    /\ requests \in TwoWaiting
    /\ QueueInv
    /\ DeselectedWaitsInv
    /\ tod \in [TodObs -> Settings]
    /\ ActiveInv
    /\ delay \in 0..2
    /\ stopCause \in {NoCause, NoTimeErrorOb}
    /\ irt \in [blocked : SUBSET Blockable, silent : SUBSET Blockable]
    /\ clock = Moment(1, 0)
    /\ dint = NoJobs
    /\ entered = {}
    /\ step = Step("any", 0, 0)
    /\ IndInv
    /\ taken = FALSE

IndNext == ~taken /\ Next /\ taken' = TRUE

IndSpec == IndInit /\ [][IndNext]_<<vars, taken>>

IndView == <<cpuVars, taken>>

(* States after the step are checked, and left. *)
Asked == ~taken
=============================================================================
