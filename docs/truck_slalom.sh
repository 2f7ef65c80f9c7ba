#!/bin/sh
# Drives the truck through its slalom and draws docs/truck_slalom.svg: docs/truck_slalom.sh [MBGEN]
# The summary that mbgen prints is the table in docs/truck_slalom.md.
set -eu
here=$(cd "$(dirname "$0")" && pwd)
mbgen=${1:-$here/../build/release/mbgen}
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT

"$mbgen" simulate "$here/../models/truck.json" --duration 5 --step 1e-3 --out "$scratch/truck.csv"

awk -F, -v panels='lateral acceleration, m/s^2 | 1 |
    tractor = lateral_acceleration_tractor [m/s^2]; semitrailer = lateral_acceleration_trailer [m/s^2]
  # yaw rate, degrees/s | 57.29577951308232 | tractor = yaw_rate_tractor [rad/s]; semitrailer = yaw_rate_trailer [rad/s]
  # angles, degrees | 57.29577951308232 | articulation = articulation [rad]; left front wheel = steer_left [rad]
  # roll, degrees | 57.29577951308232 | tractor, front of the frame = roll_frame [rad]; semitrailer = roll_trailer [rad]
  # loads of the left wheels, kN | 1e-3 | axle 1 = load1_left [N]; 2 = load2_left [N]; 3 = load3_left [N];
    4 = load4_left [N]; 5 = load5_left [N]
  # loads of the right wheels, kN | 1e-3 | axle 1 = load1_right [N]; 2 = load2_right [N]; 3 = load3_right [N];
    4 = load4_right [N]; 5 = load5_right [N]
  # vertical acceleration of the driver, m/s^2 | 1 | = driver_acceleration [m/s^2]' \
  -f "$here/plot_table.awk" "$scratch/truck.csv" > "$scratch/truck.svg"
mv "$scratch/truck.svg" "$here/truck_slalom.svg"
