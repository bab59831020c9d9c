"""python3 scripts/mutants"""

import pathlib
import sys

# The folder of this file stands first in the path when it is run by its name.
sys.path[0] = str(pathlib.Path(__file__).resolve().parents[1])

try:
    import tree_sitter  # noqa: F401
    import tree_sitter_rust  # noqa: F401
except ImportError as error:
    print(f"{error.name} is missing: pip install -r scripts/mutants/requirements.txt", file=sys.stderr)
    sys.exit(2)

from mutants.command import main  # noqa: E402

sys.exit(main())
