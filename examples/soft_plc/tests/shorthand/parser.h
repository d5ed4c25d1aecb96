/* Inside the parser of the shorthand. */
#ifndef SHORTHAND_PARSER_H
#define SHORTHAND_PARSER_H

#include "reader.h"
#include "shorthand.h"
#include "words.h"

struct parser {
    struct scenario *scenario;
    const char *file;
    int line;
    struct words words;
    int body;              /* index of the body that is open, -1 where none is */
    int body_line;
    unsigned seen;         /* settings that were given */
    int priority_line[S7CPU_OBS];
    int step7_line[S7CPU_TODS];
};

/* Records the error and returns false. `found` may be NULL. */
bool parser_fail(struct parser *p, const char *field, const char *expected, const char *found);
/* The i-th word, NULL behind the last. */
const char *parser_word(const struct parser *p, int i);

bool parse_setting(struct parser *p, bool *known);
bool parse_settings_end(struct parser *p);
bool parse_body_begin(struct parser *p);
bool parse_step(struct parser *p);
bool parse_at(struct parser *p);
bool parse_every(struct parser *p);

/* Numbers that several statements need. */
bool parse_ob(struct parser *p, const char *field, int word, int *ob);
bool parse_word_count(struct parser *p, const char *field, int count, const char *expected);

#endif
