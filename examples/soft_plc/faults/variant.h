/* For the variants: the library's internals, and which faults a CPU has. */
#ifndef VARIANT_H
#define VARIANT_H

#include "faults.h"
#include "internal.h"

static inline const struct faulty_cpu *faulty(const struct s7cpu *cpu)
{
    return (const struct faulty_cpu *)cpu; /* `cpu` is its first member */
}

static inline bool has(const struct s7cpu *cpu, enum fault f)
{
    return faulty(cpu)->faults.has[f];
}

/* The variant has the type of the function that it stands for; substitute.h names both. */
#define SUBSTITUTES(name)                                                                          \
    _Static_assert(sizeof(1 ? &s7_##name : &faulty_##name) == sizeof &s7_##name, #name)

#endif
