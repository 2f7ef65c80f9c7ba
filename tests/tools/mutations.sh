#!/bin/sh
# Puts in the faults of tests/tools/mutations.txt one by one, in a copy of the sources, and prints what catches each as a
# table: tests/tools/mutations.sh [SCRATCH]
# SCRATCH: where to build, kept; default a temporary directory. Half an hour on two processors.
set -eu
here=$(cd "$(dirname "$0")/../.." && pwd)
scratch=${1:-$(mktemp -d)}
tree=$scratch/tree
mkdir -p "$tree"
export CCACHE_BASEDIR="$tree" CCACHE_NOHASHDIR=1

# Verdict of a suite on the fault that is in.
verdict() {
  test=$tree/build/$1_test
  if ! ninja -C "$tree/build" "$1_test" > "$scratch/build.log" 2>&1; then
    echo "does not compile"
  elif timeout 600 "$test" > "$scratch/run.log" 2>&1; then
    echo "**nothing**"
  else
    sed -n 's/^\[  FAILED  \] \([A-Za-z]*[/.][^ ,]*\).*/\1/p' "$scratch/run.log" | sort -u > "$scratch/failed"
    echo "$(wc -l < "$scratch/failed") tests of \`$1_test\`, first \`$(head -n 1 "$scratch/failed")\`"
  fi
}

(cd "$here" && git ls-files -z | xargs -0 cp --parents -u -p -t "$tree")
cmake -S "$tree" -B "$tree/build" -G Ninja -DCMAKE_BUILD_TYPE=Release > /dev/null
ninja -C "$tree/build" reader_test emit_test oracle_test published_test > /dev/null
echo "| fault | file | caught by |"
echo "|---|---|---|"
grep -v '^#' "$here/tests/tools/mutations.txt" | while IFS='|' read -r suite file expression what; do
  # shellcheck disable=SC2116,SC2086  # without the blanks around
  suite=$(echo $suite) file=$(echo $file)
  cp "$tree/$file" "$scratch/sound"
  sed -i "$expression" "$tree/$file"
  if cmp -s "$tree/$file" "$scratch/sound"; then
    echo "$file: nothing to replace by $expression" >&2
    exit 1
  fi
  echo "|$what | \`$file\` | $(verdict "$suite") |"
  cp "$scratch/sound" "$tree/$file"
done
