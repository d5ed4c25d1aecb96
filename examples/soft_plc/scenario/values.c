#include "values.h"

#include <ctype.h>
#include <stdlib.h>
#include <string.h>

/* Skips `word` in either case. */
static bool skip(const char **s, const char *word)
{
    size_t n = strlen(word);
    for (size_t i = 0; i < n; i++)
        if (toupper((unsigned char)(*s)[i]) != word[i])
            return false;
    *s += n;
    return true;
}

bool value_word(const char *s, int high, int *value)
{
    bool is_byte = skip(&s, "B#");
    size_t most = is_byte ? 2 : 4;
    if (!is_byte)
        skip(&s, "W#");
    if (!skip(&s, "16#"))
        return false;
    size_t n = strspn(s, "0123456789abcdefABCDEF");
    if (n == 0 || n > most || s[n] != '\0')
        return false;
    *value = (int)strtol(s, NULL, 16);
    return *value <= high;
}

/* Up to `most` digits; how many there are, 0 for none. */
static int digits(const char **s, int most, int64_t *value)
{
    int n = 0;
    *value = 0;
    for (; n < most && isdigit((unsigned char)**s); n++, (*s)++)
        *value = *value * 10 + (**s - '0');
    return n;
}

bool value_integer(const char *s, int64_t low, int64_t high, int64_t *value)
{
    bool negative = skip(&s, "-");
    if (digits(&s, 18, value) == 0 || *s != '\0')
        return false;
    *value = negative ? -*value : *value;
    return *value >= low && *value <= high;
}

bool value_time(const char *s, int64_t *ms)
{
    static const struct {
        const char *name;
        int64_t ms;
    } units[] = {{"D", S7CPU_DAY}, {"H", S7CPU_HOUR}, {"M", S7CPU_MINUTE}, {"S", 1000}, {"MS", 1}};
    int unit = 0;
    if (!skip(&s, "TIME#") && !skip(&s, "T#"))
        return false;
    bool negative = skip(&s, "-");
    *ms = 0;
    do {
        int64_t n;
        if (digits(&s, 10, &n) == 0)
            return false;
        /* "MS" is no minute, and units come from the longest to the shortest. */
        while (unit < 5 && (!skip(&s, units[unit].name) ||
                            (unit == 2 && toupper((unsigned char)*s) == 'S' && s--)))
            unit++;
        if (unit == 5)
            return false;
        *ms += n * units[unit++].ms;
    } while (*s != '\0' && (skip(&s, "_") || true));
    *ms = negative ? -*ms : *ms;
    return *ms >= INT32_MIN && *ms <= INT32_MAX;
}

static bool part(const char **s, const char *before, int least, int most, int *value)
{
    int64_t n;
    if (!skip(s, before) || digits(s, most, &n) < least)
        return false;
    *value = (int)n;
    return true;
}

bool value_civil(const char *s, struct s7cpu_date *date)
{
    struct s7cpu_date d = {0};
    bool step7 = skip(&s, "DATE_AND_TIME#") || skip(&s, "DT#");
    int least = step7 ? 1 : 2; /* digits */
    if (!part(&s, "", 4, 4, &d.year) || !part(&s, "-", least, 2, &d.month) ||
        !part(&s, "-", least, 2, &d.day) || !part(&s, step7 ? "-" : "T", least, 2, &d.hour) ||
        !part(&s, ":", least, 2, &d.minute))
        return false;
    if (*s == ':' && !part(&s, ":", least, 2, &d.second))
        return false;
    if (*s == '.') {
        int64_t n;
        s++;
        int count = digits(&s, 3, &n);
        d.ms = (int)(count == 1 ? n * 100 : count == 2 ? n * 10 : n);
        if (count == 0)
            return false;
    }
    *date = d;
    return *s == '\0';
}

bool value_dt(const char *s, int64_t *ms)
{
    struct s7cpu_date date;
    if (!value_civil(s, &date) || !s7cpu_date_exists(&date))
        return false;
    *ms = s7cpu_ms(&date);
    return true;
}
