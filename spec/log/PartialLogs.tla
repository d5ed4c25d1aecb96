---------------------------- MODULE PartialLogs -----------------------------
(***************************************************************************)
(* Logs that leave kinds of event out (`records' of the header): an event  *)
(* of such a kind may happen unseen at any point.                          *)
(*                                                                         *)
(* Unseen starts and ends of OBs are actions, tried at every point. Unseen *)
(* loading is tried where something depends on it. Unseen start events     *)
(* cannot be enumerated: an OB starts as if its start event had come.      *)
(* LooseLogs has the rules for logs that do not tell when an OB has to     *)
(* start.                                                                  *)
(*                                                                         *)
(* The trace checker's engine evaluates Elapse, Silent and Observe, for    *)
(* complete logs as well.                                                  *)
(* Source: docs/checking/log-format.md, fine point 9.                      *)
(* Left out: nothing.                                                      *)
(***************************************************************************)
EXTENDS Trace, LooseLogs

-----------------------------------------------------------------------------
(* OBs *)

UnseenOb == \/ \E r \in requests : Start(r)
            \/ Failed /\ ErrorObStarts(Running.error)
            \/ stack # <<>> /\ End(Running.ob)

-----------------------------------------------------------------------------
(* Blocks that are loaded or deleted *)

(* The OBs that hold back the start of this one, unless they are missing. *)
\* @type: Int => Set(Int);
StandingBefore(o) ==
    { q.ob : q \in { p \in requests :
        \E r \in requests :
          /\ r.ob = o /\ ~p.open
          /\ GoesFirst(p, r) \/ (p.class = r.class /\ p.rank < r.rank) } }

(* The OBs on which the line depends. *)
\* @type: $event => Set(Int);
DependsOn(e) ==
    CASE e.event = "start"  ->
           {e.ob} \cup (IF e.ob = ProgramErrorOb THEN { r.ob : r \in requests }
                        ELSE StandingBefore(e.ob))
      [] e.event \in {"QRY_TINT", "QRY_DINT", "state"} -> {e.ob}
      [] e.event \in {"ACT_TINT", "SRT_DINT"} -> {e.ob, ProgramErrorOb}
      [] e.event \in {"SET_TINT", "SET_TINTL"} /\ AnswerNeedsLoad(e) -> {e.ob}
      [] e.event = "end" /\ e.ob = ProgramErrorOb -> { r.ob : r \in requests }
      [] e.event \in {"stop", "diag"} ->
           { r.ob : r \in requests } \cup {TimeErrorOb, ProgramErrorOb}
      [] e.event = "interrupt" -> {e.ob, TimeErrorOb, ProgramErrorOb}
      [] e.event \in {"clock", "zone", "release"} -> {TimeErrorOb}
      [] e.event = "restart" -> { o \in loaded : Deselected(o) }
      [] e.event = "run"    -> StartupObs
      [] OTHER              -> {}

(* The OBs on which events of this moment depend.                          *)
NowNeeded ==
    LET due == { r \in requests : MayStart(r) \/ MissingNoticedWhenDue }
    IN  IF due = {} /\ PointsNow = {} /\ OverNow = {} /\ ~resume.due THEN {}
        ELSE {TimeErrorOb, ProgramErrorOb} \cup { r.ob : r \in due }

\* @type: Set(Int) => Bool;
UnseenLoad(obs) ==
    \E o \in obs :
      LoadedAre(IF o \in loaded THEN loaded \ {o} ELSE loaded \cup {o})

-----------------------------------------------------------------------------
(* Start events that no line shows *)

(* Start events may have come unseen before SFC 39 blocks their OBs. Then  *)
(* these OBs still wait.                                                   *)
\* @type: $event => Bool;
UnseenEvents(e) ==
    LET fault(o) == IF o \in {TimeErrorOb, ProgramErrorOb} THEN UnknownFault
                    ELSE 0
        class(o) == IF o \in AsyncErrorObs THEN ErrorClass(o, 0)
                    ELSE ClassOf(o)
        waits  == { o \in ExternalObs :
                      /\ MayBeLoaded(o) /\ TakesEvents(o)
                      /\ o \in Meant(e.mode, e.ob)
                      /\ ~OpenIn(requests, o)
                      /\ \/ ~PendingIn(requests, o)
                         \/ o \in {TimeErrorOb, ProgramErrorOb} }
    IN  /\ e.event = "DIS_IRT" /\ waits # {}
        /\ requests' = EnterAll(requests,
                         { [ UnseenRequest(o, fault(o), class(o))
                             EXCEPT !.open = TRUE ] : o \in waits })
        /\ NothingEntered
        /\ UNCHANGED <<deviceVars, modeVars, clock, settingVars, stopCause,
                       runVars>>

(* The requests by which the OB of a start line may start.  Their unknown  *)
(* fields fit every line.                                                  *)
\* @type: $event => Set($request);
MayHaveOccurred(e) ==
    LET fault == IF e.ob \in {TimeErrorOb, ProgramErrorOb} THEN ToldFault(e)
                 ELSE 0
    IN  IF e.ob \notin ExternalObs \/ fault \in Skips THEN {}
        ELSE { UnseenRequest(e.ob, fault, class)
               : class \in ClassesOf(e.ob, fault) }

\* @type: $event => Bool;
StartsUnseen(e) ==
    \E r \in { q \in MayHaveOccurred(e) : FitsRequest(q, e) } :
      /\ ModeAllows(r) /\ Undelayed /\ Preempts(r)
      /\ r.ob \in loaded
      /\ ~TakesEvents(r.ob) => OpenIn(requests, r.ob)  \* it waits already
      /\ stack' = Append(stack, Frame(r.ob, r.class))
      /\ NothingEntered
      /\ UNCHANGED <<deviceVars, modeVars, clock, settingVars, outcomeVars,
                     delay>>

(* A start event that no line shows may have caused this entry.  That of   *)
(* a STOP by a time error may come from two excesses of the cycle time,    *)
(* also where OB 80 is loaded [OBS-26].                                    *)
\* @type: $event => Bool;
EntersUnseen(e) ==
    /\ e.id = NoProgramErrorOb => MayStopByOb85
    /\ NothingEntered
    /\ UNCHANGED <<cpuVars, waiting, eventVars, reports>>

\* @type: $event => Bool;
ShowsPartly(e) ==
    \/ Shows(e)
    \/ /\ e.event = "start" /\ Unseen("interrupt")
       /\ StartsUnseen(e) \/ ErrorObStartsUnseen(e)
       /\ Rewait
       /\ UNCHANGED <<terms, up>>
    \/ /\ e.event = "diag" /\ CauseUnseen(e.id)
       /\ EntersUnseen(e)
       /\ UNCHANGED <<terms, up>>

-----------------------------------------------------------------------------
(* The operators of the trace checker's engine *)

\* @type: $event => Bool;
Elapse(e) ==
    IF terms.loose THEN LooseElapse(AtFirst(e))
    ELSE \/ Towards(AtFirst(e))
         \/ /\ \/ Unseen("ob") /\ UnseenOb
               \/ Unseen("load") /\ UnseenLoad(NowNeeded)
            /\ Rewait
            /\ UNCHANGED <<lineVars, up>>

\* @type: $event => Bool;
Silent(e) ==
    IF terms.loose
    THEN \/ LooseUnseenLoad(e)
         \/ \E m \in LaterMoments(e) : LooseElapse(AtLater(e, m))
    ELSE \/ HiddenBefore(e)
         \/ Lingers(e)
         \/ /\ \/ Unseen("ob") /\ UnseenOb
               \/ Unseen("load") /\ UnseenLoad(DependsOn(e) \cup StartupsAhead)
               \/ Unseen("interrupt") /\ UnseenEvents(e)
            /\ Rewait
            /\ UNCHANGED <<lineVars, up>>

(* Quick to evaluate: may a silent step be possible?                       *)
\* @type: $event => Bool;
Stirs(e) == \/ e.step > 1
            \/ IF terms.loose THEN AnswerNeedsLoad(e)
                              ELSE HidesBefore(e) \/ Partial

\* @type: $event => Bool;
Observe(e) == /\ KeepsPace(e)
              /\ IF terms.loose THEN LooseShows(e)
                 ELSE IF Partial THEN ShowsPartly(e) ELSE Shows(e)
              /\ NextPace(e)

Next == Silent(NoEvent)
=============================================================================
