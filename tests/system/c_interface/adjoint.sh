#!/bin/sh
# Derivatives of one number of a motion by its adjoint, in Python, against differences of the plain solver:
#   tests/system/c_interface/adjoint.sh MBGEN
set -eu
here=$(cd "$(dirname "$0")" && pwd)
mbgen=$(realpath "$1")
page=$here/../../../docs/use/sensitivities.md
. "$here/python_and_scratch.sh"
cd "$scratch"
"$mbgen" generate "$here/../../../models/four_bar.json" --c-api --adjoint --name linkage --out made >/dev/null
grep -q 'linkage_adjoint_c.cpp' made/CMakeLists.txt
c++ -std=c++17 -O1 -fPIC -shared -Wall -Wextra -Wpedantic -Wconversion -Wshadow -Werror -Wno-psabi -Imade made/linkage.cpp \
  made/linkage_c.cpp made/linkage_tangents.cpp made/linkage_tangents_c.cpp made/linkage_adjoint.cpp \
  made/linkage_adjoint_c.cpp -lm -o made/liblinkage_c.so
PYTHONPATH=made "$python" "$here/adjoint.py"

# The page's program, with its name for the solver.
sed -n '/^```python gradient.py/,/^```$/p' "$page" | sed '1d;$d' | sed 's/four_bar/linkage/g' > gradient.py
sed -n '/^```python gradient.py/,/^In C++/p' "$page" | sed -n '/^```text/,/^```$/p' | sed '1d;$d' > expected.out
PYTHONPATH=made "$python" gradient.py | diff expected.out -
