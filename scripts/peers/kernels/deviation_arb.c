/* Travel u and deviation v of one linkage at the 360 whole degrees of its crank as certified balls, by Arb, in place.

   The mathematics is that of deviation_f64.cpp. */
#include "balls.h"

enum { POINTS = 360, NUMBERS = 15 };
static arb_struct cosine[POINTS], sine[POINTS], place[2][POINTS], l[NUMBERS];
static arb_t n, half, along, across, x, y, t;

static void places(slong bits)
{
    const arb_struct *k = l, *a = l + 2, *b = l + 4, *d = l + 6, *m = l + 8, *g = l + 9, *c = l + 11, *low = l + 12, *high = l + 13;
    int is_right = arb_is_negative(l + 14);
    for (int i = 0; i < POINTS; i++) {
        const arb_struct *co = cosine + i, *si = sine + i;
        arb_struct *u = &place[0][i], *v = &place[1][i];
        arb_mul(t, g + 1, si, bits), arb_submul(t, g, co, bits), arb_add(n, m, t, bits);
        arb_inv(half, n, bits), arb_mul_2exp_si(half, half, -1);
        arb_add(along, n, c, bits), arb_mul(along, along, half, bits);
        arb_sub(t, n, low, bits), arb_sub(across, high, n, bits), arb_mul(across, across, t, bits);
        arb_sqrt(across, across, bits), arb_mul(across, across, half, bits);
        if (is_right) arb_neg(across, across);
        arb_mul(x, d + 1, si, bits), arb_submul(x, d, co, bits), arb_add(x, x, b, bits);
        arb_mul(y, d, si, bits), arb_addmul(y, d + 1, co, bits), arb_sub(y, b + 1, y, bits);
        arb_mul(u, a, co, bits), arb_submul(u, a + 1, si, bits), arb_add(u, u, k, bits);
        arb_addmul(u, x, along, bits), arb_submul(u, y, across, bits);
        arb_mul(v, a, si, bits), arb_addmul(v, a + 1, co, bits), arb_add(v, v, k + 1, bits);
        arb_addmul(v, x, across, bits), arb_addmul(v, y, along, bits);
    }
}

int main(int count, char **words)
{
    int answers = wants_answers(count, words);
    slong bits = atoi(strrchr(words[1], '-') + 1) * 10 / 3 + 2;
    Problems problems = read_problems(words[2], NUMBERS);
    double *times = (double *)malloc(problems.lines * sizeof *times);
    for (int i = 0; i < POINTS; i++) {
        fmpq_t turn;
        fmpq_init(turn), fmpq_set_si(turn, i, 180);
        arb_sin_cos_pi_fmpq(sine + i, cosine + i, turn, bits);
        fmpq_clear(turn);
    }
    for (size_t i = 0; i < problems.lines; i++) {
        for (int k = 0; k < NUMBERS; k++) set_ball(l + k, problems.words[NUMBERS * i + k], bits);
        times[i] = 1e9;
        for (int k = 0; k < 10; k++) {
            double start = now();
            places(bits);
            double took = now() - start;
            if (took < times[i]) times[i] = took;
        }
        if (!answers) continue;
        printf("{\"task\": \"places\", \"answer\": [");
        for (int j = 0; j < 2; j++) {
            printf(j ? ", [" : "[");
            for (int k = 0; k < POINTS; k++) printf(k ? ", " : ""), print_ball(&place[j][k]);
            printf("]");
        }
        printf("]}\n");
    }
    print_seconds("places", median(times, problems.lines));
    return 0;
}
