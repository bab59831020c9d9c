/* The roots of the quartic: Ferrari's formula in doubles, Newton's method on midpoints with a precision that doubles,
   a last step on balls that proves one root in each (interval Newton). */
#include <complex.h>
#include <math.h>
#include "five_positions_elimination.h"

enum { FLOAT_BITS = 44 };
static arb_t rounded, reach;
static acb_t root, step, value, derivative, box;

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
    arb_set_round(rounded, coefficient[degree], bits);
    acb_mul_arb(y, z, rounded, bits);
    for (int i = degree - 1; i >= 0; i--) {
        arb_set_round(rounded, coefficient[i], bits);
        arb_add(acb_realref(y), acb_realref(y), rounded, bits);
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
    mag_set_d(arb_radref(reach), size);
    mag_mul_2exp_si(arb_radref(reach), arb_radref(reach), -known);
    arb_add_error_mag(acb_realref(box), arb_radref(reach));
    if (!is_real) arb_add_error_mag(acb_imagref(box), arb_radref(reach));
    evaluate(value, quartic, 4, root, bits);
    evaluate(derivative, slope, 3, box, bits - known + slack);
    acb_div(step, value, derivative, bits - known + slack);
    acb_sub(x, root, step, bits);
    return arb_contains_interior(acb_realref(box), acb_realref(x))
        && (is_real || arb_contains_interior(acb_imagref(box), acb_imagref(x)));
}
