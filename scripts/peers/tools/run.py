"""What all Python programs here share: the same call and the same lines as the kernels (kernels/kernel.h)."""

import json
import pathlib
import statistics
import sys
import time

# Seconds that this thread has had a processor for: others on the machine do not count.
clock = time.thread_time


def arguments():
    """The row, the words of every line, and whether answers are wanted."""
    row, file, what = sys.argv[1:4]
    return row, [line.split() for line in pathlib.Path(file).read_text().splitlines()], what == "answers"


def say(task, seconds):
    print(json.dumps({"task": task, "seconds": seconds}), flush=True)


def answer(task, value):
    print(json.dumps({"task": task, "answer": value}))


def quickest(solve, least=3, seconds=0.1):
    """The quickest of at least so many calls in at least so much time."""
    best, count, start = float("inf"), 0, clock()
    while count < least or clock() - start < seconds:
        since = clock()
        solve()
        best = min(best, clock() - since)
        count += 1
    return best


def each(task, problems, solve, written, answers):
    """Every problem by itself, three times, the quickest; of these the median."""
    say(task, statistics.median(quickest(lambda: solve(problem), 3, 0) for problem in problems))
    for problem in problems if answers else ():
        answer(task, written(solve(problem)))
