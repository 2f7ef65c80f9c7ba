#!/bin/sh
# Solvers of this mbgen beside those of another one, for example of an earlier commit, in turns in one process:
#   bench/beside.sh OTHER_MBGEN [MODEL.json...]
# Default: the coach and the truck, with forces and as mechanisms. MBGEN: this one (build/release/mbgen), TURNS (60).
# Columns: least processor time in microseconds of the other solver, of this one, and their ratio, for one evaluation,
# one Runge-Kutta step, and both of an instance in eight lanes; largest difference of an acceleration.
set -eu
here=$(cd "$(dirname "$0")" && pwd)
root=$(cd "$here/.." && pwd)
this=${MBGEN:-$root/build/release/mbgen}
other=${1:?"usage: bench/beside.sh OTHER_MBGEN [MODEL.json...]"}
shift
[ $# -gt 0 ] || set -- "$root/models/coach_mechanism.json" "$root/models/truck_mechanism.json" "$root/models/coach.json" \
  "$root/models/truck.json"

scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT

# library MBGEN MODEL DIRECTORY: DIRECTORY/solver.so, with the flags of the solver's CMake file
library() {
  name=$(basename "$2" .json)
  "$1" generate "$2" --batch 8 --out "$3" >/dev/null
  cmake -S "$3" -B "$3/build" -DCMAKE_POSITION_INDEPENDENT_CODE=ON >/dev/null
  cmake --build "$3/build" >/dev/null
  c++ -std=c++17 -O2 -fPIC -shared -I "$3" -DSOLVER="$name" -DSOLVER_HEADER="\"$name.hpp\"" \
    -DBATCH_HEADER="\"${name}_batch.hpp\"" "$here/beside/solver.cpp" "$3/build/lib$name.a" -o "$3/solver.so"
}

c++ -std=c++17 -O2 "$here/beside/turns.cpp" -o "$scratch/turns" -ldl
printf '%-18s | %-24s | %-24s | %-24s | %-24s | %s\n' 'other, this, ratio' 'one evaluation, us' 'one step, us' \
  'evaluation in lanes, us' 'a step in lanes, us' deviation
for model in "$@"; do
  library "$this" "$model" "$scratch/this"
  library "$other" "$model" "$scratch/other"
  printf '%-16s  ' "$(basename "$model" .json)"
  "$scratch/turns" "$scratch/this/solver.so" "$scratch/other/solver.so" "${TURNS:-60}"
  rm -rf "$scratch/this" "$scratch/other"
done
