#!/bin/sh
# Makes the tables of docs/evidence/verification.md anew and puts them between the markers there: docs/evidence/verification.sh [BUILD] [--long]
# BUILD: a build directory with the tests, default build/release. Half a minute; with --long also what takes minutes.
set -eu
here=$(cd "$(dirname "$0")" && pwd)
build=${1:-$here/../../build/release}
page=$here/verification.md
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT

"$build/verification_table" > "$scratch/published"
[ "${2:-}" != --long ] || "$build/verification_table" --long > "$scratch/long"

# From the lines that the tests print: "MODEL: accelerations as in Simbody, 1.0e-13 relative" and the like.
"$build/oracle_test" > "$scratch/lines"
awk '
  { model = $1; sub(/:$/, "", model) }
  /: accelerations as in Simbody/ { order[++count] = model; accelerations[model] = $(NF - 1) }
  /: accelerations as in MuJoCo/ { tree[model] = $(NF - 1) }
  / carry what Simbody says/ { reactions[model] = $10 " (" $2 ")" }
  /: 5 s as in Simbody/ { motion[model] = $7 }
  END {
    print "| model | accelerations | reactions (joints and rods) | accelerations, MuJoCo | 5 s of motion |"
    print "|---|---|---|---|---|"
    for (i = 1; i <= count; ++i) {
      m = order[i]
      printf "| %s | %s | %s | %s | %s |\n", m, accelerations[m], reactions[m], tree[m], motion[m]
    }
  }' "$scratch/lines" > "$scratch/oracle"

awk -v folder="$scratch" '
  /^<!-- [a-z]*: end -->/ { inside = 0 }
  !inside { print }
  /^<!-- [a-z]*: begin -->/ {
    table = folder "/" substr($2, 1, length($2) - 1)
    while ((getline line < table) > 0) { print line; inside = 1 }  # no table, no change
  }' "$page" > "$scratch/page"
cat "$scratch/page" > "$page"
