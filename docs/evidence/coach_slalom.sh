#!/bin/sh
# Drives the coach through its slalom and draws docs/evidence/coach_slalom.svg: docs/evidence/coach_slalom.sh [MBGEN]
# The summary that mbgen prints is the table in docs/evidence/coach_slalom.md.
set -eu
here=$(cd "$(dirname "$0")" && pwd)
mbgen=${1:-$here/../../build/release/mbgen}
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT

"$mbgen" simulate "$here/../../models/coach.json" --duration 5 --step 1e-3 --out "$scratch/coach.csv"
"$mbgen" plot "$scratch/coach.csv" --degrees --columns lateral_acceleration --columns roll --columns yaw_rate \
  --columns 'load_*' -o "$here/coach_slalom.svg"
