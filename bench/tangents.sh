#!/bin/sh
# Runge-Kutta steps with derivatives by eight parameters, and steps backwards, beside plain steps, in turns in one process,
# five times in copies of the program: the least times, and the least and largest median ratio of a copy:
#   bench/tangents.sh [-b MBGEN] [-n STEPS] [-t TURNS] [MODEL.json PARAMETER,...]
# Default: build/release/mbgen, else build/mbgen; 300 steps in 40 turns; models/coach.json by its bars, air springs, drag
# and driver.
set -eu

here=$(cd "$(dirname "$0")" && pwd)
steps=300
turns=40
# shellcheck source=bench/steps_arguments.sh
. "$here/steps_arguments.sh"
[ $# -gt 0 ] || set -- "$root/models/coach.json" \
  air_pressure_front,air_pressure_rear,bar_front,bar_rear,drag_area,drive_gain,speed,steer_amplitude

"$binary" generate "$1" --sensitivities "$2" --adjoint --name plain --out "$scratch/made" >/dev/null
write_start "$1"
cmake -S "$scratch/made" -B "$scratch/made/build" >/dev/null
cmake --build "$scratch/made/build" >/dev/null
c++ -std=c++17 -O2 -march=native -Wno-psabi -I "$scratch/made" -DPLAIN=plain -DPLAIN_HEADER='"plain.hpp"' \
  -DADJOINT=plain_adjoint -DADJOINT_HEADER='"plain_adjoint.hpp"' -DTANGENTS=plain_tangents \
  -DTANGENTS_HEADER='"plain_tangents.hpp"' "$here/tangents.cpp" \
  "$scratch/made/build/libplain.a" -o "$scratch/tangents"
# Pages of a program lie elsewhere in the second cache with each copy, which moves a step by up to a fifth.
printf '%-12s %14s %22s %18s %10s %18s\n' model 'plain step, us' 'with derivatives, us' 'ratios of copies' 'back, us' \
  'ratios of copies'
for copy in 1 2 3 4 5; do
  cp "$scratch/tangents" "$scratch/copy_$copy"
  "$scratch/copy_$copy" "$scratch/state" "$steps" "$turns"
done | awk -v name="$(basename "$1" .json)" '
  { for (k = 1; k <= NF; ++k) {
      if (NR == 1 || $k < least[k]) least[k] = $k
      if (NR == 1 || $k > most[k]) most[k] = $k } }
  END { printf "%-12s %14.2f %22.2f %18s %10.2f %18s\n", name, 1e6 * least[1], 1e6 * least[2],
          sprintf("%.2f to %.2f", least[4], most[4]), 1e6 * least[3], sprintf("%.2f to %.2f", least[5], most[5]) }'
