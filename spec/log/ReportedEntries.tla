--------------------------- MODULE ReportedEntries --------------------------
(***************************************************************************)
(* Entries of the diagnostic buffer in a log: each entry in a line has a   *)
(* cause. If the log has such lines, each cause leads to an entry within   *)
(* the latency.                                                            *)
(*                                                                         *)
(* Source: docs/checking/log-format.md, fine point 9; requirements, table  *)
(* 7.5.                                                                    *)
(* Left out: entries of other events. Table 7.5 has those of OB 80, OB 85, *)
(* STOP by rule and SFC 39.                                                *)
(***************************************************************************)
EXTENDS StartInfo, LogState

(* Entries that have to come, if the log has entries. *)
DemandedEntries == { ErrorEntry + f : f \in (1..11) \cup (\hA1..\hA3) }
                     \cup {EntriesDisabled, NoTimeErrorOb, NoProgramErrorOb}
(* Entries that need a cause: these, and 454A.                             *)
JudgedEntries == DemandedEntries \cup {DeselectedLoaded}

(* OB number 0 or 16#FF stands for no OB. *)
\* @type: ($entry, $event) => Bool;
FitsEntry(entry, e) ==
    /\ \/ e.id = entry.id
       \/ /\ e.id - ErrorEntry \in ObNotLoaded
          /\ FitsFault(entry.id - ErrorEntry, e.id - ErrorEntry)
    /\ \/ entry.of.ob = 0
       \/ /\ e.ob \in {0, 255, entry.of.ob}
          /\ Fits(e.priority, entry.of.class)
          /\ FitsError(entry.of, e.info)

(* An unseen event may have caused this entry. Only DIS_IRT causes the     *)
(* entry of disabled entries.                                              *)
\* @type: Int => Bool;
CauseUnseen(id) ==
    LET kinds == IF id = EntriesDisabled THEN {"call"} ELSE Kinds \ {"load"}
    IN  ~(kinds \subseteq terms.records)

-----------------------------------------------------------------------------
(* Entries that the log has not shown yet *)

(* The fields of an entry that a line can show. If the log has no such     *)
(* lines, the active OB and the certainty of the entry do not matter.      *)
\* @type: $entry => $entry;
AsReported(entry) ==
    LET told == [ entry EXCEPT !.of.since = At(0), !.of.rank = 0,
                               !.of.open = FALSE ]
    IN  IF DiagRecorded THEN told
        ELSE [told EXCEPT !.open = FALSE, !.of.during = -1]

(* If the log has no such lines, three equal entries stand for any number. *)
Many == 3

\* @type: Int => Int;
OneMore(times) == IF DiagRecorded \/ times < Many THEN times + 1 ELSE Many
\* @type: Int => Int;
OneLess(times) == IF DiagRecorded \/ times < Many THEN times - 1 ELSE Many

(* [OBS-26] The cycle time was exceeded twice in a cycle: the CPU may stop, *)
(* and the STOP has one entry, which the log may show before or after it.  *)
ExceededTwice    == overruns = 2
EntryOfCycleTime == [id |-> NoTimeErrorOb, of |-> NoRequest, open |-> TRUE]

EntriesOfCycleTime ==
    IF ~ExceededTwice /\ ExceededTwice' THEN {EntryOfCycleTime} ELSE {}

(* [AMB-49] The entry of a STOP that waits for the end of a delay comes    *)
(* with the STOP; not at all if the CPU is stopped before. [OBS-26] So     *)
(* does the entry of a STOP by the cycle time.                             *)
\* @type: $report => Bool;
WaitsWithStop(r) ==
    \/ r.entry.id = stopCause /\ ~StopIsDue
    \/ /\ r.entry = AsReported(EntryOfCycleTime)
       /\ ExceededTwice /\ mode # "STOP"

\* @type: $report => $report;
AfterStop(r) == IF WaitsWithStop(r) THEN [r EXCEPT !.entry.open = TRUE] ELSE r

Unreported == IF DiagRecorded /\ mode # "STOP" /\ mode' = "STOP"
              THEN { AfterStop(r) : r \in reports } ELSE reports

(* The entries of this step have to be shown; their cause was `age' ms     *)
(* ago. Entries that an unseen event may have caused are not kept.         *)
\* @type: Int => Bool;
Report(age) ==
    LET shown == { m \in entered' \cup EntriesOfCycleTime :
                     m.id \in JudgedEntries /\ ~CauseUnseen(m.id) }
        new == { AsReported(n) : n \in shown }
        a   == IF DiagRecorded THEN age ELSE 0
        same(n) == { r \in Unreported : r.entry = n /\ r.age = a }
        times(n) == IF same(n) = {} THEN 1
                    ELSE OneMore((CHOOSE r \in same(n) : TRUE).times)
    IN  reports' = IF new = {} THEN Unreported
                   ELSE (Unreported \ UNION { same(n) : n \in new })
                          \cup { [entry |-> n, age |-> a, times |-> times(n)]
                                 : n \in new }

(* The entries that would be too late in d ms. *)
\* @type: Int => Set($report);
EntriesLate(d) ==
    IF reports = {} \/ ~DiagRecorded THEN {}
    ELSE { r \in reports : /\ ~r.entry.open /\ ~WaitsWithStop(r)
                           /\ r.entry.id \in DemandedEntries
                           /\ r.age + d > terms.latency }

(* The entries grow older. An entry that need not come is forgotten after  *)
(* the latency.                                                            *)
\* @type: Int => Set($report);
ReportsAfter(d) ==
    IF reports = {} \/ ~DiagRecorded THEN reports
    ELSE { IF WaitsWithStop(r) THEN r ELSE [r EXCEPT !.age = @ + d]
           : r \in { q \in reports : \/ q.age + d <= terms.latency
                                    \/ WaitsWithStop(q) } }

-----------------------------------------------------------------------------

(* A line shows an entry that no line has shown yet. *)
\* @type: $event => Bool;
IsEntry(e) ==
    LET fits == { r \in reports : FitsEntry(r.entry, e) }
    IN  /\ UNCHANGED cpuVars
        /\ NothingEntered
        /\ IF e.id \notin JudgedEntries THEN UNCHANGED reports
           ELSE \E r \in { q \in fits : \A p \in fits : p.age <= q.age } :
                  reports' = (reports \ {r}) \cup
                               IF OneLess(r.times) = 0 THEN {}
                               ELSE {[r EXCEPT !.times = OneLess(@)]}
=============================================================================
