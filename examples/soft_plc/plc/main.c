#define _POSIX_C_SOURCE 200809L
#include <errno.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "choices.h"
#include "plc.h"
#include "random_program.h"
#include "scenario.h"
#include "values.h"

enum { EXIT_DONE = 0, EXIT_IO = 1, EXIT_WRONG = 2 };
enum { LATENCY_SIMULATED_MS = 10, LATENCY_REAL_MS = 50 };

enum { CHOICES_MAX = 32 };

struct options {
    const char *scenario, *output;
    bool real_time, up, cycle, diag, state, random, kit, family_given;
    uint64_t seed, events;
    enum s7cpu_family family;
    struct fault_set faults;
    const char *choices[CHOICES_MAX];
    int choice_count;
};

static void usage(FILE *out)
{
    fputs("usage: soft_plc [options] PROGRAM         (- reads standard input)\n"
          "       soft_plc [options] --random SEED --events N\n"
          "       soft_plc [options] --kit\n"
          "  --kit           run the programs on standard input, one a line; each log ends with a\n"
          "                  line {\"event\": \"done\"}: an adapter of `s7check kit run`\n"
          "  -o FILE         write the log to FILE instead of standard output\n"
          "  --real-time     run on the real clock: 8 s of a program take 8 s\n"
          "  --up            add `up`, elapsed ms, to every event (always with --real-time)\n"
          "  --cycle         log every start and end of OB 1\n"
          "  --diag          log the entries of the diagnostic buffer\n"
          "  --state         read the state of OBs now and then, with a random program\n"
          "  --random SEED   run a random program instead of a file\n"
          "  --events N      end after N events\n"
          "  --cpu FAMILY    S7-300, S7-400, 318 or S7-1500, with --random\n"
          "  --choose N=V    a behaviour that the requirements leave open; repeatable; `help` lists\n"
          "                  them\n"
          "  --fault NAME    make this deliberate mistake; repeatable; `help` lists them\n"
          "  --help          this text\n"
          "exit status: 0 done, 1 input or output failed, 2 wrong program or arguments\n",
          out);
}

static bool wrong(const char *option, const char *expected)
{
    fprintf(stderr, "soft_plc: %s: expected %s\n", option, expected);
    return false;
}

static bool number(const char *option, const char *s, int64_t low, uint64_t *value)
{
    int64_t n;
    if (s == NULL || !value_integer(s, low, INT64_MAX, &n))
        return wrong(option, low == 0 ? "a number" : "a number from 1");
    *value = (uint64_t)n;
    return true;
}

static bool add_fault(const char *name, struct fault_set *set)
{
    enum fault f;
    if (name == NULL || !fault_by_name(name, &f))
        return wrong("--fault", "a name that --fault help lists");
    set->has[f] = true;
    return true;
}

static bool add_choice(const char *text, struct options *o)
{
    struct s7cpu_choices any;
    if (text == NULL || !choice_set(&any, text))
        return wrong("--choose", "a choice that --choose help lists, as AMB-34=b");
    if (o->choice_count == CHOICES_MAX)
        return wrong("--choose", "at most 32 choices");
    o->choices[o->choice_count++] = text;
    return true;
}

static bool set_family(const char *name, struct options *o)
{
    static const char *const names[] = {"S7-300", "S7-400", "318", "S7-1500"};
    for (int i = 0; i < 4; i++)
        if (name != NULL && strcmp(name, names[i]) == 0) {
            o->family = (enum s7cpu_family)i;
            o->family_given = true;
            return true;
        }
    return wrong("--cpu", "S7-300, S7-400, 318 or S7-1500");
}

/* Options without a value; false where it is none of them. */
static bool flag(const char *a, struct options *o)
{
    if (strcmp(a, "--real-time") == 0)
        o->real_time = true;
    else if (strcmp(a, "--up") == 0)
        o->up = true;
    else if (strcmp(a, "--cycle") == 0)
        o->cycle = true;
    else if (strcmp(a, "--diag") == 0)
        o->diag = true;
    else if (strcmp(a, "--state") == 0)
        o->state = true;
    else if (strcmp(a, "--kit") == 0)
        o->kit = true;
    else
        return false;
    return true;
}

static bool read_options(int argc, char **argv, struct options *o)
{
    for (int i = 1; i < argc; i++) {
        const char *a = argv[i];
        if (flag(a, o))
            continue;
        if (a[0] != '-' || a[1] == '\0') {
            if (o->scenario != NULL)
                return wrong(a, "one program");
            o->scenario = a;
            continue;
        }
        const char *value = ++i < argc ? argv[i] : NULL;
        bool ok;
        if (strcmp(a, "-o") == 0)
            ok = (o->output = value) != NULL || wrong(a, "a file");
        else if (strcmp(a, "--random") == 0)
            ok = o->random = number(a, value, 0, &o->seed);
        else if (strcmp(a, "--events") == 0)
            ok = number(a, value, 1, &o->events);
        else if (strcmp(a, "--cpu") == 0)
            ok = set_family(value, o);
        else if (strcmp(a, "--fault") == 0)
            ok = add_fault(value, &o->faults);
        else if (strcmp(a, "--choose") == 0)
            ok = add_choice(value, o);
        else
            ok = wrong(a, "an option that --help lists");
        if (!ok)
            return false;
    }
    if (o->random + o->kit + (o->scenario != NULL) != 1)
        return wrong("arguments", "a program, --random SEED or --kit");
    if (o->family_given && !o->random)
        return wrong("--cpu", "--random beside it; a program names its CPU itself");
    if (o->output != NULL && o->kit)
        return wrong("-o", "no --kit beside it, whose logs go to standard output");
    return true;
}

static int run(const struct options *o, const struct plc_config *config, struct program *program,
               FILE *out)
{
    static struct plc plc; /* too large for the stack; used through pointers only */
    static struct log log;
    log_open(&log, out, o->real_time);
    plc_run(&plc, config, program, &log, o->real_time);
    if (o->kit && !log.s7.is_done)
        fputs("{\"event\": \"done\"}\n", out); /* it has broken off, and the kit says what is missing */
    if (log_close(&log)) {
        if (o->scenario != NULL && o->events == 0 && log.s7.events == config->max_events)
            fprintf(stderr, "soft_plc: the log ends after %llu events; see --events\n",
                    (unsigned long long)log.s7.events);
        return EXIT_DONE;
    }
    fputs("soft_plc: the log could not be written\n", stderr);
    return EXIT_IO;
}

/* Program of a file or random program, with the options on top. */
static int prepare_and_run(const struct options *o, struct scenario *s, FILE *out)
{
    struct random_program random;
    struct program *program = &s->program;
    struct plc_config *c = &s->config;
    if (o->random || s->random) {
        random_program(&random, o->random ? o->seed : s->seed);
        random.states = o->state;
        program = &random.program;
    }
    if (o->random) {
        random_config(&random, &c->cpu, o->family_given ? &o->family : NULL);
        c->cycle_ms = 10;
        c->duration = INT64_MAX;
        c->max_events = 1000;
    }
    if (o->events != 0)
        c->max_events = o->events;
    if (!s->latency_given)
        c->log.latency_ms = o->real_time ? LATENCY_REAL_MS : LATENCY_SIMULATED_MS;
    c->log.cycle |= o->cycle;
    c->log.diag |= o->diag;
    c->log.up = o->up || o->real_time;
    c->faults = o->faults;
    for (int i = 0; i < o->choice_count; i++)
        choice_set(&c->cpu.choices, o->choices[i]);
    return run(o, c, program, out);
}

static int read_scenario(const char *file, struct scenario *s)
{
    bool standard = strcmp(file, "-") == 0;
    FILE *in = standard ? stdin : fopen(file, "r");
    char *text = NULL;
    size_t room = 0;
    ssize_t length = in != NULL ? getdelim(&text, &room, '\0', in) : -1;
    if (in == NULL || (length < 0 && ferror(in))) {
        fprintf(stderr, "soft_plc: %s: %s\n", file, strerror(errno));
        free(text);
        return EXIT_WRONG;
    }
    bool ok = scenario_read(s, standard ? "(standard input)" : file, 1, text,
                            length > 0 ? (size_t)length : 0);
    if (!standard)
        fclose(in);
    free(text);
    if (!ok)
        fprintf(stderr, "%s\n", s->error);
    return ok ? EXIT_DONE : EXIT_WRONG;
}

/* The reason why a program is not run, an error of its reader without file and line, as a line of
 * the adapter's protocol. */
static void skip(const char *error, FILE *out)
{
    const char *reason = strstr(error, ": ");
    reason = reason != NULL ? reason + 2 : error;
    fputs("{\"event\": \"skip\", \"reason\": \"", out);
    for (const char *p = reason; *p != '\0'; p++)
        fputc(*p == '"' || *p == '\\' || (unsigned char)*p < 0x20 ? '\'' : *p, out);
    fputs("\"}\n", out);
}

static int run_kit(const struct options *o)
{
    char *line = NULL;
    size_t room = 0;
    ssize_t length;
    int status = EXIT_DONE;
    for (int number = 1; status == EXIT_DONE && (length = getline(&line, &room, stdin)) > 0;
         number++) {
        struct scenario s;
        if (scenario_read(&s, "(standard input)", number, line, (size_t)length)) {
            status = prepare_and_run(o, &s, stdout);
        } else {
            skip(s.error, stdout);
        }
        scenario_free(&s);
        if (fflush(stdout) != 0)
            status = EXIT_IO;
    }
    free(line);
    return status;
}

static int with_output(const struct options *o, struct scenario *s)
{
    FILE *out = o->output != NULL ? fopen(o->output, "w") : stdout;
    if (out == NULL) {
        fprintf(stderr, "soft_plc: %s: %s\n", o->output, strerror(errno));
        return EXIT_IO;
    }
    int status = prepare_and_run(o, s, out);
    if (o->output != NULL && fclose(out) != 0 && status == EXIT_DONE) {
        fprintf(stderr, "soft_plc: %s: %s\n", o->output, strerror(errno));
        status = EXIT_IO;
    }
    return status;
}

int main(int argc, char **argv)
{
    struct options o = {0};
    struct scenario scenario = {0};
    for (int i = 1; i < argc; i++) {
        if (strcmp(argv[i], "--help") == 0) {
            usage(stdout);
            return EXIT_DONE;
        }
        if (i + 1 == argc || strcmp(argv[i + 1], "help") != 0)
            continue;
        if (strcmp(argv[i], "--fault") == 0) {
            faults_help(stdout);
            return EXIT_DONE;
        }
        if (strcmp(argv[i], "--choose") == 0) {
            choices_help(stdout);
            return EXIT_DONE;
        }
    }
    if (!read_options(argc, argv, &o)) {
        fputs("try soft_plc --help\n", stderr);
        return EXIT_WRONG;
    }
    if (o.kit)
        return run_kit(&o);
    int status = o.random ? EXIT_DONE : read_scenario(o.scenario, &scenario);
    if (status == EXIT_DONE && o.state && !o.random && !scenario.random) {
        wrong("--state", "a random program; another has the event state itself");
        status = EXIT_WRONG;
    }
    if (status == EXIT_DONE)
        status = with_output(&o, &scenario);
    scenario_free(&scenario);
    return status;
}
