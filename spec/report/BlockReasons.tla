---------------------------- MODULE BlockReasons ----------------------------
(***************************************************************************)
(* Reasons that SFC 39 and SFC 40 give: an OB is blocked or not, or its    *)
(* start event was lost. They follow from the state before a line, and     *)
(* from the lines before it, `past' (PastLines).                           *)
(*                                                                         *)
(* Source: requirements, section 3.                                        *)
(***************************************************************************)
EXTENDS Irt, PastLines

-----------------------------------------------------------------------------
(* Line e blocks or enables OB o.                                          *)
\* @type: ($event, Int) => Bool;
Means(e, o) == /\ e.event \in {"DIS_IRT", "EN_IRT"} /\ Worked(e)
               /\ CASE Level(e.mode) = 0 -> TRUE
                    [] Level(e.mode) = 1 -> ClassNumber(o) = e.ob
                    [] OTHER             -> o = e.ob

\* @type: (Seq($event), Int) => Set(Int);
IrtLines(past, o) == { i \in DOMAIN past : Means(past[i], o) }

\* @type: $event => Set(Str);
OfMode(e) ==
    IF e.event = "EN_IRT"
    THEN {"IRT-13"} \cup When(Level(e.mode) = 1, {"IRT-14"})
    ELSE (CASE Level(e.mode) = 0 -> {"IRT-06"}
            [] Level(e.mode) = 1 -> {"IRT-07"}
            [] OTHER             -> {"IRT-08"})
           \cup When(WithoutEntries(e.mode), {"IRT-09"})

(* The requirements that decide whether the OB is blocked. *)
\* @type: (Seq($event), Int) => Set(Str);
BlockRequirements(past, o) ==
    LET lines == IrtLines(past, o)
        last  == LastIn(lines)
        dis   == { i \in lines : past[i].event = "DIS_IRT" }
    IN  IF lines = {} THEN {"IRT-01"}
        ELSE IF LastOf(past, {"restart"}) > last THEN {"IRT-03", "OBS-53"}
        ELSE OfMode(past[last])
               \cup When(Level(past[last].mode) = 1 /\ o # ClassNumber(o),
                         {"IRT-11"})
               \cup When(LastOf(past, {"end", "hold"}) > last,
                         {"IRT-02", "IRT-03"})
               \cup When(
                      Cardinality({ Level(past[i].mode) : i \in lines }) > 1,
                      {"IRT-20"})
               \cup When(Cardinality(dis) > 1 /\ last \notin dis, {"IRT-16"})

(* The OB starts although it is blocked. *)
\* @type: (Seq($event), Int) => Set(Str);
ThoughBlocked(past, o) ==
    IF DisIrtStopsCatchUp /\ o \in TodObs THEN {"IRT-01", "CLK-04"}
    ELSE {"IRT-01", "IRT-04"} \cup BlockRequirements(past, o)
           \cup When(o = TimeErrorOb, {"OBS-33"})

(* Start events came only while the OB was blocked; they are lost. *)
\* @type: (Seq($event), Int) => Bool;
LostMeanwhile(past, o) ==
    LET last == LastIn(IrtLines(past, o))
    IN  /\ last > 0 /\ past[last].event = "EN_IRT"
        /\ last > LastStart(past, o)
        /\ last > LastWith(past, {"interrupt", "SRT_DINT", "ACT_TINT"}, o)

(* The OB is not blocked, and its start event has had no effect. *)
\* @type: (Seq($event), Int) => Set(Str);
ThoughNotBlocked(past, o) ==
    LET lines == IrtLines(past, o)
        last  == LastIn(lines)
        other == LastOf(past, {"DIS_IRT"})
    IN  IF Blocked(o) THEN {"IRT-01", "AMB-72"}  \* it came before
        ELSE IF last > LastStart(past, o)
        THEN {"IRT-15"} \cup BlockRequirements(past, o)
        ELSE IF lines = {} /\ irt.blocked # {} /\ other > 0
        THEN OfMode(past[other]) \cup {"IRT-11"}
        ELSE {}
=============================================================================
