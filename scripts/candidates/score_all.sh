#!/bin/sh
# Scores every candidate of this folder and writes the tables into docs/candidates.md.
#
#   scripts/candidates/score_all.sh [DIR|NAME]
#
# DIR or NAME is as for `burmester score --problems`; all corpora in data/ if left out. PYTHON is the
# Python that has numpy, python-flint, cypari, pylinkage and scipy (python3 if not set), BURMESTER the
# program (else it is built). A candidate whose tools are not there is left out, and named.
set -eu
cd "$(dirname "$0")/../.."
python=${PYTHON:-python3}
if [ -z "${BURMESTER:-}" ]; then
    cargo build --release --quiet
    BURMESTER=$PWD/target/release/burmester
fi
export BURMESTER
results=$(mktemp -d)
trap 'rm -rf "$results"' EXIT

score() {
    name=$1
    shift
    echo "$name" >&2
    status=0
    "$BURMESTER" score ${problems:+--problems "$problems"} --format json -- "$@" > "$results/$name.json" || status=$?
    if [ "$status" -gt 1 ]; then
        echo "$name: left out (status $status)" >&2
        rm -f "$results/$name.json"
    fi
}

# Whether the Python has these modules.
has() {
    for module in "$@"; do
        "$python" -c "import $module" 2> /dev/null || {
            echo "left out: $python has no $module" >&2
            return 1
        }
    done
}

problems=${1:-}
has numpy && score numpy_quartic "$python" scripts/candidates/numpy_quartic.py
has flint && score flint_pairs "$python" scripts/candidates/flint_pairs.py
has cypari && score pari_pairs "$python" scripts/candidates/pari_pairs.py
has pylinkage scipy && score pylinkage_burmester "$python" scripts/candidates/pylinkage_burmester.py
score burmester_f64 sh scripts/candidates/burmester_f64.sh
command -v node > /dev/null && score newton node scripts/candidates/newton.js
"$python" scripts/candidates/tables.py docs/candidates.md "${problems:-data}" "$results"
