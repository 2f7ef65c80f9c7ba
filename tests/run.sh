#!/bin/sh
# Installs what is missing (Debian 12, as root), builds everything, runs the tests, counts their cases.
# --long: the tests with the label "long" too, which repeat at greater length what others check.
set -eu
without="-LE ^long$"
if [ "${1:-}" = --long ]; then without=; fi
cd "$(dirname "$0")/.."

.ci/install g++ binutils cmake make ninja-build libeigen3-dev libfmt-dev nlohmann-json3-dev libcli11-dev \
  libpugixml-dev libopenblas-serial-dev libsuitesparse-dev libsundials-dev libceres-dev libnlopt-dev libgtest-dev libbenchmark-dev nodejs npm python3
# All else is fetched and unpacked while the compiler has the processors.
.ci/install clang libsimbody-dev libmujoco-dev libclang-rt-14-dev patch locales python3-numpy python3-scipy dpkg-dev \
  pkg-config libxml2-utils file g++-aarch64-linux-gnu qemu-user openmpi-bin chromium &
installation=$!
# gold, of binutils, links in half the time. The two longest rooms are compiled meanwhile; tests look for the solvers of
# others, which are there later.
cmake --preset release -DMBGEN_TESTS=OFF -DMBGEN_BENCH=OFF -DCMAKE_EXE_LINKER_FLAGS=-fuse-ld=gold \
  -DCMAKE_COMPILE_WARNING_AS_ERROR=ON
cmake --build --preset release --target mbgen_generic mbgen_judges
wait "$installation"
cmake --preset release -DMBGEN_TESTS=ON
cmake --build --preset release
status=0
# shellcheck disable=SC2086  # two words, or none
ctest --preset release --parallel "$(nproc)" $without || status=$?
awk -f tests/tools/cases.awk build/release/Testing/Temporary/LastTest.log
exit "$status"
