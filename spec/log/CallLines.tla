------------------------------ MODULE CallLines -----------------------------
(***************************************************************************)
(* Lines of calls: the answers and the STATUS that the CPU may give, and   *)
(* the action that a line stands for.                                      *)
(*                                                                         *)
(* Source: docs/checking/log-format.md, events of kind `call'.             *)
(* Left out: the effects of calls (Airt, Irt, TimeOfDay, TimeDelay).       *)
(***************************************************************************)
EXTENDS Airt, Irt, TimeOfDay, TimeDelay, LogEvents

CallEvents == {"SET_TINT", "CAN_TINT", "ACT_TINT", "QRY_TINT",
               "SRT_DINT", "CAN_DINT", "QRY_DINT",
               "DIS_IRT", "EN_IRT", "DIS_AIRT", "EN_AIRT"}

(* The values that RET_VAL may have.                                       *)
\* @type: $event => Set(Int);
AnswersTo(e) ==
    CASE e.event = "SET_TINT" ->
           SetAnswers(e.ob, e.sdt, e.period)
      [] e.event = "CAN_TINT" -> CanAnswers(e.ob)
      [] e.event = "ACT_TINT" -> ActAnswers(e.ob)
      [] e.event = "QRY_TINT" -> Answers(e.ob, ObErrors(e.ob))
      [] e.event = "SRT_DINT" -> Answers(e.ob, SrtErrors(e.ob, e.dtime))
      [] e.event = "CAN_DINT" -> CanDintAnswers(e.ob)
      [] e.event = "QRY_DINT" -> Answers(e.ob, DintErrors(e.ob))
      [] e.event = "DIS_IRT"  -> Usual(IrtErrors(e.mode, e.ob, DisModes))
      [] e.event = "EN_IRT"   -> Usual(IrtErrors(e.mode, e.ob, EnModes))
      [] e.event = "DIS_AIRT" -> {delay + 1}
      [] OTHER                -> {IF delay = 0 THEN NotDelayed ELSE delay - 1}

(* The values that STATUS may have.                                        *)
\* @type: $event => Set(Int);
StatusesOf(e) == IF e.event = "QRY_TINT" THEN Statuses(e.ob)
                                         ELSE DintStatuses(e.ob)

(* The call of the line, with this RET_VAL.                                *)
\* @type: ($event, Int) => Bool;
Answered(e, ret) ==
    CASE e.event = "SET_TINT" -> SetTint(e.ob, e.sdt, e.period, ret)
      [] e.event = "CAN_TINT" -> CanTint(e.ob, ret)
      [] e.event = "ACT_TINT" -> ActTint(e.ob, ret)
      [] e.event = "QRY_TINT" -> QryTint(e.ob, ret, e.status)
      [] e.event = "SRT_DINT" -> SrtDint(e.ob, e.dtime, e.sign, ret)
      [] e.event = "CAN_DINT" -> CanDint(e.ob, ret)
      [] e.event = "QRY_DINT" -> QryDint(e.ob, ret, e.status)
      [] e.event = "DIS_IRT"  -> DisIrt(e.mode, e.ob, ret)
      [] e.event = "EN_IRT"   -> EnIrt(e.mode, e.ob, ret)
      [] e.event = "DIS_AIRT" -> DisAirt(ret)
      [] OTHER                -> EnAirt(ret)

\* @type: $event => Bool;
IsCall(e) == \E ret \in Given(e.ret, AnswersTo(e)) : Answered(e, ret)
=============================================================================
