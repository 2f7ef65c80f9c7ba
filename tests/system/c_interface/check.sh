#!/bin/sh
# The C interface and the Python module of the four-bar, built by the emitted CMake file alone:
#   tests/system/c_interface/check.sh MBGEN [SCALAR]      default: double
set -eu
here=$(cd "$(dirname "$0")" && pwd)
mbgen=$(realpath "$1")
scalar=${2:-double}
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
"$mbgen" generate "$here/../../../models/four_bar.json" --c-api --scalar "$scalar" --out "$scratch/four_bar" >/dev/null
cmake -S "$scratch/four_bar" -B "$scratch/four_bar/build" >/dev/null
cmake --build "$scratch/four_bar/build" >/dev/null
warnings="-Wall -Wextra -Wpedantic -Wconversion -Wshadow -Wdouble-promotion -Werror"
caller="-I $scratch/four_bar"
[ "$scalar" = double ] || caller="$caller -DSINGLE_PRECISION"
library=$scratch/four_bar/build/libfour_bar.a
# shellcheck disable=SC2086  # several words
{
  cc -std=c99 $warnings -Wstrict-prototypes $caller -c "$here/check.c" -o "$scratch/check.o"
  c++ -std=c++17 $warnings -I "$scratch/four_bar" "$here/native.cpp" "$library" -o "$scratch/native"
  c++ -std=c++17 $warnings -O2 -ffp-contract=off -I "$scratch/four_bar" -c "$scratch/four_bar/four_bar_c.cpp" -o "$scratch/o"
}
cc "$scratch/check.o" "$library" -lm -o "$scratch/check"
"$scratch/native" >"$scratch/native.txt"
"$scratch/check" >"$scratch/check.txt"
cmp "$scratch/native.txt" "$scratch/check.txt"
echo "C99 caller: bits of the solver"
# The same for aarch64, static and shared, where its compiler and qemu are installed.
if command -v aarch64-linux-gnu-g++ >/dev/null 2>&1 && command -v qemu-aarch64 >/dev/null 2>&1; then
  build=$scratch/four_bar/aarch64
  cmake -S "$scratch/four_bar" -B "$build" -DCMAKE_CXX_COMPILER=aarch64-linux-gnu-g++ -DCMAKE_SYSTEM_NAME=Linux \
    -DCMAKE_SYSTEM_PROCESSOR=aarch64 >/dev/null
  cmake --build "$build" >/dev/null
  # shellcheck disable=SC2086  # several words
  aarch64-linux-gnu-gcc -std=c99 $caller -c "$here/check.c" -o "$build/check.o"
  aarch64-linux-gnu-gcc "$build/check.o" "$build/libfour_bar.a" -static -lm -o "$build/static"
  aarch64-linux-gnu-gcc "$build/check.o" -L "$build" -lfour_bar_c -Wl,-rpath,"$build" -lm -o "$build/shared"
  qemu-aarch64 "$build/static" | cmp - "$scratch/native.txt"
  qemu-aarch64 -L /usr/aarch64-linux-gnu "$build/shared" | cmp - "$scratch/native.txt"
  echo "C99 caller on aarch64, static and shared: bits of the solver"
else
  echo "C99 caller on aarch64: skipped, aarch64-linux-gnu-g++ or qemu-aarch64 is not installed (apt-get install g++-aarch64-linux-gnu qemu-user)"
fi
# The examples of docs/use/embedding.md say the same.
examples=$here/../../../examples/c_interface
cc -std=c99 -Wall -Wextra -Wpedantic -Werror -I "$scratch/four_bar" "$examples/four_bar.c" "$library" -lm -o "$scratch/example"
"$scratch/example" >"$scratch/example.txt"
[ "$(wc -l <"$scratch/example.txt")" -eq 4 ]
symbols=$(nm -D --defined-only "$scratch/four_bar/build/libfour_bar_c.so" | awk '{ print $3 }' | grep -v '^four_bar_' || true)
[ -z "$symbols" ] || { echo "the shared library exports more: $symbols"; exit 1; }
needed=$(nm -D --undefined-only "$scratch/four_bar/build/libfour_bar_c.so" | grep -E ' (U|v) ' | grep -vE 'sin|cos|GLIBC' || true)
[ -z "$needed" ] || { echo "the shared library needs more than libm: $needed"; exit 1; }
for python in python3 /usr/bin/python3; do
  if "$python" -c 'import numpy' 2>/dev/null; then
    "$python" "$here/check.py" "$scratch/four_bar" >"$scratch/python.txt"
    cmp "$scratch/native.txt" "$scratch/python.txt"
    "$python" "$examples/four_bar_run.py" "$scratch/four_bar" | cmp - "$scratch/example.txt"
    echo "Python module: bits of the solver"
    exit 0
  fi
done
echo "Python module: skipped, python3 with numpy is not installed (apt-get install python3-numpy)"
