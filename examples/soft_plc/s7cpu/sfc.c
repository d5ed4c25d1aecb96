/* The SFCs as the user program calls them: the rule, then the event. */
#include "internal.h"

/* OB_NR is a number [T15-07]. */
static int ob_of(const struct s7cpu *cpu, int ob_nr)
{
    return s7cpu_ob(&cpu->config, ob_nr);
}

static int called(struct s7cpu *cpu, struct s7cpu_event call, int ret)
{
    call.ret = ret;
    s7_emit(cpu, call);
    return ret;
}

int s7cpu_set_tint(struct s7cpu *cpu, int ob_nr, const struct s7cpu_date *sdt, int period)
{
    return called(cpu,
                  (struct s7cpu_event){
                      .kind = S7CPU_SET_TINT, .ob = ob_nr, .sdt = *sdt, .period = period},
                  s7_tod_set(cpu, ob_of(cpu, ob_nr), sdt, false, period)); /* [T15-21] */
}

int s7cpu_set_tintl(struct s7cpu *cpu, int ob_nr, const struct s7cpu_date *sdt, bool local,
                    int period, bool activate)
{
    int ret = s7_tod_set(cpu, ob_of(cpu, ob_nr), sdt, local, period);
    if (ret == RET_OK && activate)
        ret = s7_tod_activate(cpu, ob_of(cpu, ob_nr));
    return called(cpu,
                  (struct s7cpu_event){.kind = S7CPU_SET_TINTL, .ob = ob_nr, .sdt = *sdt,
                                       .local = local, .period = period, .activate = activate},
                  ret);
}

int s7cpu_can_tint(struct s7cpu *cpu, int ob_nr)
{
    return called(cpu, (struct s7cpu_event){.kind = S7CPU_CAN_TINT, .ob = ob_nr},
                  s7_tod_cancel(cpu, ob_of(cpu, ob_nr)));
}

int s7cpu_act_tint(struct s7cpu *cpu, int ob_nr)
{
    return called(cpu, (struct s7cpu_event){.kind = S7CPU_ACT_TINT, .ob = ob_nr},
                  s7_tod_activate(cpu, ob_of(cpu, ob_nr)));
}

int s7cpu_qry_tint(struct s7cpu *cpu, int ob_nr, int *status)
{
    struct s7cpu_event call = {.kind = S7CPU_QRY_TINT, .ob = ob_nr};
    int ret = s7_tod_query(cpu, ob_of(cpu, ob_nr), &call.status);
    if (ret == RET_OK)
        *status = call.status; /* [TINT-71] */
    return called(cpu, call, ret);
}

int s7cpu_srt_dint(struct s7cpu *cpu, int ob_nr, int64_t dtime, int sign)
{
    return called(cpu,
                  (struct s7cpu_event){
                      .kind = S7CPU_SRT_DINT, .ob = ob_nr, .dtime = dtime, .sign = sign},
                  s7_dint_start(cpu, ob_of(cpu, ob_nr), dtime, sign));
}

int s7cpu_can_dint(struct s7cpu *cpu, int ob_nr)
{
    return called(cpu, (struct s7cpu_event){.kind = S7CPU_CAN_DINT, .ob = ob_nr},
                  s7_dint_cancel(cpu, ob_of(cpu, ob_nr)));
}

int s7cpu_qry_dint(struct s7cpu *cpu, int ob_nr, int *status)
{
    struct s7cpu_event call = {.kind = S7CPU_QRY_DINT, .ob = ob_nr};
    int ret = s7_dint_query(cpu, ob_of(cpu, ob_nr), &call.status);
    if (ret == RET_OK)
        *status = call.status;
    return called(cpu, call, ret);
}

int s7cpu_dis_irt(struct s7cpu *cpu, int mode, int ob_nr)
{
    int ret = called(cpu, (struct s7cpu_event){.kind = S7CPU_DIS_IRT, .mode = mode, .ob = ob_nr},
                     s7_irt_disable(cpu, mode, ob_of(cpu, ob_nr)));
    if (ret == RET_OK && mode & NO_ENTRIES)
        s7_diag_suppressed(cpu); /* behind the call, its cause [IRT-09] */
    return ret;
}

int s7cpu_en_irt(struct s7cpu *cpu, int mode, int ob_nr)
{
    return called(cpu, (struct s7cpu_event){.kind = S7CPU_EN_IRT, .mode = mode, .ob = ob_nr},
                  s7_irt_enable(cpu, mode, ob_of(cpu, ob_nr)));
}

int s7cpu_dis_airt(struct s7cpu *cpu)
{
    return called(cpu, (struct s7cpu_event){.kind = S7CPU_DIS_AIRT}, s7_airt_disable(cpu));
}

int s7cpu_en_airt(struct s7cpu *cpu)
{
    return called(cpu, (struct s7cpu_event){.kind = S7CPU_EN_AIRT}, s7_airt_enable(cpu));
}
