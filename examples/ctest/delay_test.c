/* A test of your CPU: OB 20 comes once, half a second after SFC 32. The log goes to the file that is named. */
#include "s7log.h"

static struct s7log log_;
static struct s7log_now now_;

/* In the place of your CPU: it tells what happens in the order in which it happens. */
static void run_cpu(void)
{
    s7log_srt_dint(&log_, now_, 20, 500, 0x0007, 0x0000);
    now_.at += 500, now_.up += 500;
    s7log_start(&log_, now_, 20, NULL);
    s7log_end(&log_, now_, 20);
}

int main(int count, char **arguments)
{
    const int obs[] = {1, 20, 80, 85, 100};
    const struct s7log_dt noon = {2026, 11, 21, 12, 0, 0, 0};
    const struct s7log_header header = {
        .cpu = S7LOG_S7_400, .obs = obs, .ob_count = 5, .clock = s7log_ms(&noon), .mode = S7LOG_RUN,
        .latency_ms = 10, .records = S7LOG_CALL | S7LOG_OB | S7LOG_MODE};
    FILE *file = count == 2 ? fopen(arguments[1], "w") : NULL;

    if (!file)
        return 2;
    now_.at = header.clock;
    s7log_open(&log_, s7log_to_file, file);
    if (s7log_header(&log_, &header) != S7LOG_OK)
        return 1;
    run_cpu();
    return fclose(file) ? 1 : 0;
}
