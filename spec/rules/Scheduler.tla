----------------------------- MODULE Scheduler ------------------------------
(***************************************************************************)
(* OBs start and end: dispatch of requests, the cycle of OB 1, the startup *)
(* OB (section 5.1).                                                       *)
(*                                                                         *)
(* Left out: OBs that are missing (MissingObs).                            *)
(***************************************************************************)
EXTENDS ServedPoints

(* An open request turns out to have no effect when its OB could start. *)
\* @type: $request => Bool;
Drop(r) ==
    /\ MayStart(r)
    /\ r.open
    /\ requests' = Close(requests \ {r})
    /\ NothingEntered
    /\ UNCHANGED <<deviceVars, modeVars, clock, settingVars, stopCause,
                   runVars>>

-----------------------------------------------------------------------------
(* Once interrupts *)

(* [TINT-08] The call of its OB cancels a once, even if the clock was set  *)
(* back meanwhile and its point is ahead again [AMB-59] [CLK-12]. An       *)
(* interrupt that was set anew stays.                                      *)
\* @type: $request => Bool;
LastCall(r) ==
    /\ r.ob \in TodObs /\ tod[r.ob].active /\ HasOnePoint(tod[r.ob].period)
    /\ tod[r.ob].next = Never \/ r.since = FirstMoment(tod[r.ob])

\* @type: Int => (Int -> $tod);
TodUsedUp(o) == [tod EXCEPT ![o] = UsedUp(@)]

\* @type: Int => (Int -> $tod);
TodCalled(o) == [tod EXCEPT ![o].next = Never, ![o].called = TRUE]

(* [AMB-71] A once is used up when its OB starts, or when it ends. *)
\* @type: $request => Set(Int -> $tod);
TodsAfterStart(r) ==
    IF ~LastCall(r) THEN {tod}
    ELSE (IF OnceMayEndAtItsStart THEN {TodUsedUp(r.ob)} ELSE {})
           \cup (IF OnceMayEndAtItsEnd THEN {TodCalled(r.ob)} ELSE {})

\* @type: Int => (Int -> $tod);
TodAfterEnd(o) == IF o \in TodObs /\ tod[o].called THEN TodUsedUp(o) ELSE tod

(* A cancelled interrupt loses its other requests, too [AMB-11].           *)
\* @type: $request => Set($request);
RequestsAfterCall(r) ==
    IF LastCall(r) THEN Withdraw(Remove(requests, r), r.ob)
                   ELSE Remove(requests, r)

-----------------------------------------------------------------------------
(* Start and end *)

(* [OBS-01] [OBS-02] [OBS-03] The OB of request r starts. *)
\* @type: $request => Bool;
Start(r) ==
    /\ MayStart(r)
    /\ r.ob \in loaded
    /\ stack'    = Append(stack, Frame(r.ob, r.class))
    /\ requests' = RequestsAfterCall(r)
    /\ tod'      \in TodsAfterStart(r)
    /\ NothingEntered
    /\ UNCHANGED <<deviceVars, modeVars, clock, dint, irt, stopCause, delay>>

(* [AMB-45] When OB 85 ends, it may have reported all missing OBs.         *)
Excused ==
    LET missing == { r \in requests : r.ob \notin loaded \cup AsyncErrorObs }
    IN  CASE OneOb85ForAll  -> Close(requests \ missing)
          [] OneOb85ForEach -> requests
          [] OTHER -> (requests \ missing)
                        \cup { [r EXCEPT !.open = TRUE] : r \in missing }

(* [AIRT-04] The delay count falls to 0 when the OB has been processed     *)
(* [AMB-25].                                                               *)
\* @type: Int => Bool;
End(o) ==
    /\ Running.ob = o
    /\ mode # "HOLD"
    /\ stack' = SubSeq(stack, 1, Len(stack) - 1)
    /\ delay' = IF o = CycleOb /\ CountOutlivesTheCycle THEN delay ELSE 0
    /\ requests' = IF o = ProgramErrorOb THEN Excused ELSE requests
    /\ tod' = TodAfterEnd(o)
    /\ NothingEntered
    /\ UNCHANGED <<deviceVars, modeVars, clock, dint, irt, stopCause>>

-----------------------------------------------------------------------------
(* OB 1 and the startup OB *)

(* OB 1 is always there; it starts when nothing runs. *)
CycleStarts ==
    /\ mode = "RUN"
    /\ stack = <<>>
    /\ stack' = <<Frame(CycleOb, 1)>>
    /\ NothingEntered
    /\ UNCHANGED <<deviceVars, modeVars, clock, settingVars, outcomeVars,
                   delay>>

(* [OBS-42] [OBS-55] *)
\* @type: Int => Bool;
StartupStarts(o) ==
    /\ startup \in {"warm", "cold"}
    /\ o = StartupOb(startup)
    /\ o \in loaded
    /\ stack = <<>>
    /\ stack'   = <<Frame(o, 27)>>
    /\ startup' = "begun"
    /\ NothingEntered
    /\ UNCHANGED <<deviceVars, mode, clock, settingVars, outcomeVars, delay>>
=============================================================================
