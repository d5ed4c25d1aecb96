------------------------------ MODULE PastLines -----------------------------
(***************************************************************************)
(* The lines before a rejected line, `past': the latest lines, and the     *)
(* last older line of each event, OB and MODE.                             *)
(*                                                                         *)
(* Source: docs/checking/log-format.md.                                    *)
(* Left out: the requirements that follow (BlockReasons and the others).   *)
(***************************************************************************)
EXTENDS PartialLogs

\* @type: Set(Int) => Int;
LastIn(positions) ==
    IF positions = {} THEN 0
    ELSE CHOOSE i \in positions : \A k \in positions : k <= i

(* The last line with one of these events, for any OB and for one OB; 0 if *)
(* there is none.                                                          *)
\* @type: (Seq($event), Set(Str)) => Int;
LastOf(past, names) == LastIn({ i \in DOMAIN past : past[i].event \in names })
\* @type: (Seq($event), Set(Str), Int) => Int;
LastWith(past, names, o) ==
    LastIn({ i \in DOMAIN past : past[i].event \in names /\ past[i].ob = o })

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

\* @type: $event => Bool;
Worked(e) == e.ret \in {OK, -1}

(* Requirements that count only under a condition. *)
\* @type: (Bool, Set(Str)) => Set(Str);
When(condition, ids) == IF condition THEN ids ELSE {}

(* The direction in which the clock was last set after position i: 1       *)
(* forward, -1 back; 0 if it was not set.                                  *)
\* @type: (Seq($event), Int) => Int;
ClockWasSet(past, i) ==
    LET k == LastOf(past, {"clock"})
    IN  IF k <= i THEN 0 ELSE IF Before(past[k].to, past[k].at) THEN -1 ELSE 1
=============================================================================
