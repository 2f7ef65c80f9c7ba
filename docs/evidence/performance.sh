#!/bin/sh
# Measures anew what docs/evidence/performance.md holds and puts it between the markers there: docs/evidence/performance.sh [OPTION...]
# Options are those of mbgen_compare. Some minutes; the machine should have nothing else to do.
# OTHER_MBGEN: another mbgen, for example of an earlier commit, whose solvers bench/beside.sh then sets beside these.
set -eu
here=$(cd "$(dirname "$0")" && pwd)
root=$here/../..
page=$here/performance.md
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT

# fill NAME: what `$scratch/table` holds, between the markers of this name
fill() {
  awk -v table="$scratch/table" -v name="$1" '
    $0 == "<!-- " name ": end -->" { inside = 0 }
    !inside { print }
    $0 == "<!-- " name ": begin -->" {
      inside = 1
      print "```"
      while ((getline line < table) > 0) print line
      print "```"
    }' "$page" > "$scratch/page"
  cat "$scratch/page" > "$page"
}

"$root/bench/compare.sh" "$@" > "$scratch/table"
fill compare
if [ -n "${OTHER_MBGEN:-}" ]; then
  build=${MBGEN_BUILD:-$root/build/compare}
  cmake --build "$build" --target mbgen >&2
  MBGEN=$build/mbgen "$root/bench/beside.sh" "$OTHER_MBGEN" > "$scratch/table"
  fill beside
fi
