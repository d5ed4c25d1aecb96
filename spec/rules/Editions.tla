------------------------------ MODULE Editions ------------------------------
(***************************************************************************)
(* The letters of the ambiguities in docs/rules/readings.md: the default   *)
(* letters, which hold where neither a header nor a model names another;   *)
(* the letters that a header may name; the profiles, each with the letters *)
(* of one edition of the manual; the letter of the CPU at hand.            *)
(*                                                                         *)
(* Module Readings gives each letter its meaning.                          *)
(* Left out: letters that no formula tells apart; docs/rules/readings.md   *)
(* says why.                                                               *)
(***************************************************************************)
EXTENDS State

(* The ambiguities with a default other than (a). *)
\* @type: Set(Str);
ReadByB ==
    { "AMB-02", "AMB-27", "AMB-31", "AMB-44", "AMB-63" }
\* @type: Set(Str);
ReadByC ==
    { "AMB-01", "AMB-28", "AMB-34", "AMB-45", "AMB-47", "AMB-48",
      "AMB-49", "AMB-50", "AMB-52", "AMB-53", "AMB-54", "AMB-55",
      "AMB-56", "AMB-57", "AMB-60", "AMB-61", "AMB-67", "AMB-68", "AMB-70",
      "AMB-79" }
\* @type: Set(Str);
ReadByD == { "AMB-11", "AMB-13", "AMB-18", "AMB-71", "AMB-77" }

(* The number of letters that formulas tell apart. *)
\* @type: Set(Str);
FourLetters ==
    { "AMB-11", "AMB-13", "AMB-18", "AMB-56", "AMB-71", "AMB-77" }
\* @type: Set(Str);
ThreeLetters ==
    { "AMB-01", "AMB-03", "AMB-04", "AMB-05", "AMB-06",
      "AMB-14", "AMB-15", "AMB-19", "AMB-28", "AMB-34", "AMB-38", "AMB-39",
      "AMB-45", "AMB-47", "AMB-48", "AMB-49", "AMB-50", "AMB-52", "AMB-53",
      "AMB-54", "AMB-55", "AMB-57", "AMB-60", "AMB-61",
      "AMB-67", "AMB-68", "AMB-70", "AMB-79" }
\* @type: Set(Str);
TwoLetters ==
    { "AMB-02", "AMB-07", "AMB-08", "AMB-09", "AMB-10", "AMB-12",
      "AMB-16", "AMB-17", "AMB-20", "AMB-21", "AMB-22", "AMB-23",
      "AMB-25", "AMB-27", "AMB-29", "AMB-31", "AMB-32", "AMB-33",
      "AMB-35", "AMB-36", "AMB-37", "AMB-40", "AMB-41", "AMB-42",
      "AMB-43", "AMB-44", "AMB-46", "AMB-51", "AMB-58", "AMB-59",
      "AMB-62", "AMB-63", "AMB-65", "AMB-66", "AMB-69", "AMB-72", "AMB-73",
      "AMB-74", "AMB-75", "AMB-76" }

Ambiguities == FourLetters \cup ThreeLetters \cup TwoLetters

(* The defaults. *)
\* @type: Str -> Str;
Defaults ==
    [ a \in Ambiguities |->
        IF a \in ReadByB THEN "b" ELSE IF a \in ReadByC THEN "c"
        ELSE IF a \in ReadByD THEN "d" ELSE "a" ]

(* The letters that a header may name. *)
\* @type: Str => Set(Str);
Letters(a) == CASE a \in FourLetters  -> {"a", "b", "c", "d"}
                [] a \in ThreeLetters -> {"a", "b", "c"}
                [] a \in TwoLetters   -> {"a", "b"}
                [] a \in ReadByB      -> {"b"}
                [] a \in ReadByC      -> {"c"}
                [] OTHER              -> {"a"}

-----------------------------------------------------------------------------
(* Looking a letter up *)

(* The letter by which a CPU reads a question, and that of this CPU. *)
\* @type: ($cpu, Str) => Str;
ReadingOf(c, a) == IF a \in DOMAIN c.readings THEN c.readings[a]
                                              ELSE Defaults[a]
\* @type: Str => Str;
Reading(a) == ReadingOf(cpu, a)

(* (a) nothing of the set, (b) all of it, or any part. *)
\* @type: (Str, Set(Int)) => Set(Set(Int));
PartBy(letter, whole) ==
    { part \in SUBSET whole : CASE letter = "a" -> part = {}
                               [] letter = "b" -> part = whole
                               [] OTHER        -> TRUE }

(* The CPU c with a letter of its own. *)
\* @type: (Str, Str, $cpu) => $cpu;
ReadAs(a, letter, c) ==
    [ c EXCEPT !.readings = [ x \in DOMAIN c.readings \cup {a} |->
                                IF x = a THEN letter ELSE c.readings[x] ] ]

(* The CPUs that c may turn out to be, if its letter is the open one. *)
\* @type: ($cpu, Str, Str, Set(Str)) => Set($cpu);
Turned(c, a, open, letters) ==
    IF ReadingOf(c, a) # open THEN {c}
    ELSE { ReadAs(a, letter, c) : letter \in letters }

-----------------------------------------------------------------------------
(* Profiles: the letters of an edition as printed, where the defaults      *)
(* would reject it. AMB-06 has the letter "delay" for the edition of 2010: *)
(* (b) for time-delay interrupts alone.                                    *)

ProfileNames == {"1997", "2006", "2010"}

\* @type: Str => Set(<<Str, Str>>);
Profile(name) ==
    CASE name = "1997" ->
           { <<"AMB-01", "a">>, <<"AMB-02", "a">>, <<"AMB-04", "b">>,
             <<"AMB-05", "b">>, <<"AMB-14", "c">>, <<"AMB-17", "b">>,
             <<"AMB-20", "b">>, <<"AMB-43", "b">> }
      [] name = "2006" ->
           { <<"AMB-01", "b">>, <<"AMB-02", "a">>, <<"AMB-04", "b">>,
             <<"AMB-20", "b">>, <<"AMB-22", "b">>, <<"AMB-36", "b">>,
             <<"AMB-40", "b">>, <<"AMB-41", "b">>, <<"AMB-42", "b">> }
      [] name = "2010" ->
           { <<"AMB-01", "b">>, <<"AMB-06", "delay">>, <<"AMB-20", "b">>,
             <<"AMB-36", "b">>, <<"AMB-74", "b">> }
      [] OTHER -> {}
=============================================================================
