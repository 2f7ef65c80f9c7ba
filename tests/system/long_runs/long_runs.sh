#!/bin/sh
# Long runs, some minutes: the four-bar for 1e8 steps and the coach for an hour of simulated time. Prints energy, closure
# residuals and memory as they go; docs/use/numerical_trouble.md has a record.
#   tests/system/long_runs/long_runs.sh [MBGEN] [STEPS] [SECONDS]      default: build/mbgen 100000000 3600
set -eu
here=$(cd "$(dirname "$0")" && pwd)
root=$here/../../..
mbgen=${1:-$root/build/mbgen}
steps=${2:-100000000}
seconds=${3:-3600}
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT

echo "four-bar, conservative, $steps steps; closures and energy are looked at every 1000 steps"
"$mbgen" generate "$root/models/four_bar.json" --out "$scratch/four_bar" >/dev/null
cmake -S "$scratch/four_bar" -B "$scratch/build" >/dev/null
cmake --build "$scratch/build" >/dev/null
c++ -std=c++17 -O2 -I "$scratch/four_bar" "$here/four_bar.cpp" "$scratch/build/libfour_bar.a" \
  -o "$scratch/run"
"$scratch/run" "$steps" 1e-4 rk4
"$scratch/run" "$steps" 1e-4 abm4

echo
echo "coach, slalom at 20 m/s, $seconds s at 1 ms by rk4"
"$mbgen" simulate "$root/models/coach.json" --duration "$seconds" --step 1e-3 --every 1000 \
  --out "$scratch/coach.csv" >"$scratch/summary" 2>"$scratch/problems" &
pid=$!
first=
while kill -0 "$pid" 2>/dev/null; do
  # Compiling does not count: the motion begins when the solver is loaded.
  if grep -q '/coach-.*\.so' "/proc/$pid/maps" 2>/dev/null; then
    memory=$(awk '/VmRSS/ { print $2 }' "/proc/$pid/status" 2>/dev/null || true)
    [ -n "$memory" ] && last=$memory
    [ -n "$first" ] || first=$memory
  fi
  sleep 2
done
wait "$pid" || { cat "$scratch/problems"; exit 1; }
cat "$scratch/summary"
echo "resident memory of mbgen: ${first:-?} kB in the first seconds of the motion, ${last:-?} kB in the last"
