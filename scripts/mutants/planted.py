"""Defects of which a list says file, old and new text, as switches of the same program.

Of the difference of old and new the smallest expression around it is exchanged. A file of `data/` is
exchanged where it is built in, and a source that tests read as text where they read it.
"""

import collections
import pathlib
import tomllib

from . import build, run, sample, switch

LIST = pathlib.Path(__file__).with_name("planted.toml")
BUILT_IN = "src/ledger/paper.rs"


class Planted(sample.Sample):
    """The defects of the list."""

    def __init__(self, root):
        self.files, self.edits, self.mutants, self.unswitched = {}, collections.defaultdict(list), {}, []
        self.variants, self.at_run_time = {}, {}
        for number, defect in enumerate(tomllib.loads(LIST.read_text())["defect"], 1):
            text = (root / defect["file"]).read_text()
            if text.count(defect["old"]) != 1:
                raise SystemExit(f"planted: {defect['file']} holds {text.count(defect['old'])} times: {defect['old']}")
            self.mutants[number] = {"room": defect["kind"], "name": f"{defect['file']}: {defect['new']}"}
            changed = text.replace(defect["old"], defect["new"])
            if defect.get("read_at_run_time"):
                self.at_run_time[number] = (defect["file"], changed)
            elif defect["file"].startswith("data/"):
                self.variants[number] = (defect["file"], changed)
            else:
                self.plant(root, number, defect, text, changed)
        self.plant_data(root)

    def plant(self, root, number, defect, text, changed):
        name = defect["file"]
        file = self.files.setdefault(name, switch.File((root / name).read_bytes()))
        edit = file.exchange(text.encode(), changed.encode())
        if not switch.disjoint(edit, self.edits[name]):
            raise SystemExit(f"planted: two defects in one expression of {name}")
        edit.number = number
        self.edits[name].append(edit)

    def plant_data(self, root):
        file = self.files.setdefault(BUILT_IN, switch.File((root / BUILT_IN).read_bytes()))
        of_file = collections.defaultdict(list)
        for number, (name, _) in self.variants.items():
            of_file[name].append(number)
        for name, numbers in of_file.items():
            old = f'include_str!("../../{name}")'
            start = file.source.index(old.encode())
            chain = "".join(
                f'if {switch.SWITCH}({n}) {{{{ include_str!("../../{name}.{n}") }}}} else ' for n in numbers
            )
            self.edits[BUILT_IN].append(file.made(start, start + len(old), f"({chain}{{{{ {old} }}}})"))

    def write(self, root, folder):
        for number, (name, text) in self.variants.items():
            sample.put(folder / f"{name}.{number}", text.encode())
        super().write(root, folder)


def fate(planted, suite, folder, plain, reach, number):
    """What notices a defect; one that tests read as text is put into a plain copy meanwhile."""
    if number not in planted.at_run_time:
        return run.fate(folder, reach, number)
    name, text = planted.at_run_time[number]
    kept = (plain / name).read_text()
    (plain / name).write_text(text)
    found, _ = run.run((suite, "architecture"), plain, {}, 300, 1)
    (plain / name).write_text(kept)
    return None if found == "passed" else found


def main(root, folder, say):
    planted = Planted(root)
    sample.copy(root, folder, planted.switched())
    planted.write(root, folder)
    plain = folder.with_name("plain-tree")
    sample.copy(root, plain)
    programs = build.programs(folder)
    suite = next(program for program in programs if "/suite-" in program)
    reach = run.Reach(programs, folder, say)
    print("| defect | planted | noticed by |\n| --- | --- | --- |")
    missed = 0
    for number, defect in planted.mutants.items():
        found = fate(planted, suite, folder, plain, reach, number)
        missed += found is None
        what = " ".join(defect["name"].split())
        print(f"| {defect['room']} | `{what}` | {f'`{found}`' if found else 'no test'} |", flush=True)
    return 1 if missed else 0
