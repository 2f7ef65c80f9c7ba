#!/bin/sh
# Drives the coach through its slalom and draws docs/coach_slalom.svg: docs/coach_slalom.sh [MBGEN]
# The summary that mbgen prints is the table in docs/coach_slalom.md.
set -eu
here=$(cd "$(dirname "$0")" && pwd)
mbgen=${1:-$here/../build/release/mbgen}
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT

"$mbgen" simulate "$here/../models/coach.json" --duration 5 --step 1e-3 --out "$scratch/coach.csv"

awk -F, -v panels='lateral acceleration, m/s^2 | 1 | = lateral_acceleration [m/s^2]
  # roll, degrees | 57.29577951308232 | = roll [rad]
  # yaw rate, degrees/s | 57.29577951308232 | = yaw_rate [rad/s]
  # wheel loads, kN | 1e-3 | front left = load_front_left [N]; front right = load_front_right [N];
    rear left (twin) = load_rear_left [N]; rear right (twin) = load_rear_right [N]' \
  -f "$here/plot_table.awk" "$scratch/coach.csv" > "$scratch/coach.svg"
mv "$scratch/coach.svg" "$here/coach_slalom.svg"
