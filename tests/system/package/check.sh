#!/bin/sh
# Installs mbgen from a build directory and builds a project outside the tree with it, by Ninja and by Make, for this
# machine and for aarch64; then the same from the Debian package. Missing tools are left out with a message.
#   tests/system/package/check.sh BUILD [GENERATOR]
# GENERATOR: nothing but all of its builds; otherwise that the rules are written anew is seen with Ninja alone.
set -eu
here=$(cd "$(dirname "$0")" && pwd)
root=$(cd "$here/../../.." && pwd)
build=$(realpath "$1")
only=${2:-}
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
project="$scratch/a project"  # paths with blanks have to be escaped in rules of Make
cases=0

is_there() { command -v "$1" >/dev/null 2>&1; }

passed() {
  cases=$((cases + 1))
  echo "package: $1"
}

fail() {
  echo "package: FAILS: $1"
  [ ! -f "$scratch/log" ] || tail -n 40 "$scratch/log"
  exit 1
}

# logged COMMAND...: its output is shown when it fails.
logged() { "$@" >"$scratch/log" 2>&1 || fail "$*"; }

# refused WORDS COMMAND...: fails, and says WORDS.
refused() {
  words=$1
  shift
  if "$@" >"$scratch/log" 2>&1; then fail "taken: $*"; fi
  tr -s '\n ' ' ' <"$scratch/log" | grep -qF -- "$words" || fail "does not say \"$words\": $*"
}

# no_way_back DIRECTORY: no file in it knows where it was built; assertions and sanitizers of other builds do.
no_way_back() {
  grep -q '^CMAKE_BUILD_TYPE:[A-Z]*=Release$' "$build/CMakeCache.txt" || return 0
  if grep -rlF -e "$root" -e "$build" "$1" >"$scratch/log"; then fail "files point back to the tree"; fi
}

# Which files the package has, that none of them knows where it was built, that it may be moved.
check_installation() {
  logged cmake --install "$build" --strip --prefix "$scratch/first"
  no_way_back "$scratch/first"
  if readelf -d "$scratch/first/bin/mbgen" | grep -E 'RPATH|RUNPATH' >"$scratch/log"; then fail "mbgen has a run path"; fi
  mv "$scratch/first" "$scratch/installed"
  (cd "$scratch" && env -i installed/bin/mbgen generate "$project/models/swing.json" --out alone >/dev/null)
  passed "installed and moved: $(find "$scratch/installed" -type f | wc -l) files"
}

# When both solvers and the program that links them were written, in nanoseconds.
stamps() {
  for file in mbgen_models/swing/swing.hpp mbgen_models/swing-matrix/by_matrix.cpp run; do date -r "$1/$file" +%s%N; done
}

# expect_after CHANGE anew|as_before BUILD: what a build after a change did to all of them.
expect_after() {
  before=$(stamps "$3")
  logged cmake --build "$3" --target run --parallel 2
  after=$(stamps "$3")
  if [ "$2" = as_before ]; then
    [ "$before" = "$after" ] || fail "$1: generated anew"
  else
    for time in $before; do
      case $after in *"$time"*) fail "$1: not generated anew" ;; esac
    done
  fi
  passed "$1: $2"
}

# check_generator GENERATOR BUILD: builds, runs, and generates anew what has to be.
check_generator() {
  models=$project/models
  logged cmake -S "$project" -B "$2" -G "$1" -DCMAKE_PREFIX_PATH="$scratch/installed" -DMBGEN_MARCH=
  logged cmake --build "$2" --parallel 2
  "$2/run" >"$2/run.txt" || fail "$1: the solvers differ"
  "$2/run_c" | cmp - "$2/run.txt" || fail "$1: the C interface differs"
  passed "$1: $(cat "$2/run.txt")"
  expect_after "$1: nothing changed" as_before "$2"
  touch "$models/parts/unused.json"
  expect_after "$1: a file that is not included touched" as_before "$2"
  touch "$models/parts/masses.json"
  expect_after "$1: an included file touched" anew "$2"
  expect_after "$1: nothing changed again" as_before "$2"
  [ "$1" = "${only:-Ninja}" ] || return 0
  # One more include, known from the rule that the last run wrote.
  sed -i 's|"parts/masses.json"|"parts/masses.json", "parts/more.json"|' "$models/swing.json"
  echo '{ "mbgen": 1, "gravity": [0, 0, -1.62] }' >"$models/parts/more.json"
  expect_after "$1: another file included" anew "$2"
  "$2/run" >"$2/moon.txt"
  if cmp -s "$2/run.txt" "$2/moon.txt"; then fail "$1: the program is as before"; fi
  # A mistake in that file stops the build, names its place, and is mended.
  echo '{ "mbgen": 1, "gravty": [0, 0, -1.62] }' >"$models/parts/more.json"
  refused 'unknown key "gravty"' cmake --build "$2"
  cp "$here/project/models/swing.json" "$models/swing.json"
  expect_after "$1: mended" anew "$2"
  "$2/run" | cmp - "$2/run.txt" || fail "$1: not what it was"
}

# flags_of BUILD FILE: the words of the compiler's command that are no paths.
flags_of() {
  grep '"command"' "$1/compile_commands.json" | grep -F "$2.cpp.o" | tr ' ' '\n' | grep -E '^-[OfmWs]' | sort
}

# The package compiles as the CMakeLists.txt of the emitted code does, with each compiler.
check_flags() {
  models=$here/project/models
  "$scratch/installed/bin/mbgen" generate "$models/swing.json" --name swing --batch 4 --form recursive --c-api \
    --out "$scratch/alone_$1" >/dev/null
  logged cmake -S "$scratch/alone_$1" -B "$scratch/alone_$1/build" -DCMAKE_EXPORT_COMPILE_COMMANDS=ON -DCMAKE_CXX_COMPILER="$1"
  logged cmake -S "$project" -B "$scratch/flags_$1" -Dmbgen_DIR="$scratch/installed/share/cmake/mbgen" \
    -DCMAKE_CXX_COMPILER="$1"
  for file in swing swing_batch swing_c; do
    flags_of "$scratch/alone_$1/build" /$file >"$scratch/emitted.txt"
    flags_of "$scratch/flags_$1" /$file >"$scratch/package.txt"
    [ "$(wc -l <"$scratch/emitted.txt")" -gt 5 ] || fail "$1: no flags of $file"
    diff "$scratch/emitted.txt" "$scratch/package.txt" >"$scratch/log" || fail "$1: other flags for $file"
  done
  passed "$1: flags of the emitted CMakeLists.txt"
}

# The host's mbgen, a toolchain file, and the bits of this machine.
check_cross() {
  if ! is_there aarch64-linux-gnu-g++ || ! is_there qemu-aarch64; then
    echo "package: aarch64: skipped, g++-aarch64-linux-gnu or qemu-user is not installed"
    return
  fi
  target=$scratch/aarch64
  logged cmake -S "$project" -B "$target" -G Ninja -DCMAKE_TOOLCHAIN_FILE="$here/project/aarch64.cmake" \
    -Dmbgen_DIR="$scratch/installed/share/cmake/mbgen"
  logged cmake --build "$target" --target run
  readelf -h "$target/run" | grep -q AArch64 || fail "aarch64: not for it"
  qemu-aarch64 "$target/run" | cmp - "$scratch/ninja build/run.txt" || fail "aarch64: other bits"
  passed "aarch64: the bits of this machine"
}

check_refusals() {
  package=-Dmbgen_DIR=$scratch/installed/share/cmake/mbgen
  refused "set MBGEN_EXECUTABLE to one" cmake -S "$project" -B "$scratch/r1" "$package" -DMBGEN_EXECUTABLE=/bin/true
  logged cmake -S "$project" -B "$scratch/r2" "$package" -DMBGEN_EXECUTABLE="$scratch/installed/bin/mbgen"
  for line in 'MODEL m.json FROM matrix|no argument is called' 'C_API|MODEL file.json is missing' \
    'MODEL m.json FORM|a value is missing after FORM'; do
    mkdir -p "$scratch/wrong"
    cat >"$scratch/wrong/CMakeLists.txt" <<LINES
cmake_minimum_required(VERSION 3.20)
project(wrong LANGUAGES CXX)
find_package(mbgen REQUIRED)
mbgen_add_model(wrong ${line%|*})
LINES
    refused "${line#*|}" cmake -S "$scratch/wrong" -B "$scratch/wrong/build" "$package"
  done
  passed "wrong arguments are named"
}

check_pkg_config() {
  if ! is_there pkg-config; then
    echo "package: pkg-config: skipped, it is not installed"
    return
  fi
  flags=$(PKG_CONFIG_PATH="$1/share/pkgconfig" pkg-config --cflags mbgen)
  compiler=$(PKG_CONFIG_PATH="$1/share/pkgconfig" pkg-config --variable=mbgen mbgen)
  "$compiler" generate "$project/models/swing.json" --name swing --no-runtime --out "$scratch/no_runtime" >/dev/null
  # shellcheck disable=SC2086  # several words
  logged c++ -std=c++17 $flags -c "$scratch/no_runtime/swing.cpp" -o "$scratch/swing.o"
  passed "pkg-config $(PKG_CONFIG_PATH="$1/share/pkgconfig" pkg-config --modversion mbgen)"
}

# An FMU is made when the command export is there.
check_fmu() {
  if ! "$scratch/installed/bin/mbgen" --help | grep -q '^  export '; then
    echo "package: mbgen_add_fmu: skipped, this mbgen has no command export"
    return
  fi
  logged cmake -S "$project" -B "$scratch/fmu" -DCMAKE_PREFIX_PATH="$scratch/installed" -DWITH_FMU=ON
  logged cmake --build "$scratch/fmu" --target unit
  before=$(stat -c '%i %y' "$scratch/fmu/unit.fmu")
  logged cmake --build "$scratch/fmu" --target unit
  [ "$before" = "$(stat -c '%i %y' "$scratch/fmu/unit.fmu")" ] || fail "the FMU is made again for no reason"
  touch "$project/models/parts/masses.json"
  logged cmake --build "$scratch/fmu" --target unit
  [ "$before" != "$(stat -c '%i %y' "$scratch/fmu/unit.fmu")" ] || fail "the FMU does not follow an included file"
  passed "mbgen_add_fmu: made, and again after an included file"
}

# The Debian package, unpacked into a root and used from there by the example of docs/use/embedding.md.
check_debian() {
  if ! is_there dpkg-shlibdeps || ! is_there dpkg-deb; then
    echo "package: Debian: skipped, dpkg-dev is not installed"
    return
  fi
  logged cpack --config "$build/CPackConfig.cmake" -B "$scratch/packages"
  package=$(ls "$scratch"/packages/mbgen_*.deb)
  dpkg-deb -x "$package" "$scratch/root"
  depends=$(dpkg-deb -f "$package" Depends)
  for library in $(readelf -d "$scratch/root/usr/bin/mbgen" "$scratch"/root/usr/lib/mbgen/*.so | sed -n 's/.*NEEDED.*\[\(.*\)\]/\1/p'); do
    # Not that of another architecture; of OpenBLAS any variant will do.
    owner=$(dpkg-query -S "*/$library" 2>/dev/null |
      sed -nE "s/:$(dpkg --print-architecture): .*//;T;s/-(serial|pthread|openmp)$//;p;q")
    case $depends in
      *"$owner"*) ;;
      *) fail "the package depends on \"$depends\", but $library is of \"$owner\"" ;;
    esac
  done
  grep -q licence "$scratch/root/usr/share/doc/mbgen/copyright" || fail "the package says nothing of its licence"
  find "$scratch/root" -type d ! -perm 0755 | grep . && fail "directories with other permissions than 0755"
  no_way_back "$scratch/root"
  cp -r "$root/examples/cmake_project" "$scratch/example"
  logged cmake -S "$scratch/example" -B "$scratch/example/build" -DCMAKE_PREFIX_PATH="$scratch/root/usr"
  logged cmake --build "$scratch/example/build" --parallel 2
  "$scratch/example/build/swing" >"$scratch/log" || fail "the example does not run"
  passed "$(basename "$package"), which depends on $depends: $(tail -n 1 "$scratch/log")"
}

cp -r "$here/project" "$project"
check_installation
export CMAKE_CXX_COMPILER_LAUNCHER="$root/tests/tools/quick.sh"  # the flags that CMake knows stay
if [ -n "$only" ]; then
  check_generator "$only" "$scratch/build"
  echo "package: $cases cases"
  exit 0
fi
check_generator Ninja "$scratch/ninja build"
check_generator "Unix Makefiles" "$scratch/make build"
for compiler in g++ clang++; do
  if is_there $compiler; then check_flags $compiler; else echo "package: $compiler: skipped, it is not installed"; fi
done
check_cross
check_refusals
check_pkg_config "$scratch/installed"
check_fmu
check_debian
echo "package: $cases cases"
