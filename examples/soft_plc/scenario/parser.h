/* Inside the scenario parser. */
#ifndef SCENARIO_PARSER_H
#define SCENARIO_PARSER_H

#include "scenario.h"
#include "words.h"

struct parser {
    struct scenario *scenario;
    const char *file;
    int line;
    struct words words;
    int body;              /* index of the body that is open, -1 where none is */
    unsigned seen;         /* settings that were given */
    int priority_line[S7CPU_OBS];
    int step7_line[S7CPU_TODS];
};

/* Records the error and returns false. `found` may be NULL. */
bool parser_fail(struct parser *p, const char *field, const char *expected, const char *found);
/* The i-th word, NULL behind the last. */
const char *parser_word(const struct parser *p, int i);
/* Enlarges an array; it never returns NULL. */
void *parser_grow(void *array, uint32_t count, uint32_t *room, size_t size);

bool parse_setting(struct parser *p, bool *known);
bool parse_settings_end(struct parser *p);
bool parse_body_begin(struct parser *p);
bool parse_step(struct parser *p);
bool parse_at(struct parser *p);
bool parse_every(struct parser *p);

/* Numbers that several statements need. */
bool parse_ob(struct parser *p, const char *field, int word, int *ob);
bool parse_word_count(struct parser *p, const char *field, int count, const char *expected);

/* The interface of struct program. */
void scenario_program(struct scenario *s);

#endif
