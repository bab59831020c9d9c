"""The command: samples, builds, runs, and says which mutants no test notices."""

import argparse
import json
import os
import pathlib
import sys
import time
import tomllib

from . import build, planted, run, sample

ROOT = pathlib.Path(__file__).resolve().parents[2]
EQUIVALENT = pathlib.Path(__file__).with_name("equivalent.toml")


def arguments():
    parser = argparse.ArgumentParser(
        prog="python3 scripts/mutants",
        description="Mutation testing: draws mutants that cargo-mutants makes, builds one program with all of "
        "them behind switches, and runs the tests that reach a mutant until one fails. Status 1 if fewer than "
        "95 %% are noticed in some room, 2 if nothing can be built.",
    )
    parser.add_argument("rooms", nargs="*", metavar="ROOM", help=f"of src (default: {' '.join(sample.ROOMS)}), or `planted`: the defects of planted.toml instead")
    parser.add_argument("--sample", type=int, default=55, help="mutants of each room, or as many as compile (default 55)")
    parser.add_argument("--seed", type=int, default=1888)
    parser.add_argument("--only", metavar="TEXT", help="only mutants whose name holds this text")
    parser.add_argument("--again", type=pathlib.Path, metavar="FILE", help="only those that nothing had noticed when --json wrote this file")
    parser.add_argument("--jobs", type=int, default=os.cpu_count())
    parser.add_argument("--json", type=pathlib.Path, metavar="FILE", help="write what became of each")
    return parser.parse_args()


def say(text):
    print(f"{time.strftime('%H:%M:%S')} {text}", file=sys.stderr, flush=True)


def main():
    given = arguments()
    rooms = given.rooms or sample.ROOMS
    if rooms != ["planted"] and (unknown := [room for room in rooms if not (ROOT / "src" / room).is_dir()]):
        print(f"mutants: src has no room {unknown[0]}", file=sys.stderr)
        return 2
    folder = ROOT / "target" / "mutants-tree"
    if given.rooms == ["planted"]:
        return planted.main(ROOT, folder, say)
    mutants = sample.listed(ROOT)
    if given.only:
        mutants = [m for m in mutants if given.only in m["name"]]
    if given.again:
        before = [json.loads(line) for line in given.again.read_text().splitlines()]
        missed = {mutant["name"] for mutant in before if mutant["noticed_by"] is None}
        mutants = [m for m in mutants if m["name"] in missed]
    drawn = sample.Sample(ROOT, mutants, rooms, 2 * given.sample, given.seed)
    say(f"{len(drawn.mutants)} drawn of {len(mutants)}")
    sample.copy(ROOT, folder, drawn.switched())
    build.without_errors(drawn, ROOT, folder, say)
    drawn.keep(given.sample)
    say(f"{len(drawn.mutants)} chosen of those that compile; building the tests")
    reach = run.Reach(build.programs(folder), folder, say)
    found = {}
    for number, fate in run.fates(folder, reach, sorted(drawn.mutants), given.jobs):
        found[number] = fate
        name = drawn.mutants[number]["name"]
        say(f"{len(found)}/{len(drawn.mutants)} {'MISSED' if fate is None else fate}: {name}")
    if given.json:
        lines = [{**drawn.mutants[n], "noticed_by": found[n], "reached_by": [name for _, name in reach.of(n)]} for n in sorted(found)]
        given.json.write_text("".join(json.dumps(line) + "\n" for line in lines))
    return report(drawn, found, rooms)


def equivalents():
    """Names without places of those that change nothing."""
    return {(m["file"], m["change"]) for m in tomllib.loads(EQUIVALENT.read_text())["mutant"]}


def report(drawn, found, rooms):
    status, known = 0, equivalents()
    missed = [drawn.mutants[n] for n, fate in found.items() if fate is None]
    equivalent = [m for m in missed if (m["file"], sample.change(m)) in known]
    print("| room | mutants | noticed | equivalent | noticed of the others |\n|" + " --- |" * 5)
    for room in rooms:
        total, of_missed, same = (
            sum(mutant["room"] == room for mutant in mutants)
            for mutants in ([drawn.mutants[n] for n in found], missed, equivalent)
        )
        noticed, different = total - of_missed, total - same
        share = noticed / different if different else 1
        status |= share < 0.95
        print(f"| `{room}` | {total} | {noticed} | {same} | {100 * share:.1f} % |")
    rest = sorted(mutant["name"] for mutant in missed if mutant not in equivalent)
    if rest:
        print("\nNoticed by no test:")
        for name in rest:
            print(f"- {name}")
    return status
