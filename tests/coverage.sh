#!/bin/sh
# Line coverage of compiler/ and runtime/ by the whole suite: tests/coverage.sh [BUILD], default build/coverage.
# Installs gcovr; some 20 minutes on two processors. Prints one line per room and the total, fails below 90 %.
set -eu
cd "$(dirname "$0")/.."
build=${1:-build/coverage}
.ci/install gcovr >&2
cmake -S . -B "$build" -G Ninja -DCMAKE_BUILD_TYPE=None -DMBGEN_TESTS=ON -DMBGEN_BENCH=OFF \
  -DCMAKE_CXX_FLAGS="-O1 --coverage -fprofile-update=atomic" >&2
cmake --build "$build" >&2
find "$build" -name '*.gcda' -delete
ctest --test-dir "$build" --parallel "$(nproc)" --output-on-failure --exclude-regex 'fuzz|determinism' >&2
gcovr --root . --filter compiler/ --filter runtime/ --exclude-throw-branches --exclude-unreachable-branches \
  --gcov-ignore-parse-errors --json-summary "$build/coverage.json" --fail-under-line 90 "$build" >"$build/coverage.txt" ||
  status=$?
awk -F'[ \t]+' '/^(compiler|runtime)\// && NF >= 3 { print }' "$build/coverage.txt" >"$build/files.txt"
tail -n 4 "$build/coverage.txt"
exit "${status:-0}"
