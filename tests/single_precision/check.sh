#!/bin/sh
# Solvers in single precision against the same in double precision: accelerations and trajectories within bounds that
# compare.cpp derives, the same bits from g++ and clang++, no float promoted to a double unseen.
#   tests/single_precision/check.sh [-b MBGEN] [-n STEPS] [MODEL.json...]
# default: build/mbgen, 500 steps of 1 ms, the four-bar, the slider-crank and the coach's mechanism
set -eu
here=$(cd "$(dirname "$0")" && pwd)
root=$here/../..
mbgen=$root/build/mbgen steps=500
while getopts b:n: option; do
  case $option in
    b) mbgen=$OPTARG ;;
    n) steps=$OPTARG ;;
    *) exit 2 ;;
  esac
done
shift $((OPTIND - 1))
[ $# -gt 0 ] || set -- "$root/models/four_bar.json" "$root/models/slider_crank.json" "$root/models/coach_mechanism.json"
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
flags="-std=c++17 -O1 -fno-math-errno -ffp-contract=off -Wall -Wextra -Wno-psabi -Wdouble-promotion -Werror"

failures=0 cases=0
for march in "" -march=x86-64-v3; do
  # shellcheck disable=SC2086  # empty or a word
  g++ $flags $march -I "$root/runtime/include" "$here/elementary.cpp" -o "$scratch/elementary"
  if [ -z "$march" ] || grep -qw fma /proc/cpuinfo; then
    cases=$((cases + 1))
    "$scratch/elementary" || failures=$((failures + 1))
  fi
done
for other in --c-api "--batch 4"; do
  cases=$((cases + 1))
  # shellcheck disable=SC2086  # several words
  if "$mbgen" generate "$1" --scalar float $other --out "$scratch/refused" 2>"$scratch/message"; then
    echo "--scalar float $other: not refused"
    failures=$((failures + 1))
  fi
  grep -q -- '--scalar float' "$scratch/message" || failures=$((failures + 1))
done
for model in "$@"; do
  name=$(basename "$model" .json)
  directory=$scratch/$name
  "$mbgen" generate "$model" --c-api --out "$directory/double" >/dev/null
  "$mbgen" generate "$model" --scalar float --no-runtime --out "$directory/float" >/dev/null
  # The solver in single precision under a name of its own, so that both are in one program.
  for file in hpp cpp; do
    sed "s/\\b$name::/${name}_float::/g; s/namespace $name\\b/namespace ${name}_float/; s/\"$name.hpp\"/\"${name}_float.hpp\"/" \
      "$directory/float/$name.$file" >"$directory/float/${name}_float.$file"
  done
  sed -n '/^constexpr double kInitial/,/;$/p' "$directory/double/${name}_c.cpp" >"$directory/initial.hpp"
  include="-I $directory -I $directory/double -I $directory/float"
  echo "$name:"
  # shellcheck disable=SC2086  # several words
  (
    cd "$directory"
    g++ $flags $include -c "double/$name.cpp" -o double.o
    for compiler in g++ clang++; do
      $compiler $flags $include -c "float/${name}_float.cpp" -o "$compiler.o"
      g++ $flags $include -DSOLVER="$name" -DSINGLE="${name}_float" "-DDOUBLE_INTERFACE=<$name.hpp>" \
        "-DSINGLE_INTERFACE=<${name}_float.hpp>" "$here/compare.cpp" double.o "$compiler.o" -o "$compiler.run"
    done
  )
  cases=$((cases + 2))
  "$directory/g++.run" "$steps" 1e-3 >"$directory/g++.txt" || failures=$((failures + 1))
  sed 's/^/  /' "$directory/g++.txt"
  "$directory/clang++.run" "$steps" 1e-3 >"$directory/clang++.txt" || true
  if ! cmp -s "$directory/g++.txt" "$directory/clang++.txt"; then
    echo "  clang++ DIFFERS: $(diff "$directory/g++.txt" "$directory/clang++.txt" | grep '^[<>]')"
    failures=$((failures + 1))
  fi
done
echo "single precision: $cases cases, $failures failures"
[ "$failures" -eq 0 ]
