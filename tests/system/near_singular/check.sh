#!/bin/sh
# A step past a singular position that is too long fails, whatever the offset, the step and the method; others keep the
# energy: scalar and in lanes.   tests/system/near_singular/check.sh MBGEN COMPILER
set -eu

here=$(cd "$(dirname "$0")" && pwd)
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
solver=$scratch/solver
"$1" generate "$here/near_parallelogram.json" --batch 4 --out "$solver" >/dev/null
"$2" -std=c++17 -O1 -march=native -I "$solver" "$here/check.cpp" "$solver/near_parallelogram.cpp" \
  "$solver/near_parallelogram_batch.cpp" -o "$scratch/check"
"$scratch/check"
