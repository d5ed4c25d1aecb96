#include "shorthand.h"

#include <stdlib.h>
#include <string.h>

#include "parser.h"

enum { LINE_MAX_CHARS = 1024 };

bool parser_fail(struct parser *p, const char *field, const char *expected, const char *found)
{
    char *error = p->scenario->error;
    size_t room = sizeof p->scenario->error;
    if (found != NULL)
        snprintf(error, room, "%.120s:%d: %.40s: expected %.100s, found \"%.30s\"", p->file,
                 p->line, field, expected, found);
    else
        snprintf(error, room, "%.120s:%d: %.40s: expected %.100s", p->file, p->line, field,
                 expected);
    return false;
}

const char *parser_word(const struct parser *p, int i)
{
    return i < p->words.count ? p->words.word[i] : NULL;
}

bool parse_ob(struct parser *p, const char *field, int word, int *ob)
{
    const char *s = parser_word(p, word);
    int64_t n;
    if (s == NULL || !word_int(s, 1, S7CPU_OBS - 1, &n) || !s7cpu_ob_exists((int)n))
        return parser_fail(p, field, "the number of an OB", s);
    *ob = (int)n;
    return true;
}

bool parse_word_count(struct parser *p, const char *field, int count, const char *expected)
{
    return p->words.count == count || parser_fail(p, field, expected, parser_word(p, count));
}

static bool parse_line(struct parser *p)
{
    const char *first = parser_word(p, 0);
    bool known = false;
    if (first == NULL)
        return true;
    if (p->body >= 0) {
        if (strcmp(first, "}") != 0)
            return parse_step(p);
        p->body = -1;
        return parse_word_count(p, "}", 1, "the end of the line");
    }
    if (strcmp(first, "ob") == 0)
        return parse_body_begin(p);
    if (strcmp(first, "at") == 0)
        return parse_at(p);
    if (strcmp(first, "every") == 0)
        return parse_every(p);
    if (!parse_setting(p, &known))
        return false;
    return known || parser_fail(p, first, "a setting, at, every or ob", NULL);
}

static bool parse_end(struct parser *p)
{
    struct scenario *s = p->scenario;
    if (p->body >= 0) {
        p->line = p->body_line;
        return parser_fail(p, "ob", "} at the end of the body", NULL);
    }
    if (!parse_settings_end(p))
        return false;
    if (s->random && (s->body_count > 0 || s->action_count > 0))
        return parser_fail(p, "random", "no ob, at or every beside it", NULL);
    scenario_end(s);
    return true;
}

bool shorthand_read(struct scenario *s, const char *file, FILE *in)
{
    struct parser p = {.scenario = s, .file = file, .body = -1};
    char line[LINE_MAX_CHARS];
    memset(s, 0, sizeof *s);
    while (fgets(line, sizeof line, in) != NULL) {
        p.line++;
        if (strchr(line, '\n') == NULL && !feof(in))
            return parser_fail(&p, "line", "at most 1000 characters", NULL);
        if (!words_split(line, &p.words))
            return parser_fail(&p, "line", "at most 64 words", NULL);
        if (!parse_line(&p))
            return false;
    }
    if (ferror(in))
        return parser_fail(&p, "file", "a file that can be read", NULL);
    return parse_end(&p);
}
