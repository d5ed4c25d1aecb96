--------------------------- MODULE OrderOfReasons ---------------------------
(***************************************************************************)
(* The order in which the requirements of a line are cited: the first one  *)
(* is what the reader does not expect.                                     *)
(*                                                                         *)
(* No action uses this module.                                             *)
(* Source: the requirement IDs.                                            *)
(***************************************************************************)
EXTENDS Readings

(* Requirements of a special case: where one of these decides, it is what  *)
(* the reader does not expect.                                             *)
Special ==
    { "AIRT-04", "AIRT-09", "AIRT-13", "AIRT-16", "CLK-01", "CLK-04", "CLK-10",
      "CLK-11", "CLK-13", "CLK-14", "CLK-18", "DINT-04", "DINT-08", "DINT-10",
      "DINT-11", "DINT-12", "DINT-13", "DINT-15", "DINT-17", "DINT-18",
      "DINT-19", "DINT-20", "IRT-03", "IRT-06", "IRT-09", "IRT-11", "IRT-12",
      "IRT-14", "IRT-16", "IRT-17", "IRT-18", "IRT-19", "IRT-20", "IRT-23",
      "IRT-24", "OBS-05", "OBS-06", "OBS-22", "OBS-25", "OBS-28", "OBS-29",
      "OBS-31", "OBS-33", "OBS-41", "OBS-42", "OBS-43", "OBS-46", "OBS-52",
      "OBS-53", "OBS-54", "OBS-55", "OBS-56", "OBS-57", "OBS-60", "TINT-11",
      "TINT-13", "TINT-14", "TINT-18", "TINT-19", "TINT-31", "TINT-32",
      "TINT-33", "TINT-36", "TINT-51", "TINT-62", "TINT-63", "TINT-64",
      "TINT-77", "TINT-79" }

(* What differs between families of CPUs: as special.                      *)
OfFamilies ==
    { "T15-20", "T15-23", "T15-26", "T15-30", "T15-35", "T15-36", "T15-61",
      "T15-62", "T15-63", "T15-64", "T15-65", "T15-66", "T15-90", "T15-91",
      "T15-93", "T15-94", "T15-95", "T15-96", "T15-97", "T15-98", "T15-99",
      "T15-103", "T15-100", "T15-110", "T15-111", "T15-112", "T15-113",
      "T15-114", "T15-115", "T15-117", "T15-118", "T15-119", "T15-120",
      "T15-141" }

(* Requirements of every start, every call, every STOP: true, and little   *)
(* news.                                                                   *)
General ==
    { "AIRT-02", "AIRT-03", "CLK-08", "CLK-12", "DINT-02", "DINT-03",
      "DINT-05", "DINT-07", "DINT-21", "DINT-22", "IRT-13", "IRT-22", "OBS-01",
      "OBS-02", "OBS-03", "OBS-20", "OBS-23", "OBS-30", "OBS-40", "OBS-44",
      "TINT-01", "TINT-02", "TINT-06", "TINT-07", "TINT-08", "TINT-09",
      "TINT-12", "TINT-17", "TINT-22", "TINT-23", "TINT-30", "TINT-35",
      "TINT-60" }

(* Questions that no text answers, and that decide alone.                  *)
Unanswered == {"A15-17", "AMB-85"}

(* The least general requirement is cited first.                           *)
\* @type: Str => Int;
Generality(id) ==
    CASE id \in Special \cup OfFamilies \cup Unanswered -> 0
      [] id \in General                      -> 2
      [] id \in { q[1] : q \in Questions } -> 3
      [] OTHER                               -> 1
=============================================================================
