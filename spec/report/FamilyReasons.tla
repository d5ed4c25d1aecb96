--------------------------- MODULE FamilyReasons ----------------------------
(***************************************************************************)
(* The requirements of a line, by the words of the CPU's family:           *)
(* where a text about the family says otherwise, its requirement is cited  *)
(* in the place of that of S7-300/400.                                     *)
(*                                                                         *)
(* No action uses this module.                                             *)
(* Source: the requirement IDs.                                            *)
(***************************************************************************)
EXTENDS ReportedData, Readings

(* A requirement of S7-300/400, and that of the S7-1500 in its place. *)
\* @type: Set(<<Str, Str>>);
InPlace ==
  { <<"AIRT-13", "T15-53">>, <<"CLK-05", "T15-100">>, <<"DINT-01", "T15-35">>,
    <<"DINT-09", "T15-40">>, <<"DINT-10", "T15-36">>, <<"OBS-05", "T15-60">>,
    <<"OBS-11", "T15-62">>, <<"OBS-20", "T15-112">>, <<"OBS-21", "T15-113">>,
    <<"OBS-23", "T15-111">>, <<"OBS-26", "T15-114">>, <<"OBS-27", "T15-111">>,
    <<"OBS-31", "T15-61">>, <<"OBS-32", "T15-92">>, <<"OBS-43", "T15-117">>,
    <<"OBS-57", "T15-115">>, <<"OBS-61", "T15-63">>, <<"OBS-62", "T15-63">>,
    <<"OBS-63", "T15-111">>, <<"TINT-14", "T15-26">>, <<"TINT-16", "T15-112">>,
    <<"TINT-18", "T15-23">>, <<"TINT-33", "T15-32">> }

(* Of its priority. *)
\* @type: Int => Str;
OfItsClass(o) ==
    CASE o \in TodObs       -> "T15-30"
      [] o \in DintObs      -> "T15-35"
      [] Kin(o) \in 30..38  -> "T15-66"
      [] Kin(o) \in 40..47  -> "T15-65"
      [] o = TimeErrorOb    -> "T15-61"
      [] o \in AsyncErrorObs -> "T15-62"
      [] o \in SyncErrorObs -> "T15-63"
      [] o \in StartupObs   -> "T15-64"
      [] OTHER              -> "T15-60"

(* Of the last setting of the clock: how far, and in which direction. *)
\* @type: Seq($event) => Set(Str);
OfTheJump(past) ==
    LET set == { i \in DOMAIN past : past[i].event = "clock" }
        c   == past[CHOOSE i \in set : \A j \in set : j <= i]
        ms  == IF Before(c.at, c.to) THEN Span(c.at, c.to)
                                     ELSE Span(c.to, c.at)
    IN  IF set = {} THEN {"T15-91"}
        ELSE IF ms = Family.jump THEN {"T15-95"}
        ELSE IF Before(c.at, c.to)
        THEN {IF ms < Family.jump THEN "T15-90" ELSE "T15-91"}
        ELSE {IF ms < Family.jump THEN "T15-93" ELSE "T15-94"}

(* Points passed in HOLD, or in the STOP before the latest restart.        *)
\* @type: Seq($event) => Str;
OfThePause(past) ==
    IF \E i \in DOMAIN past :
         /\ past[i].event = "restart"
         /\ \A j \in DOMAIN past : past[j].event = "release" => j < i
    THEN "T15-120" ELSE "T15-119"

(* An interrupt counts by local time; or none does, though that differs.   *)
\* @type: Set(Str);
OfItsBase ==
    CASE \E o \in DOMAIN tod : tod[o].zone # 0 -> {"T15-20"}
      [] cpu.zone # 0                         -> {"T15-99"}
      [] OTHER                                -> {}

(* Local time was set, and the clock was not since. An interrupt that      *)
(* serves its points again tells that daylight saving has ended.           *)
\* @type: Seq($event) => Set(Str);
OfLocalTime(past) ==
    LET set  == { i \in DOMAIN past : past[i].event \in {"clock", "zone"} }
        n    == CHOOSE i \in set : \A j \in set : j <= i
        later == \E i \in DOMAIN past :
                   i > n /\ past[i].event \in {"SET_TINTL", "restart"}
    IN  CASE set = {} -> {}
          [] past[n].event = "clock" -> {}
          [] later -> {"T15-103"}
          [] past[n].reason = "zone" -> {"T15-98"}
          [] \E o \in DOMAIN tod : tod[o].local /\ tod[o].overTo > 0 ->
               {"T15-97"}
          [] OTHER -> {"T15-96"}

(* Of its start information.                                               *)
\* @type: ($event, Seq($event)) => Set(Str);
OfTheInfo(e, past) ==
    LET i == e.info
        local == OfLocalTime(past)
        \* @type: Str => Set(Str);
        tag(id) == {"T15-131"} \cup (IF local = {} THEN {id} ELSE local)
        tags ==
          (IF i.caught_up = -1 THEN {} ELSE tag("T15-90"))
            \cup (IF i.second_time = -1 THEN {} ELSE tag("T15-94"))
            \cup (IF i.event_count = -1 THEN {}
                  ELSE IF e.ob \in TodObs \cup DintObs THEN {"T15-71"}
                  ELSE {"T15-69"})
            \cup (IF i.csg_ob = -1 /\ i.csg_priority = -1 THEN {}
                  ELSE {"T15-132"})
            \cup (IF i.strt_info # -1
                     /\ (e.ob \in NumberedObs \cup {57}
                           \/ Kin(e.ob) \in 40..47)
                  THEN {"T15-133"} ELSE {})
            \cup (IF e.ob = CycleOb /\ i.strt_info # -1 THEN {"T15-134"}
                  ELSE {})
    IN  CASE ~HasOneLayout(i) -> {"T15-135"}
          [] tags = {}         -> {"OBS-10"}
          [] OTHER             -> tags

(* Of a queue whose parameters are known. It has dropped events, or not.   *)
\* @type: ($event, Str) => Set(Str);
OfTheQueue(e, id) ==
    CASE e.event = "diag" /\ e.id = ErrorEntry + BufferOverflow -> {"T15-72"}
      [] id = "OBS-30" -> {"T15-73"}
      [] id = "OBS-08" -> {"T15-72"}
      [] /\ e.event = "start" /\ HasQueue(e.ob) /\ ~Unseen("interrupt")
         /\ terms.dropped[e.ob] > 0 -> {"T15-69"}
      [] OTHER         -> {"T15-68", "T15-69"}

\* @type: ($event, Seq($event), Str) => Set(Str);
Instead(e, past, id) ==
    CASE id \in {"CLK-02", "CLK-03", "CLK-09", "CLK-10"} ->
           IF OfLocalTime(past) = {} THEN OfTheJump(past)
           ELSE OfLocalTime(past)
      [] id = "CLK-12" ->
           {id} \cup (IF \E i \in DOMAIN past : past[i].event = "clock"
                      THEN OfTheJump(past) ELSE {})
      [] id = "OBS-46" -> {OfThePause(past)}
      [] id = "TINT-32" ->
           {id} \cup (IF /\ OfLocalTime(past) # {}
                        /\ \E o \in DOMAIN tod : tod[o].local
                     THEN OfLocalTime(past) ELSE OfItsBase)
      [] id = "OBS-50" -> {id} \cup OfLocalTime(past)
      [] id = "OBS-30" /\ OfLocalTime(past) # {} -> {id} \cup OfLocalTime(past)
      [] id \in {"TINT-01", "DINT-05"} /\ e.ob > 122 ->
           {"T15-10", "T15-11"}
      [] id = "OBS-10" /\ e.event = "start" -> OfTheInfo(e, past)
      [] /\ id \in {"OBS-02", "OBS-07", "OBS-08", "OBS-30"}
         /\ DOMAIN cpu.queues # {} -> OfTheQueue(e, id)
      [] id = "OBS-08" -> {"T15-68"}
      [] id = "OBS-40" /\ mode = "HOLD" /\ startup # "none" -> {"T15-121"}
      [] id = "OBS-45" /\ startup # "none" -> {id, "T15-121"}
      [] id = "OBS-03" /\ Kin(e.ob) = CycleOb /\ CycleObs # {CycleOb} ->
           {"T15-79"}
      [] id = "OBS-20" /\ e.event = "interrupt" /\ e.ob \in NumberedObs ->
           {"T15-11"}
      [] id = "AIRT-02" \/ (id = "DINT-06" /\ DelaysStandStill) ->
           {id, "T15-39"}
      [] id \in {"IRT-07", "IRT-11"} /\ NumberedObs # {} -> {"T15-54"}
      [] id = "IRT-12" /\ e.event = "EN_IRT" -> {id, "T15-147"}
      [] /\ id = "OBS-01" /\ e.event = "start"
         /\ \A r \in requests : r.ob # e.ob -> {id}
      [] id \in {"OBS-01", "OBS-02", "OBS-04"} /\ e.event = "start" ->
           {id, OfItsClass(e.ob)}
             \cup (IF Running.ob \in SyncErrorObs THEN {"T15-63"} ELSE {})
      [] id = "OBS-01" -> {id} \cup { OfItsClass(r.ob) : r \in requests }
      [] id = "OBS-22" ->
           IF stopCause # NoCause THEN {"T15-114"}
           ELSE {"T15-110"}
                  \cup (IF past # <<>> /\ past[Len(past)].event = "clock"
                        THEN OfTheJump(past) ELSE {})
      [] id = "TINT-06" -> {id} \cup (IF \E o \in DOMAIN tod :
                                         tod[o].period = EndOfMonth
                                      THEN {"T15-22"} ELSE {})
      [] id = "OBS-42" -> {CASE e.event # "start"    -> "T15-118"
                             [] e.ob \in StartupObs -> "T15-116"
                             [] OTHER               -> "T15-117"}
      [] \E p \in InPlace : p[1] = id ->
           { p[2] : p \in { q \in InPlace : q[1] = id } }
      [] OTHER -> {id}

\* @type: ($event, Seq($event), Set(Str)) => Set(Str);
Cited(e, past, ids) ==
    IF ~Family.byKind THEN ids ELSE UNION { Instead(e, past, id) : id \in ids }
=============================================================================
