"""pylinkage, the best-known Python library for linkages, by the functions that its documentation names.

`compute_circle_point_curve(poses)` is its "main entry point for Burmester theory" and returns circle
points as they lie in the first position, with their centers; `compute_all_poles(poses)` returns the
poles, infinite ones without a direction (these are left out here). For five positions version 1.3.0
searches a grid of circle points and keeps those whose radii agree within one percent.

Installed with `pip install pylinkage scipy` (without scipy its synthesis cannot be imported); tried with
Python 3.11.7, pylinkage 1.3.0, numpy 2.4.6.
"""

import cmath
import itertools

from pylinkage.synthesis.burmester import compute_all_poles, compute_circle_point_curve
from pylinkage.synthesis._types import Pose

from protocol import Skipped, positions, serve


def poses_of(problem):
    return [Pose(t.real, t.imag, cmath.phase(r)) for r, t in positions(problem)]


def coordinates(z):
    return [float(z.real), float(z.imag)]


def pairs(problem):
    r, t = positions(problem)[0]
    found = []
    for dyad in compute_circle_point_curve(poses_of(problem)).get_all_dyads():
        circlepoint = (dyad.circle_point - t) / r
        found.append({"circlepoint": coordinates(circlepoint), "center": coordinates(dyad.center_point)})
    return {"pairs": found}


def poles(problem):
    poses = poses_of(problem)
    labels = itertools.combinations(range(1, len(poses) + 1), 2)
    found = zip(labels, compute_all_poles(poses))
    return {"poles": {f"{i}{j}": coordinates(p) for (i, j), p in found if cmath.isfinite(p)}}


def solve(problem):
    tasks = {"five-positions": pairs, "poles": poles}
    if problem["problem"] not in tasks:
        raise Skipped("not offered")
    return tasks[problem["problem"]](problem)


serve(solve)
