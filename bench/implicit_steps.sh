#!/bin/sh
# Cost of an implicit step against one of Runge-Kutta of the same model: times in turns of one run, one instance and
# eight lanes. Models ask for "integrator": "rosenbrock".
#   bench/implicit_steps.sh [-b MBGEN] [-n STEPS] [-t TURNS] [MODEL.json...]
# Default: build/release/mbgen, 500 steps in 15 turns, models/rubber_wishbone.json and models/rubber_coach.json.
set -eu

here=$(cd "$(dirname "$0")" && pwd)
steps=500
turns=15
# shellcheck source=bench/steps_arguments.sh
. "$here/steps_arguments.sh"
[ $# -gt 0 ] || set -- "$root/models/rubber_wishbone.json" "$root/models/rubber_coach.json"

printf '%-16s %-6s %14s %16s %8s\n' model lanes 'rk4, us' 'rosenbrock, us' ratio
for model in "$@"; do
  name=$(basename "$model" .json)
  directory=$scratch/$name
  "$binary" generate "$model" --batch 8 --out "$directory" >/dev/null
  write_start "$model"
  cmake -S "$directory" -B "$directory/native" -DMBGEN_MARCH=native >/dev/null
  cmake --build "$directory/native" >/dev/null
  c++ -std=c++17 -O2 -march=native -I "$directory" -DSOLVER="$name" -DBATCH_INTERFACE="\"${name}_batch.hpp\"" \
    "$here/implicit_steps.cpp" "$directory/native/lib$name.a" -o "$directory/steps"
  "$directory/steps" "$scratch/state" "$steps" "$turns" |
    awk -v name="$name" '{ printf "%-16s %-6s %14.2f %16.2f %8s\n", name, $1, 1e6 * $2, 1e6 * $3, $4 }'
done
