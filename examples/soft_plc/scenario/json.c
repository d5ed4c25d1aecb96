#include "json.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { DEPTH_MAX = 32 };

struct reader {
    const char *at, *end;
    int line;
    int depth;
    const char *expected; /* set by the first error */
};

static struct json *read_value(struct reader *r);

static void *allocate(size_t size)
{
    void *p = calloc(1, size);
    if (p == NULL) {
        fputs("soft_plc: out of memory\n", stderr);
        exit(1);
    }
    return p;
}

static bool fail(struct reader *r, const char *expected)
{
    if (r->expected == NULL)
        r->expected = expected;
    return false;
}

static void skip_space(struct reader *r)
{
    for (; r->at < r->end && strchr(" \t\r\n", *r->at) != NULL && *r->at != '\0'; r->at++)
        r->line += *r->at == '\n';
}

static bool take(struct reader *r, char c)
{
    skip_space(r);
    if (r->at == r->end || *r->at != c)
        return false;
    r->at++;
    return true;
}

static bool take_word(struct reader *r, const char *word)
{
    size_t n = strlen(word);
    if ((size_t)(r->end - r->at) < n || memcmp(r->at, word, n) != 0)
        return false;
    r->at += n;
    return true;
}

/* Four hexadecimal digits. */
static bool take_unit(struct reader *r, unsigned *unit)
{
    *unit = 0;
    for (int i = 0; i < 4; i++, r->at++) {
        const char *digits = "0123456789abcdefABCDEF";
        const char *hit = r->at < r->end && *r->at != '\0' ? strchr(digits, *r->at) : NULL;
        if (hit == NULL)
            return fail(r, "four hexadecimal digits behind \\u");
        unsigned value = (unsigned)(hit - digits);
        *unit = *unit * 16 + (value > 15 ? value - 6 : value);
    }
    return true;
}

static char *put_utf8(char *to, unsigned code)
{
    if (code < 0x80) {
        *to++ = (char)code;
    } else if (code < 0x800) {
        *to++ = (char)(0xC0 | code >> 6);
        *to++ = (char)(0x80 | (code & 0x3F));
    } else if (code < 0x10000) {
        *to++ = (char)(0xE0 | code >> 12);
        *to++ = (char)(0x80 | (code >> 6 & 0x3F));
        *to++ = (char)(0x80 | (code & 0x3F));
    } else {
        *to++ = (char)(0xF0 | code >> 18);
        *to++ = (char)(0x80 | (code >> 12 & 0x3F));
        *to++ = (char)(0x80 | (code >> 6 & 0x3F));
        *to++ = (char)(0x80 | (code & 0x3F));
    }
    return to;
}

static bool take_code(struct reader *r, unsigned *code)
{
    unsigned low;
    if (!take_unit(r, code))
        return false;
    if (*code == 0 || (*code >= 0xDC00 && *code <= 0xDFFF))
        return fail(r, "a character behind \\u");
    if (*code < 0xD800 || *code > 0xDBFF)
        return true;
    if (!take_word(r, "\\u") || !take_unit(r, &low) || low < 0xDC00 || low > 0xDFFF)
        return fail(r, "a character behind \\u");
    *code = 0x10000 + ((*code - 0xD800) << 10) + (low - 0xDC00);
    return true;
}

/* One character of a string behind a backslash. */
static bool take_escape(struct reader *r, char **to)
{
    static const char names[] = "\"\\/bfnrt", values[] = "\"\\/\b\f\n\r\t";
    const char *hit = r->at < r->end && *r->at != '\0' ? strchr(names, *r->at) : NULL;
    unsigned code;
    if (hit != NULL) {
        r->at++;
        *(*to)++ = values[hit - names];
        return true;
    }
    if (!take_word(r, "u"))
        return fail(r, "an escape of JSON behind \\");
    if (!take_code(r, &code))
        return false;
    *to = put_utf8(*to, code);
    return true;
}

/* The text behind an opening quote; no character is longer there than in the source. */
static char *take_text(struct reader *r)
{
    const char *close = r->at;
    while (close < r->end && *close != '"')
        close += *close == '\\' && close + 1 < r->end ? 2 : 1;
    char *text = allocate((size_t)(close - r->at) + 1), *to = text;
    while (r->at < r->end && *r->at != '"' && r->expected == NULL) {
        if (*r->at == '\\') {
            r->at++;
            take_escape(r, &to);
        } else if ((unsigned char)*r->at < 0x20) {
            fail(r, "no control character in a string");
        } else {
            *to++ = *r->at++;
        }
    }
    if (r->expected == NULL && r->at == r->end)
        fail(r, "\" at the end of the string");
    r->at += r->expected == NULL;
    return text;
}

static size_t take_digits(struct reader *r)
{
    const char *begin = r->at;
    while (r->at < r->end && *r->at >= '0' && *r->at <= '9')
        r->at++;
    return (size_t)(r->at - begin);
}

static void take_number(struct reader *r, struct json *value)
{
    bool negative = take_word(r, "-");
    const char *first = r->at;
    size_t digits = take_digits(r);
    bool whole = true;
    if (digits == 0 || (digits > 1 && *first == '0')) {
        fail(r, "a value");
        return;
    }
    if (take_word(r, ".")) {
        whole = false;
        if (take_digits(r) == 0)
            fail(r, "digits behind the point");
    }
    if (take_word(r, "e") || take_word(r, "E")) {
        whole = false;
        if (!take_word(r, "+"))
            take_word(r, "-");
        if (take_digits(r) == 0)
            fail(r, "digits in the exponent");
    }
    if (!whole || digits > 18) {
        value->kind = JSON_OTHER_NUMBER;
        return;
    }
    value->kind = JSON_INTEGER;
    for (const char *p = first; p < r->at; p++)
        value->integer = value->integer * 10 + (*p - '0');
    value->integer = negative ? -value->integer : value->integer;
}

static void take_name(struct reader *r, const struct json *object, char **name)
{
    if (!take(r, '"')) {
        fail(r, "the name of a member");
        return;
    }
    *name = take_text(r);
    if (json_member(object, *name) != NULL)
        fail(r, "each name once in an object");
    if (!take(r, ':'))
        fail(r, ":");
}

/* Elements up to `close`; those of an object have names. */
static void take_elements(struct reader *r, struct json *value, char close)
{
    struct json **last = &value->first;
    if (take(r, close))
        return;
    do {
        char *name = NULL;
        if (close == '}')
            take_name(r, value, &name);
        struct json *element = r->expected == NULL ? read_value(r) : NULL;
        if (element == NULL) {
            free(name);
            return;
        }
        element->name = name;
        *last = element;
        last = &element->next;
        if (r->expected != NULL)
            return;
    } while (take(r, ','));
    if (!take(r, close))
        fail(r, close == '}' ? ", or }" : ", or ]");
}

static void take_value(struct reader *r, struct json *value)
{
    if (take(r, '"')) {
        value->kind = JSON_STRING;
        value->text = take_text(r);
    } else if (take(r, '{')) {
        value->kind = JSON_OBJECT;
        take_elements(r, value, '}');
    } else if (take(r, '[')) {
        value->kind = JSON_LIST;
        take_elements(r, value, ']');
    } else if (take_word(r, "true")) {
        value->kind = JSON_TRUE;
    } else if (take_word(r, "false")) {
        value->kind = JSON_FALSE;
    } else if (!take_word(r, "null")) {
        take_number(r, value);
    }
}

static struct json *read_value(struct reader *r)
{
    skip_space(r);
    if (r->depth == DEPTH_MAX) {
        fail(r, "at most 32 levels of nesting");
        return NULL;
    }
    struct json *value = allocate(sizeof *value);
    value->line = r->line;
    r->depth++;
    take_value(r, value);
    r->depth--;
    return value;
}

struct json *json_read(const char *text, size_t length, int *line, const char **expected)
{
    struct reader r = {.at = text, .end = text + length, .line = *line};
    struct json *value = read_value(&r);
    skip_space(&r);
    if (r.expected == NULL && r.at != r.end)
        fail(&r, "the end of the text");
    if (r.expected == NULL)
        return value;
    json_free(value);
    *line = r.line;
    *expected = r.expected;
    return NULL;
}

void json_free(struct json *value)
{
    while (value != NULL) {
        struct json *next = value->next;
        json_free(value->first);
        free(value->text);
        free(value->name);
        free(value);
        value = next;
    }
}

const struct json *json_member(const struct json *object, const char *name)
{
    for (const struct json *m = object->first; m != NULL; m = m->next)
        if (strcmp(m->name, name) == 0)
            return m;
    return NULL;
}
