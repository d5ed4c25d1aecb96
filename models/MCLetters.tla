------------------------------ MODULE MCLetters -----------------------------
(***************************************************************************)
(* For ReadingSets of a model: a letter that is not the default, or two.   *)
(*                                                                         *)
(* The controls letter-... of manifest.json show what a letter contradicts *)
(* (not_proved of proofs.json).                                            *)
(* Left out: the letters that contradict nothing.                          *)
(***************************************************************************)

\* @type: (Str, Str) => Set(Str -> Str);
ReadBy(ambiguity, letter) == {[a \in {ambiguity} |-> letter]}

\* @type: (Str, Str, Str) => Set(Str -> Str);
BothBy(first, second, letter) == {[a \in {first, second} |-> letter]}

Letter01a == ReadBy("AMB-01", "a")
Letter01b == ReadBy("AMB-01", "b")
Letter02a == ReadBy("AMB-02", "a")
Letter04b == ReadBy("AMB-04", "b")
Letter05b == ReadBy("AMB-05", "b")
Letter05c == ReadBy("AMB-05", "c")
Letter06b == ReadBy("AMB-06", "b")
Letter06b23b == BothBy("AMB-06", "AMB-23", "b")
Letter06b33b == BothBy("AMB-06", "AMB-33", "b")
Letter06b41b == BothBy("AMB-06", "AMB-41", "b")
Letter08b == ReadBy("AMB-08", "b")
Letter09b == ReadBy("AMB-09", "b")
Letter14b == ReadBy("AMB-14", "b")
Letter14c == ReadBy("AMB-14", "c")
Letter15c == ReadBy("AMB-15", "c")
Letter20b == ReadBy("AMB-20", "b")
Letter21b == ReadBy("AMB-21", "b")
Letter25b == ReadBy("AMB-25", "b")
Letter32b == ReadBy("AMB-32", "b")
Letter37b == ReadBy("AMB-37", "b")
Letter38b == ReadBy("AMB-38", "b")
Letter39c == ReadBy("AMB-39", "c")
Letter41b == ReadBy("AMB-41", "b")
Letter42b == ReadBy("AMB-42", "b")
Letter46b == ReadBy("AMB-46", "b")
Letter62b == ReadBy("AMB-62", "b")
Letter66b == ReadBy("AMB-66", "b")
Letter72b == ReadBy("AMB-72", "b")
Letter74b == ReadBy("AMB-74", "b")
=============================================================================
