#!/bin/sh
# Solvers in single precision against the same in double precision: accelerations and trajectories within bounds that
# compare.cpp derives, no float promoted to a double unseen. That compilers and processors agree on the bits is seen by
# tests/system/determinism/trajectories.sh.
#   tests/system/single_precision/check.sh [-b MBGEN] [-f FORM] [-n STEPS] [MODEL.json[=MOMENT[,UNITS]]...]
# default: build/mbgen, the form with fewer operations, 1000 steps of 1 ms; the four-bar, every element with constants that
# follow from tunable parameters, the parallelogram that passes singular positions, a disc that rolls, and a ball on ropes and a floor
set -eu
here=$(cd "$(dirname "$0")" && pwd)
root=$here/../../..
mbgen=$root/build/mbgen steps=1000 form=
while getopts b:f:n: option; do
  case $option in
    b) mbgen=$OPTARG ;;
    f) form="--form $OPTARG" ;;
    n) steps=$OPTARG ;;
    *) exit 2 ;;
  esac
done
shift $((OPTIND - 1))
# The four-bar's spring pulls with 69 N at 0.3 m. The wheels of all elements carry 5 kN, 1 m from the frame's origin, and its
# frozen partition is used down to pivots of a tenth. The disc is pressed with 30 N on its rim, 0.3 m from its centre.
[ $# -gt 0 ] || set -- "$root/models/four_bar.json=20" "$root/tests/data/models/all_elements.json=5e3,80" \
  "$root/models/iftomm/a02_n_four_bar_2.json" "$root/models/rolling_disc.json=10" \
  "$root/tests/data/models/hung_ball.json=30"
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
flags="-std=c++17 -O1 -fno-math-errno -ffp-contract=off -Wall -Wextra -Wno-psabi -Wdouble-promotion -Werror"

failures=0 cases=0
for march in "" -march=x86-64-v3; do
  [ -z "$form" ] || continue  # the elementary functions are the same in every form
  # shellcheck disable=SC2086  # empty or a word
  g++ $flags $march -I "$root/runtime/include" "$here/elementary.cpp" -o "$scratch/elementary"
  if [ -z "$march" ] || grep -qw fma /proc/cpuinfo; then
    cases=$((cases + 1))
    "$scratch/elementary" || failures=$((failures + 1))
  fi
done

# build_solver SOLVER OPTION...: the object of a solver.
build_solver() {
  solver=$1
  shift
  # shellcheck disable=SC2086  # no word or two
  "$mbgen" generate "$model" --no-runtime --name "$solver" $form --out "$directory" "$@" >/dev/null
  # shellcheck disable=SC2086  # several words
  g++ $flags -I "$root/runtime/include" -I "$directory" -c "$directory/$solver.cpp" -o "$directory/$solver.o"
}

for argument in "$@"; do
  model=${argument%=*} moment=0 units=8
  [ "$model" = "$argument" ] || moment=${argument##*=}
  [ "$moment" = "${moment%,*}" ] || units=${moment##*,} moment=${moment%,*}
  name=$(basename "$model" .json)
  directory=$scratch/$name
  build_solver "${name}_double" &
  build_solver "${name}_float" --scalar float
  wait $!
  # shellcheck disable=SC2086  # several words
  g++ $flags -I "$root/runtime/include" -I "$directory" -DSOLVER="${name}_double" -DSINGLE="${name}_float" \
    "-DDOUBLE_INTERFACE=<${name}_double.hpp>" "-DSINGLE_INTERFACE=<${name}_float.hpp>" "$here/compare.cpp" \
    "$directory/${name}_double.o" "$directory/${name}_float.o" -o "$directory/compare"
  echo "$name:"
  cases=$((cases + 1))
  "$directory/compare" "$steps" 1e-3 "$moment" "$units" >"$directory/report" || failures=$((failures + 1))
  sed 's/^/  /' "$directory/report"
done
echo "single precision: $cases cases, $failures failures"
[ "$failures" -eq 0 ]
