#!/bin/sh
# Pages of the coach's slalom, of a hump and of modes in Debian's chromium: tests/report/browser.sh MBGEN [PICTURES]
# PICTURES: directory that takes the screenshots. Skipped (77) without chromium, node and npm, or where mbgen was built
# without reports. MBGEN_REPORT_MODULES: where playwright-core is kept from one run to the next.
set -eu
mbgen=$(realpath "$1")
here=$(cd "$(dirname "$0")" && pwd)
models=$here/../../models
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
pictures=${2:-$scratch}
modules=${MBGEN_REPORT_MODULES:-$scratch}/modules

for tool in chromium node npm; do
  command -v "$tool" > /dev/null || { echo "skipped: $tool is missing (apt-get install chromium nodejs npm)"; exit 77; }
done

cd "$scratch"
"$mbgen" simulate "$models/coach.json" --duration 5 --step 1e-3 --engine generic --out coach.csv > /dev/null
if ! "$mbgen" report coach.csv -o coach.html 2> problem; then
  grep -q "built without reports" problem || { cat problem; exit 1; }
  echo "skipped: $(cat problem)"
  exit 77
fi
"$mbgen" linearize "$models/coach.json" --at equilibrium --json --report modes.html > modes.json
"$mbgen" linearize "$models/four_bar.json" --report growing.html > /dev/null
# A start whose loops do not close: the summary says what moved.
cat > moved.json << EOF
{ "mbgen": 1, "include": ["$models/four_bar.json"],
  "initial": { "positions": { "crank_pin": { "value": 0.6, "locked": true }, "rocker_pin": -0.9 } } }
EOF
"$mbgen" simulate moved.json --duration 0.1 --engine generic --out moved.csv > /dev/null 2>&1
"$mbgen" report moved.csv -o moved.html
"$mbgen" simulate "$models/rubber_wishbone.json" --duration 0.2 --engine generic --out rubber.csv > /dev/null
"$mbgen" report rubber.csv -o rubber.html
# A run with metrics, as mbgen simulate --manoeuvre describes it.
cp moved.csv circle.csv
node "$here/metrics.mjs" describe moved.csv.run.json circle.csv.run.json
"$mbgen" report circle.csv -o circle.html
"$mbgen" simulate "$models/rides/coach_hump.json" --set speed=8.3333 --set steer_amplitude=0 --duration 1.4 \
  --engine generic --out hump.csv > /dev/null
"$mbgen" report hump.csv -o hump.html
# Two lane changes of a car, and the response of a mass on a spring.
car=$here/../data/models/four_wheeler.json
printf '{ "mbgen_manoeuvre": 1, "type": "lane_change", "speed": 12, "approach": 20, "duration": 9 }' > lane.json
"$mbgen" sweep "$car" --manoeuvre lane.json --vary manoeuvre.speed=12,14 --keep lanes --every 20 --engine generic \
  --out lanes.csv > /dev/null 2>&1
"$mbgen" report lanes/case_1.csv lanes/case_2.csv -o overlay.html
cat > mass.json << EOF
{ "mbgen": 1, "name": "mass", "gravity": [0, 0, 0], "inputs": { "force": { "unit": "N" } },
  "bodies": { "ground": { "points": { "o": [0, 0, 0], "top": [0, 0, 1] } },
    "mass": { "mass": 1, "inertia": [1, 1, 1], "points": { "o": [0, 0, 0] } } },
  "joints": { "z": { "type": "prismatic", "from": "ground.o", "to": "mass.o", "axis": "z" } },
  "springs": { "s": { "from": "ground.top", "to": "mass.o", "stiffness": 40, "damping": 0.4 } },
  "forces": { "f": { "at": "mass.o", "force": [0, 0, "force"] } },
  "outputs": { "z": { "joint": "z" } } }
EOF
"$mbgen" linearize mass.json --bode force:z --frequencies 0.1:10:400 --report responses.html > /dev/null
for page in coach modes hump; do
  size=$(wc -c < $page.html)
  [ "$size" -lt 3000000 ] || { echo "$page.html of the coach has $size bytes"; exit 1; }
done

# The lock is put beside the modules last, as the mark of a complete installation.
mkdir -p "$modules"
if ! cmp -s "$here/package-lock.json" "$modules/installed"; then
  cp "$here/package.json" "$here/package-lock.json" "$modules"
  if ! (cd "$modules" && npm ci --no-audit --no-fund --loglevel=error > npm.log 2>&1); then
    echo "skipped: npm ci: $(cat "$modules/npm.log")"
    exit 77
  fi
  cp "$here/package-lock.json" "$modules/installed"
fi
node "$here/browser.mjs" coach.html "$pictures" "$modules" moved.html rubber.html
node "$here/metrics.mjs" check circle.html "$pictures" "$modules"
node "$here/overlay.mjs" overlay.html responses.html "$pictures" "$modules"
# The coach stands 22 mm deep in its tyres, and so does its road; the hump is 80 mm high.
[ "$(node "$here/road.mjs" hump.html 1.4 "" "$pictures/report_road.png" "$modules")" = "-0.0220 0.0580" ]
node "$here/modes.mjs" modes.html modes.json growing.html "$pictures" "$modules"
