------------------------------- MODULE Explain ------------------------------
(***************************************************************************)
(* A specification for the engine's own tests: a counter that can be read, *)
(* set, and set to any number up to a limit.  Before it is read it may     *)
(* double unseen while it is under 8.  At Full no time elapses; at Round   *)
(* it starts again and again.                                              *)
(***************************************************************************)
EXTENDS Integers, Sequences

VARIABLES count, time

Full == 99
Round == 98

NoHeader == [first |-> 0, choices |-> {}, foreign |-> {}]
NoEvent == [event |-> "", line |-> 0, at |-> 0, value |-> 0]
Explained == {"read", "set", "any"}
NotCovered(h) == h.foreign

Init == count = 0 /\ time = 0

Begin(h) == count' \in {h.first} \cup h.choices /\ time' = 0

Arrived(e) == time = e.at
Elapse(e) == /\ count # Full
             /\ time < e.at
             /\ time' = IF count = Round THEN (time + 1) % 30000 ELSE time + 1
             /\ count' = count

Stirs(e) == count > 0
Silent(e) == /\ count < 8
             /\ count' = 2 * count
             /\ time' = time

(* [TINY-03] *)
Observe(e) ==
    /\ CASE e.event = "read" -> count = e.value /\ count' = count
         [] e.event = "set"  -> count' = e.value
         [] e.event = "any"  -> count' \in 1..e.value
    /\ time' = time

(* There is nothing uncertain to give up. *)
Loosen == FALSE /\ UNCHANGED <<count, time>>
LastResort == Loosen
(* No log leaves anything out. *)
Partial == FALSE
Loose == FALSE

(* Nor anything that many states share. *)
Crowd == FALSE /\ UNCHANGED <<count, time>>
MeetingPlace == <<count, time>>
Waits == count
Meet(all) == FALSE /\ UNCHANGED <<count, time>>

Expected(e) == {[event |-> "read", value |-> count]}
Deciding(e, past) == {"TINY-01"} \cup {"TINY-" \o p.event : p \in {past[i] : i \in DOMAIN past}}
LateDistance(e) == 0
Distance(e) == IF count < e.value THEN e.value - count ELSE count - e.value
TooLate(e) == {[event |-> "set", value |-> 0]}
LateRequirements(e, past) == {"TINY-02"}

(* [TINY-04] *)
Small(n) == count + n < 3
Guarded(n) == n >= 0 /\ Small(n) /\ count' = n /\ time' = time
Either(n) == \/ Guarded(n)
             \/ \E m \in {} : Guarded(m)
             \/ LET double == 2 * n
                IN  IF double > 1 THEN count > n /\ UNCHANGED <<count, time>>
                                  ELSE Silent(NoEvent)

Situation == [count |-> count]
Distinct == <<count, time>>
DistinctAfterLine == Distinct
Alternatives == {1, 2}
Generality(id) == 0

Next == Silent(NoEvent)
=============================================================================
