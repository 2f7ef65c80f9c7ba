#!/bin/sh
# Largest relative difference of the Cartesian judges' accelerations from the generated code's: docs/method/judges.sh [MBGEN [MODEL..]]
# Prints the table in docs/method/judges.md: eight random closed states of each model, the error of a state being the largest
# difference over its largest acceleration.
set -eu
here=$(cd "$(dirname "$0")" && pwd)
mbgen=${1:-$here/../../build/release/mbgen}
[ $# -gt 0 ] && shift
[ $# -gt 0 ] || set -- "$here"/../../models/*.json
judges="augmented range-space null-space maggi"
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT

# Random values around the reference: a Lehmer generator, so that every awk draws the same ones.
random_states() {
  awk -v n="$1" '
    function uniform() { seed = (seed * 16807) % 2147483647; return 2 * seed / 2147483647 - 1 }
    function list(size,   text, i) { for (i = 0; i < n; ++i) text = text (i ? "," : "") size * uniform(); return "[" text "]" }
    BEGIN {
      seed = 20120401
      for (s = 0; s < 8; ++s) states = states (s ? "," : "") "{\"z\":" list(0.03) ",\"zd\":" list(0.5) "}"
      print "{\"states\":[" states "]}"
    }'
}

# The accelerations in the output of evaluate, one state a line.
accelerations() { grep -o '"zdd":\(\[[^]]*\]\|null\)' | tr -d '[]"zd:'; }

largest_difference() {
  awk -F, '
    NR == FNR { expected[FNR] = $0; next }
    $0 == "null" || expected[FNR] == "null" { print "no accelerations"; failed = 1; exit }
    {
      split(expected[FNR], right); error = size = 0
      for (i = 1; i <= NF; ++i) {
        d = $i - right[i]; d = d < 0 ? -d : d; a = right[i] < 0 ? -right[i] : right[i]
        if (d > error) error = d
        if (a > size) size = a
      }
      if (size > 0 && error / size > worst) worst = error / size
    }
    END { if (!failed) printf "%.0e\n", worst }' "$1" "$2"
}

echo "| model | $(echo "$judges" | sed 's/ / | /g') |"
echo "|---|---|---|---|---|"
for model in "$@"; do
  count=$("$mbgen" inspect "$model" --json | grep -o '"relative_coordinates": [0-9]*' | grep -o '[0-9]*')
  random_states "$count" > "$scratch/open.json"
  # The output of evaluate after projection is itself a file of states.
  "$mbgen" evaluate "$model" --states "$scratch/open.json" --project --engine generic |
    sed 's/"zdd":\[[^]]*\],//g' > "$scratch/closed.json"
  "$mbgen" evaluate "$model" --states "$scratch/closed.json" | accelerations > "$scratch/generated"
  row="| $(basename "$model" .json)"
  for judge in $judges; do
    "$mbgen" evaluate "$model" --states "$scratch/closed.json" --engine "$judge" | accelerations > "$scratch/judge"
    row="$row | $(largest_difference "$scratch/generated" "$scratch/judge")"
  done
  echo "$row |"
done
