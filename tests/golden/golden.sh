#!/bin/sh
# Golden files: generates the chosen models again and compares with generated/, byte for byte.
#   tests/golden/golden.sh [--update] [MBGEN]
# MBGEN: the binary, default build/release/mbgen, else build/mbgen.
# --update: takes the generated files as the new golden files.
# Of a model with --reading the copy for people is kept in full, and of its fast solver hashes, counts and bits: fast.txt.
set -eu

here=$(cd "$(dirname "$0")" && pwd)
root=$(cd "$here/../.." && pwd)
update=no
binary=
for argument in "$@"; do
  case $argument in
    --update) update=yes ;;
    *) binary=$argument ;;
  esac
done
if [ -z "$binary" ]; then
  for binary in "$root/build/release/mbgen" "$root/build/mbgen"; do
    [ -x "$binary" ] && break
  done
fi
if [ ! -x "$binary" ]; then
  echo "golden: no mbgen at $binary; build it, or name it: tests/golden/golden.sh MBGEN" >&2
  exit 1
fi

# Fast solver of a model: hashes and lines of its files, operations, accelerations at the reference states.
fast_solver() {
  "$binary" generate "$root/models/$1.json" --out "$scratch/fast" --no-runtime >/dev/null
  (cd "$scratch/fast" && sha256sum -- * && wc -l -- * && grep -E '^  (Operations of|total)' ./*_cost.txt)
  "$binary" evaluate "$root/models/$1.json" --states "$root/tests/data/reference/${1%_mechanism}_states.json" >"$scratch/bits"
  sha256sum <"$scratch/bits"
  head -n 60 "$scratch/bits"
}

scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
failures=0
while read -r model options; do
  # shellcheck disable=SC2086  # options are words
  "$binary" generate "$root/models/$model.json" --out "$scratch/$model" --no-runtime $options >/dev/null
  case $options in
    *--reading*) fast_solver "$model" >"$scratch/fast.txt" && mv "$scratch/fast.txt" "$scratch/$model" ;;
  esac
  if [ "$update" = yes ]; then
    rm -rf "${root:?}/generated/$model"
    mkdir -p "$root/generated"
    cp -R "$scratch/$model" "$root/generated/$model"
    echo "golden: generated/$model is up to date"
  elif ! diff -ruN "$root/generated/$model" "$scratch/$model" >"$scratch/$model.diff"; then
    # A change of the compiler can touch every line: the first hundred say what it is about.
    head -n 100 "$scratch/$model.diff"
    echo "golden: generated/$model differs in $(wc -l <"$scratch/$model.diff") lines of diff"
    failures=$((failures + 1))
  else
    echo "golden: generated/$model is the same"
  fi
done <"$here/models.txt"

if [ "$failures" -gt 0 ]; then
  echo "golden: when the new code is right, take it with: tests/golden/golden.sh --update"
  exit 1
fi
