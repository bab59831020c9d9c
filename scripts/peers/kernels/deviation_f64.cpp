/* Travel u and deviation v of one linkage at the 360 whole degrees of its crank, in doubles, in lanes.

   n = m - Re(g e), u + iv = k + a e + (b - d e)(n + c +- i sqrt(F))/(2n), F = (n - low)(high - n), with e of the crank's
   angle: one root and one division a position. The loop is plain; the compiler makes lanes of it. */
#include <cmath>
#include "kernel.h"

enum { POINTS = 360, NUMBERS = 15 };
alignas(64) static double cosine[POINTS], sine[POINTS];
struct Linkage { double k[2], a[2], b[2], d[2], m, g[2], c, low, high, side; };

static __attribute__((noinline)) void places(const Linkage &l, double *__restrict u, double *__restrict v)
{
    const Linkage o = l;
#pragma omp simd
    for (int i = 0; i < POINTS; i++) {
        const double co = cosine[i], si = sine[i];
        const double n = o.m - (o.g[0] * co - o.g[1] * si), half = 0.5 / n;
        const double along = (n + o.c) * half, across = std::sqrt((n - o.low) * (o.high - n)) * (half * o.side);
        const double x = o.b[0] - (o.d[0] * co - o.d[1] * si), y = o.b[1] - (o.d[0] * si + o.d[1] * co);
        u[i] = o.k[0] + (o.a[0] * co - o.a[1] * si) + (x * along - y * across);
        v[i] = o.k[1] + (o.a[0] * si + o.a[1] * co) + (x * across + y * along);
    }
}

int main(int count, char **words)
{
    const int answers = wants_answers(count, words);
    const Problems problems = read_problems(words[2], NUMBERS);
    auto *linkages = static_cast<Linkage *>(malloc(problems.lines * sizeof(Linkage)));
    for (size_t i = 0; i < NUMBERS * problems.lines; i++) reinterpret_cast<double *>(linkages)[i] = as_double(problems.words[i]);
    for (int i = 0; i < POINTS; i++) cosine[i] = std::cos(i * (M_PI / 180)), sine[i] = std::sin(i * (M_PI / 180));
    alignas(64) static double u[POINTS], v[POINTS];
    double best = 1e9;
    for (double start = now(); now() - start < 0.1;) {
        const double since = now();
        for (size_t i = 0; i < problems.lines; i++) {
            places(linkages[i], u, v);
            __asm__ volatile("" ::: "memory");
        }
        best = std::fmin(best, now() - since);
    }
    print_seconds("places", best / problems.lines);
    for (size_t i = 0; i < problems.lines && answers; i++) {
        places(linkages[i], u, v);
        printf("{\"task\": \"places\", \"answer\": [[");
        for (int k = 0; k < POINTS; k++) printf("%s%.17g", k ? ", " : "", u[k]);
        printf("], [");
        for (int k = 0; k < POINTS; k++) printf("%s%.17g", k ? ", " : "", v[k]);
        printf("]]}\n");
    }
}
