"""Building the copy with all switches, without the mutants that do not compile."""

import json
import os
import subprocess

PROFILE = [
    "--config", 'profile.mutants.inherits="dev"',
    "--config", "profile.mutants.debug=false",
    "--config", "profile.mutants.opt-level=1",
    "--profile", "mutants",
]


def cargo(folder, arguments):
    environment = dict(os.environ, CARGO_TARGET_DIR=str(folder / "target"), RUSTFLAGS="-Awarnings")
    return subprocess.Popen(
        ["cargo", *arguments, "--message-format=json"], cwd=folder, env=environment,
        stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True,
    )


def messages(folder, arguments):
    process = cargo(folder, arguments)
    out, err = process.communicate()
    found = [json.loads(line) for line in out.splitlines() if line.startswith("{")]
    return process.returncode, found, err


def places(found, of_help):
    """Files and lines that errors point at, or the help that comes with them."""
    for message in found:
        if message["reason"] != "compiler-message" or message["message"]["level"] != "error":
            continue
        error = message["message"]
        for part in error["children"] if of_help else [error]:
            for span in part["spans"]:
                yield span["file_name"], range(span["line_start"], span["line_end"] + 1)


def rendered(found):
    return "\n".join(m["message"]["rendered"] for m in found if m["reason"] == "compiler-message")


def without_errors(sample, root, folder, say):
    """Drops mutants until the rest compiles; the numbers of the dropped."""
    while True:
        sample.write(root, folder)
        status, found, err = messages(folder, ["check", "--lib", *PROFILE])
        if status == 0:
            return
        dropped = sample.drop(places(found, False)) or sample.drop(places(found, True))
        if not dropped:
            raise SystemExit("the copy does not compile, and not for a mutant:\n" + rendered(found)[-3000:])
        say(f"{len(dropped)} do not compile")


def programs(folder):
    """The paths of the test programs: the suite, and the tests beside the code."""
    status, found, err = messages(folder, ["test", "--no-run", "--lib", "--test", "suite", *PROFILE])
    if status:
        raise SystemExit("the tests do not compile:\n" + (rendered(found) or err)[-3000:])
    tests = [m for m in found if m["reason"] == "compiler-artifact" and m["profile"]["test"]]
    return [message["executable"] for message in tests if message["executable"]]
