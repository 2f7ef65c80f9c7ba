#!/bin/sh
# One definition per name: links mbgen with -flto, where g++ sees types of one name that differ between files, which
# corrupt memory silently: tests/tools/one_definition.sh [BUILD], default build/one_definition. Some 5 minutes on two processors.
set -eu
cd "$(dirname "$0")/../.."
build=${1:-build/one_definition}
cmake -S . -B "$build" -G Ninja -DCMAKE_BUILD_TYPE=None -DCMAKE_CXX_COMPILER=g++ -DMBGEN_TESTS=OFF -DMBGEN_BENCH=OFF \
  -DCMAKE_CXX_FLAGS="-O1 -flto=auto -fno-fat-lto-objects" -DCMAKE_AR=/usr/bin/gcc-ar -DCMAKE_RANLIB=/usr/bin/gcc-ranlib \
  -DCMAKE_EXE_LINKER_FLAGS="-Wodr -Wlto-type-mismatch -Werror=odr" >/dev/null
cmake --build "$build" --target mbgen
echo "one definition: every type of mbgen has one"
