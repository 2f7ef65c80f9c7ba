#!/bin/sh
# The same trajectories, bit for bit, from g++ and clang++ on x86-64 and from g++ for aarch64 (under qemu), by the CMake
# file of the emitted solver; see docs/evidence/determinism.md. Missing compilers are left out with a message.
#   tests/system/determinism/trajectories.sh [-b MBGEN] [-i] [-s SCALAR] [MODEL.json...]
# default: build/mbgen, double and float, the linkages, all elements, the coach
# -i: installs the cross compiler and qemu first (Debian, as root). -s: double or float only.
set -eu
here=$(cd "$(dirname "$0")" && pwd)
root=$here/../../..
mbgen=$root/build/mbgen
scalars="double float"
while getopts b:is: option; do
  case $option in
    b) mbgen=$OPTARG ;;
    i) "$root/.ci/install" g++ clang cmake make g++-aarch64-linux-gnu qemu-user ;;
    s) scalars=$OPTARG ;;
    *) exit 2 ;;
  esac
done
shift $((OPTIND - 1))
if [ $# -eq 0 ]; then
  set -- "$root/models/four_bar.json" "$root/models/slider_crank.json" "$root/models/andrews_squeezer.json" \
    "$root/tests/data/models/all_elements.json" "$root/models/coach.json"
fi
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT

is_there() { command -v "$1" >/dev/null 2>&1; }

# trajectory SOLVER_DIRECTORY NAME TAG COMPILER RUNNER CMAKE_OPTION...: the text of the trajectory, or nothing.
trajectory() {
  directory=$1 name=$2 tag=$3 compiler=$4 runner=$5
  shift 5
  if ! is_there "$compiler" || { [ -n "$runner" ] && ! is_there "$runner"; }; then
    echo "  $tag: skipped, $compiler ${runner:+or $runner }is not installed"
    return
  fi
  cmake -S "$directory" -B "$directory/$tag" -DCMAKE_CXX_COMPILER="$compiler" "$@" >/dev/null
  cmake --build "$directory/$tag" >/dev/null
  "$compiler" -std=c++17 -O1 -ffp-contract=off -static -I "$directory" -DSOLVER="$name" \
    -DINTERFACE="\"$name.hpp\"" "$here/trajectory.cpp" "$directory/$tag/lib$name.a" -o "$directory/$tag/run"
  $runner "$directory/$tag/run" >"$directory/$tag.txt"
}

# compare SOLVER_DIRECTORY TAG...: each trajectory with the first that is there.
compare() {
  directory=$1
  shift
  first=
  for tag in "$@"; do
    [ -f "$directory/$tag.txt" ] || continue
    if [ -z "$first" ]; then
      first=$tag
      echo "  $tag: $(wc -l <"$directory/$tag.txt") lines, $(sha256sum <"$directory/$tag.txt" | cut -c1-16)"
    elif cmp -s "$directory/$first.txt" "$directory/$tag.txt"; then
      echo "  $tag: the same"
    else
      echo "  $tag: DIFFERS from $first, in lines $(diff "$directory/$first.txt" "$directory/$tag.txt" | grep -c '^<')"
      failures=$((failures + 1))
    fi
  done
}

failures=0
cross="-DCMAKE_SYSTEM_NAME=Linux -DCMAKE_SYSTEM_PROCESSOR=aarch64"
# trajectories MODEL SCALAR
trajectories() {
  directory=$scratch/$(basename "$1" .json).$2
  "$mbgen" generate "$1" --scalar "$2" --out "$directory" >/dev/null
  name=$(basename "$(ls "$directory"/*.json)" .json)
  echo "$name, $2:"
  trajectory "$directory" "$name" x86-64-g++ g++ ""
  trajectory "$directory" "$name" x86-64-clang++ clang++ ""
  # shellcheck disable=SC2086  # several words
  trajectory "$directory" "$name" aarch64-g++ aarch64-linux-gnu-g++ qemu-aarch64 $cross
  compare "$directory" x86-64-g++ x86-64-clang++ aarch64-g++
}

for model in "$@"; do
  for scalar in $scalars; do trajectories "$model" "$scalar"; done
done
if [ "$failures" -gt 0 ]; then
  echo "trajectories: $failures differ"
  exit 1
fi
echo "trajectories: all are the same"
