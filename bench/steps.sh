#!/bin/sh
# Whole steps of generated solvers, alone in a loop: time, real-time factor at 1e-3 s, instructions, and the least time of
# an instance in eight lanes.
#   bench/steps.sh [-b MBGEN] [-n STEPS] [-t TURNS] [MODEL.json...]
# Default: build/release/mbgen, else build/mbgen; 5000 steps in 20 turns; models/coach.json and truck.json, 5 s of slalom.
# Times are for this processor; instructions, when valgrind is installed, for x86-64-v3 (valgrind knows no AVX-512).
set -eu

here=$(cd "$(dirname "$0")" && pwd)
steps=5000
turns=20
# shellcheck source=bench/steps_arguments.sh
. "$here/steps_arguments.sh"
[ $# -gt 0 ] || set -- "$root/models/coach.json" "$root/models/truck.json"

# compile MARCH NAME DIRECTORY: the solver with the flags of its CMake file, and the loops around it
compile() {
  cmake -S "$3" -B "$3/$1" -DMBGEN_MARCH="$1" >/dev/null
  cmake --build "$3/$1" >/dev/null
  c++ -std=c++17 -O2 -I "$3" -DSOLVER="$2" -DINTERFACE="\"$2.hpp\"" "$here/steps.cpp" "$3/$1/lib$2.a" -o "$3/steps_$1"
  c++ -std=c++17 -O2 -march="$1" -I "$3" -DSOLVER="$2" -DLANES -DINTERFACE="\"$2_batch.hpp\"" "$here/steps.cpp" \
    "$3/$1/lib$2.a" -o "$3/lanes_$1"
}

# instructions PROGRAM STATE INTEGRATOR: of one step, by the difference of two runs
instructions() {
  for count in 100 300; do
    valgrind --tool=callgrind --callgrind-out-file=/dev/null "$1" "$2" "$count" 1 "$3" 2>&1 |
      awk '/Collected/ { print $NF }'
  done | awk '{ n[NR] = $1 } END { printf "%.0f", (n[2] - n[1]) / 200 }'
}

printf '%-10s %-6s %12s %12s %12s %14s %12s %12s\n' model method 'least, us' 'median, us' 'real time' instructions \
  'in lanes' 'real time'
for model in "$@"; do
  name=$(basename "$model" .json)
  directory=$scratch/$name
  "$binary" generate "$model" --batch 8 --out "$directory" >/dev/null
  write_start "$model"
  compile native "$name" "$directory"
  if command -v valgrind >/dev/null; then compile x86-64-v3 "$name" "$directory"; fi
  for method in rk4 abm4; do
    times=$("$directory/steps_native" "$scratch/state" "$steps" "$turns" "$method")
    counted=-
    if [ -x "$directory/steps_x86-64-v3" ]; then
      counted=$(instructions "$directory/steps_x86-64-v3" "$scratch/state" "$method")
    fi
    in_lanes=$("$directory/lanes_native" "$scratch/state" "$((steps / 4))" "$turns" "$method")
    echo "$name $method $times $counted $in_lanes" |
      awk '{ printf "%-10s %-6s %12.2f %12.2f %12.0f %14s %12.2f %12.0f\n", $1, $2, 1e6 * $3, 1e6 * $4, 1e-3 / $3, $5,
                    1e6 * $6, 1e-3 / $6 }'
  done
done
