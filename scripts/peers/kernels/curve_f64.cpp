/* 10 000 points of a centerpoint curve in doubles, homogeneous coordinates, in lanes.

   The curve Re(conj(alpha) z)|z|^2 + beta |z|^2 + Re(conj(nu) z) = 0, z from the focus. The line through the focus in
   the direction e^{i psi} e^{i eta}, 2 psi the argument of alpha nu, meets it at r with
   Re(conj(alpha) e) r^2 + beta r + Re(conj(nu) e) = 0, whose discriminant is m + d - 2 d cos(eta)^2, d = 2 |alpha nu|,
   m = beta^2 - 2 Re(conj(alpha) nu). Two branches: its two roots; one: cos(eta) = kappa cos(theta). Of the two ways to
   write a root that is taken which loses nothing. The loops below are plain; the compiler makes lanes of them. */
#include <cmath>
#include <complex>
#include "kernel.h"

using Complex = std::complex<double>;
enum { POINTS = 10000 };
static double cosine[POINTS], sine[POINTS], x[POINTS], y[POINTS], w[POINTS];

struct Curve { Complex focus, alpha, nu, axis; double beta, kappa, modulus, reach; int branches; };

static Curve prepared(char **words)
{
    double k[7];
    for (int i = 0; i < 7; i++) k[i] = as_double(words[i]);
    Curve c = {{k[0], k[1]}, {k[2], k[3]}, {k[5], k[6]}, 1, k[4], 1, 1, 1, 1};
    const Complex product = c.alpha * c.nu;
    const double length = std::abs(product), mean = c.beta * c.beta - 2 * std::real(std::conj(c.alpha) * c.nu);
    c.branches = mean > 2 * length ? 2 : 1;
    c.kappa = std::sqrt((mean + 2 * length) / (4 * length));
    c.modulus = 4 * length / (mean + 2 * length);
    c.reach = std::sqrt(mean + 2 * length);
    c.axis = std::real(product) < 0 ? Complex(std::imag(product), length - std::real(product))
                                    : Complex(length + std::real(product), std::imag(product));
    c.axis /= std::abs(c.axis);
    return c;
}

/* One branch; `sign` is that of the root of the discriminant where there are two. */
template <bool two> static void branch(const Curve &c, double sign, int count, double *__restrict px, double *__restrict py, double *__restrict pw)
{
    const double ar = c.alpha.real(), ai = c.alpha.imag(), nr = c.nu.real(), ni = c.nu.imag(), beta = c.beta;
    const double er = c.axis.real(), ei = c.axis.imag(), fr = c.focus.real(), fi = c.focus.imag();
    const double reach = two ? sign * c.reach : c.reach, modulus = c.modulus, kappa = c.kappa;
#pragma omp simd
    for (int i = 0; i < count; i++) {
        const double co = two ? cosine[i] : kappa * cosine[i];
        const double si = two ? sine[i] : std::sqrt(1 - co * co);
        const double root = two ? reach * std::sqrt(1 - modulus * co * co) : reach * sine[i];
        const double dx = er * co - ei * si, dy = er * si + ei * co;
        const bool opposite = beta * root <= 0;
        const double r = opposite ? root - beta : 2 * (nr * dx + ni * dy);
        const double v = opposite ? 2 * (ar * dx + ai * dy) : -(root + beta);
        px[i] = fr * v + r * dx, py[i] = fi * v + r * dy, pw[i] = v;
    }
}

static void trace(const Curve &c)
{
    if (c.branches == 1) return branch<false>(c, 1, POINTS, x, y, w);
    const double open = c.beta < 0 ? 1 : -1;
    branch<true>(c, open, POINTS / 2, x, y, w);
    branch<true>(c, -open, POINTS / 2, x + POINTS / 2, y + POINTS / 2, w + POINTS / 2);
}

int main(int count, char **words)
{
    const int answers = wants_answers(count, words);
    const Problems problems = read_problems(words[2], 7);
    auto *times = static_cast<double *>(malloc(problems.lines * sizeof(double)));
    for (size_t i = 0; i < problems.lines; i++) {
        const Curve curve = prepared(problems.words + 7 * i);
        const double half = POINTS / 2 / curve.branches;
        for (int k = 0; k < 2 * half; k++) {
            const double n = k - half, size = half * half + n * n;
            cosine[k] = (half * half - n * n) / size, sine[k] = 2 * n * half / size;
        }
        times[i] = 1e9;
        for (int k = 0; k < 100; k++) {
            const double since = now();
            trace(curve);
            __asm__ volatile("" ::: "memory");
            times[i] = std::fmin(times[i], now() - since);
        }
        if (!answers) continue;
        printf("{\"task\": \"points\", \"answer\": [");
        for (int k = 0; k < POINTS; k++) printf("%s[%.17g, %.17g, %.17g]", k ? ", " : "", x[k], y[k], w[k]);
        printf("]}\n");
    }
    print_seconds("points", median(times, problems.lines));
}
