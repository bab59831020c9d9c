/* Single operations of Arb on balls, and of MPFR on numbers, at one precision; results in place. */
#include <mpfr.h>
#include "balls.h"

enum { OPERATIONS = 6 };
static const char *const names[OPERATIONS] = {"add", "mul", "div", "sqrt", "sin+cos", "atan"};

static void on_balls(int which, arb_t x, arb_t y, const arb_t a, const arb_t b, slong bits)
{
    switch (which) {
    case 0: arb_add(x, a, b, bits); break;
    case 1: arb_mul(x, a, b, bits); break;
    case 2: arb_div(x, a, b, bits); break;
    case 3: arb_sqrt(x, a, bits); break;
    case 4: arb_sin_cos(x, y, a, bits); break;
    case 5: arb_atan(x, a, bits); break;
    }
}

static void on_numbers(int which, mpfr_ptr x, mpfr_ptr y, mpfr_srcptr a, mpfr_srcptr b)
{
    switch (which) {
    case 0: mpfr_add(x, a, b, MPFR_RNDN); break;
    case 1: mpfr_mul(x, a, b, MPFR_RNDN); break;
    case 2: mpfr_div(x, a, b, MPFR_RNDN); break;
    case 3: mpfr_sqrt(x, a, MPFR_RNDN); break;
    case 4: mpfr_sin_cos(x, y, a, MPFR_RNDN); break;
    case 5: mpfr_atan(x, a, MPFR_RNDN); break;
    }
}

int main(int count, char **words)
{
    int answers = wants_answers(count, words);
    slong bits = atoi(strrchr(words[1], '-') + 1);
    Problems problems = read_problems(words[2], 2);
    size_t lines = problems.lines;
    arb_ptr balls = _arb_vec_init(2 * lines);
    mpfr_t *numbers = (mpfr_t *)malloc(2 * lines * sizeof *numbers), p, q;
    arb_t x, y;
    arb_init(x), arb_init(y), mpfr_init2(p, bits), mpfr_init2(q, bits);
    for (size_t i = 0; i < 2 * lines; i++) {
        set_ball(balls + i, problems.words[i], bits);
        mpfr_init2(numbers[i], bits), arf_get_mpfr(numbers[i], arb_midref(balls + i), MPFR_RNDN);
    }
    for (int which = 0; which < OPERATIONS; which++) {
        double best[2] = {1e9, 1e9};
        char name[40];
        for (int side = 0; side < 2; side++)
            for (double start = now(); now() - start < 0.1;) {
                double since = now();
                for (size_t i = 0; i < lines; i++)
                    side ? on_numbers(which, p, q, numbers[2 * i], numbers[2 * i + 1])
                         : on_balls(which, x, y, balls + 2 * i, balls + 2 * i + 1, bits);
                double took = now() - since;
                if (took < best[side]) best[side] = took;
            }
        snprintf(name, sizeof name, "mpfr %s", names[which]);
        print_seconds(names[which], best[0] / lines), print_seconds(name, best[1] / lines);
        for (size_t i = 0; i < lines && answers; i++) {
            on_balls(which, x, y, balls + 2 * i, balls + 2 * i + 1, bits);
            printf("{\"task\": \"%s\", \"answer\": [", names[which]), print_ball(x);
            if (which == 4) printf(", "), print_ball(y);
            printf("]}\n");
        }
    }
    return 0;
}
