#!/bin/sh
# A step past a singular position that is too long fails, whatever the offset, the step and the method; others keep the
# energy: scalar and in lanes.   tests/system/near_singular/check.sh MBGEN COMPILER
set -eu

mbgen=$(realpath "$1")

here=$(cd "$(dirname "$0")" && pwd)
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
solver=$scratch/solver
"$mbgen" generate "$here/near_parallelogram.json" --batch 4 --out "$solver" >/dev/null
"$2" -std=c++17 -O1 -march=native -I "$solver" "$here/check.cpp" "$solver/near_parallelogram.cpp" \
  "$solver/near_parallelogram_batch.cpp" -o "$scratch/check"
"$scratch/check"

python3 -c 'import ctypes' 2>/dev/null || { echo "python3 is not installed, units left out"; exit 0; }
unit() {  # STEP OFFSET WORD
  sed "s/\"step\": 0.001/\"step\": $1/; s/\"rosenbrock\"/\"rk4\"/" "$here/near_parallelogram.json" \
    >"$scratch/near_parallelogram.json"
  rm -rf "$scratch/unit"
  "$mbgen" export "$scratch/near_parallelogram.json" --fmi 2 -o "$scratch/unit.fmu" >/dev/null
  python3 -m zipfile -e "$scratch/unit.fmu" "$scratch/unit"
  python3 "$here/unit.py" "$(find "$scratch/unit/binaries" -name near_parallelogram.so)" \
    "$scratch/unit/modelDescription.xml" "$@"
}
unit 0.0005 1e-3 kept
unit 0.02 1e-3 refused
unit 0.05 1e-2 refused
