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

(* What the two see of a state is in variables, since Apalache copies what *)
(* stands for a variable.                                                  *)
VARIABLES
    (* @type: { running: Seq(Int), waiting: Int -> Int,
                perhaps: Set(Int), asked: Bool };                          *)
    lockView,
    (* @type: { setting: Str, once: Bool, blocked: Bool, waiting: Int,
                perhaps: Bool, running: Bool };                            *)
    lifeView

LockView == [ running |-> RunningClasses,
              waiting |-> [c \in APClasses |-> WaitingIn(c)],
              perhaps |-> { c \in APClasses : PerhapsIn(c) },
              asked   |-> MayWithdraw ]
LifeView == [ setting |-> Setting10, once |-> Once10, blocked |-> Blocked(10),
              waiting |-> Waiting10, perhaps |-> OpenIn(requests, 10),
              running |-> OnStack(10) ]

Lock == INSTANCE CounterLock WITH
            Classes <- APClasses,
            on      <- mode # "STOP",
            held    <- mode = "HOLD",
            count   <- delay,
            running <- lockView.running,
            waiting <- lockView.waiting,
            perhaps <- lockView.perhaps,
            asked   <- lockView.asked

Life == INSTANCE LifeCycle WITH
            on      <- mode # "STOP",
            doomed  <- stopCause # NoCause,
            loaded  <- 10 \in loaded,
            setting <- lifeView.setting,
            once    <- lifeView.once,
            blocked <- lifeView.blocked,
            waiting <- lifeView.waiting,
            perhaps <- lifeView.perhaps,
            running <- lifeView.running

StartsAnother == /\ Len(stack') > Len(stack)
                 /\ stack'[Len(stack')].class # AnyClass

-----------------------------------------------------------------------------

Views == lockView = LockView /\ lifeView = LifeView
FirstInit == Init /\ past = "none" /\ Views
AnyPast == {"none", "served", "cancelled", "lost", "missed", "cleared"}
AnyRefined == AnyInit /\ past \in AnyPast /\ Views

(* What is history follows from the step. *)
History == /\ past' = PastAfter
           /\ lockView' = LockView'
           /\ lifeView' = LifeView'

LockBegins == Lock!Init
LifeBegins == Life!Init
LockStep == StartsAnother \/ Lock!Next \/ UNCHANGED Lock!lockVars
LifeStep == Life!Next \/ UNCHANGED Life!lifeVars
=============================================================================
