#!/bin/sh
# Derivatives of a motion in Python, against differences of the plain solver:
#   tests/system/c_interface/tangents.sh MBGEN
set -eu
here=$(cd "$(dirname "$0")" && pwd)
mbgen=$(realpath "$1")
model=$here/../../../models/sensitivities/four_bar.json
. "$here/python_and_scratch.sh"
cd "$scratch"
"$mbgen" generate "$model" --c-api --sensitivities k,l2 --name linkage --out made >/dev/null
grep -q 'linkage_tangents.cpp' made/CMakeLists.txt
c++ -std=c++17 -O1 -fPIC -shared -Wall -Wextra -Wpedantic -Wconversion -Wshadow -Werror -Wno-psabi -Imade made/linkage.cpp \
  made/linkage_c.cpp made/linkage_tangents.cpp made/linkage_tangents_c.cpp -lm -o made/liblinkage_c.so
cd made
PYTHONPATH=. "$python" "$here/tangents.py"
