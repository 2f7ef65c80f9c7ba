#!/bin/sh
# The emitted object may need nothing but libm: symbols.sh COMPILER SOURCE RUNTIME_INCLUDE
set -eu
compiler=$1
source=$2
include=$3
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
# -O1 keeps this quick; calls to memcpy, allocation or exceptions would show at any level.
"$compiler" -std=c++17 -O1 -fno-exceptions -fno-rtti -fno-math-errno -fno-tree-loop-distribute-patterns \
  -I"$include" -I"$(dirname "$source")" -c "$source" -o "$scratch/solver.o"
nm -u "$scratch/solver.o" | awk '{print $2}' | sort -u >"$scratch/needed"
nm -D --defined-only "$("$compiler" -print-file-name=libm.so.6)" | awk '{sub(/@.*/, "", $3); print $3}' | sort -u >"$scratch/libm"
if comm -23 "$scratch/needed" "$scratch/libm" | grep -v '^_GLOBAL_OFFSET_TABLE_$'; then
  echo "symbols: $source needs the symbols above, which libm does not have"
  exit 1
fi
echo "symbols: only libm is needed ($(tr '\n' ' ' <"$scratch/needed"))"
