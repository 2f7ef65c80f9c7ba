#!/bin/sh
# Makes the picture of docs/use/manoeuvres.md: docs/use/manoeuvres.sh [MBGEN]. Needs chromium.
set -eu
here=$(cd "$(dirname "$0")" && pwd)
mbgen=$(realpath "${1:-$here/../../build/release/mbgen}")
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT

cd "$here/../.."
"$mbgen" simulate models/coach_driver.json --manoeuvre models/manoeuvres/lane_change.json --every 10 --out "$scratch/run.csv"
"$mbgen" report "$scratch/run.csv" -o "$scratch/run.html"
chromium --headless --no-sandbox --use-angle=swiftshader --enable-unsafe-swiftshader --ignore-gpu-blocklist --hide-scrollbars \
  --virtual-time-budget=4000 --window-size=1200,860 --screenshot="$scratch/manoeuvres.png" "file://$scratch/run.html"
mv "$scratch/manoeuvres.png" "$here"
