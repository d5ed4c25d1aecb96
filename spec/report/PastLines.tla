----------------------------- MODULE PastLines ------------------------------
(***************************************************************************)
(* Questions about the lines before a line that is rejected, `past': the   *)
(* latest lines, and the last older line of each event, OB and MODE. A     *)
(* line is named by its position, 0 where there is none.                   *)
(*                                                                         *)
(* No action uses this module.                                             *)
(* Source: the log format; sections 1 to 6 of the requirements.            *)
(***************************************************************************)
EXTENDS FiniteSets, Calendar, Codes, LogState

\* @type: Set(Int) => Int;
LastIn(positions) ==
    IF positions = {} THEN 0
    ELSE CHOOSE i \in positions : \A k \in positions : k <= i

(* SET_TINTL counts as SET_TINT.                                           *)
\* @type: $event => Str;
NameOf(e) == IF e.event = "SET_TINTL" THEN "SET_TINT" ELSE e.event

(* The last line with one of these events, for any OB and for one OB; 0 if *)
(* there is none.                                                          *)
\* @type: (Seq($event), Set(Str)) => Int;
LastOf(past, names) ==
    LastIn({ i \in DOMAIN past : NameOf(past[i]) \in names })
\* @type: (Seq($event), Set(Str), Int) => Int;
LastWith(past, names, o) ==
    LastIn({ i \in DOMAIN past : NameOf(past[i]) \in names /\ past[i].ob = o })

\* @type: (Seq($event), Int) => Int;
LastStart(past, o) == LastWith(past, {"start"}, o)

(* The start of the OB before its last one.                                *)
\* @type: (Seq($event), Int) => Int;
StartBefore(past, o) ==
    LastIn({ i \in DOMAIN past : /\ i < LastStart(past, o) /\ past[i].ob = o
                                 /\ past[i].event = "start" })

(* How many lines with these events for the OB follow position i.          *)
\* @type: (Seq($event), Set(Str), Int, Int) => Int;
TimesSince(past, names, o, i) ==
    Cardinality({ k \in DOMAIN past : /\ k > i /\ past[k].ob = o
                                     /\ past[k].event \in names })

(* The last restart that erases settings, and the last hot one.            *)
\* @type: Seq($event) => Int;
LastReset(past) ==
    LastIn({ i \in DOMAIN past : past[i].event = "restart"
                                 /\ past[i].type # "hot" })
\* @type: Seq($event) => Int;
LastHot(past) ==
    LastIn({ i \in DOMAIN past : past[i].event = "restart"
                                 /\ past[i].type = "hot" })

(* The line at position i stands in the STARTUP after the last restart.    *)
\* @type: (Seq($event), Int) => Bool;
SetInStartup(past, i) == LET restart == LastOf(past, {"restart"})
                         IN  /\ 0 < restart /\ restart < i
                             /\ LastOf(past, {"run"}) \notin restart..i

\* @type: $event => Bool;
Worked(e) == e.ret \in {OK, -1}

(* Requirements that count only under a condition. *)
\* @type: (Bool, Set(Str)) => Set(Str);
When(condition, ids) == IF condition THEN ids ELSE {}

(* Since a hot restart, which keeps what was set and started, nothing was  *)
(* set or started for the OB; 0 stands for the delay of SFC 41.            *)
\* @type: (Int, Seq($event)) => Set(Str);
SinceHotRestart(o, past) ==
    LET last == LastWith(past, {"start", "interrupt", "SRT_DINT", "CAN_DINT",
                                "SET_TINT", "ACT_TINT", "CAN_TINT",
                                "DIS_AIRT", "EN_AIRT"}, o)
    IN  When(LastHot(past) > last,
             IF o = 0 THEN {"OBS-54"}
             ELSE {"OBS-52"} \cup When(OnStack(o), {"OBS-54"}))

(* The direction in which the clock was last set after position i: 1       *)
(* forward, -1 back; 0 if it was not set.                                  *)
\* @type: (Seq($event), Int) => Int;
ClockWasSet(past, i) ==
    LET k == LastOf(past, {"clock"})
    IN  IF k <= i THEN 0 ELSE IF Before(past[k].to, past[k].at) THEN -1 ELSE 1
=============================================================================
