/* Five positions: all Burmester pairs as certified balls, by Arb, in place.

   |r z + t - M|^2 has one value in all positions; the differences are linear in X, Y, p, q and 1, x, y, where
   z = x + iy, M = X + iY, p + iq = z conj(M). Exact elimination without fractions gives X, Y, p, q as linear
   forms; p = xX + yY and q = yX - xY are two quadratic equations in y, their resultant a quartic in x. Its roots:
   Ferrari's formula in doubles, Newton's method on midpoints with a precision that doubles, a last step on balls
   that proves one root in each (interval Newton); four disjoint balls hold all roots. y, X and Y follow. */
#include <complex.h>
#include <math.h>
#include "balls.h"

enum { FLOAT_BITS = 44, GUARD = 48, MOST = 4 };
typedef struct { acb_struct at[4]; int is_real; } Pair;
typedef struct { Pair pair[MOST]; int count, real; } Answer;

static fmpz matrix[4][7], base[7], entry, other, last_pivot, number[4], scale[4];
static arb_t form[4][3], first[3], second[2], third[4], quartic[5], slope[4], determinant, t0, t1, t2;
static acb_t root, step, value, derivative, box, image;

/* One row: coefficients of X, Y, p, q, 1, x, y for c + is, a + ib, all times `unit`. */
static void integral(fmpz *row, fmpz *unit, const fmpq *position)
{
    const fmpz *c = fmpq_numref(position), *s = fmpq_numref(position + 1);
    const fmpz *a = fmpq_numref(position + 2), *b = fmpq_numref(position + 3);
    fmpz *n = &scale[0], *m = &scale[1], *c1 = &number[0], *s1 = &number[1], *a1 = &number[2], *b1 = &number[3];
    fmpz_lcm(n, fmpq_denref(position), fmpq_denref(position + 1));
    fmpz_lcm(m, fmpq_denref(position + 2), fmpq_denref(position + 3));
    fmpz_divexact(&entry, n, fmpq_denref(position)), fmpz_mul(c1, c, &entry);
    fmpz_divexact(&entry, n, fmpq_denref(position + 1)), fmpz_mul(s1, s, &entry);
    fmpz_divexact(&entry, m, fmpq_denref(position + 2)), fmpz_mul(a1, a, &entry);
    fmpz_divexact(&entry, m, fmpq_denref(position + 3)), fmpz_mul(b1, b, &entry);
    fmpz_mul(&scale[2], m, m), fmpz_mul_2exp(&scale[2], &scale[2], 1); /* 2 m^2 */
    fmpz_mul(&scale[3], n, m), fmpz_mul_2exp(&scale[3], &scale[3], 1); /* 2 n m */
    fmpz_mul(&row[0], a1, &scale[3]), fmpz_neg(&row[0], &row[0]);
    fmpz_mul(&row[1], b1, &scale[3]), fmpz_neg(&row[1], &row[1]);
    fmpz_mul(&row[2], c1, &scale[2]), fmpz_neg(&row[2], &row[2]);
    fmpz_mul(&row[3], s1, &scale[2]);
    fmpz_mul(&row[4], a1, a1), fmpz_addmul(&row[4], b1, b1), fmpz_mul(&row[4], &row[4], n);
    fmpz_mul_2exp(&entry, m, 1);
    fmpz_mul(&row[5], a1, c1), fmpz_addmul(&row[5], b1, s1), fmpz_mul(&row[5], &row[5], &entry);
    fmpz_mul(&row[6], b1, c1), fmpz_submul(&row[6], a1, s1), fmpz_mul(&row[6], &row[6], &entry);
    fmpz_mul(unit, &scale[3], m);
}

/* Gauss and Jordan without fractions (Bareiss): last_pivot (X, Y, p, q) = -matrix[.][4..7] (1, x, y). */
static int eliminate(const fmpq *positions)
{
    static fmpz unit, base_unit;
    integral(base, &base_unit, positions);
    for (int i = 0; i < 4; i++) {
        integral(matrix[i], &unit, positions + 4 * (i + 1));
        fmpz_zero(&other);
        for (int k = 0; k < 7; k++) {
            fmpz_mul(&matrix[i][k], &matrix[i][k], &base_unit), fmpz_submul(&matrix[i][k], &base[k], &unit);
            if (!fmpz_is_one(&other)) fmpz_gcd(&other, &other, &matrix[i][k]);
        }
        for (int k = 0; k < 7 && !fmpz_is_one(&other); k++) fmpz_divexact(&matrix[i][k], &matrix[i][k], &other);
    }
    fmpz_one(&last_pivot);
    for (int column = 0; column < 4; column++) {
        int best = column;
        while (best < 4 && fmpz_is_zero(&matrix[best][column])) best++;
        if (best == 4) return 0;
        for (int k = 0; k < 7 && best != column; k++) fmpz_swap(&matrix[best][k], &matrix[column][k]);
        for (int i = 0; i < 4; i++) {
            if (i == column) continue;
            for (int k = column + 1; k < 7; k++) {
                fmpz_mul(&entry, &matrix[i][k], &matrix[column][column]);
                fmpz_submul(&entry, &matrix[i][column], &matrix[column][k]);
                fmpz_divexact(&matrix[i][k], &entry, &last_pivot);
            }
        }
        fmpz_set(&last_pivot, &matrix[column][column]);
    }
    return 1;
}

/* x = a b - c d */
static void minor(arb_t x, const arb_t a, const arb_t b, const arb_t c, const arb_t d, slong bits)
{
    arb_mul(x, a, b, bits);
    arb_submul(x, c, d, bits);
}

/* The quartic, lowest first, and y = -first/second. With a y^2 + b y + c and e y^2 + f y + g of the two conics:
   first = ag - ec, second = af - eb, third = bg - fc, quartic = first^2 - second third. */
static void resultant(slong bits)
{
    static arb_t b[2], c[3], f[2], g[3];
    arb_struct *a = form[1][2], *e = form[0][2];
    for (int i = 0; i < 4; i++)
        for (int k = 0; k < 3; k++) arb_set_round_fmpz(form[i][k], &matrix[i][k + 4], bits), arb_neg(form[i][k], form[i][k]);
    arb_set_round_fmpz(determinant, &last_pivot, bits);
    arb_sub(b[0], form[1][0], form[2][2], bits), arb_add(b[1], form[0][2], form[1][1], bits);
    arb_neg(c[0], form[2][0]), arb_sub(c[1], form[0][0], form[2][1], bits), arb_set(c[2], form[0][1]);
    arb_sub(f[0], form[0][0], form[3][2], bits), arb_sub(f[1], form[0][1], form[1][2], bits);
    arb_neg(g[0], form[3][0]), arb_add(g[1], form[1][0], form[3][1], bits), arb_neg(g[1], g[1]), arb_neg(g[2], form[1][1]);
    for (int k = 0; k < 3; k++) minor(first[k], a, g[k], e, c[k], bits);
    for (int k = 0; k < 2; k++) minor(second[k], a, f[k], e, b[k], bits);
    for (int k = 0; k < 4; k++) {
        arb_zero(third[k]);
        if (k < 3) minor(third[k], b[0], g[k], f[0], c[k], bits);
        if (k > 0) arb_addmul(third[k], b[1], g[k - 1], bits), arb_submul(third[k], f[1], c[k - 1], bits);
    }
    arb_mul(quartic[0], first[0], first[0], bits), arb_mul(quartic[1], first[0], first[1], bits);
    arb_mul(quartic[2], first[0], first[2], bits), arb_mul(quartic[3], first[1], first[2], bits);
    for (int k = 1; k < 4; k++) arb_mul_2exp_si(quartic[k], quartic[k], 1);
    arb_addmul(quartic[2], first[1], first[1], bits), arb_mul(quartic[4], first[2], first[2], bits);
    for (int k = 0; k < 4; k++)
        for (int i = 0; i < 2; i++) arb_submul(quartic[k + i], second[i], third[k], bits);
    for (int k = 0; k < 4; k++) arb_mul_ui(slope[k], quartic[k + 1], k + 1, bits);
}

/* Starting values for all roots: Ferrari's formula and two steps of Newton's method, in doubles. */
static int approximate(double complex *z)
{
    double k[5];
    slong top = WORD_MIN;
    arf_t part;
    for (int i = 0; i < 5; i++) {
        slong e = arf_abs_bound_lt_2exp_si(arb_midref(quartic[i]));
        if (e > top) top = e;
    }
    arf_init(part);
    for (int i = 0; i < 5; i++) {
        arf_mul_2exp_si(part, arb_midref(quartic[i]), -top);
        k[i] = arf_get_d(part, ARF_RND_NEAR);
    }
    arf_clear(part);
    double b = k[3] / k[4], c = k[2] / k[4], d = k[1] / k[4], e = k[0] / k[4];
    double p = c - 0.375 * b * b, q = d - 0.5 * b * c + 0.125 * b * b * b;
    double r = e - 0.25 * b * d + b * b * c / 16 - 3 * b * b * b * b / 256;
    /* The resolvent w^3 + 2 p w^2 + (p^2 - 4 r) w - q^2. */
    double s = -(p * p + 12 * r) / 3, t = -(2 * p * p * p - 72 * p * r + 27 * q * q) / 27;
    double complex under = csqrt(t * t / 4 + s * s * s / 27), cube = -t / 2 + under;
    if (cabs(-t / 2 - under) > cabs(cube)) cube = -t / 2 - under;
    double complex third_root = cpow(cube, 1.0 / 3), w = csqrt(third_root - s / (3 * third_root) - 2 * p / 3), u = q / w;
    double complex inner = csqrt(-w * w - 2 * p - 2 * u), outer = csqrt(-w * w - 2 * p + 2 * u);
    z[0] = -b / 4 + (w + inner) / 2, z[1] = -b / 4 + (w - inner) / 2;
    z[2] = -b / 4 + (-w + outer) / 2, z[3] = -b / 4 + (-w - outer) / 2;
    for (int i = 0; i < 4; i++) {
        for (int k = 0; k < 2; k++)
            z[i] -= ((((z[i] + b) * z[i] + c) * z[i] + d) * z[i] + e) / (((4 * z[i] + 3 * b) * z[i] + 2 * c) * z[i] + d);
        if (!isfinite(creal(z[i])) || !isfinite(cimag(z[i]))) return 0;
    }
    return 1;
}

/* The same by FLINT's iteration, where doubles do not do. */
static int searched(double complex *z, slong bits)
{
    acb_poly_t p;
    acb_struct roots[4];
    acb_poly_init(p);
    for (int i = 0; i < 4; i++) acb_init(roots + i);
    for (int i = 0; i < 5; i++) acb_set_arb(root, quartic[i]), acb_get_mid(root, root), acb_poly_set_coeff_acb(p, i, root);
    int found = acb_poly_find_roots(roots, p, NULL, 0, bits) == 4;
    for (int i = 0; i < 4; i++) {
        double im = arf_get_d(arb_midref(acb_imagref(roots + i)), ARF_RND_NEAR);
        if (arb_contains_zero(acb_imagref(roots + i))) im = 0;
        z[i] = arf_get_d(arb_midref(acb_realref(roots + i)), ARF_RND_NEAR) + im * I;
    }
    acb_poly_clear(p);
    for (int i = 0; i < 4; i++) acb_clear(roots + i);
    return found;
}

/* Horner, with the coefficients rounded first. */
static void evaluate(acb_t y, arb_t *coefficient, int degree, const acb_t z, slong bits)
{
    arb_set_round(t0, coefficient[degree], bits);
    acb_mul_arb(y, z, t0, bits);
    for (int i = degree - 1; i >= 0; i--) {
        arb_set_round(t0, coefficient[i], bits);
        arb_add(acb_realref(y), acb_realref(y), t0, bits);
        if (i) acb_mul(y, y, z, bits);
    }
}

/* A ball with exactly one root near z, real or not; 0 where that is not proven. */
static int refined(acb_t x, double complex z, double size, int is_real, slong bits, slong slack)
{
    slong half[40];
    int steps = 0;
    for (slong h = bits / 2 + 4; h > FLOAT_BITS; h = h / 2 + 4) half[steps++] = h;
    slong known = steps ? bits / 2 : FLOAT_BITS - 4;
    acb_set_d_d(root, creal(z), is_real ? 0 : cimag(z));
    while (steps--) {
        evaluate(value, quartic, 4, root, half[steps] + slack);
        evaluate(derivative, slope, 3, root, half[steps] / 2 + slack);
        acb_div(step, value, derivative, half[steps] / 2 + slack);
        acb_sub(root, root, step, half[steps] + slack);
        acb_get_mid(root, root);
    }
    acb_set(box, root);
    mag_set_d(arb_radref(t1), size);
    mag_mul_2exp_si(arb_radref(t1), arb_radref(t1), -known);
    arb_add_error_mag(acb_realref(box), arb_radref(t1));
    if (!is_real) arb_add_error_mag(acb_imagref(box), arb_radref(t1));
    evaluate(value, quartic, 4, root, bits);
    evaluate(derivative, slope, 3, box, bits - known + slack);
    acb_div(step, value, derivative, bits - known + slack);
    acb_sub(x, root, step, bits);
    return arb_contains_interior(acb_realref(box), acb_realref(x))
        && (is_real || arb_contains_interior(acb_imagref(box), acb_imagref(x)));
}

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
    arb_struct *numbers[] = {determinant, t0, t1, t2};
    acb_struct *complex_numbers[] = {root, step, value, derivative, box, image};
    for (int i = 0; i < 4; i++) for (int k = 0; k < 3; k++) arb_init(form[i][k]);
    for (int i = 0; i < 5; i++) arb_init(quartic[i]);
    for (int i = 0; i < 4; i++) arb_init(numbers[i]), arb_init(third[i]), arb_init(slope[i]);
    for (int i = 0; i < 3; i++) arb_init(first[i]);
    for (int i = 0; i < 2; i++) arb_init(second[i]);
    for (int i = 0; i < 6; i++) acb_init(complex_numbers[i]);
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
