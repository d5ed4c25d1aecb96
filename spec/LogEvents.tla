------------------------------ MODULE LogEvents -------------------------------
(***************************************************************************)
(* The records that stand for the lines of a log: header and events, with  *)
(* the value that a field has where the line does not give it (-1).  The   *)
(* trace checker's engine fills them from the log.                         *)
(* Source: docs/log-format.md, the fields of header and events.            *)
(* Left out: `source', `comment' and fields that the format does not know. *)
(***************************************************************************)
EXTENDS Modes

(* Event records: the fields of a log line; -1 where a value is not given *)

\* @type: $moment;
NoMoment == [min |-> -1, ms |-> 0]

\* @type: $date;
NoDate == [ year |-> 0, month |-> 0, day |-> 0, hour |-> 0, minute |-> 0,
            second |-> 0, ms |-> 0 ]

\* @type: $info;
NoInfo == [ strt_info |-> -1, flt_id |-> -1, priority |-> -1, period |-> -1,
            sign |-> -1, dtime |-> -1, error_info |-> -1, ev |-> -1,
            ev_ob |-> -1, time |-> NoMoment ]

\* @type: $event;
NoEvent == [ event |-> "", at |-> NoMoment, up |-> NoMoment, ob |-> 0,
             sdt |-> NoDate, period |-> -1, dtime |-> -1, sign |-> -1,
             mode |-> -1, ret |-> -1, status |-> -1, to |-> NoMoment,
             type |-> "", cause |-> -1, flt_id |-> -1, id |-> -1,
             priority |-> -1, info |-> NoInfo ]

\* @type: (Int, Set(Int)) => Set(Int);
Given(value, possible) == IF value = -1 THEN possible ELSE {value}

-----------------------------------------------------------------------------
(* The header *)

\* @type: $header;
NoHeader == [ cpu |-> "", obs |-> {}, clock |-> NoMoment, mode |-> "",
              latency |-> 0, cycle |-> FALSE, priority |-> {}, step7 |-> {},
              readings |-> {}, profile |-> "", records |-> {} ]

NoParameters == [ execution |-> "none", start |-> 0, active |-> FALSE,
                  deselected |-> FALSE ]
=============================================================================
