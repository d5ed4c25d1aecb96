#define _POSIX_C_SOURCE 200809L
#include "test.h"

#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "plc.h"
#include "random_program.h"
#include "shorthand.h"

static struct {
    int checks, failed;
} tally;

void test_check(bool ok, const char *file, int line, const char *text)
{
    tally.checks++;
    if (ok)
        return;
    tally.failed++;
    fprintf(stderr, "%s:%d: failed: %s\n", file, line, text);
}

static char *run(const struct plc_config *config, struct program *program)
{
    char *text = NULL;
    size_t length = 0;
    FILE *out = open_memstream(&text, &length);
    struct plc *plc = malloc(sizeof *plc);
    struct log *log = malloc(sizeof *log);
    if (out == NULL || plc == NULL || log == NULL)
        abort();
    log_open(log, out, false);
    plc_run(plc, config, program, log, false);
    CHECK(log_close(log));
    fclose(out);
    free(plc);
    free(log);
    return text;
}

static const char base[] = "cpu S7-400\nobs 1 10 11 35 40 80 85 100 102\n"
                           "clock 2026-11-21T05:59:30\nmode RUN\nduration 10min\n";

static bool read_text(struct scenario *s, const char *text)
{
    size_t size = sizeof base + strlen(text);
    char *whole = malloc(size);
    if (whole == NULL)
        abort();
    snprintf(whole, size, "%s%s", strncmp(text, "cpu", 3) == 0 ? "" : base, text);
    bool ok = shorthand_read(s, whole);
    free(whole);
    return ok;
}

char *test_run(const char *text, enum fault fault)
{
    struct scenario s;
    char *log;
    if (read_text(&s, text)) {
        s.config.faults.has[fault] = true;
        log = run(&s.config, &s.program);
    } else {
        test_check(false, "scenario", 0, s.error);
        log = calloc(1, 1);
    }
    scenario_free(&s);
    return log;
}

void test_join(char *to, size_t size, const char *first, const char *second)
{
    snprintf(to, size, "%s%s", first, second);
}

char *test_random(uint64_t seed, uint64_t events, enum fault fault)
{
    struct random_program r;
    struct plc_config c;
    memset(&c, 0, sizeof c);
    random_program(&r, seed);
    r.states = true;
    random_config(&r, &c.cpu, NULL);
    c.log.diag = true;
    c.cycle_ms = 10;
    c.log.latency_ms = 10;
    c.duration = INT64_MAX;
    c.max_events = events;
    c.faults.has[fault] = true;
    return run(&c, &r.program);
}

bool test_in_order(const char *log, ...)
{
    va_list pieces;
    const char *piece;
    bool ok = true;
    va_start(pieces, log);
    while (ok && (piece = va_arg(pieces, const char *)) != NULL) {
        const char *hit = strstr(log, piece);
        if (hit == NULL) {
            fprintf(stderr, "not found in its place: %s\n", piece);
            ok = false;
        } else {
            const char *end = strchr(hit, '\n');
            log = end != NULL ? end : hit + strlen(hit);
        }
    }
    va_end(pieces);
    return ok;
}

int test_count(const char *log, const char *piece)
{
    int n = 0;
    for (const char *p = log; (p = strstr(p, piece)) != NULL; p += strlen(piece))
        n++;
    return n;
}

int main(void)
{
    test_calendar();
    test_calls();
    test_dint();
    test_irt();
    test_diag();
    test_faults();
    test_scheduling();
    test_choices();
    test_clock();
    test_modes();
    test_s7_1500();
    test_program();
    test_random_program();
    printf("%d checks, %d failed\n", tally.checks, tally.failed);
    return tally.failed == 0 ? 0 : 1;
}
