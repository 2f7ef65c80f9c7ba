#!/bin/sh
# Drives the truck through its slalom and draws docs/evidence/truck_slalom.svg: docs/evidence/truck_slalom.sh [MBGEN]
# The summary that mbgen prints is the table in docs/evidence/truck_slalom.md.
set -eu
here=$(cd "$(dirname "$0")" && pwd)
mbgen=${1:-$here/../../build/release/mbgen}
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT

"$mbgen" simulate "$here/../../models/truck.json" --duration 5 --step 1e-3 --out "$scratch/truck.csv"
"$mbgen" plot "$scratch/truck.csv" --degrees \
  --columns lateral_acceleration_tractor,lateral_acceleration_trailer \
  --columns yaw_rate_tractor,yaw_rate_trailer --columns articulation,steer_left --columns roll_frame,roll_trailer \
  --columns 'load*_left' --columns 'load*_right' --columns driver_acceleration -o "$here/truck_slalom.svg"
