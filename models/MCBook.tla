------------------------------- MODULE MCBook -------------------------------
(***************************************************************************)
(* The tables of the book: `make site' has TLC evaluate them. A state is a *)
(* CPU of a family in a situation that a STATUS shows, and no step follows.*)
(***************************************************************************)
EXTENDS System, ReportedData

(* An error OB 121 or 122 has the class of the OB that fails. *)
BookObs == {CycleOb} \cup TodObs \cup DintObs \cup ExternalObs
             \cup StartupObs

BookSetting == [NoSetting EXCEPT !.set = TRUE, !.active = TRUE, !.next = 1,
                                 !.period = Daily]

BookInit ==
    /\ cpu \in [ family : FamilyNames, priority : Priorities,
                 step7 : {[o \in OldTodObs |-> NoParameters]},
                 readings : ReadingSets, classes : ObClasses,
                 queues : Queues, zone : Zones ]
    /\ loaded \in {{}, {10, 20}}
    /\ mode \in {"STARTUP", "RUN"}
    /\ clock = At(0)
    /\ \E active \in BOOLEAN :
         /\ tod = [o \in TodObs |-> IF active THEN BookSetting ELSE NoSetting]
         /\ dint = [o \in DintObs |-> [NoJobs[o] EXCEPT !.started = active]]
    /\ irt \in {NoneBlocked, [NoneBlocked EXCEPT !.blocked = {10, 20}]}
    /\ startup = "none" /\ resume = NothingKept
    /\ requests = {} /\ stack = <<>> /\ delay = 0 /\ stopCause = NoCause
    /\ entered = {} /\ step = Step("power on", 0, 0)
    /\ terms = 0 /\ up = 0 /\ waiting = 0 /\ first = 0 /\ overruns = 0
    /\ arrivals = 0 /\ changes = {} /\ pace = 0 /\ reports = {}

BookNext ==
    FALSE /\ UNCHANGED <<vars, lineVars, eventVars, up, waiting, reports>>

(* SFC 31 for OB 10, SFC 34 for OB 20. *)
SituationTable ==
    [ family |-> cpu.family, startup |-> mode = "STARTUP",
      blocked |-> Blocked(10), active |-> tod[10].active,
      loaded |-> 10 \in loaded,
      tint |-> Statuses(10), dint |-> DintStatuses(20) ]

FamilyTable ==
    [ family  |-> cpu.family,
      periods |-> ValidPeriods,
      dis     |-> DisModes,
      en      |-> EnModes,
      silent  |-> { m \in DisModes : WithoutEntries(m) },
      level   |-> [m \in DisModes |-> Level(m)],
      meant   |-> [n \in ClassNumbersOfIrt |->
                     { o \in ObNumbersOfIrt : ClassNumber(o) = n }],
      classes |-> [o \in BookObs |-> ClassOf(o)],
      events  |-> [o \in BookObs |-> EventsOf(o)],
      lacks   |-> BookObs \cap (Family.lacks \cup Family.unknown) ]
=============================================================================
