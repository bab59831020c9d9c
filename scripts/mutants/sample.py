"""Which mutants: a seeded sample of those that cargo-mutants makes, in a copy of the tree."""

import collections
import hashlib
import json
import subprocess

from . import switch

ROOMS = ["number", "formula", "plane", "finite", "curvature", "linkage", "straight_line", "scenes", "ledger"]


def listed(root):
    """All mutants of cargo-mutants under its configuration, in its order."""
    run = subprocess.run(["cargo", "mutants", "--list", "--json"], cwd=root, capture_output=True, text=True)
    if run.returncode:
        raise SystemExit("cargo mutants --list failed (cargo install --locked cargo-mutants):\n" + run.stderr)
    return json.loads(run.stdout)


def copy(root, folder, switched=()):
    """The files of the project as they stand, into a folder that may hold an earlier copy, but for those
    that switches are written into."""
    run = subprocess.run(
        ["git", "ls-files", "--cached", "--others", "--exclude-standard"],
        cwd=root, capture_output=True, text=True, check=True,
    )
    names = {name for name in run.stdout.split("\n") if (root / name).is_file()}
    for old in (folder / "src").rglob("*.*"):
        if str(old.relative_to(folder)) not in names.union(switched):
            old.unlink()
    for name in names.difference(switched):
        put(folder / name, (root / name).read_bytes())


def put(path, content):
    """Unless it is there: the compiler goes by times."""
    if not path.exists() or path.read_bytes() != content:
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_bytes(content)


def change(mutant):
    """Its name without the place."""
    return mutant["name"].split(" ", 1)[1]


def chance(seed, mutant):
    """The same however the lines of the file move."""
    return hashlib.sha256(f"{seed} {mutant['file']} {change(mutant)}".encode()).digest()


class Sample:
    """The chosen mutants of all rooms and the switches that hold them."""

    def __init__(self, root, mutants, rooms, size, seed):
        self.files = {}
        self.edits = {}
        self.mutants = {}
        self.unswitched = []
        for room in rooms:
            of_room = [m for m in mutants if m["file"].startswith(f"src/{room}/")]
            of_room.sort(key=lambda mutant: chance(seed, mutant))
            self.draw(root, room, of_room, size)

    def draw(self, root, room, mutants, size):
        drawn = 0
        for mutant in mutants:
            if drawn == size:
                return
            name = mutant["file"]
            file = self.files.setdefault(name, switch.File((root / name).read_bytes()))
            try:
                edit = file.edit(mutant)
            except switch.NoSwitch as reason:
                self.unswitched.append((mutant["name"], str(reason)))
                continue
            edits = self.edits.setdefault(name, [])
            if not switch.disjoint(edit, edits):
                continue
            edit.number = len(self.mutants) + 1
            edits.append(edit)
            self.mutants[edit.number] = {"room": room, "name": mutant["name"], "file": name}
            drawn += 1

    def switched(self):
        """The files that `write` writes."""
        return {*self.edits, "src/mutated.rs", "src/lib.rs"}

    def write(self, root, folder):
        """All switches into a copy of the tree."""
        for name, edits in self.edits.items():
            put(folder / name, switch.applied(self.files[name].source, edits))
        put(folder / "src/mutated.rs", switch.MODULE.encode())
        library = (root / "src/lib.rs").read_bytes()
        put(folder / "src/lib.rs", library + b"\n#[doc(hidden)]\npub mod mutated;\n")

    def keep(self, size):
        """No more than so many of each room."""
        rooms = collections.Counter()
        for number, mutant in list(self.mutants.items()):
            rooms[mutant["room"]] += 1
            if rooms[mutant["room"]] > size:
                del self.mutants[number]

    def drop(self, errors):
        """Takes out those that the compiler's errors point at; which these are."""
        dropped = set()
        for name, lines in errors:
            hit = [e for e in self.edits.get(name, []) if set(lines) & set(e.lines)]
            exact = [e for e in hit if len(e.lines) == min(len(h.lines) for h in hit)]
            dropped.update(e.number for e in exact)
        for edits in self.edits.values():
            edits[:] = [e for e in edits if e.number not in dropped]
        for number in dropped:
            del self.mutants[number]
        return dropped
