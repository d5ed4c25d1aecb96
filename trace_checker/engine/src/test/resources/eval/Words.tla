-------------------------------- MODULE Words -------------------------------
(***************************************************************************)
(* Every construct that the evaluator knows.  The test evaluates all       *)
(* operators without parameters and compares with TLC.  It evaluates an    *)
(* operator with a name in Act as an action.  An operator with a name in   *)
(* Err has no value; the evaluator leaves an operator with a name in Tlc   *)
(* to TLC.                                                                 *)
(***************************************************************************)
EXTENDS Integers, Sequences, FiniteSets

VARIABLES number, set, record, function, sequence

vars == <<number, set, record, function, sequence>>
others == <<record, function, sequence>>
groups == <<set, <<others>>>>

Init ==
    /\ number = 3
    /\ set = {1, 2, 5}
    /\ record = [a |-> 1, b |-> [c |-> "x", d |-> {}]]
    /\ function = [i \in 10..12 |-> i * 2]
    /\ sequence = <<7, 8, 9>>

InitSeveral == /\ number \in {1, 2}
               /\ set = {number}
               /\ record = [a |-> 1] \/ record = [a |-> number + 1]
               /\ function = [i \in set |-> i]
               /\ sequence = <<>>

-----------------------------------------------------------------------------
Arithmetic == <<number + 2, number - 5, number * number, -number, 7 \div 2,
                (-7) \div 2, 7 % 3, (-7) % 3, \h1F>>
Comparison == <<number < 3, number <= 3, number > 3, number >= 3, number = 3,
                number # 3, 3 \in set, 3 \notin set, number \in 1..3>>
Logic == <<TRUE /\ number = 3, number = 4 \/ number = 3, ~(number = 3),
           number = 4 => FALSE, number = 3 <=> 2 \in set, BOOLEAN>>
First(a, b) == IF a = 0 THEN b ELSE a
\* A part that is not needed is not evaluated.
Lazily == LET never == CHOOSE x \in {} : TRUE
              first(a, b) == a
          IN  <<IF number < 9 THEN 1 ELSE never, first(2, never), First(3, never),
                number < 9 \/ never, number > 9 /\ never>>

Sets == <<set \cup {9}, set \cap 2..7, set \ {1}, (1..4) \ set, SUBSET set,
          UNION {set, 4..5}, {1, 2} \subseteq set, set \subseteq {1, 2},
          Cardinality(set \cup 1..3), {x \in set : x > number},
          {x + y : x \in set, y \in 1..2}, {set, {}}, {} = set, set # {},
          {x \in set : x > 9} = {}, (set \ set) \cup set, number..1 = {}>>
Members == <<number \in set \cup {3}, 12 \in DOMAIN function, 2 \in DOMAIN sequence,
             number \in {number, 8}, {1} \in SUBSET set, 2 \in set \ {2}>>
Records == <<record.a, record.b.c, [record EXCEPT !.a = @ + 1, !.b.d = {@}],
             [z |-> 1, a |-> number], record = [b |-> [c |-> "x", d |-> {}], a |-> 1],
             record["a"]>>
Functions == <<function[11], DOMAIN function, [function EXCEPT ![10] = @ + number],
               [x \in set |-> x + number], [x \in set |-> x][2], [s \in {"p", "q"} |-> s],
               [x \in {} |-> x], [[x \in set |-> x] EXCEPT ![5] = 0],
               [function EXCEPT ![10] = 1, ![11] = @ + 1, ![10] = @ + 5],
               [x \in 1..2 |-> x] = <<1, 2>>, [x \in {3, 2} |-> x] = [x \in 2..3 |-> x]>>
Sequences1 == <<sequence[2], Len(sequence), Append(sequence, number), SubSeq(sequence, 2, 3),
                SubSeq(sequence, 1, 0), Head(sequence), sequence \o <<1>>, <<>>,
                [sequence EXCEPT ![1] = @ + 1], Append(<<>>, 1)>>
Bound == <<\E x \in set : x > 4, \A x \in set : x > 1, \E x, y \in set, z \in 1..2 : x + y = z,
           \A x \in {} : FALSE, CHOOSE x \in set : x > 1, CHOOSE x \in set : TRUE,
           \E x \in SUBSET set : Cardinality(x) = 2>>
Cases == <<CASE number = 1 -> "a" [] number = 3 -> "b" [] OTHER -> "c",
           CASE number = 1 -> "a" [] OTHER -> "c",
           CASE number = 3 -> 1 [] number > 2 -> 2>>

Domains == <<{1, 2} = 1..2, <<1, 2>>, [x \in {1, 2} |-> x], {2, 1}, 1..2>>

\* Too large to be written out, and called within its own arguments.
Long(a, b) ==
    LET c == a + b
        d(x) == x + c + a
        both == {x \in {a, b} : x # c}
    IN  IF c > 100 THEN d(a) + Cardinality(both) + d(d(b)) + (IF a > b THEN a - b ELSE b - a)
        ELSE IF c > 50 THEN d(b) + Cardinality(both \cup {c}) + d(d(a)) + d(d(d(a)))
        ELSE IF c > 10 THEN a * b + d(c) + d(d(c)) ELSE a + d(b) + c
Calls == <<Long(1, 2), Long(Long(1, 2), Long(3, Long(4, number))), {Long(x, 50) : x \in set},
           LET p == Long(number, 7) IN p + p>>
\* An inner @ is that of the inner EXCEPT.
Nested == [function EXCEPT ![10] = [x \in 1..1 |-> [function EXCEPT ![11] = @ + x][11] + @][1]]

-----------------------------------------------------------------------------
ActAssign == number' = number + 1 /\ UNCHANGED <<set, others>>
ActGroups == record' = record /\ UNCHANGED <<number, groups>>
ActAny == /\ number' \in set
          /\ number' > 1
          /\ UNCHANGED set
          /\ UNCHANGED others
ActBranches ==
    /\ \/ number' = 1 \/ number' = 2
       \/ \E x \in set, y \in {10, 20} : x # 2 /\ number' = x + y
    /\ set' = {number'}
    /\ UNCHANGED others
ActConditions ==
    /\ IF number = 3 THEN number' = 4 ELSE number' = 5
    /\ CASE number = 2 -> set' = {} [] number' = 4 -> set' = {4} [] OTHER -> UNCHANGED set
    /\ number < 9 => record' = [record EXCEPT !.a = number']
    /\ UNCHANGED <<function, sequence>>
ActTest == /\ UNCHANGED vars
           /\ number' = 3 /\ number' \in {3, 4} /\ number' = number
ActNot == UNCHANGED vars /\ number' # number
ActNone == number > 5 /\ UNCHANGED vars

Next(v) == number' = v
Twice == 2 * number
Sum(x) == number + x
ActPrimed ==
    LET old == number
        new == number'
        both(x) == x + number'
    IN  /\ \E v \in {6, 7} : Next(v)
        /\ set' = {Twice', Twice, old, new, both(old), Sum(old)', Long(number, 1)', Long(number, 1)}
        /\ \/ (number = 9)' /\ sequence' = <<>>
           \/ sequence' = <<(number + Twice)', \E x \in set' : x = new>>
        /\ UNCHANGED <<record, function>>
        /\ sequence' = sequence \/ Len(sequence') = 2
\* A value remembered of this state is not taken for the next state.
Evens == {x \in set : x % 2 = 0}
ActMemo == /\ set' \in {{2, 4}, {6}, {1}}
           /\ number' = Cardinality(Evens') + Cardinality(Evens)
           /\ UNCHANGED others

-----------------------------------------------------------------------------
Enabled == <<ENABLED ActAssign, ENABLED ActNone, ~ENABLED (number > 5 /\ number' = 1),
             {x \in set : ENABLED (x > 1 /\ number' = x)}>>
ActEnabled == /\ number' = 7
              /\ ENABLED (number = 3 /\ number' = 4)
              /\ UNCHANGED <<set, others>>
TlcEnabled == (ENABLED ActAssign)'

\* Evaluated again and again with other numbers, which are its times.
TimedPair(e) == [a |-> number + e.a, b |-> [c |-> e.c, d |-> {[a |-> number * 2], [a |-> e.a, k |-> 1]}]]
TimedValue(e) ==
    <<number < e.a, number <= e.a, number = e.a, (number + e.a) \div 3 = e.a % 7, number \in 3..9,
      [a |-> number] = [a |-> e.a], [a |-> number] \in {[a |-> e.a], [a |-> 4]}, -number = 3 - e.a,
      TimedPair(e).a > 10 /\ e.c = "x", TimedPair(e) = [a |-> 9, b |-> TimedPair(e).b],
      LET f == [r \in {[a |-> number], [a |-> number, k |-> 2]} |-> r.a]
      IN  f[[a |-> number]] = e.a \/ [a |-> e.a] \in DOMAIN f,
      IF number > e.a THEN "more" ELSE "less">>
ActTimed(e) ==
    /\ IF number < e.a THEN number' = number + 2 ELSE number' \in {e.a, number - e.a}
    /\ record' = IF number % 2 = 0 THEN TimedPair(e) ELSE [record EXCEPT !.a = @ + e.a]
    /\ \/ set' = set
       \/ e.c = "x" /\ set' = {1}
    /\ UNCHANGED <<function, sequence>>

ErrChoose == CHOOSE x \in set : x > 9
ErrDomain == function[9]
ErrField == record.z
ErrCase == CASE number = 1 -> 2
ErrOverflow == 2147483647 + number
ErrKinds == number = "x"
ErrBoolean == number /\ TRUE

ActErrUnassigned == number' = 1
ActErrBefore == set' = {number'} /\ number' = 1 /\ UNCHANGED others

TlcLength == Len("abc")
TlcString == "x" \o "y"
=============================================================================
