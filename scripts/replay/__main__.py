"""python3 scripts/replay"""

import pathlib
import sys

# The folder of this file stands first in the path when it is run by its name.
sys.path[0] = str(pathlib.Path(__file__).resolve().parents[1])

MISSING = "{} is missing: pip install python-flint mpmath (python-flint 0.6 or later)"

try:
    import flint  # noqa: F401
    import mpmath  # noqa: F401
except ImportError as error:
    print(MISSING.format(error.name), file=sys.stderr)
    sys.exit(2)

from replay.command import main  # noqa: E402

sys.exit(main())
