-------------------------------- MODULE Codes -------------------------------
(***************************************************************************)
(* The words that the program and the CPU exchange: RET_VAL codes, PERIOD  *)
(* codes, fault ids and event ids (tables 7.2 to 7.6).                     *)
(*                                                                         *)
(* Left out: the general error codes 8x7F and 8x22..8x45 [TINT-22]         *)
(* (Calls).                                                                *)
(***************************************************************************)
EXTENDS Integers

(* [TINT-22] RET_VAL: no error *)
OK == 0
(* [TINT-35] [TINT-51] [TINT-61] [TINT-70] [DINT-05] [IRT-12] bad OB_NR *)
BadOb == \h8090
(* [TINT-35] bad SDT *)
BadSdt == \h8091
(* [DINT-04] bad DTIME *)
BadDtime == \h8091
(* [IRT-12] bad MODE *)
BadMode == \h8091
(* [TINT-35] bad PERIOD *)
BadPeriod == \h8092
(* [TINT-51] [TINT-61] no start date and time defined for the OB *)
NotSet == \h80A0
(* [DINT-14] no delay started for the OB *)
NotStarted == \h80A0
(* [TINT-36] [TINT-61] start point in the past *)
PastStart == \h80A1
(* [AIRT-07] EN_AIRT where nothing is delayed *)
NotDelayed == \h8080

(* [TINT-33] [TINT-34] PERIOD; AMB-01 says which of the weekly codes are   *)
(* accepted.                                                               *)
Once       == \h0000
Minutely   == \h0201
Hourly     == \h0401
Daily      == \h1001
Weekly     == {\h1201, \h1202}
Monthly    == \h1401
Yearly     == \h1801
EndOfMonth == \h2001

(* [AMB-05] (c) [AMB-86] (b) Not a code of the CPU: monthly, in shorter    *)
(* months on the last day.                                                 *)
MonthlyOrLast == -1
(* [AMB-62] (b) [AMB-86] (c) Nor this: set, without a point. *)
NoPeriod == -2
(* [AMB-38] (c) Nor these: yearly, in common years on February 28 or on    *)
(* March 1 for February 29.                                                *)
YearlyOrDayBefore == -3
YearlyOrDayAfter  == -4

PeriodCodes ==
    {Once, Minutely, Hourly, Daily, Monthly, Yearly, EndOfMonth} \cup Weekly

(* [OBS-30] fault ids of OB 80 and (table 7.3) of OB 85 *)
CycleTimeExceeded == \h01
StillRunning    == \h02
SkippedByClock  == \h05
SkippedInHold   == \h06
Skips           == {SkippedByClock, SkippedInHold}
(* [T15-96] By a local time that daylight saving sets ahead, entered as    *)
(* 3504; [T15-98] that a new zone sets ahead, which is no fault: no OB 80  *)
(* reports it.                                                             *)
SkippedByDaylight == \h04
SkippedByZone     == \h100
LocalSkips        == {SkippedByDaylight, SkippedByZone}
BufferOverflow  == \h07
ObNotLoaded     == {\hA1, \hA2}
(* Faults that the start event of an OB causes. *)
FaultsOfStart   == {StillRunning, BufferOverflow} \cup ObNotLoaded
(* Faults that follow from the rules here, and never come from outside.    *)
FaultsOfRules == {StillRunning, BufferOverflow} \cup Skips \cup ObNotLoaded
(* No source says which fault it is. *)
UnknownFault    == -1

(* [CLK-06] The mask by which OB 80 names late OBs: bit k is OB 10 + k. *)
\* @type: Set(Int) => Int;
LateMask(obs) ==
    LET b(o, v) == IF o \in obs THEN v ELSE 0
    IN  b(10, 1) + b(11, 2) + b(12, 4) + b(13, 8) + b(14, 16) + b(15, 32)
          + b(16, 64) + b(17, 128)

(* Entries of the diagnostic buffer (table 7.5): \h3500 + fault id for     *)
(* time errors and missing OBs, and that of DIS_IRT with MODE 8x [IRT-09]. *)
ErrorEntry == \h3500
EntriesDisabled == \h5380

(* Causes of STOP, which are entries too: [OBS-22] [OBS-21] [OBS-25]; 0    *)
(* where the sources name no event for the rule [OBS-23].                  *)
NoTimeErrorOb    == \h4568
NoProgramErrorOb == \h456D
DeselectedLoaded == \h454A
(* [OBS-27] [OBS-63] OB 121 or OB 122 is missing, or fails itself.         *)
NoProgrammingErrorOb == \h4562
NoAccessErrorOb      == \h4563
CausesOfSyncErrors   == {NoProgrammingErrorOb, NoAccessErrorOb}
OtherErrorOb     == 0
NoCause          == -1
(* Causes that follow from the rules here alone.                           *)
CausesOfRules == {NoTimeErrorOb, NoProgramErrorOb, DeselectedLoaded}
                   \cup CausesOfSyncErrors
=============================================================================
