"""Running the tests against one mutant at a time, those that reach it, until one fails."""

import concurrent.futures
import os
import pathlib
import re
import resource
import signal
import subprocess
import tempfile
import threading
import time

# They read the source itself, or build.
NOT_RUN = {"architecture", "dependencies", "examples", "fuzzed", "robustness", "schemas"}
MEMORY = 6 << 30


def limited():
    os.setsid()
    resource.setrlimit(resource.RLIMIT_AS, (MEMORY, MEMORY))


def modules(program, folder):
    """Of a test program, as (program, name)."""
    text = subprocess.run([program, "--list"], cwd=folder, capture_output=True, text=True, check=True).stdout
    names = {line.split("::")[0] for line in text.splitlines() if "::" in line}
    return [(program, name) for name in sorted(names - NOT_RUN)]


def run(part, folder, environment, seconds, threads):
    """`passed`, the name of the first test that fails, `timeout` or `crash`; and how long it took."""
    start = time.monotonic()
    program, module = part
    process = subprocess.Popen(
        [program, f"{module}::", "--test-threads", str(threads)],
        cwd=folder, env={**os.environ, "PROPTEST_FAILURE_PERSISTENCE": "off", **environment},
        stdout=subprocess.PIPE, stderr=subprocess.DEVNULL, text=True, preexec_fn=limited,
    )
    late = threading.Event()

    def stop():
        late.set()
        os.killpg(process.pid, signal.SIGKILL)

    timer = threading.Timer(seconds, stop)
    timer.start()
    failed = None
    try:
        for line in process.stdout:
            if match := re.match(r"test (\S+) \.\.\. FAILED", line):
                failed = match[1]
                break
        else:
            process.wait()
    finally:
        timer.cancel()
        if process.poll() is None:
            os.killpg(process.pid, signal.SIGKILL)
            process.wait()
    taken = time.monotonic() - start
    if failed:
        return failed, taken
    if late.is_set():
        return f"timeout of {module}", taken
    return ("passed" if process.returncode == 0 else f"crash of {module}"), taken


class Reach:
    """Which mutants each module of the tests reaches, and how long it takes without any."""

    def __init__(self, programs, folder, say):
        self.seconds, self.reached = {}, {}
        for part in (part for program in programs for part in modules(program, folder)):
            with tempfile.TemporaryDirectory() as temporary:
                file = pathlib.Path(temporary) / "reached"
                found, taken = run(part, folder, {"BURMESTER_REACHED": str(file)}, 900, os.cpu_count())
                if found != "passed":
                    raise SystemExit(f"without any mutant: {found}")
                numbers = file.read_text().split() if file.exists() else []
            self.seconds[part] = taken
            self.reached[part] = set(map(int, numbers))
            say(f"{part[1]}: {taken:.1f} s, reaches {len(self.reached[part])}")

    def of(self, number):
        """Quickest first."""
        found = [part for part, numbers in self.reached.items() if number in numbers]
        return sorted(found, key=self.seconds.get)


def fate(folder, reach, number):
    """What notices the mutant; None if nothing does."""
    for part in reach.of(number):
        limit = 10 + 6 * reach.seconds[part]
        found, _ = run(part, folder, {"BURMESTER_MUTANT": str(number)}, limit, 1)
        if found != "passed":
            return found
    return None


def fates(folder, reach, numbers, jobs):
    """Of all, as they are known."""
    with concurrent.futures.ThreadPoolExecutor(jobs) as pool:
        futures = {pool.submit(fate, folder, reach, n): n for n in numbers}
        for done in concurrent.futures.as_completed(futures):
            yield futures[done], done.result()
