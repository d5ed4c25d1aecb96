------------------------------ MODULE APRefine ------------------------------
(***************************************************************************)
(* System implements CounterLock, for Apalache: from any state in which    *)
(* Ind holds, in the world of APSystem, each action is a step of           *)
(* CounterLock or changes nothing of it.                                   *)
(*                                                                         *)
(* CounterLock has two classes here, and each is any.  That is enough for  *)
(* any number: Next speaks of one class that starts and, of each other, by *)
(* itself.  A start has to be of the first class, since another is another *)
(* case of the same query.                                                 *)
(*                                                                         *)
(* A start event counts as in MCRefineLock: if its OB is loaded and the    *)
(* mode lets it run, or if HOLD alone keeps it from running.               *)
(***************************************************************************)
EXTENDS APSystem

CONSTANTS
    \* @type: Int;
    AnyClass,
    \* @type: Int;
    OtherClass

RefineConstants == /\ AnyConstants
                   /\ AnyClass \in 1..28
                   /\ OtherClass \in 1..28

APClasses == {AnyClass, OtherClass}

(* Four OBs run after the step. *)
RunningClasses ==
    FunAsSeq([i \in DOMAIN stack |-> stack[i].class], Len(stack), 4)

\* @type: Int => Set($request);
InClass(c) == { r \in requests : /\ r.class = c /\ r.ob \in loaded
                                 /\ ModeAllows(r) \/ mode = "HOLD" }

Lock == INSTANCE CounterLock WITH
            Classes <- APClasses,
            on      <- mode # "STOP",
            held    <- mode = "HOLD",
            count   <- delay,
            running <- RunningClasses,
            waiting <- [c \in APClasses |->
                          Cardinality({ r \in InClass(c) : ~r.open })],
            perhaps <- { c \in APClasses : \E r \in InClass(c) : r.open }

StartsAnother == /\ Len(stack') > Len(stack)
                 /\ stack'[Len(stack')].class # AnyClass

LockBegins == Lock!Init
LockStep == StartsAnother \/ Lock!Next \/ UNCHANGED Lock!lockVars
=============================================================================
