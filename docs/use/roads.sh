#!/bin/sh
# Makes the pictures of docs/use/roads.md: docs/use/roads.sh [MBGEN]. Needs chromium, node and npm.
set -eu
here=$(cd "$(dirname "$0")" && pwd)
root=$(realpath "$here/../..")
mbgen=$(realpath "${1:-$root/build/release/mbgen}")
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT

cp "$root/tests/report/package.json" "$root/tests/report/package-lock.json" "$scratch"
(cd "$scratch" && npm ci --no-audit --no-fund --loglevel=error > npm.log)
cd "$scratch"

# picture NAME RIDE SPEED DURATION TIME KEYS PLOTS
picture() {
  "$mbgen" simulate "$root/models/rides/$2.json" --set speed="$3" --set steer_amplitude=0 --duration "$4" --out "$2.csv"
  "$mbgen" report "$2.csv" -o "$2.html"
  node "$root/tests/report/road.mjs" "$2.html" "$5" "$6" "$here/$1.png" "$scratch" "$7"
}

front=load_front_left,load_front_right
rear=load_rear_left,load_rear_right
picture roads_class_c coach_class_c 22.2222 6 3.5 1eedd "$front/$rear/driver_height/roll"
picture roads_hump truck_hump 8.3333 4 1.82 1eeedd \
  "load1_left,load1_right/load2_left,load2_right/load4_left,load4_right/driver_acceleration"
