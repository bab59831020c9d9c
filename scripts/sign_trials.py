#!/usr/bin/env python3
"""Changes one sign at a time in a copy of the tree and says which tests notice.

    python3 scripts/sign_trials.py [--target-dir DIR] [--only WORD]

Exit status 1 where a change is noticed by no test, 2 where a change cannot be made: its text does
not stand in its file exactly once, or the tests do not even pass without any change.
"""

import argparse
import os
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile

ROOT = pathlib.Path(__file__).resolve().parent.parent
TESTS = ["plane", "scenes", "verdicts"]
TIME_LIMIT = 900

# file, old text, new text
CHANGES = [
    ("src/linkage/five_bar.rs", "let q_to_f = -(&to_n * &w);", "let q_to_f = &to_n * &w;"),
    ("src/linkage/five_bar.rs", "let n = &q + to_n.scaled(&lengths.n);", "let n = &q - to_n.scaled(&lengths.n);"),
    ("src/linkage/five_bar.rs", "(rate(&with_omega), -rate(&with_turn))", "(rate(&with_omega), rate(&with_turn))"),
    ("src/linkage/five_bar.rs", "from_m - 2 * s * x + s.square()", "from_m + 2 * s * x + s.square()"),
    ("src/linkage/five_bar.rs", "(first.0 - second.0) / (2 *", "(first.0 + second.0) / (2 *"),
    ("src/linkage/focal_mechanism.rs", "(m + p * q / n, n + p * q / m)", "(m - p * q / n, n + p * q / m)"),
    ("src/linkage/focal_mechanism.rs", "(m + p * q / n, n + p * q / m)", "(m + p * q / n, n - p * q / m)"),
    ("src/plane/angle.rs", "Self::of((to - vertex) * (from - vertex).conj())", "Self::of((to - vertex) * (from + vertex).conj())"),
    ("src/plane/angle.rs", "self.direction.re() + self.length(),", "self.direction.re() - self.length(),"),
    ("src/plane/angle.rs", "Self::from_cos_sin((1 - t.square()) / &scale, 2 * t / &scale)", "Self::from_cos_sin((1 - t.square()) / &scale, -2 * t / &scale)"),
    ("src/plane/angle.rs", "power.im().is_zero() & power.re().is_positive()", "power.im().is_zero() & (-power.re()).is_positive()"),
    ("src/plane/relation.rs", "((b - a).conj() * (c - a)).im().clone()", "((b - a).conj() * (c + a)).im().clone()"),
    ("src/plane/relation.rs", "let cross = (a - c) * (b - d) *", "let cross = (a - c) * (b + d) *"),
    ("src/plane/relation.rs", "((b - a) * (c1 - a1)).equals(", "((b + a) * (c1 - a1)).equals("),
    ("src/plane/displacement.rs", "(&self.translation - &other.translation)", "(&self.translation + &other.translation)"),
    ("src/plane/displacement.rs", "&self.rotation * point + &self.translation", "&self.rotation * point - &self.translation"),
    ("src/curvature/slider_crank.rs", "sa * (sa * cd + 3 * sd * ca - k_sin)", "sa * (sa * cd + 3 * sd * ca + k_sin)"),
    ("src/curvature/slider_crank.rs", "let absolute = ca * (sd * ca - k_sin);", "let absolute = ca * (sd * ca + k_sin);"),
    ("src/curvature/slider_crank.rs", "Quotient::new(k.clone(), k + 4)", "Quotient::new(k.clone(), k - 4)"),
    ("src/curvature/slider_crank.rs", "Quotient::new(k.clone(), 2 * k - 1)", "Quotient::new(k.clone(), 2 * k + 1)"),
    ("src/curvature/slider_crank.rs", "let denominator = 2 * &k_sin - 3 * sd * ca;", "let denominator = 2 * &k_sin + 3 * sd * ca;"),
    ("src/scenes/wunderlich1968/focal_mechanism.rs", 'bindings.bind("BT", -t_from_b);', 'bindings.bind("BT", t_from_b);'),
    ("src/scenes/wunderlich1968/focal_mechanism.rs", 'bindings.bind("NS", &s - &position.d);', 'bindings.bind("NS", &s + &position.d);'),
    ("src/scenes/wunderlich1968/five_bar.rs", 'bindings.bind("NS", &s - d);', 'bindings.bind("NS", &s + d);'),
    ("src/scenes/wunderlich1968/position.rs", "Angle::of(&q - &base)", "Angle::of(&q + &base)"),
    ("src/scenes/wunderlich1968/coupler.rs", "Point::from(d.clone()) + v.scaled(&b)", "Point::from(d.clone()) - v.scaled(&b)"),
    ("src/scenes/wunderlich1968/symmetric_crank_drive.rs", "let y = half(&h_1 - &h_2);", "let y = half(&h_1 + &h_2);"),
    ("src/scenes/wunderlich1968/hart_kite.rs", "let q = -(&m * &p / &n);", "let q = &m * &p / &n;"),
    ("src/scenes/filemon1973/pole_quadrilateral.rs", "let longest = -smaller(&-&long, &-&h)?;", "let longest = smaller(&long, &h)?;"),
    ("src/scenes/filemon1973/pole_quadrilateral.rs", "let u = shortest + longest;", "let u = shortest - longest;"),
]


def stop(message):
    print(f"sign_trials: {message}", file=sys.stderr)
    sys.exit(2)


def changed(file, old, new):
    """The text of the file with the change made."""
    try:
        text = (ROOT / file).read_text(encoding="utf-8")
    except OSError as error:
        stop(f"{file}: {error.strerror}")
    if text.count(old) != 1:
        stop(f"{file}: `{old}` stands there {text.count(old)} times, expected once")
    return text.replace(old, new)


def run(copy, target):
    """The names of the tests that fail; None where the code does not even compile."""
    command = ["cargo", "test", "--quiet", "--no-fail-fast", "--offline"]
    command += [word for test in TESTS for word in ("--test", test)]
    # Most of the time goes into compiling, so without optimisation.
    environment = dict(os.environ, CARGO_TARGET_DIR=str(target), CARGO_PROFILE_DEV_OPT_LEVEL="0",
                       RUST_BACKTRACE="0", PROPTEST_CASES="64")
    try:
        done = subprocess.run(command, cwd=copy, env=environment, text=True, timeout=TIME_LIMIT,
                              stdout=subprocess.PIPE, stderr=subprocess.STDOUT)
    except subprocess.TimeoutExpired:
        return ["(no end in time)"]
    if done.returncode == 0:
        return []
    failed = re.findall(r"^    ([a-z_:0-9]+)$", done.stdout, re.M)
    if not failed:
        print(done.stdout[-4000:], file=sys.stderr)
        return None
    return sorted(set(failed))


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--target-dir", default=tempfile.gettempdir() + "/sign-trials")
    parser.add_argument("--only", default="", help="changes in files whose name contains this")
    options = parser.parse_args()
    # Every change is looked for before the first build.
    trials = [(file, old, new, changed(file, old, new)) for file, old, new in CHANGES
              if options.only in file]
    if not trials:
        stop(f"no change is in a file whose name contains `{options.only}`")
    survivors = 0
    with tempfile.TemporaryDirectory(prefix="sign-trials-") as folder:
        copy = pathlib.Path(folder) / "tree"
        # Copied as new files: what an earlier trial left in the target directory is then out of date.
        shutil.copytree(ROOT, copy, ignore=shutil.ignore_patterns("target", ".git"),
                        copy_function=shutil.copyfile)
        before = run(copy, options.target_dir)
        if before is None or before:
            stop(f"without any change there fail: {before or 'the build'}")
        for file, old, new, text in trials:
            place = copy / file
            kept = place.read_text(encoding="utf-8")
            place.write_text(text, encoding="utf-8")
            failed = run(copy, options.target_dir)
            place.write_text(kept, encoding="utf-8")
            print(f"{file}: {old}  →  {new}")
            if failed is None:
                stop("this change does not compile")
            survivors += not failed
            more = f" and {len(failed) - 3} more" if len(failed) > 3 else ""
            print("    " + (", ".join(failed[:3]) + more if failed else "NOTICED BY NO TEST"), flush=True)
    print(f"{len(trials)} changes, {survivors} noticed by no test")
    sys.exit(1 if survivors else 0)


if __name__ == "__main__":
    main()
