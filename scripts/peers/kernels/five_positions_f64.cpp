/* Five positions in doubles: all Burmester pairs, one problem after the other.

   The differences of |r z + t - M|^2 between positions are linear in X, Y, p, q and 1, x, y (p + iq = z conj(M));
   Gauss with pivots gives X, Y, p, q as linear forms; p = xX + yY and q = yX - xY are two quadratic equations in y,
   their resultant a quartic in x. Roots by Ferrari's formula in real arithmetic, improved by Newton's method;
   y, X and Y follow. Lengths are measured in that of the largest translation. */
#include <cmath>
#include <complex>
#include <utility>
#include "kernel.h"

using Complex = std::complex<double>;
struct Position { double c, s, a, b; };
struct Pairs { Complex at[4][4]; int count, real; };

static inline Complex times(Complex z, Complex w)
{
    return {z.real() * w.real() - z.imag() * w.imag(), z.real() * w.imag() + z.imag() * w.real()};
}

static inline Complex over(Complex z, Complex w)
{
    double n = 1 / (w.real() * w.real() + w.imag() * w.imag());
    return {(z.real() * w.real() + z.imag() * w.imag()) * n, (z.imag() * w.real() - z.real() * w.imag()) * n};
}

/* The linear forms, rows X, Y, p, q; false where there are none. */
static inline bool forms_of(const Position *at, double form[4][3])
{
    double m[4][7], base[7];
    for (int j = 0; j < 5; j++) {
        const auto [c, s, a, b] = at[j];
        const double row[7] = {-2 * a, -2 * b, -2 * c, 2 * s, a * a + b * b, 2 * (a * c + b * s), 2 * (b * c - a * s)};
        for (int k = 0; k < 7; k++) j ? m[j - 1][k] = row[k] - base[k] : base[k] = row[k];
    }
    for (int i = 0; i < 4; i++) {
        int best = i;
        for (int k = i + 1; k < 4; k++) if (std::fabs(m[k][i]) > std::fabs(m[best][i])) best = k;
        if (m[best][i] == 0) return false;
        if (best != i) for (int k = i; k < 7; k++) std::swap(m[i][k], m[best][k]);
        const double inverse = 1 / m[i][i];
        for (int k = i + 1; k < 7; k++) m[i][k] *= inverse;
        for (int j = 0; j < 4; j++) {
            if (j == i) continue;
            const double factor = m[j][i];
            for (int k = i + 1; k < 7; k++) m[j][k] -= factor * m[i][k];
        }
    }
    for (int i = 0; i < 4; i++) for (int k = 0; k < 3; k++) form[i][k] = -m[i][k + 4];
    return true;
}

/* The largest root of w^3 + b w^2 + c w + d, which is real and not negative for d <= 0. */
static inline double largest_root(double b, double c, double d)
{
    const double q = (b * b - 3 * c) / 9, r = (2 * b * b * b - 9 * b * c + 27 * d) / 54, under = r * r - q * q * q;
    if (under < 0) return 2 * std::sqrt(q) * std::cos(std::acos(-r / (q * std::sqrt(q))) / 3) - b / 3;
    const double k = std::cbrt(std::fabs(r) + std::sqrt(under)), u = r > 0 ? -k : k;
    return u + (u != 0 ? q / u : 0) - b / 3;
}

/* Both roots of z^2 + b z + c; of conjugate ones the upper stands first. */
static inline void square_roots(double b, double c, Complex *z)
{
    const double half = -b / 2, under = half * half - c;
    if (under < 0) {
        z[0] = {half, std::sqrt(-under)}, z[1] = std::conj(z[0]);
        return;
    }
    const double far = half + std::copysign(std::sqrt(under), half);
    z[0] = far, z[1] = far != 0 ? c / far : 0;
}

/* All roots of x^4 + b x^3 + c x^2 + d x + e. */
static inline void roots_of(double b, double c, double d, double e, Complex *z)
{
    const double p = c - 0.375 * b * b, q = d - 0.5 * b * c + 0.125 * b * b * b;
    const double r = e - 0.25 * b * d + b * b * c / 16 - 3 * b * b * b * b / 256;
    const double w2 = std::fmax(largest_root(2 * p, p * p - 4 * r, -q * q), 0), w = std::sqrt(w2), u = w > 0 ? q / w : 0;
    const double rest = (p + w2) / 2;
    square_roots(-w, rest + u / 2, z);
    square_roots(w, rest - u / 2, z + 2);
    for (int i = 0; i < 4; i++) {
        z[i] -= b / 4;
        if (z[i].imag() < 0) continue;
        for (int step = 0; step < 2; step++) {
            if (z[i].imag() == 0) {
                const double x = z[i].real(), slope = ((4 * x + 3 * b) * x + 2 * c) * x + d;
                if (slope != 0) z[i] -= ((((x + b) * x + c) * x + d) * x + e) / slope;
            } else {
                const Complex x = z[i];
                const Complex value = times(times(times(x + b, x) + c, x) + d, x) + e;
                z[i] -= over(value, times(times(4.0 * x + 3 * b, x) + 2 * c, x) + d);
            }
        }
    }
}

static inline bool solve(const Position *given, Pairs &pairs)
{
    /* Lengths and origin with which the numbers are about one. */
    double size = 0;
    Position at[5];
    for (int i = 1; i < 5; i++) size = std::fmax(size, std::hypot(given[i].a - given[0].a, given[i].b - given[0].b));
    for (int i = 0; i < 5; i++) at[i] = {given[i].c, given[i].s, (given[i].a - given[0].a) / size, (given[i].b - given[0].b) / size};
    double form[4][3];
    if (!forms_of(at, form)) return false;
    const auto [x0, x1, x2] = form[0]; const auto [y0, y1, y2] = form[1];
    const auto [p0, p1, p2] = form[2]; const auto [q0, q1, q2] = form[3];
    const double a = y2, b0 = y0 - p2, b1 = x2 + y1, c0 = -p0, c1 = x0 - p1, c2 = x1;
    const double e = x2, f0 = x0 - q2, f1 = x1 - y2, g0 = -q0, g1 = -y0 - q1, g2 = -y1;
    const double u0 = a * g0 - e * c0, u1 = a * g1 - e * c1, u2 = a * g2 - e * c2;
    const double v0 = a * f0 - e * b0, v1 = a * f1 - e * b1;
    const double w0 = b0 * g0 - f0 * c0, w1 = b0 * g1 + b1 * g0 - f0 * c1 - f1 * c0;
    const double w2 = b0 * g2 + b1 * g1 - f0 * c2 - f1 * c1, w3 = b1 * g2 - f1 * c2;
    const double inverse = 1 / (u2 * u2 - v1 * w3);
    Complex x[4];
    roots_of((2 * u1 * u2 - v0 * w3 - v1 * w2) * inverse, (u1 * u1 + 2 * u0 * u2 - v0 * w2 - v1 * w1) * inverse,
             (2 * u0 * u1 - v0 * w1 - v1 * w0) * inverse, (u0 * u0 - v0 * w0) * inverse, x);
    pairs.count = pairs.real = 0;
    for (int i = 0; i < 4; i++) {
        if (x[i].imag() < 0) continue;
        pairs.real += x[i].imag() == 0;
        Complex *to = pairs.at[pairs.count++];
        const Complex y = -over(times(u2 * x[i] + u1, x[i]) + u0, v1 * x[i] + v0);
        to[0] = size * x[i], to[1] = size * y;
        to[2] = size * (x1 * x[i] + x2 * y + x0) + given[0].a, to[3] = size * (y1 * x[i] + y2 * y + y0) + given[0].b;
    }
    return true;
}

int main(int count, char **words)
{
    const int answers = wants_answers(count, words);
    const Problems problems = read_problems(words[2], 20);
    auto *numbers = static_cast<Position *>(malloc(5 * problems.lines * sizeof(Position)));
    for (size_t i = 0; i < 5 * problems.lines; i++) {
        char **w = problems.words + 4 * i;
        numbers[i] = {as_double(w[0]), as_double(w[1]), as_double(w[2]), as_double(w[3])};
    }
    auto *pairs = static_cast<Pairs *>(malloc(problems.lines * sizeof(Pairs)));
    double best = 1e9;
    for (double start = now(); now() - start < 0.1;) {
        const double since = now();
        for (size_t i = 0; i < problems.lines; i++)
            if (!solve(numbers + 5 * i, pairs[i])) return fprintf(stderr, "problem %zu is not solved\n", i + 1), 1;
        best = std::fmin(best, now() - since);
    }
    print_seconds("many", best / problems.lines);
    print_seconds("one", best / problems.lines);
    for (size_t i = 0; i < problems.lines && answers; i++) {
        printf("{\"task\": \"many\", \"answer\": [");
        for (int k = 0; k < pairs[i].count; k++) {
            printf(k ? ", [" : "[");
            for (int j = 0; j < 4; j++)
                printf("%s[%.17g, %.17g]", j ? ", " : "", pairs[i].at[k][j].real(), pairs[i].at[k][j].imag());
            printf("]");
        }
        printf("]}\n");
    }
}
