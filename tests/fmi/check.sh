#!/bin/sh
# FMUs of several models: valid, reproducible, alone but for libm, and run by our own importer:
# tests/fmi/check.sh MBGEN [MODEL:VERSION..]
set -eu
here=$(cd "$(dirname "$0")" && pwd)
root=$here/../..
mbgen=$(realpath "$1")
shift
[ $# -gt 0 ] || set -- four_bar:3 slider_crank:2 tuned_rod:2 driven_cart:2 coach_rig:3
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
fail() { echo "fmi: $*"; exit 1; }
warnings="-Wall -Wextra -Wpedantic -Wshadow -Werror"
# shellcheck disable=SC2086  # several words
c++ -std=c++17 -O1 $warnings -I "$root/templates" "$here/importer.cpp" -o "$scratch/importer" -ldl
libm=$(cc -print-file-name=libm.so.6)
nm -D --defined-only "$libm" | awk '{ sub(/@.*/, "", $3); print $3 }' | sort -u >"$scratch/libm"

check_schema() {  # SCHEMA FILE
  xmllint --noout --schema "$1" "$2" 2>"$scratch/log" || fail "$(cat "$scratch/log")"
}

# All functions of the standard, nothing else, and nothing that libm does not have.
check_symbols() {  # VERSION LIBRARY
  sed -n "s/^FMI$1_Export .* \(fmi$1[A-Za-z0-9]*\);/\1/p" "$root/templates/fmi$1Functions.h" | sort >"$scratch/standard"
  nm -D --defined-only "$2" | awk '{ print $NF }' | sort >"$scratch/exported"
  cmp "$scratch/standard" "$scratch/exported" || fail "$2 exports other functions than FMI $1 has"
  nm -D --undefined-only "$2" | awk '{ sub(/@.*/, "", $NF); print $NF }' | sort >"$scratch/imported"
  [ -z "$(comm -23 "$scratch/imported" "$scratch/libm")" ] || fail "$2 imports $(comm -23 "$scratch/imported" "$scratch/libm")"
}

cases=0
for case in "$@"; do
  model=${case%:*}
  version=${case#*:}
  # Durations that are whole steps to the last bit.
  file=$root/models/$model.json
  for place in fmi models; do [ -e "$file" ] || file=$root/tests/data/$place/$model.json; done
  "$mbgen" simulate "$file" --duration "$([ "$model" = slider_crank ] && echo 0.02 || echo 0.2)" \
    --every 1 --out "$scratch/$model.csv" >/dev/null
  fmu=$scratch/${model}_$version
  mkdir "$fmu"
  "$mbgen" export "$file" --fmi "$version" -o "$fmu.fmu" >/dev/null
  (cd "$fmu" && cmake -E tar xf "$fmu.fmu")
  schema=$root/tests/data/fmi/fmi$version-schema/fmi$version
  check_schema "${schema}ModelDescription.xsd" "$fmu/modelDescription.xml"
  [ "$version" -eq 2 ] || check_schema "${schema}BuildDescription.xsd" "$fmu/sources/buildDescription.xml"
  library=$(find "$fmu/binaries" -name '*.so')
  check_symbols "$version" "$library"
  [ -z "$(find "$fmu" -name 'fmi*Functions.h')" ] || fail "the standard's headers are in sources/"
  echo "$model, FMI $version"
  "$scratch/importer" "$version" "$library" "$fmu/modelDescription.xml" "$scratch/$model.csv"
  cases=$((cases + 1))
done

# The same bytes again, and a library from the sources alone, as an importer with its own headers makes it.
set -- "${1%:*}" "${1#*:}"
fmu=$scratch/$1_$2
"$mbgen" export "$root/models/$1.json" --fmi "$2" -o "$scratch/again.fmu" >/dev/null
cmp "$scratch/again.fmu" "$fmu.fmu" || fail "another export has other bytes"
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
c++ -std=c++17 -O1 "$here/two_units.cpp" "$scratch"/static_*/sources/*.o -lm -o "$scratch/two_units"
"$scratch/two_units" || fail "two FMUs in one program"

# Without a compiler there are the sources; a version that there is not, or a directory, is the user's fault.
refused() { "$@" >"$scratch/log" 2>&1 && fail "accepted: $*" || [ $? -eq 1 ] && [ ! -e "$scratch/no.fmu" ]; }
CXX=/none "$mbgen" export "$root/models/pendulum.json" --fmi 3 --sources-only -o "$scratch/sources.fmu" >/dev/null
cmake -E tar tf "$scratch/sources.fmu" | grep -q "^sources/pendulum_fmi3.cpp$" || fail "no sources"
CXX=/none refused "$mbgen" export "$root/models/pendulum.json" --fmi 3 -o "$scratch/no.fmu"
grep -q "sources-only" "$scratch/log" || fail "the message does not say what to do"
refused "$mbgen" export "$root/models/pendulum.json" --fmi 4 -o "$scratch/no.fmu"
refused "$mbgen" export "$root/models/pendulum.json" --fmi 2 -o "$scratch/none/no.fmu"
echo "fmi: $cases FMUs passed"
