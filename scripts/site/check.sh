#!/usr/bin/env bash
# Checks the site that `burmester report` writes: an HTML validator, and headless Chromium with an accessibility
# checker. Usage: scripts/site/check.sh [DIR], where DIR is the site (default: a new one is written).
# Status 0: all is well; 1: something is wrong; 2: something is missing.
set -euo pipefail
here="$(cd "$(dirname "$0")" && pwd)"
project="$(cd "$here/../.." && pwd)"

missing() {
  echo "$1 is missing; install $2" >&2
  exit 2
}
command -v node >/dev/null || missing node "Node.js 20 or later (Debian: nodejs, npm)"
command -v npm >/dev/null || missing npm "npm (Debian: npm)"
browser="${CHROMIUM:-$(command -v chromium || command -v chromium-browser || command -v google-chrome || true)}"
[ -x "$browser" ] || missing Chromium "Chromium (Debian: chromium), or name one: CHROMIUM=/path/to/chromium"

tools="$project/target/site-check"
mkdir -p "$tools"
cp "$here/package.json" "$here/"*.mjs "$tools/"
(cd "$tools" && npm install --silent --no-audit --no-fund) || missing "a package of package.json" "it by npm: is the registry reachable?"

site="${1:-}"
if [ -z "$site" ]; then
  site="$project/target/site-check/site"
  rm -rf "$site"
  (cd "$project" && cargo run --quiet --release -- report -o "$site")
fi
[ -f "$site/index.html" ] || missing "$site/index.html" "it by: burmester report -o DIR"
site="$(cd "$site" && pwd)"
cd "$tools"
node check.mjs "$browser" "$site"
