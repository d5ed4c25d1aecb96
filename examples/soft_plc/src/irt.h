/* SFC 39 and 40: start events that are lost, OB by OB. */
#ifndef IRT_H
#define IRT_H

#include "cpu.h"

int sfc_dis_irt(struct cpu *cpu, int mode, int ob_nr);
int sfc_en_irt(struct cpu *cpu, int mode, int ob_nr);
/* Enters event 5380 after a DIS_IRT with this MODE, where it suppresses entries [IRT-09]. */
void irt_report(struct cpu *cpu, int mode);

/* True where a new start event of this OB is lost, without OB and without the reaction to a
 * missing one [IRT-01, IRT-04]. */
bool irt_blocks(const struct cpu *cpu, int ob);
/* True where its events are not entered in the diagnostic buffer either [IRT-09]. */
bool irt_silences(const struct cpu *cpu, int ob);
/* True where a request in the queue has to wait: by mistake, as nothing blocked is queued. */
bool irt_holds(const struct cpu *cpu, int ob);
/* A warm or cold restart takes every block back [IRT-03, OBS-53]. */
void irt_restart(struct cpu *cpu);
/* An OB has been processed to its end; a block outlasts it [IRT-02]. */
void irt_ob_ended(struct cpu *cpu);

#endif
