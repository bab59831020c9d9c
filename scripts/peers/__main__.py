"""python3 scripts/peers"""

import os
import pathlib
import subprocess
import sys
import venv

HERE = pathlib.Path(__file__).resolve().parent
PLACE = HERE.parents[1] / "target" / "peers" / "venv"
PYTHON = PLACE / ("Scripts/python.exe" if os.name == "nt" else "bin/python")


def installed():
    """The virtual environment with the pinned peers; one that cannot be installed is left to its rows to report."""
    done = PLACE / "requirements.txt"
    wanted = (HERE / "requirements.txt").read_text()
    if done.exists() and done.read_text() == wanted:
        return
    print(f"installing {', '.join(wanted.split())} from PyPI into {PLACE}", file=sys.stderr)
    venv.create(PLACE, clear=True, symlinks=os.name != "nt", with_pip=True)
    pip = [PYTHON, "-m", "pip", "install", "--quiet", "--disable-pip-version-check"]
    results = [subprocess.run([*pip, peer]).returncode for peer in wanted.split()]
    if not any(results):
        done.write_text(wanted)


asks_only = {"-h", "--help"} & set(sys.argv[1:])
if not asks_only and pathlib.Path(sys.prefix) != PLACE:
    installed()
    os.execv(PYTHON, [PYTHON, "-B", HERE, *sys.argv[1:]])

# The folder of this file stands first in the path when it is run by its name.
sys.path[0] = str(HERE.parent)

from peers.command import main  # noqa: E402

sys.exit(main())
