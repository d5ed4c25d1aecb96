------------------------------- MODULE MCMeet -------------------------------
(***************************************************************************)
(* The world of MCAll with everything in one behaviour: a delay is         *)
(* started, OBs are blocked and freed, OB 40 holds back three times, the   *)
(* clock is set forward and back, the switch goes to STOP and a restart    *)
(* follows, while the points of OB 10 come and OB 11 is missing.           *)
(*                                                                         *)
(* Program and world follow a plan: its interventions come in this order,  *)
(* each at any time. Steps of the CPU itself, EN_AIRT and restart are      *)
(* free. MetInv claims that no behaviour has all of this: the witness      *)
(* `all-met' of models.txt is a behaviour that has it all.                 *)
(***************************************************************************)
EXTENDS MCAll

VARIABLES
    (* The interventions that are still to come. *)
    \* @type: Seq(Str);
    plan,
    (* An OB that is not loaded has been missed. *)
    \* @type: Bool;
    missed

MeetMoments == HalfMinutes(0, 1)
MeetTargets == {Moment(0, 30000), Moment(1, 30000)}

Plans == {
    << "SRT_DINT", "interrupt", "DIS_AIRT", "DIS_AIRT", "DIS_AIRT", "forward",
       "DIS_IRT", "back", "switch" >>,
    << "interrupt", "DIS_AIRT", "DIS_IRT", "DIS_AIRT", "forward", "DIS_AIRT",
       "EN_IRT", "SRT_DINT", "back", "switch" >>,
    << "forward", "switch", "back", "SRT_DINT", "DIS_IRT", "interrupt",
       "DIS_AIRT", "DIS_AIRT", "DIS_AIRT" >> }

Planned == Interventions \cup {"DIS_AIRT"}

Intervention ==
    IF step'.event # "clock" THEN step'.event
    ELSE IF Before(clock, clock') THEN "forward"
    ELSE IF Before(clock', clock) THEN "back" ELSE "clock"

MeetInit == Init /\ spent = 0 /\ plan \in Plans /\ missed = FALSE
MeetNext ==
    /\ Next
    /\ step'.event \in {"DIS_AIRT", "EN_AIRT"} => Running.ob = 40
    /\ IF step'.event \notin Planned THEN UNCHANGED plan
       ELSE plan # <<>> /\ Intervention = Head(plan) /\ plan' = Tail(plan)
    /\ missed' = (missed \/ step'.event = "missing")
    /\ UNCHANGED spent
MeetSpec == MeetInit /\ [][MeetNext]_<<vars, spent, plan, missed>>

MeetView == <<cpuVars, plan, missed>>

MetInv == ~(plan = <<>> /\ missed /\ mode = "RUN")
=============================================================================
