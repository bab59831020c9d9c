/* Five rational positions to a quartic, in place; all numbers here are those of one problem.

   |r z + t - M|^2 has one value in all positions; the differences are linear in X, Y, p, q and 1, x, y, where
   z = x + iy, M = X + iY, p + iq = z conj(M). Exact elimination without fractions gives X, Y, p, q as linear
   forms; p = xX + yY and q = yX - xY are two quadratic equations in y, their resultant a quartic in x. */
#include "balls.h"

static fmpz matrix[4][7], base[7], entry, other, last_pivot, number[4], scale[4];
static arb_t form[4][3], first[3], second[2], third[4], quartic[5], slope[4], determinant;

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
