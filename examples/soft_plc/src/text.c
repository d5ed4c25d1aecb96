#include "text.h"

char *text_str(char *p, const char *s)
{
    while (*s != '\0')
        *p++ = *s++;
    return p;
}

char *text_digits(char *p, unsigned n, int width)
{
    for (int i = width - 1; i >= 0; i--, n /= 10)
        p[i] = (char)('0' + n % 10);
    return p + width;
}

char *text_int(char *p, int64_t n)
{
    char digits[24];
    int i = 0;
    uint64_t rest = n < 0 ? 0 - (uint64_t)n : (uint64_t)n;
    if (n < 0)
        *p++ = '-';
    do
        digits[i++] = (char)('0' + rest % 10);
    while ((rest /= 10) != 0);
    while (i > 0)
        *p++ = digits[--i];
    return p;
}

char *text_word(char *p, int value, int digits)
{
    p = text_str(p, "\"16#");
    for (int shift = 4 * (digits - 1); shift >= 0; shift -= 4)
        *p++ = "0123456789ABCDEF"[((unsigned)value >> shift) & 15];
    *p++ = '"';
    return p;
}

char *text_civil(char *p, const struct civil *c)
{
    *p++ = '"';
    p = text_digits(p, (unsigned)c->year, 4);
    *p++ = '-';
    p = text_digits(p, (unsigned)c->month, 2);
    *p++ = '-';
    p = text_digits(p, (unsigned)c->day, 2);
    *p++ = 'T';
    p = text_digits(p, (unsigned)c->hour, 2);
    *p++ = ':';
    p = text_digits(p, (unsigned)c->minute, 2);
    *p++ = ':';
    p = text_digits(p, (unsigned)c->second, 2);
    *p++ = '.';
    p = text_digits(p, (unsigned)c->ms, 3);
    *p++ = '"';
    return p;
}

char *text_dt(char *p, dt_ms t)
{
    struct civil c;
    dt_to_civil(t, &c);
    return text_civil(p, &c);
}
