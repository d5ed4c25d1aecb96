------------------------------ MODULE Profiles ------------------------------
(***************************************************************************)
(* Profiles: the letters of an edition of the manual as it plainly prints, *)
(* where the defaults would reject it; the slips of its translation into   *)
(* Russian or Chinese come on top (docs/rules/readings.md).                *)
(*                                                                         *)
(* Left out: the questions themselves (Readings).                          *)
(***************************************************************************)

ProfileNames == {"1997", "2006", "2010", "1997ru", "2006ru", "2010zh"}

\* @type: Str => Set(<<Str, Str>>);
Printed(name) ==
    CASE name \in {"1997", "1997ru"} ->
           { <<"AMB-01", "a">>, <<"AMB-02", "a">>, <<"AMB-04", "b">>,
             <<"AMB-05", "b">>, <<"AMB-14", "c">>, <<"AMB-17", "b">> }
      [] name \in {"2006", "2006ru"} ->
           { <<"AMB-01", "b">>, <<"AMB-02", "a">> }
      [] name \in {"2010", "2010zh"} -> { <<"AMB-01", "b">> }
      [] OTHER -> {}

(* AMB-06 "delay": (b) for time-delay interrupts alone. *)
\* @type: Str => Set(<<Str, Str>>);
Slips(name) ==
    CASE name = "1997ru" ->
           { <<"AMB-20", "b">>, <<"AMB-36", "b">>, <<"AMB-43", "b">> }
      [] name = "2006ru" ->
           { <<"AMB-04", "b">>, <<"AMB-09", "b">>, <<"AMB-20", "b">>,
             <<"AMB-22", "b">>, <<"AMB-36", "b">>, <<"AMB-42", "b">> }
      [] name = "2010zh" -> { <<"AMB-06", "delay">>, <<"AMB-20", "b">> }
      [] OTHER -> {}

\* @type: Str => Set(<<Str, Str>>);
Profile(name) == Printed(name) \cup Slips(name)
=============================================================================
