#!/bin/sh
# Makes the pictures of docs/use/manoeuvres.md: docs/use/manoeuvres.sh [MBGEN]. Needs chromium.
set -eu
here=$(cd "$(dirname "$0")" && pwd)
mbgen=$(realpath "${1:-$here/../../build/release/mbgen}")
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT

# picture MODEL MANOEUVRE NAME: the page of a run.
picture() {
  "$mbgen" simulate "models/$1.json" --manoeuvre "models/manoeuvres/$2.json" --every 10 --out "$scratch/$3.csv"
  "$mbgen" report "$scratch/$3.csv" -o "$scratch/$3.html"
  chromium --headless --no-sandbox --use-angle=swiftshader --enable-unsafe-swiftshader --ignore-gpu-blocklist --hide-scrollbars \
    --virtual-time-budget=4000 --window-size=1200,860 --screenshot="$scratch/$3.png" "file://$scratch/$3.html"
  mv "$scratch/$3.png" "$here"
}

cd "$here/../.."
picture coach_driver lane_change manoeuvres
picture truck_driver truck_lane_change manoeuvres_truck
