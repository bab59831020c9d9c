#!/usr/bin/env bash
# Five positions: this project and python-flint, one after the other, on the same 200 problems.
set -euo pipefail
cd "$(dirname "$0")/../.."
problems="$(mktemp)"
trap 'rm -f "$problems"' EXIT
python3 scripts/five_positions_outside.py --write "$problems" >&2
echo "burmester"
BURMESTER_PROBLEMS="$problems" cargo bench --quiet --bench five_positions
echo "python-flint"
python3 scripts/peers/five_positions_flint.py "$problems"
