#!/bin/sh
# Measures anew what docs/evidence/performance.md and the figures of docs/use/batch.md hold and puts it between the markers there:
#   docs/evidence/performance.sh [OPTION...]         options of mbgen_compare
#   docs/evidence/performance.sh steps [OPTION...]   whole steps alone, and with them the figures of batches; options of bench/steps.sh
# Some minutes; the machine should have nothing else to do.
# OTHER_MBGEN: another mbgen, for example of an earlier commit, whose solvers bench/beside.sh then sets beside these.
set -eu
here=$(cd "$(dirname "$0")" && pwd)
root=$here/../..
page=$here/performance.md
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT

. "$here/put_table.sh"

# fill NAME: what `$scratch/table` holds, as text between the markers of this name
fill() {
  { echo '```'; cat "$scratch/table"; echo '```'; } | put "$1" "$page"
}

# steps_table: the lines of bench/steps.sh as a table.
steps_table() {
  echo '| model | method | us a step | times real time | instructions | in eight lanes, us per instance | times real time |'
  echo '|---|---|---|---|---|---|---|'
  awk '{ method = $2 == "rk4" ? "Runge-Kutta" : "Adams-Bashforth-Moulton"
         print "| " $1 " | " method " | " $3 " | " $5 " | " $6 " | " $7 " | " $8 " |" }' "$scratch/steps"
}

# batch_table: evaluations as performance.md has them, and these steps.
batch_table() {
  echo '| | alone | eight in lanes | times |'
  echo '|---|---|---|---|'
  awk '/^[^ ].* degrees of freedom/ { sub(/:.*/, ""); model = $0 }
       /^  mbgen, generated, recursive / { alone = $4 }
       /^  mbgen, generated, eight in lanes / && model ~ /^(coach|truck)_mechanism/ {
         printf "| %s, accelerations | %.2f | %.3f | %.1f |\n", model, alone, $6, alone / $6
       }' "$page"
  awk '$2 == "abm4" { printf "| %s, Adams-Bashforth-Moulton step | %s | %s | %.1f |\n", $1, $3, $7, $3 / $7 }' "$scratch/steps"
}

# measure_steps [OPTION...]: whole steps, and what follows from them.
measure_steps() {
  "$root/bench/steps.sh" "$@" | tail -n +2 > "$scratch/steps"
  steps_table | put steps "$page"
  batch_table | put batch "$root/docs/use/batch.md"
}

if [ "${1-}" = steps ]; then
  shift
  measure_steps "$@"
  exit
fi
"$root/bench/compare.sh" "$@" > "$scratch/table"
fill compare
if [ -n "${OTHER_MBGEN:-}" ]; then
  build=${MBGEN_BUILD:-$root/build/compare}
  cmake --build "$build" --target mbgen >&2
  MBGEN=$build/mbgen "$root/bench/beside.sh" "$OTHER_MBGEN" > "$scratch/table"
  fill beside
fi
measure_steps
