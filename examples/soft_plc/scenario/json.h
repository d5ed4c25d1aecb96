/* JSON as a tree: strict, UTF-8, no key twice in an object. */
#ifndef JSON_H
#define JSON_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

enum json_kind {
    JSON_NULL,
    JSON_FALSE,
    JSON_TRUE,
    JSON_INTEGER, /* within 64 bits */
    JSON_OTHER_NUMBER,
    JSON_STRING,
    JSON_LIST,
    JSON_OBJECT
};

struct json {
    enum json_kind kind;
    int line;
    int64_t integer;
    char *text;         /* of a string, without zero bytes */
    char *name;         /* of a member of an object */
    struct json *first; /* element or member */
    struct json *next;
};

/* The value of `text`, to be freed; NULL where it is none: `expected` says what was expected.
 * `line` is that of the text's begin, and becomes that of the error. */
struct json *json_read(const char *text, size_t length, int *line, const char **expected);
void json_free(struct json *value);

/* The member of an object, NULL where there is none. */
const struct json *json_member(const struct json *object, const char *name);

#endif
