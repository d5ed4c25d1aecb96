----------------------------- MODULE CallReasons ----------------------------
(***************************************************************************)
(* Reasons why a call is rejected: its place, its answer, its STATUS.      *)
(*                                                                         *)
(* Source: requirements, sections 1 to 4, table 7.4.                       *)
(* Left out: nothing.                                                      *)
(***************************************************************************)
EXTENDS BlockReasons

-----------------------------------------------------------------------------
(* The right answer *)

\* @type: $event => Set(Int);
RightAnswers(e) == IF terms.loose THEN LooseAnswers(e) ELSE AnswersTo(e)

\* @type: $event => Set(Int);
RightStatuses(e) == IF terms.loose THEN LooseStatuses(e.ob) ELSE StatusesOf(e)

\* @type: $event => Bool;
AnswerRight(e) == e.ret = -1 \/ e.ret \in RightAnswers(e)

(* [AMB-70] (b) The delay has to end before this call. *)
\* @type: $event => Bool;
BeforeItsEnd(e) ==
    e.event \in {"SRT_DINT", "CAN_DINT", "QRY_DINT"} /\ ~Ended(e.ob)

-----------------------------------------------------------------------------
(* RET_VAL *)

\* @type: ($event, Int) => Set(Str);
SetRequirements(e, ret) ==
    CASE ret = OK        -> {"TINT-30"}
      [] ret = BadOb     -> {"TINT-35"}
      [] ret = BadSdt    ->
           CASE e.period = Monthly /\ e.sdt.day > 28 -> {"TINT-18"}
             [] e.period = EndOfMonth -> {"TINT-19", "TINT-39"}
             [] e.period = Yearly     -> {"TINT-32", "TINT-39"}
             [] OTHER                 -> {"TINT-39", "TINT-35"}
      [] ret = BadPeriod -> {"TINT-33"}
      [] ret = PastStart ->
           {"TINT-36"} \cup When(~HasOnePoint(e.period), {"TINT-37"})
      [] OTHER           -> {"TINT-22"}

\* @type: ($event, Int) => Set(Str);
ActRequirements(e, ret) ==
    LET on == e.ob \in TodObs /\ tod[e.ob].active
    IN  CASE ret = OK -> {"TINT-60"} \cup When(on, {"TINT-63"})
          [] ret = PastStart ->
               IF e.ob \in TodObs /\ ~HasOnePoint(tod[e.ob].period)
               THEN {"TINT-62"} ELSE {"TINT-61"}
          [] ret = NotSet -> {"TINT-61", "TINT-64"}
          [] ret = BadOb  -> {"TINT-61"}
          [] OTHER -> {"TINT-22"}

\* @type: ($event, Int) => Set(Str);
SrtRequirements(e, ret) ==
    CASE ret = OK       -> {"DINT-03", "DINT-07"}
      [] ret = BadOb    -> {"DINT-05"}
      [] ret = BadDtime -> {"DINT-04"}
      [] OTHER          -> {"DINT-21"}

\* @type: ($event, Int) => Set(Str);
IrtRequirements(e, ret) ==
    CASE ret = OK /\ e.event = "EN_IRT"  -> {"IRT-13", "IRT-24"}
      [] ret = OK      -> {"IRT-06"}
      [] ret = BadMode -> {"IRT-12"}
      [] ret = BadOb   -> {"IRT-11", "IRT-12"}
      [] OTHER         -> {"IRT-22"}

\* @type: ($event, Int) => Set(Str);
AnswerRequirements(e, ret) ==
    CASE e.event = "SET_TINT" -> SetRequirements(e, ret)
      [] e.event = "CAN_TINT" ->
           IF ret = OK THEN {"TINT-50", "TINT-52"} ELSE {"TINT-51"}
      [] e.event = "ACT_TINT" -> ActRequirements(e, ret)
      [] e.event = "QRY_TINT" -> {"TINT-70"}
      [] e.event = "SRT_DINT" -> SrtRequirements(e, ret)
      [] e.event = "CAN_DINT" -> {"DINT-14"}
           \cup When(ret = NotStarted, {"DINT-15"})
      [] e.event = "QRY_DINT" -> {"DINT-16"}
      [] e.event \in {"DIS_IRT", "EN_IRT"} -> IrtRequirements(e, ret)
      [] e.event = "DIS_AIRT" -> {"AIRT-03", "AIRT-06"}
                                   \cup When(delay = 0, {"AIRT-04"})
      [] OTHER                -> {"AIRT-03", "AIRT-07"}
                                   \cup When(delay = 0, {"AIRT-04"})

\* @type: $event => Set(Str);
WrongAnswer(e) ==
    AnswerRequirements(e, e.ret)
      \cup UNION { AnswerRequirements(e, r) : r \in RightAnswers(e) }
      \cup When(/\ e.event \notin {"DIS_IRT", "EN_IRT", "DIS_AIRT", "EN_AIRT"}
                /\ e.ob \in TodObs \cup DintObs
                /\ Deselected(e.ob), {"OBS-25"})

-----------------------------------------------------------------------------
(* STATUS *)

(* The requirements that decide whether a time-of-day interrupt is active. *)
\* @type: (Int, Seq($event)) => Set(Str);
ActiveRequirements(o, past) ==
    LET last  == LastWith(past,
                          {"SET_TINT", "CAN_TINT", "ACT_TINT", "start"}, o)
        reset == LastOf(past, {"restart"})
    IN  IF tod[o].active /\ ~HasOnePoint(tod[o].period) /\ tod[o].next = Never
        THEN {}  \* a series without a further point
        ELSE IF reset > last THEN {"OBS-50", "TINT-38"}
        ELSE IF last = 0 THEN {"TINT-06"}
        ELSE CASE past[last].event = "start"    -> {"TINT-08", "TINT-64"}
               [] past[last].event = "CAN_TINT" -> {"TINT-50"}
               [] past[last].event = "SET_TINT" ->
                    IF Worked(past[last]) THEN {"TINT-05", "TINT-31"}
                    ELSE {"TINT-31", "TINT-35"}
               [] OTHER -> IF Blocked(o) \/ LostMeanwhile(past, o)
                           THEN {"IRT-04", "IRT-18", "TINT-08"}
                           ELSE {"TINT-60"}

(* The requirements that decide whether a delay is started. *)
\* @type: (Int, Seq($event)) => Set(Str);
StartedRequirements(o, past) ==
    LET last  == LastWith(past, {"SRT_DINT", "CAN_DINT", "start"}, o)
    IN  IF LastOf(past, {"restart"}) > last THEN {"DINT-13", "OBS-52"}
        ELSE IF Blocked(o) THEN {"IRT-04", "DINT-20"}
        ELSE IF last > 0 /\ past[last].event = "CAN_DINT" THEN {"DINT-14"}
        ELSE {}

(* The requirements of each wrong bit.                                     *)
\* @type: ($event, Int, Seq($event)) => Set(Str);
WrongBits(e, right, past) ==
    LET wrong(bit) == (e.status \div bit) % 2 # (right \div bit) % 2
        tods  == e.event = "QRY_TINT"
        valid == e.ob \in TodObs \cup DintObs
    IN  IF ~valid THEN {}
        ELSE When(tods /\ wrong(1), {"TINT-72"})
               \cup When(wrong(2),
                         {"IRT-17"} \cup When(IrtLines(past, e.ob) # {},
                                            BlockRequirements(past, e.ob)))
               \cup When(tods /\ wrong(2), {"TINT-73"})
               \cup When(tods /\ wrong(4),
                         {"TINT-74"} \cup ActiveRequirements(e.ob, past))
               \cup When(tods /\ wrong(8), {"TINT-75"})
               \cup When(tods /\ wrong(16), {"TINT-76"})
               \cup When(tods /\ wrong(32), {"TINT-77"})
               \cup When(tods /\ wrong(64), {"TINT-78"})
               \cup When(tods /\ e.status >= 128, {"TINT-79"})
               \cup When(~tods, {"DINT-16"})
               \cup When(~tods /\ wrong(4), StartedRequirements(e.ob, past))

(* The right value with the fewest wrong bits counts. *)
\* @type: ($event, Seq($event)) => Set(Str);
WrongStatus(e, past) ==
    LET sets == { WrongBits(e, s, past) : s \in RightStatuses(e) }
    IN  IF sets = {} THEN {"TINT-71"}
        ELSE CHOOSE s \in sets :
               \A t \in sets : Cardinality(s) <= Cardinality(t)

-----------------------------------------------------------------------------

\* @type: ($event, Seq($event)) => Set(Str);
OfCall(e, past) ==
    IF mode = "STOP" THEN {"OBS-41"}
    ELSE IF mode = "HOLD" THEN {"OBS-45"}
    ELSE IF ~Called THEN {IF mode = "STARTUP" THEN "OBS-42" ELSE "OBS-01"}
    ELSE IF StandsBefore(e) THEN {"AIRT-08"}
    ELSE IF AnswerRight(e) THEN WrongStatus(e, past) ELSE WrongAnswer(e)
=============================================================================
