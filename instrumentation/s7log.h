/* s7log.h - writes logs of the format s7-interrupt-log/1 (docs/checking/log-format.md).
 *
 * One header, C99 or later, no dependency but the standard headers, no memory of its own but the
 * struct s7log of the caller: one line is put together in its buffer and handed over whole.
 *
 *     struct s7log log;
 *     s7log_open(&log, s7log_to_file, file);
 *     s7log_header(&log, &header);                           line 1, once
 *     s7log_start(&log, now, 10, &info);                     then one call for each event
 *
 * Units
 *     at, clock, start, to, time    CPU clock: ms since 1990-01-01T00:00:00.000, 0 to S7LOG_AT_MAX;
 *                                   s7log_ms() makes it of year, month, ...
 *     up                            ms since the log began on a clock that nobody sets, from 0
 *     dtime, latency_ms             ms
 *     words                         0 to 65535; those of SFC results also as INT from -32768
 *     bytes                         0 to 255
 *     S7LOG_NONE                    the field is absent; for `ret`: null, not logged
 *
 * Every function returns S7LOG_OK or says why it has written nothing. The functions check ranges,
 * not rules: the arguments of a call are the program's own, right or wrong. Events have to be logged
 * in the order in which they happen in the CPU; a struct s7log is not shared by threads without a
 * lock.
 *
 * S7LOG_LINE       size of the buffer, 4096 bytes unless defined before; a header with everything
 *                  in it takes 3000, an event 400 and its note
 * S7LOG_NO_STDIO   leaves s7log_to_file() and <stdio.h> out */
#ifndef S7LOG_H
#define S7LOG_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>
#include <string.h>
#ifndef S7LOG_NO_STDIO
#include <stdio.h>
#endif

#ifndef S7LOG_LINE
#define S7LOG_LINE 4096
#endif

#define S7LOG_NONE (-2147483647 - 1)
#define S7LOG_DAY_MS INT64_C(86400000)
#define S7LOG_AT_MAX (36525 * S7LOG_DAY_MS - 1) /* 2089-12-31T23:59:59.999 */

enum s7log_result {
    S7LOG_OK,
    S7LOG_RANGE, /* an argument that the format cannot express */
    S7LOG_ORDER, /* an event before the header or behind done, or a second header */
    S7LOG_FULL,  /* the line is longer than the buffer */
    S7LOG_IO     /* writing failed, now or before: the log is incomplete */
};

/* Takes a whole line with its "\n"; returns 0, or anything else where it could not write it. */
typedef int s7log_write(void *context, const char *line, size_t length);

struct s7log {
    s7log_write *write;
    void *context;
    const char *note_name, *note_text; /* x_ field of the next line */
    uint64_t events;                   /* written so far */
    bool has_header, is_done, failed;
    enum s7log_result result; /* of the line in the buffer */
    size_t length;
    char line[S7LOG_LINE];
};

/* When an event happened. `up` may be S7LOG_NONE. */
struct s7log_now {
    int64_t at, up;
};

/* A date as a program writes it; it need not exist. */
struct s7log_dt {
    int year, month, day, hour, minute, second, ms;
};

enum s7log_cpu { S7LOG_S7_300, S7LOG_S7_400, S7LOG_CPU_318, S7LOG_S7_1500 };
enum s7log_mode { S7LOG_STOP, S7LOG_STARTUP, S7LOG_RUN };
enum s7log_restart_type { S7LOG_WARM, S7LOG_COLD, S7LOG_HOT };

/* Kinds of event that are logged completely, one bit each. */
enum {
    S7LOG_CALL = 1,
    S7LOG_OB = 2,
    S7LOG_CLOCK = 4,
    S7LOG_MODE = 8,
    S7LOG_INTERRUPT = 16,
    S7LOG_LOAD = 32,
    S7LOG_DIAG = 64,
    S7LOG_STATE = 128 /* no line of it is owed, listed or not */
};

enum s7log_execution {
    S7LOG_NOT_GIVEN, /* for an interrupt that is only deselected */
    S7LOG_NO_EXECUTION,
    S7LOG_ONCE,
    S7LOG_MINUTE,
    S7LOG_HOURLY,
    S7LOG_DAILY,
    S7LOG_WEEKLY,
    S7LOG_MONTHLY,
    S7LOG_YEARLY,
    S7LOG_END_OF_MONTH
};

/* STEP 7 parameters of a time-of-day interrupt. */
struct s7log_tod {
    int ob; /* 10 to 17, or of such an event class */
    enum s7log_execution execution;
    int64_t start; /* or S7LOG_NONE */
    bool active, deselected; /* active: with an execution only */
    bool local;              /* start: by local time, on S7-1500 */
};

/* The event class with which an OB from 123 on was created, on S7-1500. */
enum s7log_ob_class {
    S7LOG_CLASS_TOD,
    S7LOG_CLASS_DINT,
    S7LOG_CLASS_CYCLIC,
    S7LOG_CLASS_HARDWARE,
    S7LOG_CLASS_STARTUP,
    S7LOG_CLASS_CYCLE
};
struct s7log_class {
    int ob;
    enum s7log_ob_class ob_class;
};

/* The parameters of a queue, on S7-1500. */
struct s7log_queue {
    int ob;
    int events, threshold; /* threshold: 0 where the time error is not enabled */
    int overflow;          /* 0, 1, or S7LOG_NONE where it is not known */
};

/* A priority class that differs from the default. */
struct s7log_priority {
    int ob, priority;
};

/* The reading to check against: "AMB-02", 'a'; on S7-1500 also of A15-01 to A15-24. */
struct s7log_reading {
    const char *ambiguity;
    char letter;
};

/* Line 1. Arrays may be NULL where their count is 0. */
struct s7log_header {
    enum s7log_cpu cpu;
    const int *obs; /* loaded when the log begins */
    size_t ob_count;
    int64_t clock;
    enum s7log_mode mode;
    int latency_ms;
    unsigned records;
    bool cycle;
    const struct s7log_priority *priorities;
    size_t priority_count;
    const struct s7log_tod *tods;
    size_t tod_count;
    const struct s7log_reading *readings;
    size_t reading_count;
    const struct s7log_class *classes;
    size_t class_count;
    const struct s7log_queue *queues;
    size_t queue_count;
    int zone; /* minutes by which local time is ahead, on S7-1500 */
};

/* Start information of an OB; begin with S7LOG_INFO_NONE and fill in the known fields. */
struct s7log_info {
    int priority; /* 0 to 29 */
    int strt_info, flt_id;         /* bytes */
    int period, sign;              /* words */
    int dtime;                     /* ms */
    int error_info, ev;            /* words */
    int ev_ob;                     /* 0 to 255 */
    int64_t time;
    int caught_up, second_time;    /* 0 or 1; these and the next two lines on S7-1500 */
    int csg_ob;                    /* 0 to 32767 */
    int csg_priority, event_count; /* byte, word */
};
#define S7LOG_INFO_NONE                                                                            \
    {                                                                                              \
        S7LOG_NONE, S7LOG_NONE, S7LOG_NONE, S7LOG_NONE, S7LOG_NONE, S7LOG_NONE, S7LOG_NONE,        \
            S7LOG_NONE, S7LOG_NONE, S7LOG_NONE, S7LOG_NONE, S7LOG_NONE, S7LOG_NONE, S7LOG_NONE,    \
            S7LOG_NONE                                                                             \
    }

/* The state of an OB by SZL 16#0222, INDEX = OB number. Truth values: 0 or 1. A field that was not
 * read is S7LOG_NONE; begin with S7LOG_OB_STATE_NONE. */
struct s7log_ob_state {
    int active;      /* al1 bit 2 */
    int blocked;     /* al1 bit 1 */
    int loaded;      /* al1 bit 4 */
    int entries_off; /* al1 bit 6 */
    int left;        /* ms, while a delay runs */
};
#define S7LOG_OB_STATE_NONE                                                                        \
    {                                                                                              \
        S7LOG_NONE, S7LOG_NONE, S7LOG_NONE, S7LOG_NONE, S7LOG_NONE                                 \
    }

/* ---- dates ------------------------------------------------------------------------------- */

static inline bool s7log_is_leap(int year)
{
    return year % 4 == 0 && (year % 100 != 0 || year % 400 == 0);
}

static inline int s7log_month_days(int year, int month)
{
    static const int days[] = {31, 28, 31, 30, 31, 30, 31, 31, 30, 31, 30, 31};
    return month == 2 && s7log_is_leap(year) ? 29 : days[month - 1];
}

/* Days from 1990-01-01 to the first of January of a year from 1990 to 2090. */
static inline int s7log_year_day(int year)
{
    return 365 * (year - 1990) + (year - 1989) / 4; /* 2000 is a leap year */
}

/* ms since 1990-01-01; S7LOG_NONE where the date does not exist or is outside 1990 to 2089. */
static inline int64_t s7log_ms(const struct s7log_dt *d)
{
    int64_t days;
    if (d->year < 1990 || d->year > 2089 || d->month < 1 || d->month > 12 || d->day < 1 ||
        d->day > s7log_month_days(d->year, d->month) || d->hour < 0 || d->hour > 23 ||
        d->minute < 0 || d->minute > 59 || d->second < 0 || d->second > 59 || d->ms < 0 ||
        d->ms > 999)
        return S7LOG_NONE;
    days = s7log_year_day(d->year) + d->day - 1;
    for (int month = 1; month < d->month; month++)
        days += s7log_month_days(d->year, month);
    return (((days * 24 + d->hour) * 60 + d->minute) * 60 + d->second) * 1000 + d->ms;
}

/* The other way round, for 0 to S7LOG_AT_MAX. */
static inline struct s7log_dt s7log_date(int64_t at)
{
    struct s7log_dt d;
    int day = (int)(at / S7LOG_DAY_MS), ms = (int)(at % S7LOG_DAY_MS);
    d.year = 1990 + day / 366; /* this year or an earlier one */
    while (s7log_year_day(d.year + 1) <= day)
        d.year++;
    day -= s7log_year_day(d.year);
    for (d.month = 1; day >= s7log_month_days(d.year, d.month); d.month++)
        day -= s7log_month_days(d.year, d.month);
    d.day = day + 1;
    d.hour = ms / 3600000;
    d.minute = ms / 60000 % 60;
    d.second = ms / 1000 % 60;
    d.ms = ms % 1000;
    return d;
}

/* ---- pieces of a line (names with two underscores are internal) ---------------------------- */

static inline void s7log__char(struct s7log *l, char c)
{
    if (l->length < sizeof l->line)
        l->line[l->length++] = c;
    else if (l->result == S7LOG_OK)
        l->result = S7LOG_FULL;
}

static inline void s7log__text(struct s7log *l, const char *s)
{
    while (*s != '\0')
        s7log__char(l, *s++);
}

static inline void s7log__require(struct s7log *l, bool right)
{
    if (!right)
        l->result = S7LOG_RANGE;
}

/* Length of the UTF-8 sequence that s begins with; 0 where it is none. */
static inline int s7log__utf8(const unsigned char *s)
{
    int length = 1;
    if (s[0] >= 0x80)
        length = s[0] < 0xC2 || s[0] > 0xF4 ? 0 : s[0] < 0xE0 ? 2 : s[0] < 0xF0 ? 3 : 4;
    for (int i = 1; i < length; i++)
        if (s[i] < 0x80 || s[i] > 0xBF)
            return 0;
    if ((s[0] == 0xE0 && s[1] < 0xA0) || (s[0] == 0xED && s[1] > 0x9F) ||
        (s[0] == 0xF0 && s[1] < 0x90) || (s[0] == 0xF4 && s[1] > 0x8F))
        return 0; /* too long for its value, a surrogate, above U+10FFFF */
    return length;
}

/* A JSON string; a byte that is no UTF-8 becomes U+FFFD. */
static inline void s7log__string(struct s7log *l, const char *text)
{
    static const char hex[] = "0123456789abcdef";
    const unsigned char *s = (const unsigned char *)text;
    s7log__char(l, '"');
    while (*s != 0) {
        int length = s7log__utf8(s);
        if (length == 0) {
            s7log__text(l, "\\ufffd");
            s++;
        } else if (*s < 0x20) {
            s7log__text(l, "\\u00");
            s7log__char(l, hex[*s >> 4]);
            s7log__char(l, hex[*s & 15]);
            s++;
        } else {
            if (*s == '"' || *s == '\\')
                s7log__char(l, '\\');
            while (length-- > 0)
                s7log__char(l, (char)*s++);
        }
    }
    s7log__char(l, '"');
}

static inline void s7log__digits(struct s7log *l, int n, int width)
{
    char digits[4];
    for (int i = width - 1; i >= 0; i--, n /= 10)
        digits[i] = (char)('0' + n % 10);
    for (int i = 0; i < width; i++)
        s7log__char(l, digits[i]);
}

static inline void s7log__int(struct s7log *l, int64_t n)
{
    char digits[20];
    int i = 0;
    uint64_t rest = n < 0 ? 0 - (uint64_t)n : (uint64_t)n;
    if (n < 0)
        s7log__char(l, '-');
    do
        digits[i++] = (char)('0' + rest % 10);
    while ((rest /= 10) != 0);
    while (i > 0)
        s7log__char(l, digits[--i]);
}

static inline void s7log__name(struct s7log *l, const char *name)
{
    s7log__text(l, ",\"");
    s7log__text(l, name);
    s7log__text(l, "\":");
}

static inline void s7log__number(struct s7log *l, const char *name, int64_t n, int64_t low,
                                 int64_t high)
{
    s7log__require(l, n >= low && n <= high);
    s7log__name(l, name);
    s7log__int(l, n);
}

static inline void s7log__hex(struct s7log *l, const char *name, int value, int digits)
{
    s7log__name(l, name);
    s7log__text(l, "\"16#");
    for (int shift = 4 * (digits - 1); shift >= 0; shift -= 4)
        s7log__char(l, "0123456789ABCDEF"[((unsigned)value >> shift) & 15]);
    s7log__char(l, '"');
}

static inline void s7log__byte(struct s7log *l, const char *name, int value)
{
    s7log__require(l, value >= 0 && value <= 255);
    s7log__hex(l, name, value, 2);
}

static inline void s7log__word(struct s7log *l, const char *name, int value)
{
    s7log__require(l, value >= -32768 && value <= 65535);
    s7log__hex(l, name, value, 4);
}

static inline void s7log__ret(struct s7log *l, int ret)
{
    if (ret == S7LOG_NONE)
        s7log__text(l, ",\"ret\":null");
    else
        s7log__word(l, "ret", ret);
}

static inline void s7log__date(struct s7log *l, const char *name, const struct s7log_dt *d)
{
    s7log__require(l, d->year >= 0 && d->year <= 9999 && d->month >= 0 && d->month <= 99 &&
                          d->day >= 0 && d->day <= 99 && d->hour >= 0 && d->hour <= 99 &&
                          d->minute >= 0 && d->minute <= 99 && d->second >= 0 &&
                          d->second <= 99 && d->ms >= 0 && d->ms <= 999);
    if (l->result == S7LOG_RANGE)
        return;
    s7log__name(l, name);
    s7log__char(l, '"');
    s7log__digits(l, d->year, 4);
    s7log__char(l, '-');
    s7log__digits(l, d->month, 2);
    s7log__char(l, '-');
    s7log__digits(l, d->day, 2);
    s7log__char(l, 'T');
    s7log__digits(l, d->hour, 2);
    s7log__char(l, ':');
    s7log__digits(l, d->minute, 2);
    s7log__char(l, ':');
    s7log__digits(l, d->second, 2);
    s7log__char(l, '.');
    s7log__digits(l, d->ms, 3);
    s7log__char(l, '"');
}

static inline void s7log__clock(struct s7log *l, const char *name, int64_t at)
{
    s7log__require(l, at >= 0 && at <= S7LOG_AT_MAX);
    if (l->result != S7LOG_RANGE) {
        struct s7log_dt d = s7log_date(at);
        s7log__date(l, name, &d);
    }
}

/* An OB that the CPU knows. */
static inline void s7log__ob(struct s7log *l, int ob)
{
    s7log__number(l, "ob", ob, 1, 32767);
}

/* OB_NR of an SFC: any INT. */
static inline void s7log__ob_nr(struct s7log *l, int ob_nr)
{
    s7log__number(l, "ob", ob_nr, -32768, 32767);
}

static inline enum s7log_result s7log__end_line(struct s7log *l)
{
    if (l->note_name != NULL) {
        s7log__require(l, strncmp(l->note_name, "x_", 2) == 0);
        s7log__char(l, ',');
        s7log__string(l, l->note_name);
        s7log__char(l, ':');
        s7log__string(l, l->note_text);
        l->note_name = NULL;
    }
    s7log__text(l, "}\n");
    if (l->failed)
        return S7LOG_IO;
    if (l->result == S7LOG_OK && l->write(l->context, l->line, l->length) != 0) {
        l->failed = true;
        l->result = S7LOG_IO;
    }
    return l->result;
}

static inline void s7log__begin_event(struct s7log *l, struct s7log_now now, const char *event)
{
    l->length = 0;
    l->result = l->has_header && !l->is_done ? S7LOG_OK : S7LOG_ORDER;
    s7log__text(l, "{\"event\":\"");
    s7log__text(l, event);
    s7log__char(l, '"');
    s7log__clock(l, "at", now.at);
    if (now.up != S7LOG_NONE)
        s7log__number(l, "up", now.up, 0, INT64_MAX);
}

static inline enum s7log_result s7log__end_event(struct s7log *l)
{
    enum s7log_result result = s7log__end_line(l);
    if (result == S7LOG_OK)
        l->events++;
    return result;
}

/* The end of an object whose fields begin at `begin`, each with a comma before it: the first one
 * loses it. */
static inline void s7log__end_object(struct s7log *l, size_t begin)
{
    if (l->length > begin) {
        memmove(l->line + begin, l->line + begin + 1, l->length - begin - 1);
        l->length--;
    }
    s7log__char(l, '}');
}

static inline void s7log__truth(struct s7log *l, const char *name, int value)
{
    if (value == S7LOG_NONE)
        return;
    s7log__require(l, value == 0 || value == 1);
    s7log__name(l, name);
    s7log__text(l, value ? "true" : "false");
}

static inline void s7log__info(struct s7log *l, const struct s7log_info *i)
{
    size_t begin;
    s7log__text(l, ",\"info\":{");
    begin = l->length;
    if (i->priority != S7LOG_NONE)
        s7log__number(l, "priority", i->priority, 0, 29);
    if (i->strt_info != S7LOG_NONE)
        s7log__byte(l, "strt_info", i->strt_info);
    if (i->flt_id != S7LOG_NONE)
        s7log__byte(l, "flt_id", i->flt_id);
    if (i->period != S7LOG_NONE)
        s7log__word(l, "period", i->period);
    if (i->sign != S7LOG_NONE)
        s7log__word(l, "sign", i->sign);
    if (i->dtime != S7LOG_NONE)
        s7log__number(l, "dtime", i->dtime, INT32_MIN, INT32_MAX);
    if (i->error_info != S7LOG_NONE)
        s7log__word(l, "error_info", i->error_info);
    if (i->ev != S7LOG_NONE)
        s7log__word(l, "ev", i->ev);
    if (i->ev_ob != S7LOG_NONE)
        s7log__number(l, "ev_ob", i->ev_ob, 0, 255);
    if (i->time != S7LOG_NONE)
        s7log__clock(l, "time", i->time);
    s7log__truth(l, "caught_up", i->caught_up);
    s7log__truth(l, "second_time", i->second_time);
    if (i->csg_ob != S7LOG_NONE)
        s7log__number(l, "csg_ob", i->csg_ob, 0, 32767);
    if (i->csg_priority != S7LOG_NONE)
        s7log__byte(l, "csg_priority", i->csg_priority);
    if (i->event_count != S7LOG_NONE)
        s7log__word(l, "event_count", i->event_count);
    s7log__end_object(l, begin);
}

/* ---- the log --------------------------------------------------------------------------------- */

static inline void s7log_open(struct s7log *l, s7log_write *write, void *context)
{
    l->write = write;
    l->context = context;
    l->note_name = l->note_text = NULL;
    l->events = 0;
    l->has_header = l->is_done = l->failed = false;
    l->result = S7LOG_OK;
    l->length = 0;
}

#ifndef S7LOG_NO_STDIO
/* s7log_write for a FILE * as context. Buffering, fflush() and fclose() are the caller's. */
static inline int s7log_to_file(void *file, const char *line, size_t length)
{
    return fwrite(line, 1, length, (FILE *)file) == length ? 0 : -1;
}
#endif

/* Adds a field of the caller's own to the next line, x_ at the beginning of its name. Both texts
 * are read when that line is written. */
static inline void s7log_note(struct s7log *l, const char *name, const char *text)
{
    l->note_name = name;
    l->note_text = text;
}

/* ---- header -------------------------------------------------------------------------------- */

/* [T15-30, T15-35, T15-60 to T15-66]: on S7-1500. */
static inline bool s7log__may_have_priority(int ob, int priority)
{
    int low = ob >= 61 && ob <= 64 ? 16 : 2;
    int high = ob <= 38 || (ob >= 55 && ob <= 57) ? 24 : 26;
    bool settable = ob >= 123 || (ob >= 10 && ob <= 17) || (ob >= 20 && ob <= 23) || (ob >= 30 && ob <= 38) ||
                    (ob >= 40 && ob <= 47) || (ob >= 55 && ob <= 57) || (ob >= 61 && ob <= 64) ||
                    ob == 82 || ob == 83 || ob == 86 || ob == 121 || ob == 122;
    return settable && priority >= low && priority <= high;
}

/* [OBS-05]: the classes that may be assigned to an OB, on S7-400 and CPU 318. */
static inline bool s7log__may_have_class(int ob, int priority)
{
    int low = ob == 85 ? 24 : 2;
    int high = ob <= 47 ? 23 : ob <= 72 ? 28 : 26;
    bool settable = (ob >= 10 && ob <= 17) || (ob >= 20 && ob <= 23) || (ob >= 30 && ob <= 38) ||
                    (ob >= 40 && ob <= 47) || (ob >= 70 && ob <= 72) || (ob >= 81 && ob <= 87);
    return settable && priority >= low && priority <= high;
}

static inline void s7log__records(struct s7log *l, unsigned records)
{
    static const char *const names[] = {"call",      "ob",   "clock", "mode",
                                        "interrupt", "load", "diag",  "state"};
    const char *separator = "";
    s7log__require(l, records < 1u << 8);
    s7log__text(l, ",\"records\":[");
    for (int i = 0; i < 8; i++)
        if (records >> i & 1) {
            s7log__text(l, separator);
            s7log__string(l, names[i]);
            separator = ",";
        }
    s7log__char(l, ']');
}

/* The name of the i-th member of an object whose members are OBs; the first one begins it. */
static inline void s7log__of_ob(struct s7log *l, const char *begin, size_t i, int ob)
{
    s7log__text(l, i > 0 ? "," : begin);
    s7log__char(l, '"');
    s7log__int(l, ob);
    s7log__text(l, "\":");
}

static inline void s7log__priorities(struct s7log *l, const struct s7log_header *h)
{
    s7log__require(l, h->priority_count == 0 || h->cpu != S7LOG_S7_300);
    for (size_t i = 0; i < h->priority_count; i++) {
        const struct s7log_priority *p = &h->priorities[i];
        s7log__require(l, h->cpu == S7LOG_S7_1500 ? s7log__may_have_priority(p->ob, p->priority)
                                                  : s7log__may_have_class(p->ob, p->priority));
        s7log__of_ob(l, ",\"priority\":{", i, p->ob);
        s7log__int(l, p->priority);
    }
    s7log__text(l, h->priority_count > 0 ? "}" : "");
}

static inline void s7log__tod(struct s7log *l, const struct s7log_tod *t)
{
    static const char *const names[] = {"none",   "once",    "minute", "hourly",      "daily",
                                        "weekly", "monthly", "yearly", "end_of_month"};
    size_t begin;
    s7log__require(l, (t->ob >= 10 && t->ob <= 17) || t->ob >= 123);
    s7log__char(l, '{');
    begin = l->length;
    if (t->execution >= S7LOG_NO_EXECUTION && t->execution <= S7LOG_END_OF_MONTH) {
        s7log__name(l, "execution");
        s7log__string(l, names[t->execution - S7LOG_NO_EXECUTION]);
        s7log__text(l, t->active ? ",\"active\":true" : ",\"active\":false");
    }
    if (t->start != S7LOG_NONE)
        s7log__clock(l, "start", t->start);
    if (t->local)
        s7log__text(l, ",\"local\":true");
    if (t->deselected)
        s7log__text(l, ",\"deselected\":true");
    s7log__end_object(l, begin);
}

static inline void s7log__tods(struct s7log *l, const struct s7log_header *h)
{
    for (size_t i = 0; i < h->tod_count; i++) {
        s7log__of_ob(l, ",\"step7\":{\"tod\":{", i, h->tods[i].ob);
        s7log__tod(l, &h->tods[i]);
    }
    s7log__text(l, h->tod_count > 0 ? "}}" : "");
}

static inline void s7log__classes(struct s7log *l, const struct s7log_header *h)
{
    static const char *const names[] = {"tod", "dint", "cyclic", "hardware", "startup", "cycle"};
    for (size_t i = 0; i < h->class_count; i++) {
        const struct s7log_class *c = &h->classes[i];
        s7log__require(l, c->ob >= 123 && c->ob <= 32767 && c->ob_class <= S7LOG_CLASS_CYCLE);
        if (l->result == S7LOG_RANGE)
            return;
        s7log__of_ob(l, ",\"classes\":{", i, c->ob);
        s7log__string(l, names[c->ob_class]);
    }
    s7log__text(l, h->class_count > 0 ? "}" : "");
}

static inline void s7log__queues(struct s7log *l, const struct s7log_header *h)
{
    for (size_t i = 0; i < h->queue_count; i++) {
        const struct s7log_queue *q = &h->queues[i];
        s7log__of_ob(l, ",\"queue\":{", i, q->ob);
        s7log__text(l, "{\"events\":");
        s7log__int(l, q->events);
        s7log__require(l, q->events >= 1 && q->events <= 12);
        if (q->threshold != 0)
            s7log__number(l, "threshold", q->threshold, 1, q->events);
        s7log__truth(l, "overflow", q->overflow);
        s7log__char(l, '}');
    }
    s7log__text(l, h->queue_count > 0 ? "}" : "");
}

static inline void s7log__readings(struct s7log *l, const struct s7log_header *h)
{
    if (h->reading_count == 0)
        return;
    s7log__text(l, ",\"readings\":{");
    for (size_t i = 0; i < h->reading_count; i++) {
        const struct s7log_reading *r = &h->readings[i];
        const char letter[] = {r->letter, '\0'};
        const bool newer = h->cpu == S7LOG_S7_1500 && strncmp(r->ambiguity, "A15-", 4) == 0;
        s7log__require(l, newer || strncmp(r->ambiguity, "AMB-", 4) == 0);
        s7log__require(l, r->letter >= 'a' && r->letter <= (newer ? 'f' : 'd'));
        if (i > 0)
            s7log__char(l, ',');
        s7log__string(l, r->ambiguity);
        s7log__char(l, ':');
        s7log__string(l, letter);
    }
    s7log__char(l, '}');
}

static inline enum s7log_result s7log_header(struct s7log *l, const struct s7log_header *h)
{
    static const char *const cpus[] = {"S7-300", "S7-400", "CPU 318", "S7-1500"};
    static const char *const modes[] = {"STOP", "STARTUP", "RUN"};
    enum s7log_result result;
    if (h->cpu > S7LOG_S7_1500 || h->mode > S7LOG_RUN)
        return S7LOG_RANGE;
    l->length = 0;
    l->result = l->has_header ? S7LOG_ORDER : S7LOG_OK;
    s7log__text(l, "{\"format\":\"s7-interrupt-log/1\"");
    s7log__name(l, "cpu");
    s7log__string(l, cpus[h->cpu]);
    s7log__text(l, ",\"obs\":[");
    for (size_t i = 0; i < h->ob_count; i++) {
        s7log__require(l, h->obs[i] >= 1 && h->obs[i] <= (h->class_count > 0 ? 32767 : 122));
        if (i > 0)
            s7log__char(l, ',');
        s7log__int(l, h->obs[i]);
    }
    s7log__char(l, ']');
    s7log__clock(l, "clock", h->clock);
    s7log__name(l, "mode");
    s7log__string(l, modes[h->mode]);
    s7log__number(l, "latency_ms", h->latency_ms, 0, INT32_MAX);
    s7log__records(l, h->records);
    if (h->cycle)
        s7log__text(l, ",\"cycle\":true");
    s7log__classes(l, h);
    s7log__queues(l, h);
    if (h->zone != 0)
        s7log__number(l, "zone", h->zone, -720, 840);
    s7log__priorities(l, h);
    s7log__tods(l, h);
    s7log__readings(l, h);
    result = s7log__end_line(l);
    l->has_header = l->has_header || result == S7LOG_OK;
    return result;
}

/* ---- calls --------------------------------------------------------------------------------- */

static inline enum s7log_result s7log__call(struct s7log *l, struct s7log_now now, const char *sfc,
                                            int ob_nr, int ret)
{
    s7log__begin_event(l, now, sfc);
    s7log__ob_nr(l, ob_nr);
    s7log__ret(l, ret);
    return s7log__end_event(l);
}

static inline enum s7log_result s7log__query(struct s7log *l, struct s7log_now now,
                                             const char *sfc, int ob_nr, int ret, int status)
{
    s7log__begin_event(l, now, sfc);
    s7log__ob_nr(l, ob_nr);
    s7log__ret(l, ret);
    if (status != S7LOG_NONE)
        s7log__word(l, "status", status);
    return s7log__end_event(l);
}

static inline enum s7log_result s7log__irt(struct s7log *l, struct s7log_now now, const char *sfc,
                                           int mode, int ob_nr, int ret)
{
    s7log__begin_event(l, now, sfc);
    s7log__byte(l, "mode", mode);
    s7log__ob_nr(l, ob_nr);
    s7log__ret(l, ret);
    return s7log__end_event(l);
}

static inline enum s7log_result s7log__airt(struct s7log *l, struct s7log_now now, const char *sfc,
                                            int ret)
{
    s7log__begin_event(l, now, sfc);
    s7log__ret(l, ret);
    return s7log__end_event(l);
}

/* SFC 28 */
static inline enum s7log_result s7log_set_tint(struct s7log *l, struct s7log_now now, int ob_nr,
                                               const struct s7log_dt *sdt, int period, int ret)
{
    s7log__begin_event(l, now, "SET_TINT");
    s7log__ob_nr(l, ob_nr);
    s7log__date(l, "sdt", sdt);
    s7log__word(l, "period", period);
    s7log__ret(l, ret);
    return s7log__end_event(l);
}

/* S7-1500 */
static inline enum s7log_result s7log_set_tintl(struct s7log *l, struct s7log_now now, int ob_nr,
                                                const struct s7log_dt *sdt, bool local, int period,
                                                bool activate, int ret)
{
    s7log__begin_event(l, now, "SET_TINTL");
    s7log__ob_nr(l, ob_nr);
    s7log__date(l, "sdt", sdt);
    s7log__text(l, local ? ",\"local\":true" : ",\"local\":false");
    s7log__word(l, "period", period);
    s7log__text(l, activate ? ",\"activate\":true" : ",\"activate\":false");
    s7log__ret(l, ret);
    return s7log__end_event(l);
}

/* SFC 29 */
static inline enum s7log_result s7log_can_tint(struct s7log *l, struct s7log_now now, int ob_nr,
                                               int ret)
{
    return s7log__call(l, now, "CAN_TINT", ob_nr, ret);
}

/* SFC 30 */
static inline enum s7log_result s7log_act_tint(struct s7log *l, struct s7log_now now, int ob_nr,
                                               int ret)
{
    return s7log__call(l, now, "ACT_TINT", ob_nr, ret);
}

/* SFC 31; status: S7LOG_NONE where ret is not 0 */
static inline enum s7log_result s7log_qry_tint(struct s7log *l, struct s7log_now now, int ob_nr,
                                               int ret, int status)
{
    return s7log__query(l, now, "QRY_TINT", ob_nr, ret, status);
}

/* SFC 32 */
static inline enum s7log_result s7log_srt_dint(struct s7log *l, struct s7log_now now, int ob_nr,
                                               int64_t dtime, int sign, int ret)
{
    s7log__begin_event(l, now, "SRT_DINT");
    s7log__ob_nr(l, ob_nr);
    s7log__number(l, "dtime", dtime, INT32_MIN, INT32_MAX);
    s7log__word(l, "sign", sign);
    s7log__ret(l, ret);
    return s7log__end_event(l);
}

/* SFC 33 */
static inline enum s7log_result s7log_can_dint(struct s7log *l, struct s7log_now now, int ob_nr,
                                               int ret)
{
    return s7log__call(l, now, "CAN_DINT", ob_nr, ret);
}

/* SFC 34; status: S7LOG_NONE where ret is not 0 */
static inline enum s7log_result s7log_qry_dint(struct s7log *l, struct s7log_now now, int ob_nr,
                                               int ret, int status)
{
    return s7log__query(l, now, "QRY_DINT", ob_nr, ret, status);
}

/* SFC 39 */
static inline enum s7log_result s7log_dis_irt(struct s7log *l, struct s7log_now now, int mode,
                                              int ob_nr, int ret)
{
    return s7log__irt(l, now, "DIS_IRT", mode, ob_nr, ret);
}

/* SFC 40 */
static inline enum s7log_result s7log_en_irt(struct s7log *l, struct s7log_now now, int mode,
                                             int ob_nr, int ret)
{
    return s7log__irt(l, now, "EN_IRT", mode, ob_nr, ret);
}

/* SFC 41 */
static inline enum s7log_result s7log_dis_airt(struct s7log *l, struct s7log_now now, int ret)
{
    return s7log__airt(l, now, "DIS_AIRT", ret);
}

/* SFC 42 */
static inline enum s7log_result s7log_en_airt(struct s7log *l, struct s7log_now now, int ret)
{
    return s7log__airt(l, now, "EN_AIRT", ret);
}

/* ---- OBs, clock, modes ----------------------------------------------------------------------- */

static inline enum s7log_result s7log__with_ob(struct s7log *l, struct s7log_now now,
                                               const char *event, int ob)
{
    s7log__begin_event(l, now, event);
    s7log__ob(l, ob);
    return s7log__end_event(l);
}

static inline enum s7log_result s7log__plain(struct s7log *l, struct s7log_now now,
                                             const char *event)
{
    s7log__begin_event(l, now, event);
    return s7log__end_event(l);
}

/* info: NULL where the start information is not logged */
static inline enum s7log_result s7log_start(struct s7log *l, struct s7log_now now, int ob,
                                            const struct s7log_info *info)
{
    s7log__begin_event(l, now, "start");
    s7log__ob(l, ob);
    if (info != NULL)
        s7log__info(l, info);
    return s7log__end_event(l);
}

static inline enum s7log_result s7log_end(struct s7log *l, struct s7log_now now, int ob)
{
    return s7log__with_ob(l, now, "end", ob);
}

/* now.at: the reading before the change */
static inline enum s7log_result s7log_clock(struct s7log *l, struct s7log_now now, int64_t to)
{
    s7log__begin_event(l, now, "clock");
    s7log__clock(l, "to", to);
    return s7log__end_event(l);
}

/* On S7-1500. zone: minutes by which local time is ahead from now on; daylight: because daylight saving
 * begins or ends, else because another zone was set */
static inline enum s7log_result s7log_zone(struct s7log *l, struct s7log_now now, int zone, bool daylight)
{
    s7log__begin_event(l, now, "zone");
    s7log__number(l, "zone", zone, -720, 840);
    s7log__text(l, daylight ? ",\"reason\":\"daylight\"" : ",\"reason\":\"zone\"");
    return s7log__end_event(l);
}

static inline enum s7log_result s7log_restart(struct s7log *l, struct s7log_now now,
                                              enum s7log_restart_type type)
{
    s7log__begin_event(l, now, "restart");
    s7log__text(l, type == S7LOG_HOT    ? ",\"type\":\"hot\""
                   : type == S7LOG_COLD ? ",\"type\":\"cold\""
                                        : ",\"type\":\"warm\"");
    return s7log__end_event(l);
}

static inline enum s7log_result s7log_run(struct s7log *l, struct s7log_now now)
{
    return s7log__plain(l, now, "run");
}

/* cause: an event id, or S7LOG_NONE */
static inline enum s7log_result s7log_stop(struct s7log *l, struct s7log_now now, int cause)
{
    s7log__begin_event(l, now, "stop");
    if (cause != S7LOG_NONE)
        s7log__word(l, "cause", cause);
    return s7log__end_event(l);
}

static inline enum s7log_result s7log_hold(struct s7log *l, struct s7log_now now)
{
    return s7log__plain(l, now, "hold");
}

static inline enum s7log_result s7log_release(struct s7log *l, struct s7log_now now)
{
    return s7log__plain(l, now, "release");
}

/* The end of a log that is whole: nothing is missing up to now, and nothing may follow. */
static inline enum s7log_result s7log_done(struct s7log *l, struct s7log_now now)
{
    enum s7log_result result = s7log__plain(l, now, "done");
    l->is_done = l->is_done || result == S7LOG_OK;
    return result;
}

/* ---- start events, blocks, diagnostic buffer, state ------------------------------------------ */

/* flt_id: for OB 80 and 85, else S7LOG_NONE */
static inline enum s7log_result s7log_interrupt(struct s7log *l, struct s7log_now now, int ob,
                                                int flt_id)
{
    s7log__begin_event(l, now, "interrupt");
    s7log__require(l, (ob >= 30 && ob <= 38) || (ob >= 40 && ob <= 47) || (ob >= 55 && ob <= 57) ||
                          ob == 60 || ob == 70 || ob == 72 || (ob >= 80 && ob <= 87) ||
                          ob >= 121);
    s7log__require(l, (ob == 80 || ob == 85) == (flt_id != S7LOG_NONE));
    s7log__ob(l, ob);
    if (flt_id != S7LOG_NONE)
        s7log__byte(l, "flt_id", flt_id);
    return s7log__end_event(l);
}

static inline enum s7log_result s7log_load(struct s7log *l, struct s7log_now now, int ob)
{
    return s7log__with_ob(l, now, "load", ob);
}

static inline enum s7log_result s7log_delete(struct s7log *l, struct s7log_now now, int ob)
{
    return s7log__with_ob(l, now, "delete", ob);
}

/* ob, priority: S7LOG_NONE where the entry names none; info may be NULL */
static inline enum s7log_result s7log_diag(struct s7log *l, struct s7log_now now, int id, int ob,
                                           int priority, const struct s7log_info *info)
{
    s7log__begin_event(l, now, "diag");
    s7log__word(l, "id", id);
    if (ob != S7LOG_NONE)
        s7log__number(l, "ob", ob, 0, 255);
    if (priority != S7LOG_NONE)
        s7log__number(l, "priority", priority, 0, 255);
    if (info != NULL)
        s7log__info(l, info);
    return s7log__end_event(l);
}

static inline enum s7log_result s7log_state(struct s7log *l, struct s7log_now now, int ob,
                                            const struct s7log_ob_state *state)
{
    s7log__begin_event(l, now, "state");
    s7log__ob(l, ob);
    s7log__truth(l, "active", state->active);
    s7log__truth(l, "blocked", state->blocked);
    s7log__truth(l, "loaded", state->loaded);
    s7log__truth(l, "entries_off", state->entries_off);
    if (state->left != S7LOG_NONE)
        s7log__number(l, "left", state->left, 0, INT32_MAX);
    return s7log__end_event(l);
}

#endif
