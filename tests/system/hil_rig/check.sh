#!/bin/sh
# The rig from end to end: built as its users build it, driven through a network that spoils packets, left by its driver,
# driven from a recording and by a client that shares no code with it: tests/system/hil_rig/check.sh MBGEN [BUILD]
# BUILD is kept, and only what changed is built anew.
# Nothing here is judged by a time: a machine that is busy makes overruns, which are counted.
set -eu
here=$(cd "$(dirname "$0")" && pwd)
mbgen=$(realpath "$1")
rig=$here/../../../examples/hil_rig
scratch=$(mktemp -d)
build=${2:-$scratch/build}
children=
# shellcheck disable=SC2086  # several words
trap 'kill $children 2>/dev/null || true; rm -rf "$scratch"' EXIT

fail() {
  echo "$1" >&2
  tail -n 40 "$scratch"/*.txt >&2
  exit 1
}
# The number that a run's result has under a name.
value() { awk -v name="$1" 'index($0, name " ") == 1 { print $NF }' "$2"; }
# Whether one of the processes is running; those that ended are kept as zombies until someone waits for them.
any_runs() {
  for process in $children; do
    if grep -q '^State:[[:space:]]*[^Z]' "/proc/$process/status" 2>/dev/null; then return 0; fi
  done
  return 1
}
# Waits until a line is in a file; in vain where nobody is left who could write it.
await() {
  tries=0
  until grep -q "$1" "$2" 2>/dev/null; do
    any_runs || grep -q "$1" "$2" 2>/dev/null || fail "never came, all processes have ended: $1"
    tries=$((tries + 1))
    [ $tries -lt 6000 ] || fail "never came: $1"
    sleep 0.05
  done
}
# Each packet counts once, and what must not be is not.
check_counts() {
  sum=0
  for name in accepted corrupt refused foreign duplicate late stale; do
    sum=$((sum + $(value "packets $name" "$1")))
  done
  [ "$(value 'packets received' "$1")" -eq $sum ] || fail "the packets of $1 do not add up to $sum"
  [ "$(value 'packets refused' "$1")" -eq 0 ] || fail "$1: commands were refused"
  grep -q '^status  *ok' "$1" || fail "$1: the solver failed"
}
check_driven() { [ "$(value 'packets accepted' "$1")" -gt 0 ] || fail "$1: no command was accepted"; }

# As its users build it, but for the level of the optimisation: no result depends on the time.
export CMAKE_CXX_COMPILER_LAUNCHER="$here/../../tools/quick.sh" QUICK=-O1
cmake -S "$rig" -B "$build" -DMBGEN="$mbgen" >/dev/null
cmake --build "$build" --target hil_plant hil_driver hil_replay hil_tune -j 2 >/dev/null
build_check() { # sources, into a program of the name of the first
  c++ -std=c++20 -O1 -Wall -Wextra -I "$rig" -I "$build/coach_rig" "$@" "$build/libhil_rig.a" \
    "$build/coach_rig/build/libcoach_rig.a" -pthread -o "$scratch/$(basename "$1" .cpp)"
}
build_check "$here/loop_check.cpp" "$here/../../support/heap.cpp"
build_check "$here/proxy.cpp"

# shellcheck disable=SC2046  # several words
set -- $(python3 "$here/ports.py" 7)
"$scratch/loop_check" "$1"
echo "1: double lane change in lock step, loop without heap"

at=127.0.0.1
start_plant() { # listen, driver, control, output, other options
  listen=$at:$1 driver=$at:$2 control=$at:$3 output=$4
  shift 4
  "$build/hil_plant" --listen "$listen" --driver "$driver" --control "$control" "$@" >"$output" 2>&1 &
  plant=$!
  children="$children $plant"
}

# Through a network with faults; stopped by SIGINT.
"$scratch/proxy" $at:"$4" $at:"$5" $at:"$2" $at:"$1" 1000 >"$scratch/proxy.txt" 2>&1 &
proxy=$!
"$build/hil_driver" --patience 300 --listen $at:"$2" --plant $at:"$4" >"$scratch/driver.txt" 2>&1 &
driver_process=$!
children="$proxy $driver_process"
start_plant "$1" "$5" "$3" "$scratch/faults.txt" --histogram "$scratch/histogram"
await '^lost' "$scratch/proxy.txt"
kill -INT $plant
wait $plant || fail "the plant did not end well"
kill $proxy $driver_process 2>/dev/null || true
check_counts "$scratch/faults.txt"
check_driven "$scratch/faults.txt"
read -r _ lost _ doubled _ corrupted _ delayed _ garbage <"$scratch/proxy.txt"
for pair in "corrupt $((corrupted + garbage))" "duplicate $doubled" "late $delayed"; do
  found=$(value "packets ${pair% *}" "$scratch/faults.txt")
  if [ "$found" -gt 0 ] && [ "$found" -le "${pair#* }" ]; then continue; fi
  fail "the network made ${pair#* } ${pair% *}, $found are counted"
done
[ "$(value 'packets lost' "$scratch/faults.txt")" -gt 0 ] || fail "the network lost $lost, none is counted"
grep -q 'stopped by signal 2' "$scratch/faults.txt" || fail "SIGINT is not said"
[ "$(grep -c '^[0-9]' "$scratch/histogram")" -eq 1000 ] || fail "the histogram has not 1000 rows"
cycles=$(value cycles "$scratch/faults.txt")
awk -v cycles="$cycles" '/^[0-9]/ { a += $2; b += $3 } /Overflows/ { a += $4; b += $5 } END { exit a != cycles || b != cycles }' \
  "$scratch/histogram" || fail "the histograms do not count $cycles cycles"
echo "2: $(cat "$scratch/proxy.txt"), survived in $cycles cycles"

# A client that shares no code; the plant holds, ramps and is neutral when it falls silent; stopped by SIGTERM.
start_plant "$1" "$2" "$3" "$scratch/client.txt" --priority 0
python3 "$here/client.py" "$2" "$1" "$3" 300 || fail "client.py failed"
await 'ramps to neutral' "$scratch/client.txt"
await ': neutral' "$scratch/client.txt"
"$build/hil_tune" --listen $at:"$6" --control $at:"$3" --name drag_area --value 5 | grep -q 'drag_area set: it is 5 m^2' ||
  fail "hil_tune does not set"
await 'parameters taken over' "$scratch/client.txt"
kill -TERM $plant
wait $plant || fail "the plant did not end well"
check_counts "$scratch/client.txt"
check_driven "$scratch/client.txt"
[ "$(value 'packets corrupt' "$scratch/client.txt")" -eq 0 ] || fail "packets of client.py were taken for broken ones"
echo "3: a driver in Python, its silence, SIGTERM"

# From the recording, until the duration is over.
"$build/hil_replay" --patience 60 --listen $at:"$2" --plant $at:"$1" --recording "$rig/recording.csv" >"$scratch/replay.txt" 2>&1 &
replay=$!
children=$replay
await "$(printf ':%04X ' "$2")" /proc/net/udp # or the plant is through before anyone listens
start_plant "$1" "$2" "$3" "$scratch/recorded.txt" --duration 0.5 --cpu 0
wait $plant || fail "the plant did not end well"
wait $replay || fail "the recorded client did not end well"
check_counts "$scratch/recorded.txt"
[ "$(value cycles "$scratch/recorded.txt")" -eq 500 ] || fail "0.5 s are not 500 cycles"
grep -q 'the plant' "$scratch/replay.txt" || fail "the recorded client does not say how it ended"
echo "4: the recording, 500 cycles"

# Mistakes of whoever starts it.
for wrong in "--port 1" "--duration" "--duration x" "--listen nowhere" "--priority 99"; do
  # shellcheck disable=SC2086  # several words
  if "$build/hil_plant" $wrong >"$scratch/wrong.txt" 2>&1; then fail "hil_plant takes $wrong"; fi
  grep -q '^hil_plant: ' "$scratch/wrong.txt" || fail "hil_plant does not say what is wrong with $wrong"
done
echo "5: mistakes are said"
echo "5 of 5 cases"
