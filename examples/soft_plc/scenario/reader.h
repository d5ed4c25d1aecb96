/* Inside the reader of programs: fields of JSON objects, and errors that name them. */
#ifndef READER_H
#define READER_H

#include "json.h"
#include "scenario.h"

enum { PATH_MAX_CHARS = 120 };

struct reader {
    struct scenario *scenario;
    const char *file;
    char path[PATH_MAX_CHARS]; /* of the object that is read: bodies.1.steps.2 */
};

/* Records the error and returns false. `field` and `value` may be NULL. */
bool reader_fail(struct reader *r, const char *field, const struct json *value,
                 const char *expected);
/* Goes into a member or an element and back: `length` is of the path before. */
size_t reader_enter(struct reader *r, const char *name);
size_t reader_enter_element(struct reader *r, int place);
void reader_leave(struct reader *r, size_t length);

/* An object with no other members than `names`, which end with NULL, and those with x_. */
bool reader_members(struct reader *r, const struct json *object, const char *const *names);

/* Members of `object`; false with an error where one is wrong, or missing and needed. Of one
 * that may be missing, `value` stays as it is. */
bool reader_integer(struct reader *r, const struct json *object, const char *name, bool needed,
                    int64_t low, int64_t high, int64_t *value);
bool reader_truth(struct reader *r, const struct json *object, const char *name, bool *value);
bool reader_ob(struct reader *r, const struct json *object, int *ob);
bool reader_word(struct reader *r, const struct json *object, const char *name, bool needed,
                 int high, int *value);
bool reader_dt(struct reader *r, const struct json *object, const char *name, bool needed,
               int64_t *ms);
/* The place in `names`, which end with NULL. */
bool reader_choice(struct reader *r, const struct json *object, const char *name, bool needed,
                   const char *const *names, const char *expected, int *choice);

/* Enlarges an array; it never returns NULL. */
void *reader_grow(void *array, uint32_t count, uint32_t *room, size_t size);

/* The parts of a program. */
bool read_settings(struct reader *r, const struct json *program);
bool read_outside(struct reader *r, const struct json *list);
bool read_bodies(struct reader *r, const struct json *list);

/* The interface of struct program. */
void scenario_program(struct scenario *s);

#endif
