---------------------------- MODULE PropertiesIrt ---------------------------
(***************************************************************************)
(* Properties of SFC 39/40 (section 3) and of the entries of the           *)
(* diagnostic buffer (table 7.5), said of states and of steps.             *)
(*                                                                         *)
(* Left out: entries that are open because their error is.                 *)
(***************************************************************************)
EXTENDS Steps

IrtCalls == {"DIS_IRT", "EN_IRT"}

(* [IRT-11] The class number of an OB, as a table; 0: it has none. *)
\* @type: Int => Int;
IrtClass(o) ==
    CASE o \in 10..17 -> 10 [] o \in 20..23  -> 20 [] o \in 30..38 -> 30
      [] o \in 40..47 -> 40 [] o \in 55..57  -> 50 [] o = 60       -> 60
      [] o \in {70, 72} -> 70 [] o \in 80..87 -> 80 [] OTHER        -> 0
IrtClasses == {10, 20, 30, 40, 50, 60, 70, 80}

(* The OBs that a call names, as far as the model has them. *)
\* @type: (Int, Int) => Set(Int);
NamedBy(m, o) ==
    { b \in Blockable :
        CASE m \in {0, 128} -> IrtClass(b) # 0
          [] m \in {1, 129} -> o # 0 /\ IrtClass(b) = o
          [] OTHER          -> b = o }

(* [IRT-12] [IRT-13] [AMB-22] [AMB-63] [AMB-73] [AMB-76] *)
IrtAnswerProp ==
    [][ step'.event \in IrtCalls =>
          LET m == step'.operand
              o == step'.ob
              v == step'.value
              known == \/ m \in {0, 1, 2}
                       \/ Did("DIS_IRT") /\ m \in {128, 129, 130}
              named == CASE m \in {0, 128} -> TRUE
                         [] m \in {1, 129} -> o \in IrtClasses
                         [] OTHER          -> IrtClass(o) # 0
          IN  /\ v \in {\h0000, \h8090, \h8091}
              /\ v = 0 => known /\ named
              /\ v = \h8091 => ~known
              /\ v = \h8090 => IF known THEN ~named
                              ELSE o # 1 /\ IrtClass(o) = 0 ]_vars

(* [IRT-06] .. [IRT-09] [IRT-13] .. [IRT-16] [AMB-21] [AMB-42] The OBs     *)
(* that a call blocks and enables.                                         *)
IrtFlagProp ==
    [][ step'.event \in IrtCalls /\ step'.value = 0 =>
          LET named == NamedBy(step'.operand, step'.ob)
          IN  \A o \in Blockable :
                o \in irt'.blocked <=>
                  \/ o \in irt.blocked /\ o \notin named
                  \/ o \in named /\ Did("DIS_IRT") ]_vars

(* [IRT-20] Only a blocked OB is silent, and only by MODE 8x. *)
SilentInv == irt.silent \subseteq irt.blocked
SilentProp ==
    [][ step'.event \in IrtCalls /\ step'.value = 0 =>
          \A o \in NamedBy(step'.operand, step'.ob) :
            o \in irt'.silent <=> Did("DIS_IRT") /\ step'.operand >= 128 ]_vars

(* [IRT-02] [IRT-03] [OBS-53] An OB stays blocked until EN_IRT or a warm   *)
(* or cold restart; after a hot one HotRestartProp says it.                *)
IrtStaysProp ==
    [][ /\ irt' # irt => step'.event \in IrtCalls \cup {"restart"}
        /\ Did("restart") /\ startup' # "hot" =>
             irt'.blocked = {} /\ irt'.silent = {} ]_vars

(* A call moves no request [AMB-72]; an error changes nothing. *)
IrtCallProp ==
    [][ step'.event \in IrtCalls =>
          /\ UNCHANGED <<requests, stack, mode, clock, tod, dint, delay,
                         stopCause>>
          /\ step'.value # 0 => UNCHANGED irt ]_vars

(* [IRT-01] [IRT-04] A start event that is blocked leads to nothing: no    *)
(* OB, no OB 80 or OB 85, no STOP.                                         *)
LostProp ==
    [][ /\ step'.event \in {"reached", "elapsed", "interrupt"}
        /\ step'.ob \in irt.blocked
        => UNCHANGED <<requests, stopCause>> ]_vars

(* [IRT-01] [AMB-23] An error whose OB is blocked does not stop the CPU,   *)
(* unless it came before the block and its OB turns out to be missing      *)
(* [AMB-72].                                                               *)
NoStopProp ==
    [][ \A o \in {80, 85} :
          /\ stopCause' # stopCause /\ o \in irt.blocked
          /\ stopCause' = (IF o = 80 THEN \h4568 ELSE \h456D)
          => Did("missing") /\ step'.ob = o ]_vars

(* [IRT-01] [OBS-33] Nothing new waits for an OB that is blocked. *)
NothingNewProp ==
    [][ \A o \in irt.blocked :
          ~Did("restart") =>
            Cardinality({ r \in requests' : r.ob = o })
              <= Cardinality({ r \in requests : r.ob = o }) ]_vars

(* [IRT-18] [AMB-12] A lost point is used up; so is a one-shot interrupt,  *)
(* unless a definite or open request of its OB waits [AMB-71].             *)
LostPointProp ==
    [][ Did("reached") /\ step'.ob \in irt.blocked =>
          /\ LET waits == \E r \in requests : r.ob = step'.ob
             IN  tod[step'.ob].period = Once =>
                   /\ tod'[step'.ob].active => waits
                   /\ waits => tod'[step'.ob].active \/ OnceUsedUpAtItsPoint
          /\ ~Before(At(tod'[step'.ob].next - 1), clock) ]_vars

-----------------------------------------------------------------------------
(* Entries *)

(* [IRT-09] [IRT-19] [AMB-41] *)
DisabledEntryProp ==
    [][ \h5380 \in EnteredNow <=>
          Did("DIS_IRT") /\ step'.value = 0 /\ step'.operand >= 128 ]_vars

(* [OBS-30] [IRT-09] A definite time error that waits for OB 80 is entered *)
(* with its fault; and no error of OB 80 or OB 85 is while its OB is       *)
(* silent.                                                                 *)
TimeErrorEntryProp ==
    [][ /\ step'.event \in {"reached", "elapsed", "interrupt", "clock",
                           "release"} =>
             \A r \in requests' \ requests :
               r.ob = 80 /\ ~r.open => \h3500 + r.fault \in EnteredNow
        /\ \A n \in entered' : 80 \in irt.silent => n.of.ob # 80
        /\ \A n \in entered' : 85 \in irt.silent => n.of.ob # 85 ]_vars

(* The error's OB is blocked by SFC 39, not without entries. *)
\* @type: Int => Bool;
BlockedWithEntries(o) == Blocked(o) /\ ~Silenced(o) /\ ~Deselected(o)

(* [IRT-06] [IRT-04] An error that SFC 39 blocks with MODE 0, 1 or 2 is    *)
(* entered: one from outside, a start event whose OB runs, a skipped       *)
(* point, a missing OB.                                                    *)
BlockedEntryProp ==
    [][ /\ /\ Did("interrupt") /\ step'.ob \in {80, 85} /\ step'.value # 0
           /\ mode # "STOP" /\ BlockedWithEntries(step'.ob)
           => \h3500 + step'.value \in EnteredNow
        /\ BlockedWithEntries(80) =>
             /\ /\ step'.event \in {"reached", "elapsed"}
                /\ OnStack(step'.ob) /\ TakesEvents(step'.ob)
                /\ ~OnlyFirstPointIsReported
                => \h3502 \in EnteredNow
             /\ Did("clock") /\ mode = "RUN" /\ SkippedAndLoaded # {}
                => \h3505 \in EnteredNow
             /\ Did("release") /\ SkippedAndLoaded # {}
                => \h3506 \in EnteredNow
        /\ /\ Did("missing") /\ step'.ob \notin AsyncErrorObs \cup {70, 72}
           /\ ~MissingIsTimeError /\ ~NoticedBefore(step'.ob)
           /\ BlockedWithEntries(85)
           => EnteredNow \cap {\h35A1, \h35A2} # {} ]_vars

(* [OBS-21] [OBS-22] A STOP by rule is entered with its cause. *)
StopEntryProp ==
    [][ stopCause = NoCause /\ stopCause' \notin {NoCause, 0}
          => stopCause' \in EnteredNow ]_vars

(* [IRT-09] [OBS-30] An entry has a cause in this step. In STARTUP it may  *)
(* be that a deselected OB is loaded [OBS-25].                             *)
EntrySourceProp ==
    [][ entered' # {} =>
          \/ step'.event \in {"reached", "elapsed", "interrupt", "clock",
                             "release", "missing", "restart", "DIS_IRT"}
          \/ Did("load") /\ mode = "STARTUP" ]_vars
=============================================================================
