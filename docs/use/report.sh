#!/bin/sh
# Makes the pictures of docs/use/report.md, docs/use/linearisation.md and the robot of README.md: docs/use/report.sh [MBGEN]. Needs
# chromium, node and npm.
set -eu
here=$(cd "$(dirname "$0")" && pwd)
mbgen=${1:-$here/../../build/release/mbgen}
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT

"$here/../../tests/report/browser.sh" "$mbgen" "$scratch"
mv "$scratch/report.png" "$scratch/report_suspension.png" "$scratch/report_overlay.png" "$scratch/modes.png" "$here"
"$mbgen" inspect "$here/../../models/coach.json" --svg "$here/coach_topology.svg"

# The robot of README.md.
"$mbgen" simulate "$here/../../models/delta.json" --engine generic --duration 0.25 --step 1e-3 --out "$scratch/delta.csv"
"$mbgen" report "$scratch/delta.csv" -o "$scratch/delta.html"
chromium --headless=new --no-sandbox --use-gl=angle --use-angle=swiftshader --enable-unsafe-swiftshader --hide-scrollbars \
  --virtual-time-budget=3000 --window-size=1070,620 --screenshot="$here/delta.png" "file://$scratch/delta.html"
