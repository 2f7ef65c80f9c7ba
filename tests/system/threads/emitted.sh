#!/bin/sh
# Emitted code, scalar and in lanes, by four threads at once under the thread sanitizer: emitted.sh MBGEN MODEL.json...
set -eu
here=$(cd "$(dirname "$0")" && pwd)
mbgen=$1
shift
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
for model in "$@"; do
  directory=$scratch/$(basename "$model" .json)
  "$mbgen" generate "$model" --batch 4 --out "$directory" >/dev/null
  name=$(basename "$(ls "$directory"/*_batch.hpp)" _batch.hpp)
  cmake -S "$directory" -B "$directory/build" -DCMAKE_CXX_FLAGS=-fsanitize=thread >/dev/null
  cmake --build "$directory/build" >/dev/null
  c++ -std=c++17 -O1 -fsanitize=thread -I "$directory" -DSOLVER="$name" -DINTERFACE="\"${name}_batch.hpp\"" \
    "$here/emitted.cpp" "$directory/build/lib$name.a" -o "$directory/threads"
  TSAN_OPTIONS=halt_on_error=1 "$directory/threads"
  echo "$name: four threads give the bits of one"
done
