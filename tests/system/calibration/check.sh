#!/bin/sh
# Links of calibration files against applications that define the symbols: tests/system/calibration/check.sh MBGEN
# Every SYMBOL_LINK names a symbol of the ELF file, and its offset is where C has the number that the name says.
set -eu
here=$(cd "$(dirname "$0")" && pwd)
root=$(cd "$here/../../.." && pwd)
mbgen=$(realpath "$1")
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
warnings="-std=c99 -Wall -Wextra -Wpedantic -Wconversion -Wshadow -Wstrict-prototypes -Werror"
links=0

# check MODEL SCALAR: generates, compiles the application with the links as a table, and runs it.
check() {
  solver=$(basename "$1" .json)
  "$mbgen" generate "$1" --a2l --scalar "$2" --out "$scratch/$solver" >/dev/null
  file=$scratch/$solver/$solver.a2l
  # "name symbol offset" of every number.
  awk '/\/begin (MEASUREMENT|CHARACTERISTIC)/ { name = $3 } /SYMBOL_LINK/ { gsub(/"/, "", $2); print name, $2, $3 }' \
    "$file" >"$scratch/links"
  sed "s/SOLVER/$solver/g" "$here/application.c.in" >"$scratch/application.c"
  awk -v solver="$solver" -f "$here/table.awk" "$scratch/links" >"$scratch/table.h"
  # shellcheck disable=SC2086  # several words
  cc $warnings -I "$scratch" -I "$scratch/$solver" -c "$scratch/application.c" -o "$scratch/application.o"
  c++ -std=c++17 -I "$scratch/$solver" -c "$scratch/$solver/$solver.cpp" -o "$scratch/solver.o"
  c++ -std=c++17 -I "$scratch/$solver" -c "$scratch/$solver/${solver}_c.cpp" -o "$scratch/c.o"
  c++ "$scratch/application.o" "$scratch/solver.o" "$scratch/c.o" -o "$scratch/application"
  "$scratch/application"
  # The same without C's word: symbols and sizes of the ELF file.
  nm -S --defined-only "$scratch/application" | awk 'NF == 4 { print $4, $2 }' >"$scratch/symbols"
  # Bytes of a number by the type that the file gives it.
  awk '/\/begin (MEASUREMENT|CHARACTERISTIC)/ { name = $3 } /FNC_VALUES/ { bytes = substr($3, 6) / 8 }
    $1 ~ /^FLOAT[0-9]+_IEEE$/ { print name, substr($1, 6) / 8 } $1 == "VALUE" { print name, bytes }' "$file" >"$scratch/bytes"
  while read -r name symbol offset; do
    bytes=$(awk -v name="$name" '$1 == name { print $2 }' "$scratch/bytes")
    size=$(awk -v symbol="$symbol" '$1 == symbol { print $2 }' "$scratch/symbols")
    [ -n "$size" ] || { echo "$name: no symbol $symbol in the application"; exit 1; }
    [ $((offset + bytes)) -le $((0x$size)) ] || { echo "$name: offset $offset is outside $symbol"; exit 1; }
    links=$((links + 1))
  done <"$scratch/links"
}

check "$root/models/slider_crank.json" double
check "$root/tests/data/models/all_elements.json" double
check "$root/tests/data/models/all_elements.json" float
check "$root/models/four_bar.json" float
check "$root/models/four_bar.json" double
echo "calibration: $links links are where C has the numbers"
[ "$links" -gt 120 ]

# The example of docs/use/embedding.md: the spring lets go when a tool sets its stiffness to zero.
directory=$scratch/four_bar
# shellcheck disable=SC2086
cc $warnings -I "$directory" -c "$root/examples/c_interface/four_bar_calibration.c" -o "$scratch/example.o"
c++ -std=c++17 -I "$directory" "$scratch/example.o" "$directory/four_bar.cpp" "$directory/four_bar_c.cpp" -o "$scratch/example"
"$scratch/example" >"$scratch/example.txt"
[ "$(wc -l <"$scratch/example.txt")" -eq 4 ]
[ "$(grep -c ' 0.000000 N$' "$scratch/example.txt")" -eq 2 ]
echo "calibration: the example sets a parameter"

# Stated bound of the stack against a run on a painted one.
CXX=c++ "$mbgen" generate "$root/models/four_bar.json" --c-api --measure --out "$directory" >/dev/null
bound=$(awk '/"function": "four_bar_step"/ { found = 1 } found && /"bytes"/ { gsub(/[^0-9]/, ""); print; exit }' \
  "$directory/four_bar_measured.json")
# The flags of the emitted CMake file, which are those that were counted with.
flags=$(awk -F'"' '/"flags"/ { print $4 }' "$directory/four_bar_measured.json")
# shellcheck disable=SC2086
for unit in four_bar four_bar_c; do c++ $flags -I "$directory" -c "$directory/$unit.cpp" -o "$scratch/$unit.o"; done
cc -std=gnu99 -Wall -Wextra -Werror -I "$directory" -c "$here/painted_stack.c" -o "$scratch/painted.o"
c++ "$scratch/painted.o" "$scratch/four_bar.o" "$scratch/four_bar_c.o" -lpthread -o "$scratch/painted"
"$scratch/painted" "$bound"
