#!/bin/sh
# Line coverage of compiler/ and runtime/ by the suite's programs: tests/tools/coverage.sh [BUILD], default build/coverage.
# Compiled at -O1 with assertions. Installs gcovr; some 25 minutes on two processors. Prints the lines of each file and
# their share in all, fails below 90 %.
set -eu
cd "$(dirname "$0")/../.."
build=${1:-build/coverage}
.ci/install gcovr >&2
cmake -S . -B "$build" -G Ninja -DCMAKE_BUILD_TYPE=None -DMBGEN_TESTS=ON -DMBGEN_BENCH=OFF \
  -DCMAKE_CXX_FLAGS="-O1 --coverage" >&2
cmake --build "$build" >&2
find "$build" \( -name '*.gcda' -o -path '*CompilerId*.gcno' \) -delete
# Whole programs, not test by test: each process merges its counts into the files of all objects.
find "$build" -type f -name '*_test' -perm -u+x -print0 |
  xargs -0 -P "$(nproc)" -n 1 sh -c '"$0" >"$0.log" 2>&1 || { grep -F "[  FAILED  ]" "$0.log" >&2; exit 1; }'
gcovr --root . --filter compiler/ --filter runtime/ --fail-under-line 90 "$build"
