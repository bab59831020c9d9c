/* 10 000 points of a centerpoint curve as certified balls, homogeneous coordinates, by Arb, in place.

   The mathematics is that of curve_f64.cpp. Where a ball does not tell which way of writing a root loses nothing, both
   are right and the first is taken. */
#include "balls.h"

enum { POINTS = 10000 };
static arb_struct cosine[POINTS], sine[POINTS], point[POINTS][3];
static arb_t fr, fi, ar, ai, beta, nr, ni, er, ei, kappa, modulus, reach, t, co, si, root, dx, dy, r;

/* a b + c d, or a b - c d */
static void sum(arb_t x, const arb_t a, const arb_t b, const arb_t c, const arb_t d, int sign, slong bits)
{
    arb_mul(x, a, b, bits);
    sign > 0 ? arb_addmul(x, c, d, bits) : arb_submul(x, c, d, bits);
}

/* What all points have in common; the number of branches. */
static int prepare(char **words, slong bits)
{
    arb_struct *given[] = {fr, fi, ar, ai, beta, nr, ni};
    arb_t length, mean, top, re, im;
    arb_init(length), arb_init(mean), arb_init(top), arb_init(re), arb_init(im);
    for (int i = 0; i < 7; i++) set_ball(given[i], words[i], bits);
    sum(re, ar, nr, ai, ni, -1, bits), sum(im, ar, ni, ai, nr, 1, bits);
    arb_hypot(length, re, im, bits);
    sum(mean, ar, nr, ai, ni, 1, bits), arb_mul_2exp_si(mean, mean, 1), arb_neg(mean, mean), arb_addmul(mean, beta, beta, bits);
    arb_mul_2exp_si(top, length, 1), arb_add(top, top, mean, bits);
    arb_mul_2exp_si(t, length, 2), arb_div(modulus, t, top, bits), arb_div(kappa, top, t, bits);
    arb_sqrt(kappa, kappa, bits), arb_sqrt(reach, top, bits);
    if (arb_is_negative(re)) arb_set(er, im), arb_sub(ei, length, re, bits);
    else arb_add(er, length, re, bits), arb_set(ei, im);
    arb_hypot(t, er, ei, bits), arb_div(er, er, t, bits), arb_div(ei, ei, t, bits);
    arb_mul_2exp_si(length, length, 1);
    int branches = arb_gt(mean, length) ? 2 : 1;
    arb_clear(length), arb_clear(mean), arb_clear(top), arb_clear(re), arb_clear(im);
    return branches;
}

/* The point on the line of a direction where the discriminant has this root. */
static void on_line(arb_struct *at, const arb_t c, const arb_t s, slong bits)
{
    sum(dx, er, c, ei, s, -1, bits), sum(dy, er, s, ei, c, 1, bits);
    arb_struct *w = at + 2;
    int known = arb_is_nonzero(beta) && arb_is_nonzero(root);
    if (!known || arb_is_positive(beta) != arb_is_positive(root)) {
        arb_sub(r, root, beta, bits);
        sum(w, ar, dx, ai, dy, 1, bits), arb_mul_2exp_si(w, w, 1);
    } else {
        sum(r, nr, dx, ni, dy, 1, bits), arb_mul_2exp_si(r, r, 1);
        arb_add(w, root, beta, bits), arb_neg(w, w);
    }
    sum(at, fr, w, r, dx, 1, bits), sum(at + 1, fi, w, r, dy, 1, bits);
}

static void trace(int branches, slong bits)
{
    int count = POINTS / branches, open_is_positive = arb_is_negative(beta);
    for (int k = 0; k < POINTS; k++) {
        int i = k % count, is_open = k < count;
        if (branches == 1) {
            arb_mul(co, kappa, cosine + i, bits);
            arb_mul(t, co, co, bits), arb_sub_ui(t, t, 1, bits), arb_neg(t, t), arb_sqrt(si, t, bits);
            arb_mul(root, reach, sine + i, bits);
            on_line(point[k], co, si, bits);
            continue;
        }
        arb_mul(t, cosine + i, cosine + i, bits), arb_mul(t, t, modulus, bits);
        arb_sub_ui(t, t, 1, bits), arb_neg(t, t), arb_sqrt(t, t, bits), arb_mul(root, t, reach, bits);
        if (is_open != open_is_positive) arb_neg(root, root);
        on_line(point[k], cosine + i, sine + i, bits);
    }
}

int main(int count, char **words)
{
    int answers = wants_answers(count, words);
    slong bits = atoi(strrchr(words[1], '-') + 1);
    Problems problems = read_problems(words[2], 7);
    double *times = (double *)malloc(problems.lines * sizeof *times);
    for (size_t i = 0; i < problems.lines; i++) {
        int branches = prepare(problems.words + 7 * i, bits);
        slong half = POINTS / 2 / branches;
        for (slong n = -half; n < half; n++) {
            fmpq_t q;
            fmpq_init(q);
            fmpq_set_si(q, half * half - n * n, half * half + n * n), arb_set_fmpq(cosine + n + half, q, bits);
            fmpq_set_si(q, 2 * n * half, half * half + n * n), arb_set_fmpq(sine + n + half, q, bits);
            fmpq_clear(q);
        }
        times[i] = 1e9;
        for (int k = 0; k < 5; k++) {
            double start = now();
            trace(branches, bits);
            double took = now() - start;
            if (took < times[i]) times[i] = took;
        }
        if (!answers) continue;
        printf("{\"task\": \"points\", \"answer\": [");
        for (int k = 0; k < POINTS; k++) {
            printf(k ? ", [" : "[");
            for (int j = 0; j < 3; j++) printf(j ? ", " : ""), print_ball(&point[k][j]);
            printf("]");
        }
        printf("]}\n");
    }
    print_seconds("points", median(times, problems.lines));
    return 0;
}
