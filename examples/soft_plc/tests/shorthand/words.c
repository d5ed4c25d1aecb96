#include "words.h"

#include <ctype.h>
#include <stdlib.h>
#include <string.h>

bool words_split(char *line, struct words *w)
{
    w->count = 0;
    for (char *p = line;;) {
        while (isspace((unsigned char)*p))
            p++;
        if (*p == '\0' || *p == '#')
            return true;
        if (w->count == WORDS_MAX)
            return false;
        w->word[w->count++] = p;
        while (*p != '\0' && !isspace((unsigned char)*p))
            p++;
        if (*p != '\0')
            *p++ = '\0';
    }
}

bool word_int(const char *s, int64_t low, int64_t high, int64_t *value)
{
    bool negative = *s == '-';
    int64_t n = 0;
    s += negative;
    if (*s == '\0')
        return false;
    for (; *s != '\0'; s++) {
        if (!isdigit((unsigned char)*s) || n > INT64_MAX / 10 - 1)
            return false;
        n = n * 10 + (*s - '0');
    }
    *value = negative ? -n : n;
    return *value >= low && *value <= high;
}

bool word_hex(const char *s, int high, int *value)
{
    int64_t n;
    if (strncmp(s, "W#", 2) == 0 || strncmp(s, "B#", 2) == 0)
        s += 2;
    if (strncmp(s, "16#", 3) != 0) {
        if (!word_int(s, 0, high, &n))
            return false;
        *value = (int)n;
        return true;
    }
    s += 3;
    if (*s == '\0' || strlen(s) > 4 || s[strspn(s, "0123456789abcdefABCDEF")] != '\0')
        return false;
    *value = (int)strtol(s, NULL, 16);
    return *value <= high;
}

static bool unit(const char **s, int64_t *ms)
{
    static const struct {
        const char *name;
        int64_t ms;
    } units[] = {{"ms", 1}, {"min", S7CPU_MINUTE}, {"m", S7CPU_MINUTE}, {"s", 1000},
                 {"h", S7CPU_HOUR}, {"d", S7CPU_DAY}};
    for (unsigned i = 0; i < sizeof units / sizeof units[0]; i++) {
        size_t n = strlen(units[i].name);
        if (strncmp(*s, units[i].name, n) == 0) {
            *s += n;
            *ms = units[i].ms;
            return true;
        }
    }
    return false;
}

bool word_duration(const char *s, int64_t *ms)
{
    const int64_t limit = S7CPU_LAST + 1; /* as long as the calendar */
    if (strncmp(s, "T#", 2) == 0)
        s += 2;
    if (*s == '\0')
        return false;
    *ms = 0;
    while (*s != '\0') {
        int64_t n = 0, of;
        if (!isdigit((unsigned char)*s))
            return false;
        for (; isdigit((unsigned char)*s); s++)
            if ((n = n * 10 + (*s - '0')) > limit)
                return false;
        if (!unit(&s, &of) || n > limit / of)
            return false;
        *ms += n * of;
        if (*ms > limit)
            return false;
    }
    return true;
}

bool word_time(const char *s, int64_t *ms)
{
    bool negative = *s == '-';
    if (word_int(s, INT32_MIN, INT32_MAX, ms))
        return true;
    if (!word_duration(s + negative, ms) || *ms > INT32_MAX)
        return false;
    *ms = negative ? -*ms : *ms;
    return true;
}

static bool digits(const char **s, int width, int *value)
{
    *value = 0;
    for (int i = 0; i < width; i++, (*s)++) {
        if (!isdigit((unsigned char)**s))
            return false;
        *value = *value * 10 + (**s - '0');
    }
    return true;
}

static bool sign(const char **s, const char *any)
{
    if (**s == '\0' || strchr(any, **s) == NULL)
        return false;
    (*s)++;
    return true;
}

bool word_civil(const char *s, struct s7cpu_date *c)
{
    bool step7 = strncmp(s, "DT#", 3) == 0;
    s += step7 ? 3 : 0;
    *c = (struct s7cpu_date){0};
    if (!digits(&s, 4, &c->year) || !sign(&s, "-") || !digits(&s, 2, &c->month) ||
        !sign(&s, "-") || !digits(&s, 2, &c->day) || !sign(&s, step7 ? "-" : "T") ||
        !digits(&s, 2, &c->hour) || !sign(&s, ":") || !digits(&s, 2, &c->minute))
        return false;
    if (sign(&s, ":")) {
        if (!digits(&s, 2, &c->second))
            return false;
        if (sign(&s, ".") && !digits(&s, 3, &c->ms))
            return false;
    }
    return *s == '\0';
}

bool word_dt(const char *s, int64_t *t)
{
    struct s7cpu_date c;
    if (!word_civil(s, &c) || !s7cpu_date_exists(&c))
        return false;
    *t = s7cpu_ms(&c);
    return true;
}
