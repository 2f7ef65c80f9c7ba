#!/bin/sh
# FMUs of several models: valid, reproducible, alone but for the C library, and run by our own importer:
# tests/fmi/check.sh MBGEN [MODEL:VERSION..]
# MBGEN_FMI_EMULATED: the library for aarch64 is run, too, where there is something that runs it.
set -eu
here=$(cd "$(dirname "$0")" && pwd)
root=$here/../..
mbgen=$(realpath "$1")
shift
[ $# -gt 0 ] || set -- described:3 described:2 triple_rocker:3 driven_cart:3 tyre_rig:3 sampled_slide:3
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
fail() { echo "fmi: $*"; exit 1; }
warnings="-Wall -Wextra -Wpedantic -Wshadow -Werror"
# shellcheck disable=SC2086  # several words
c++ -std=c++17 $warnings -I "$root/templates" "$here/importer.cpp" -o "$scratch/importer" -ldl
libm=$(cc -print-file-name=libm.so.6)
{
  nm -D --defined-only "$libm" | awk '{ sub(/@.*/, "", $3); print $3 }'
  printf '%s\n' calloc free memcmp memcpy memmove memset snprintf
} | sort -u >"$scratch/allowed"

check_schema() {  # SCHEMA FILE
  xmllint --noout --schema "$1" "$2" 2>"$scratch/log" || fail "$(cat "$scratch/log")"
}

# The file of a model: those that only this test uses lie among its data.
file_of() {
  for place in tests/data/fmi models models/starters tests/data/models; do
    [ ! -f "$root/$place/$1.json" ] || { echo "$root/$place/$1.json"; return; }
  done
}

# Whole steps to the last bit.
duration_of() {
  case $1 in
    slider_crank) echo 0.02 ;;
    triple_rocker) echo 2 ;;
    tumbling) echo 0.7 ;;
    *) echo 0.2 ;;
  esac
}

# Steps that bear the motion, where those of the model do not.
options_of() {
  case $1 in
    rotor) echo --step 5e-5 ;;
  esac
}

# All functions of the standard, nothing else, and nothing but libm and a few functions of libc.
check_symbols() {  # VERSION LIBRARY
  sed -n "s/^FMI$1_Export .* \(fmi$1[A-Za-z0-9]*\);/\1/p" "$root/templates/fmi$1Functions.h" | sort >"$scratch/standard"
  nm -D --defined-only "$2" | awk '{ print $NF }' | sort >"$scratch/exported"
  cmp "$scratch/standard" "$scratch/exported" || fail "$2 exports other functions than FMI $1 has"
  nm -D --undefined-only "$2" | awk '{ sub(/@.*/, "", $NF); print $NF }' | sort >"$scratch/imported"
  [ -z "$(comm -23 "$scratch/imported" "$scratch/allowed")" ] || fail "$2 imports $(comm -23 "$scratch/imported" "$scratch/allowed")"
}

cases=0
for case in "$@"; do
  model=${case%:*}
  version=${case#*:}
  file=$(file_of "$model")
  # shellcheck disable=SC2046  # several words
  "$mbgen" simulate "$file" --duration "$(duration_of "$model")" $(options_of "$model") \
    --every 1 --out "$scratch/$model.csv" >/dev/null
  fmu=$scratch/${model}_$version
  mkdir "$fmu"
  "$mbgen" export "$file" --fmi "$version" -o "$fmu.fmu" >/dev/null 2>"$fmu.log"
  (cd "$fmu" && cmake -E tar xf "$fmu.fmu")
  schema=$root/tests/data/fmi/fmi$version-schema/fmi$version
  check_schema "${schema}ModelDescription.xsd" "$fmu/modelDescription.xml"
  check_schema "$root/tests/data/fmi/fmi3-schema/fmi3BuildDescription.xsd" "$fmu/sources/buildDescription.xml"
  xmllint --noout --html "$fmu/documentation/index.html" 2>"$scratch/log" || fail "$(cat "$scratch/log")"
  icon=$fmu/model.png
  if [ "$version" -eq 3 ]; then
    icon=$fmu/terminalsAndIcons/icon.png
    check_schema "${schema}TerminalsAndIcons.xsd" "$fmu/terminalsAndIcons/terminalsAndIcons.xml"
  fi
  python3 "$here/icon.py" "$icon" || fail "no icon in $fmu"
  library=$(find "$fmu/binaries" -name '*.so')
  check_symbols "$version" "$library"
  [ -z "$(find "$fmu" -name 'fmi*Functions.h')" ] || fail "the standard's headers are in sources/"
  echo "$model, FMI $version"
  "$scratch/importer" "$version" "$library" "$fmu/modelDescription.xml" "$scratch/$model.csv"
  cases=$((cases + 1))
done

# The same bytes again (of the library: below, with the other platforms), and a library from the sources alone, as an
# importer with its own headers makes it.
set -- "${1%:*}" "${1#*:}"
fmu=$scratch/$1_$2
for place in once again; do
  "$mbgen" export "$(file_of "$1")" --fmi "$2" --sources-only -o "$scratch/$place.fmu" >/dev/null 2>&1
done
cmp "$scratch/once.fmu" "$scratch/again.fmu" || fail "another export has other bytes"
# shellcheck disable=SC2086  # several words
c++ -std=c++17 $warnings -fPIC -shared -O1 -DFMI2_OVERRIDE_FUNCTION_PREFIX -I "$fmu/sources" -I "$root/templates" "$fmu"/sources/*.cpp -lm -o "$scratch/source.so"
nm -D --defined-only "$scratch/source.so" | grep -q " fmi$2DoStep$" || fail "the sources of FMI $2 export no functions"

# Two FMUs in one program: their functions have the names of their models.
for model in pendulum slider_crank; do
  "$mbgen" export "$root/models/$model.json" --fmi 2 --sources-only -o "$scratch/$model.fmu" >/dev/null
  mkdir "$scratch/static_$model"
  (cd "$scratch/static_$model" && cmake -E tar xf "$scratch/$model.fmu")
  for source in "$scratch/static_$model"/sources/*.cpp; do
    # shellcheck disable=SC2086  # several words
    c++ -std=c++17 $warnings -O1 -c -I "$scratch/static_$model/sources" -I "$root/templates" "$source" -o "${source%.cpp}.o"
  done
done
# shellcheck disable=SC2086  # several words
c++ -std=c++17 -O1 $warnings -pthread -I "$root/templates" "$here/two_units.cpp" "$scratch"/static_*/sources/*.o -lm -o "$scratch/two_units"
guid_of() { sed -n 's/.* guid="\([^"]*\)".*/\1/p' "$scratch/static_$1/modelDescription.xml"; }
"$scratch/two_units" "$(guid_of pendulum)" "$(guid_of slider_crank)" || fail "two FMUs in one program"
# Texts of the model about itself and its values; names that are taken get a prefix, and a note says so.
described() { grep -q -- "$1" "$scratch/described_$2/modelDescription.xml" || fail "FMI $2: no $1"; }
for version in 2 3; do
  if [ ! -d "$scratch/described_$version" ]; then continue; fi
  for part in 'description="A block on a rail, &quot;pulled&quot; &amp; braked &lt;by hand&gt;."' 'author="Eve"' \
    ' version="1.2"' 'copyright="none"' 'license="CC0-1.0"' 'stopTime="0.5" stepSize="0.001" tolerance="1e-05"' \
    'name="par.time"' 'name="y.pull"' 'min="0.0" max="1000.0" nominal="400.0"' 'unit="m" displayUnit="mm"' \
    '<DisplayUnit name="mm" factor="1000.0"/>' '<DisplayUnit name="km/h" factor="3.6"/>' '<DisplayUnit name="deg" factor="57.29577951308232"/>' \
    'variability="fixed"' 'description="speed at the start"' 'along the rail'; do
    described "$part" "$version"
  done
  [ "$(grep -c 'name="time"' "$scratch/described_$version/modelDescription.xml")" -eq 1 ] || fail "two variables named time"
  grep -q 'note: parameter "time" is "par.time" in the FMU' "$scratch/described_$version.log" || fail "no note of a name"
  grep -q 'the block' "$scratch/described_$version/documentation/index.html" || fail "the page does not describe bodies"
  # A parameter of the start acts as the same value in the model does.
  sed 's/"v0": { "value": 2/"v0": { "value": 5/' "$root/tests/data/fmi/described.json" >"$scratch/faster.json"
  "$mbgen" simulate "$scratch/faster.json" --duration 0.2 --every 1 --out "$scratch/faster.csv" >/dev/null
  "$scratch/importer" "$version" "$scratch/described_$version"/binaries/*/slide.so \
    "$scratch/described_$version/modelDescription.xml" "$scratch/faster.csv" v0=5
  c++ -std=c++17 -ffast-math -fsyntax-only -I "$root/templates" -I "$scratch/described_$version/sources" \
    "$scratch/described_$version/sources/slide_fmi$version.cpp" >"$scratch/log" 2>&1 && fail "-ffast-math is taken"
  grep -q "compile it without -ffast-math" "$scratch/log" || fail "no word of -ffast-math"
  for option in -funsafe-math-optimizations -freciprocal-math -fno-signed-zeros; do
    g++ -std=c++17 $option -fsyntax-only -I "$root/templates" -I "$scratch/described_$version/sources" \
      "$scratch/described_$version/sources/slide_fmi$version.cpp" >"$scratch/log" 2>&1 && fail "$option is taken"
    grep -q "compile it without -funsafe-math-optimizations" "$scratch/log" || fail "no word of $option"
  done
done

# A shipped model has a parameter of the start, too.
"$mbgen" export "$root/models/starters/tyre_rig.json" --fmi 3 --sources-only -o "$scratch/tyre_rig.fmu" >/dev/null 2>&1
cmake -E chdir "$scratch" cmake -E tar xf tyre_rig.fmu modelDescription.xml
grep -q 'name="spin".* causality="parameter" variability="fixed" initial="exact" unit="rad/s" start="66.0"' \
  "$scratch/modelDescription.xml" || fail "tyre_rig has no parameter of the start"

# Other platforms in one FMU.
has() { command -v "$1" >/dev/null 2>&1; }
platforms=x86_64-linux
if has aarch64-linux-gnu-g++; then platforms=$platforms,aarch64-linux; else echo "fmi: no compiler for aarch64-linux, skipped"; fi
if has x86_64-w64-mingw32-g++; then platforms=$platforms,x86_64-windows; else echo "fmi: no compiler for x86_64-windows, skipped"; fi
model=$(file_of "${1%:*}")
"$mbgen" export "$model" --fmi 3 --platform "$platforms" -o "$scratch/many.fmu" >/dev/null
mkdir "$scratch/many"
(cd "$scratch/many" && cmake -E tar xf "$scratch/many.fmu")
if [ "$2" -eq 3 ]; then
  cmp "$scratch"/many/binaries/x86_64-linux/*.so "$fmu"/binaries/x86_64-linux/*.so || fail "another export has another library"
else
  "$mbgen" export "$model" --fmi "$2" -o "$scratch/again.fmu" >/dev/null 2>&1
  cmp "$scratch/again.fmu" "$fmu.fmu" || fail "another export has other bytes"
fi
set -- "$scratch/many/modelDescription.xml" "$scratch/${1%:*}.csv"
library=$(find "$scratch/many/binaries/aarch64-linux" -name '*.so' 2>/dev/null || true)
if [ -n "$library" ]; then
  check_symbols 3 "$library"
  if [ -n "${MBGEN_FMI_EMULATED:-}" ] && has qemu-aarch64; then
    aarch64-linux-gnu-g++ -std=c++17 -I "$root/templates" "$here/importer.cpp" -o "$scratch/importer_arm" -ldl
    echo "aarch64-linux, FMI 3"
    qemu-aarch64 -L /usr/aarch64-linux-gnu "$scratch/importer_arm" 3 "$library" "$1" "$2"
  fi
fi
library=$(find "$scratch/many/binaries/x86_64-windows" -name '*.dll' 2>/dev/null || true)
if [ -n "$library" ]; then
  x86_64-w64-mingw32-objdump -p "$library" | sed -n 's/^\t\[ *[0-9]*\] \(fmi3[A-Za-z0-9]*\)$/\1/p' | sort >"$scratch/exported"
  sed -n "s/^FMI3_Export .* \(fmi3[A-Za-z0-9]*\);/\1/p" "$root/templates/fmi3Functions.h" | sort >"$scratch/standard"
  cmp "$scratch/standard" "$scratch/exported" || fail "the DLL exports other functions than FMI 3 has"
  [ "$(x86_64-w64-mingw32-objdump -p "$library" | sed -n 's/.*DLL Name: //p' | sort | tr '\n' ' ')" = "KERNEL32.dll msvcrt.dll " ] ||
    fail "the DLL imports of others than the system"
  if has wine; then
    x86_64-w64-mingw32-g++ -std=c++17 -O1 -static -I "$root/templates" "$here/importer.cpp" -o "$scratch/importer.exe"
    echo "x86_64-windows, FMI 3"
    export WINEPREFIX="$scratch/wine" WINEDEBUG=-all
    wine "$scratch/importer.exe" 3 "$library" "$1" "$2"
    wineserver -k || true
  fi
fi

# Without a compiler there are the sources; a version that there is not, or a directory, is the user's fault.
refused() { "$@" >"$scratch/log" 2>&1 && fail "accepted: $*" || [ $? -eq 1 ] && [ ! -e "$scratch/no.fmu" ]; }
CXX=/none "$mbgen" export "$root/models/pendulum.json" --fmi 3 --sources-only -o "$scratch/sources.fmu" >/dev/null
cmake -E tar tf "$scratch/sources.fmu" | grep -q "^sources/pendulum_fmi3.cpp$" || fail "no sources"
CXX=/none refused "$mbgen" export "$root/models/pendulum.json" --fmi 3 -o "$scratch/no.fmu"
grep -q "sources-only" "$scratch/log" || fail "the message does not say what to do"
refused "$mbgen" export "$root/models/pendulum.json" --fmi 3 --platform vax -o "$scratch/no.fmu"
CXX_aarch64_linux=/none refused "$mbgen" export "$root/models/pendulum.json" --fmi 3 --platform aarch64-linux -o "$scratch/no.fmu"
grep -q "no C++ compiler for aarch64-linux: ./none. does not run; install one (apt-get install g++-aarch64-linux-gnu)" "$scratch/log" ||
  fail "the message does not say which compiler"
refused "$mbgen" export "$root/models/pendulum.json" --fmi 4 -o "$scratch/no.fmu"
refused "$mbgen" export "$root/models/pendulum.json" --fmi 2 -o "$scratch/none/no.fmu"
echo "fmi: $cases FMUs passed"
