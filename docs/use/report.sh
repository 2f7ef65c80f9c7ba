#!/bin/sh
# Makes the pictures of docs/use/report.md and docs/use/linearisation.md: docs/use/report.sh [MBGEN]. Needs chromium, node and npm.
set -eu
here=$(cd "$(dirname "$0")" && pwd)
mbgen=${1:-$here/../../build/release/mbgen}
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT

"$here/../../tests/report/browser.sh" "$mbgen" "$scratch"
mv "$scratch/report.png" "$scratch/report_suspension.png" "$scratch/modes.png" "$here"
"$mbgen" inspect "$here/../../models/coach.json" --svg "$here/coach_topology.svg"
