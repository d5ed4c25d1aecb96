------------------------------ MODULE APRefine ------------------------------
(***************************************************************************)
(* System implements CounterLock and LifeCycle, for Apalache: from any     *)
(* state in which Ind holds, in the world of APSystem, each action is a    *)
(* step of each of them or changes nothing of it.                          *)
(*                                                                         *)
(* CounterLock has two classes here, and each is any.  That is enough for  *)
(* any number: Next speaks of one class that starts and, of each other, by *)
(* itself.  A start has to be of the first class, since another is another *)
(* case of the same query.                                                 *)
(***************************************************************************)
EXTENDS APSystem, LockMapping, LifeMapping

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

Lock == INSTANCE CounterLock WITH
            Classes <- APClasses,
            on      <- mode # "STOP",
            held    <- mode = "HOLD",
            count   <- delay,
            running <- RunningClasses,
            waiting <- [c \in APClasses |-> WaitingIn(c)],
            perhaps <- { c \in APClasses : PerhapsIn(c) },
            asked   <- MayWithdraw

StartsAnother == /\ Len(stack') > Len(stack)
                 /\ stack'[Len(stack')].class # AnyClass

-----------------------------------------------------------------------------

FirstInit == Init /\ past = "none"
AnyPast == {"none", "served", "cancelled", "lost", "missed", "cleared"}
AnyRefined == AnyInit /\ past \in AnyPast

(* What is history follows from the step. *)
History == past' = PastAfter

LockBegins == Lock!Init
LifeBegins == Life!Init
LockStep == StartsAnother \/ Lock!Next \/ UNCHANGED Lock!lockVars
LifeStep == Life!Next \/ UNCHANGED Life!lifeVars
=============================================================================
