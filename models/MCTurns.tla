------------------------------ MODULE MCTurns -------------------------------
(***************************************************************************)
(* Several startup OBs and several cycle OBs of an S7-1500 [T15-116]       *)
(* [T15-79], and OB 40 above them. The history `ran' notes which of them   *)
(* have ended in this STARTUP or in this cycle, the latest first.          *)
(***************************************************************************)
EXTENDS MCS71500

TurnClasses ==
    {[ o \in 130..133 |-> IF o \in {130, 131} THEN 100 ELSE 1 ]}
TurnLoads == { {40} \cup obs : obs \in {{130, 131, 132, 133},
                                        {100, 130, 132}, {100, 131, 133} } }
TurnRetVals == {0, 1, 2}
TurnBounded == /\ delay <= 1 /\ Waiting(1)
               /\ mode = "STOP" => clock \in PowerOnMoments

VARIABLE
    \* @type: Seq(Int);
    ran

Turns == 100..133 \cup {1}
TurnsInit == Init /\ ran = <<>>
TurnsNext ==
    /\ Next
    /\ ran' = IF step'.event \in {"restart", "run"} \/ Started(1) THEN <<>>
              ELSE IF Did("end") /\ step'.ob \in Turns THEN <<step'.ob>> \o ran
              ELSE ran
TurnsSpec == TurnsInit /\ [][TurnsNext]_<<vars, ran>>
TurnsView == <<cpuVars, ran>>

Startups == loaded \cap (100..131)
Cycles == {1} \cup (loaded \cap {132, 133})
\* @type: (Set(Int), Seq(Int)) => Bool;
AreAll(obs, q) == obs = { q[i] : i \in DOMAIN q }

(* [T15-116] A startup OB runs in STARTUP when those of smaller numbers    *)
(* have run, and RUN follows the last. [T15-79] A cycle is OB 1, and then  *)
(* the others by number; the next begins when all have run.                *)
TurnsProp ==
    [][ /\ \A o \in 100..131 : Started(o) =>
             /\ o \in loaded /\ mode = "STARTUP" /\ stack = <<>>
             /\ AreAll({ q \in Startups : q < o }, ran)
        /\ Did("run") => AreAll(Startups, ran)
        /\ \A o \in {132, 133} : Started(o) =>
             /\ o \in loaded /\ mode = "RUN" /\ stack = <<>>
             /\ AreAll({ q \in Cycles : q < o }, ran)
        /\ Started(1) => ran = <<>> \/ AreAll(Cycles, ran) ]_<<vars, ran>>

(* One of them can always start where nothing runs.                        *)
SomeTurnInv ==
    Settled /\ stack = <<>> /\ mode = "STARTUP" =>
      (MayProceed("run") <=> AreAll(Startups, ran))
=============================================================================
