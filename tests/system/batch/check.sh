#!/bin/sh
# Lanes against the scalar solver, bit for bit, on any model: statuses, states, accelerations, multipliers, outputs.
#   tests/system/batch/check.sh [-b MBGEN] [-c COMPILER] [-w LANES] [-m MARCH] [-s] MODEL.json...
# Default: build/mbgen, c++, 8 lanes, -march=native. The flags are those of the generated CMake file.
# No function may touch the heap. -s: everything under the address and undefined-behaviour sanitizers instead, at -O1.
set -eu

here=$(cd "$(dirname "$0")" && pwd)
binary=$here/../../../build/mbgen
compiler=c++
lanes=8
march=native
sanitizers=
watch=$here/../../support/heap.cpp
while getopts b:c:w:m:s option; do
  case $option in
    b) binary=$OPTARG ;;
    c) compiler=$OPTARG ;;
    w) lanes=$OPTARG ;;
    m) march=$OPTARG ;;
    s)
      export CMAKE_CXX_COMPILER_LAUNCHER="$here/../../tools/quick.sh" QUICK=-O1
      sanitizers="-fsanitize=address,undefined,float-divide-by-zero,float-cast-overflow -fno-sanitize-recover=all"
      watch=
      ;;
    *) exit 2 ;;
  esac
done
shift $((OPTIND - 1))

scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
failures=0
for model in "$@"; do
  directory=$scratch/$(basename "$model" .json)
  "$binary" generate "$model" --batch "$lanes" --out "$directory" >/dev/null
  name=$(basename "$(ls "$directory"/*_batch.hpp)" _batch.hpp)
  cmake -S "$directory" -B "$directory/build" -DCMAKE_CXX_COMPILER="$compiler" -DMBGEN_MARCH="$march" \
    -DCMAKE_CXX_FLAGS="$sanitizers" >/dev/null
  cmake --build "$directory/build" >/dev/null
  # shellcheck disable=SC2086  # several words or none
  "$compiler" -std=c++17 -O1 $sanitizers -I "$directory" -DSOLVER="$name" -DINTERFACE="\"${name}_batch.hpp\"" \
    "$here/check.cpp" $watch "$directory/build/lib$name.a" -o "$directory/check"
  if "$directory/check"; then
    echo "$name, $lanes lanes, $compiler${sanitizers:+, sanitized}: the same"
  else
    failures=$((failures + 1))
  fi
done
[ "$failures" -eq 0 ]
