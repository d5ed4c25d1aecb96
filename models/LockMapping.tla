----------------------------- MODULE LockMapping -----------------------------
(***************************************************************************)
(* The start events of System that CounterLock knows, for MCRefineLock and *)
(* APRefine: those whose OB is loaded, as soon as the mode lets it run. If *)
(* deferred in STARTUP, they arrive in RUN; in HOLD they go on waiting,    *)
(* and what STARTUP defers does not arrive [T15-121].                      *)
(***************************************************************************)
EXTENDS Properties

\* @type: Int => Set($request);
InClass(c) == { r \in requests : /\ r.class = c /\ r.ob \in loaded
                                 /\ \/ ModeAllows(r)
                                    \/ /\ mode = "HOLD"
                                       /\ \/ startup = "none"
                                          \/ r.ob \in AsyncErrorObs
                                               \ Family.heldBack }

\* @type: Int => Int;
WaitingIn(c) == Cardinality({ r \in InClass(c) : ~r.open })

(* The sources leave open whether a start event of the class waits. *)
\* @type: Int => Bool;
PerhapsIn(c) == \E r \in InClass(c) : r.open

(* The last step may have withdrawn start events. *)
MayWithdraw == step.event \in { "SET_TINT", "CAN_TINT", "SRT_DINT",
                                "CAN_DINT", "delete" }
=============================================================================
