/* What all kernels share: problems as lines of numbers p/q, the clock, the lines that go out.

   A kernel is called with a row's name, a file of problems and the word `answers` or `times`. It prints a line
   {"task": ..., "seconds": ...} for each of its tasks, and after the word `answers` a line
   {"task": ..., "answer": [...]} for each problem. */
#ifndef KERNEL_H
#define KERNEL_H
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>

/* Seconds that this program has had a processor for: others on the machine do not count. */
static inline double now(void)
{
    struct timespec t;
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &t);
    return t.tv_sec + 1e-9 * t.tv_nsec;
}

static int ascending(const void *a, const void *b)
{
    double x = *(const double *)a, y = *(const double *)b;
    return (x > y) - (x < y);
}

static inline double median(double *x, size_t n)
{
    qsort(x, n, sizeof *x, ascending);
    return n % 2 ? x[n / 2] : (x[n / 2 - 1] + x[n / 2]) / 2;
}

/* The words of all lines, `width` of them in each; ends the program where a line has another number. */
typedef struct { size_t lines, width; char **words; } Problems;

static inline Problems read_problems(const char *file, size_t width)
{
    FILE *f = fopen(file, "r");
    Problems p = {0, width, NULL};
    char *line = NULL, *rest, *word;
    size_t room = 0, taken = 0;
    if (!f) { perror(file); exit(2); }
    while (getline(&line, &room, f) > 0) {
        size_t count = 0;
        for (word = strtok_r(line, " \n", &rest); word; word = strtok_r(NULL, " \n", &rest), count++) {
            if (taken % 1024 == 0) p.words = (char **)realloc(p.words, (taken + 1024) * sizeof *p.words);
            p.words[taken++] = strdup(word);
        }
        if (count != width) { fprintf(stderr, "%s: a line of %zu numbers, not %zu\n", file, count, width); exit(2); }
        p.lines++;
    }
    fclose(f);
    free(line);
    return p;
}

/* The double nearest p/q: both are exact, so that one division rounds. */
static inline double as_double(const char *text)
{
    char *end;
    double p = strtod(text, &end);
    return *end == '/' ? p / strtod(end + 1, NULL) : p;
}

static inline void print_seconds(const char *task, double seconds)
{
    printf("{\"task\": \"%s\", \"seconds\": %.9e}\n", task, seconds);
}

static inline int wants_answers(int count, char **words)
{
    if (count != 4) { fprintf(stderr, "usage: %s ROW FILE answers|times\n", words[0]); exit(2); }
    return strcmp(words[3], "answers") == 0;
}
#endif
