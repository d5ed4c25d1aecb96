#include "reader.h"

#include <stdlib.h>
#include <string.h>

#include "values.h"

bool reader_fail(struct reader *r, const char *field, const struct json *value,
                 const char *expected)
{
    char *error = r->scenario->error;
    size_t room = sizeof r->scenario->error;
    int n = snprintf(error, room, "%.100s:%d: %s%s%s: expected %.100s", r->file,
                     value != NULL ? value->line : 1, r->path,
                     field != NULL && r->path[0] != '\0' ? "." : "", field != NULL ? field : "",
                     expected);
    if (value != NULL && n > 0 && (size_t)n < room && value->kind == JSON_STRING)
        snprintf(error + n, room - (size_t)n, ", found \"%.30s\"", value->text);
    return false;
}

size_t reader_enter(struct reader *r, const char *name)
{
    size_t length = strlen(r->path);
    snprintf(r->path + length, sizeof r->path - length, "%s%.20s", length > 0 ? "." : "", name);
    return length;
}

size_t reader_enter_element(struct reader *r, int place)
{
    char name[12];
    snprintf(name, sizeof name, "%d", place);
    return reader_enter(r, name);
}

void reader_leave(struct reader *r, size_t length)
{
    r->path[length] = '\0';
}

bool reader_members(struct reader *r, const struct json *object, const char *const *names)
{
    if (object->kind != JSON_OBJECT)
        return reader_fail(r, NULL, object, "an object");
    for (const struct json *m = object->first; m != NULL; m = m->next) {
        int i = 0;
        while (names[i] != NULL && strcmp(names[i], m->name) != 0)
            i++;
        if (names[i] == NULL && strncmp(m->name, "x_", 2) != 0)
            return reader_fail(r, m->name, m, "a field of this object");
    }
    return true;
}

/* A member, NULL where it is missing; `ok` is false where that is an error. */
static const struct json *member(struct reader *r, const struct json *object, const char *name,
                                 bool needed, bool *ok)
{
    const struct json *m = json_member(object, name);
    *ok = m != NULL || !needed;
    if (!*ok)
        reader_fail(r, name, object, "this field");
    return m;
}

bool reader_integer(struct reader *r, const struct json *object, const char *name, bool needed,
                    int64_t low, int64_t high, int64_t *value)
{
    char expected[80];
    bool ok;
    const struct json *m = member(r, object, name, needed, &ok);
    if (m == NULL)
        return ok;
    *value = m->integer;
    if (m->kind == JSON_INTEGER && *value >= low && *value <= high)
        return true;
    snprintf(expected, sizeof expected, "an integer from %lld to %lld", (long long)low,
             (long long)high);
    return reader_fail(r, name, m, expected);
}

bool reader_truth(struct reader *r, const struct json *object, const char *name, bool *value)
{
    const struct json *m = json_member(object, name);
    if (m == NULL)
        return true;
    *value = m->kind == JSON_TRUE;
    return *value || m->kind == JSON_FALSE || reader_fail(r, name, m, "true or false");
}

bool reader_ob(struct reader *r, const struct json *object, int *ob)
{
    int64_t n;
    if (!reader_integer(r, object, "ob", true, 1, INT16_MAX, &n))
        return false;
    *ob = s7cpu_ob(&r->scenario->config.cpu, (int)n);
    return s7cpu_ob_exists(r->scenario->config.cpu.family, *ob) ||
           reader_fail(r, "ob", json_member(object, "ob"), "the number of an OB of this CPU");
}

bool reader_word(struct reader *r, const struct json *object, const char *name, bool needed,
                 int high, int *value)
{
    bool ok;
    const struct json *m = member(r, object, name, needed, &ok);
    if (m == NULL)
        return ok;
    if (m->kind == JSON_INTEGER && m->integer >= (high == 0xFFFF ? INT16_MIN : 0) &&
        m->integer <= high) {
        *value = (int)(m->integer & 0xFFFF);
        return true;
    }
    if (m->kind == JSON_STRING && value_word(m->text, high, value))
        return true;
    return reader_fail(r, name, m, high == 0xFF ? "a byte as B#16#80" : "a word as 16#0201");
}

bool reader_dt(struct reader *r, const struct json *object, const char *name, bool needed,
               int64_t *ms)
{
    bool ok;
    const struct json *m = member(r, object, name, needed, &ok);
    if (m == NULL)
        return ok;
    if (m->kind == JSON_STRING && value_dt(m->text, ms))
        return true;
    return reader_fail(r, name, m, "a date and time from 1990 to 2089");
}

bool reader_choice(struct reader *r, const struct json *object, const char *name, bool needed,
                   const char *const *names, const char *expected, int *choice)
{
    bool ok;
    const struct json *m = member(r, object, name, needed, &ok);
    if (m == NULL)
        return ok;
    for (int i = 0; m->kind == JSON_STRING && names[i] != NULL; i++)
        if (strcmp(m->text, names[i]) == 0) {
            *choice = i;
            return true;
        }
    return reader_fail(r, name, m, expected);
}

void *reader_grow(void *array, uint32_t count, uint32_t *room, size_t size)
{
    if (count < *room)
        return array;
    *room = *room == 0 ? 16 : *room * 2;
    void *larger = realloc(array, *room * size);
    if (larger == NULL) {
        fputs("soft_plc: out of memory\n", stderr);
        exit(1);
    }
    return larger;
}
