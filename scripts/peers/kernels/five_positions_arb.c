/* Five positions: all Burmester pairs as certified balls, by Arb, in place.

   Elimination gives a quartic in x (five_positions_elimination.h), whose roots are proven one by one
   (five_positions_roots.h); four disjoint balls hold all roots. y, X and Y follow by substitution. More bits are taken
   where these do not suffice. */
#include "five_positions_roots.h"

enum { GUARD = 48, MOST = 4 };
typedef struct { acb_struct at[4]; int is_real; } Pair;
typedef struct { Pair pair[MOST]; int count, real; } Answer;

/* Whether both coordinates of a point are known to so many bits of the larger one. */
static int is_sharp(const acb_struct *point, double bits)
{
    double size = -INFINITY, radius = -INFINITY;
    for (int i = 0; i < 4; i++) {
        const arb_struct *part = i % 2 ? acb_imagref(point + i / 2) : acb_realref(point + i / 2);
        if (!arf_is_zero(arb_midref(part))) size = fmax(size, ARF_EXP(arb_midref(part)) - 1);
        if (!mag_is_zero(arb_radref(part))) radius = fmax(radius, MAG_EXP(arb_radref(part)));
    }
    return radius < size - 1 - bits;
}

/* x, y, X, Y of the root that stands in x; 0 where not sharp enough. */
static int lifted(acb_struct *at, double wanted, slong bits)
{
    acb_mul_arb(value, &at[0], first[2], bits), acb_add_arb(value, value, first[1], bits);
    acb_mul(value, value, &at[0], bits), acb_add_arb(value, value, first[0], bits);
    acb_mul_arb(derivative, &at[0], second[1], bits), acb_add_arb(derivative, derivative, second[0], bits);
    acb_div(&at[1], value, derivative, bits), acb_neg(&at[1], &at[1]);
    for (int i = 0; i < 2; i++) {
        acb_mul_arb(&at[2 + i], &at[0], form[i][1], bits), acb_mul_arb(value, &at[1], form[i][2], bits);
        acb_add(&at[2 + i], &at[2 + i], value, bits), acb_add_arb(&at[2 + i], &at[2 + i], form[i][0], bits);
        acb_div_arb(&at[2 + i], &at[2 + i], determinant, bits);
    }
    return is_sharp(at, wanted) && is_sharp(at + 2, wanted);
}

/* All pairs with so many bits, of conjugate ones the upper; 0 where these do not suffice. */
static int attempt(Answer *answer, const double complex *z, double wanted, slong bits)
{
    int above = 0;
    double top = fmax(fmax(cabs(z[0]), cabs(z[1])), fmax(cabs(z[2]), cabs(z[3])));
    answer->count = answer->real = 0;
    for (int i = 0; i < 4; i++) {
        double size = cabs(z[i]) > 1e-12 * top ? cabs(z[i]) : top; /* a root may be zero */
        int is_real = fabs(cimag(z[i])) < 1e-9 * size;
        Pair *pair = &answer->pair[answer->count];
        if (!is_real && cimag(z[i]) < 0) continue;
        pair->is_real = is_real;
        if (!refined(&pair->at[0], z[i], size, is_real, bits, (bits - wanted) / 2)) return 0;
        if (!is_real && !arb_is_positive(acb_imagref(&pair->at[0]))) return 0;
        answer->count++, answer->real += is_real, above += !is_real;
    }
    if (answer->real + 2 * above != 4) return 0;
    for (int i = 0; i < answer->count; i++)
        for (int k = 0; k < i; k++)
            if (acb_overlaps(&answer->pair[i].at[0], &answer->pair[k].at[0])) return 0;
    for (int i = 0; i < answer->count; i++)
        if (!lifted(answer->pair[i].at, wanted, bits)) return 0;
    return 1;
}

static int solve(Answer *answer, const fmpq *positions, int digits)
{
    double complex z[4];
    double wanted = digits * 3.3219281;
    if (!eliminate(positions)) return 0;
    for (slong bits = wanted + GUARD; bits < 100 * wanted; bits += bits / 2) {
        resultant(bits);
        if (approximate(z) && attempt(answer, z, wanted, bits)) return 1;
        if (searched(z, bits) && attempt(answer, z, wanted, bits)) return 1;
    }
    return 0;
}

static void initialise(Answer *answer)
{
    arb_struct *numbers[] = {determinant, rounded, reach};
    acb_struct *complex_numbers[] = {root, step, value, derivative, box};
    for (int i = 0; i < 4; i++) for (int k = 0; k < 3; k++) arb_init(form[i][k]);
    for (int i = 0; i < 5; i++) arb_init(quartic[i]);
    for (int i = 0; i < 4; i++) arb_init(third[i]), arb_init(slope[i]);
    for (int i = 0; i < 3; i++) arb_init(numbers[i]);
    for (int i = 0; i < 3; i++) arb_init(first[i]);
    for (int i = 0; i < 2; i++) arb_init(second[i]);
    for (int i = 0; i < 5; i++) acb_init(complex_numbers[i]);
    for (int i = 0; i < MOST; i++) for (int k = 0; k < 4; k++) acb_init(&answer->pair[i].at[k]);
}

static void print_answer(const char *task, const Answer *answer)
{
    printf("{\"task\": \"%s\", \"answer\": [%d, [", task, answer->real);
    for (int i = 0; i < answer->count; i++) {
        printf(i ? ", [" : "[");
        for (int k = 0; k < 4; k++) {
            const acb_struct *z = &answer->pair[i].at[k];
            if (k) printf(", ");
            if (answer->pair[i].is_real) { print_ball(acb_realref(z)); continue; }
            printf("["), print_ball(acb_realref(z)), printf(", "), print_ball(acb_imagref(z)), printf("]");
        }
        printf("]");
    }
    printf("]]}\n");
}

int main(int count, char **words)
{
    int answers = wants_answers(count, words), digits = atoi(strrchr(words[1], '-') + 1);
    Problems problems = read_problems(words[2], 20);
    fmpq *numbers = _fmpq_vec_init(20 * problems.lines);
    double *times = (double *)malloc(problems.lines * sizeof *times);
    static Answer answer;
    initialise(&answer);
    for (size_t i = 0; i < 20 * problems.lines; i++) set_rational(numbers + i, problems.words[i]);
    for (size_t i = 0; i < problems.lines; i++) {
        times[i] = 1e9;
        for (int k = 0; k < 3; k++) {
            double start = now();
            if (!solve(&answer, numbers + 20 * i, digits)) { fprintf(stderr, "problem %zu is not solved\n", i + 1); return 1; }
            double took = now() - start;
            if (took < times[i]) times[i] = took;
        }
        if (answers) print_answer("pairs", &answer);
    }
    print_seconds("pairs", median(times, problems.lines));
    return 0;
}
