/* Puts the variants of this folder in the place of functions of the library.
 *
 * The units of the library are compiled a second time, for the program with the deliberate faults,
 * with this header in front (-include) and with IN_<unit> defined. A name of the library then
 * means the variant wherever it is called from another unit than its own; the variants themselves
 * are compiled without this header and call the library's functions. */
#ifndef IN_airt
#define s7_airt_disable faulty_airt_disable
#define s7_airt_enable faulty_airt_enable
#define s7_airt_ob_ended faulty_airt_ob_ended
#endif
#ifndef IN_diag
#define s7_diag_error faulty_diag_error
#define s7_diag_stop faulty_diag_stop
#define s7_diag_suppressed faulty_diag_suppressed
#endif
#ifndef IN_dint
#define s7_dint_cancel faulty_dint_cancel
#define s7_dint_released faulty_dint_released
#define s7_dint_restart faulty_dint_restart
#define s7_dint_start faulty_dint_start
#endif
#ifndef IN_emit
#define s7_emit faulty_emit
#define s7_emit_start faulty_emit_start
#define s7_emit_diag faulty_emit_diag
#endif
#ifndef IN_errors
#define s7_error_missing faulty_error_missing
#define s7_error_overlap faulty_error_overlap
#define s7_error_skipped faulty_error_skipped
#endif
#ifndef IN_irt
#define s7_irt_disable faulty_irt_disable
#define s7_irt_enable faulty_irt_enable
#define s7_irt_loses faulty_irt_loses
#endif
#ifndef IN_irt_mask
#define s7_irt_block faulty_irt_block
#define s7_irt_blocks faulty_irt_blocks
#define s7_irt_open faulty_irt_open
#define s7_irt_restart faulty_irt_restart
#define s7_irt_silences faulty_irt_silences
#endif
#ifndef IN_modes
#define s7_stop faulty_stop
#endif
#ifndef IN_ob
#define s7_ob_class faulty_ob_class
#endif
#ifndef IN_queue
#define s7_queue_choose faulty_queue_choose
#define s7_queue_has_skip faulty_queue_has_skip
#define s7_queue_put faulty_queue_put
#endif
#ifndef IN_scheduler
#define s7_may_start faulty_may_start
#endif
#ifndef IN_status
#define s7_state faulty_state
#define s7_status faulty_status
#endif
#ifndef IN_time_error
#define s7_time_error faulty_time_error
#endif
#ifndef IN_tod
#define s7_tod_begin_running faulty_tod_begin_running
#define s7_tod_poll faulty_tod_poll
#define s7_tod_restart faulty_tod_restart
#define s7_tod_used_up faulty_tod_used_up
#endif
#ifndef IN_tod_clock
#define s7_tod_clock_changed faulty_tod_clock_changed
#endif
#ifndef IN_tod_points
#define s7_tod_first_point faulty_tod_first_point
#endif
#ifndef IN_tod_requests
#define s7_tod_catch_up faulty_tod_catch_up
#define s7_tod_overlap faulty_tod_overlap
#endif
#ifndef IN_tod_sfc
#define s7_tod_activate faulty_tod_activate
#define s7_tod_cancel faulty_tod_cancel
#define s7_tod_set faulty_tod_set
#endif
