#!/bin/sh
# A solver's object, as committed_test links it, may need nothing but libm: symbols.sh COMPILER OBJECT
set -eu
compiler=$1
object=$2
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
nm -u "$object" | awk '{print $2}' | sort -u >"$scratch/needed"
nm -D --defined-only "$("$compiler" -print-file-name=libm.so.6)" | awk '{sub(/@.*/, "", $3); print $3}' | sort -u >"$scratch/libm"
if comm -23 "$scratch/needed" "$scratch/libm" | grep -v '^_GLOBAL_OFFSET_TABLE_$'; then
  echo "symbols: $object needs the symbols above, which libm does not have"
  exit 1
fi
echo "symbols: only libm is needed ($(tr '\n' ' ' <"$scratch/needed"))"
