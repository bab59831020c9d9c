/* Arb from FLINT 3 or, before it was a part of FLINT, by itself; and balls as text. */
#ifndef BALLS_H
#define BALLS_H
#ifdef ARB_ALONE
#include <acb.h>
#include <acb_poly.h>
#include <arb.h>
#else
#include <flint/acb.h>
#include <flint/acb_poly.h>
#include <flint/arb.h>
#endif
#include <flint/fmpq.h>
#include "kernel.h"

/* "m e r f" in hexadecimal: m 2^e +- r 2^f */
static inline void print_ball(const arb_t x)
{
    char *text = arb_dump_str(x);
    printf("\"%s\"", text);
    flint_free(text);
}

static inline void set_rational(fmpq_t x, const char *text)
{
    if (fmpq_set_str(x, text, 10)) { fprintf(stderr, "not a number: %s\n", text); exit(2); }
}

static inline void set_ball(arb_t x, const char *text, slong bits)
{
    fmpq_t q;
    fmpq_init(q);
    set_rational(q, text);
    arb_set_fmpq(x, q, bits);
    fmpq_clear(q);
}
#endif
