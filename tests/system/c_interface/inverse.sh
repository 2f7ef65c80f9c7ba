#!/bin/sh
# Inverse dynamics of a parallel ankle through the C interface and Python:
#   tests/system/c_interface/inverse.sh MBGEN
set -eu
here=$(cd "$(dirname "$0")" && pwd)
mbgen=$(realpath "$1")
model=$here/../../../models/robots/parallel_ankle.json
. "$here/python_and_scratch.sh"
cd "$scratch"
"$mbgen" generate "$model" --c-api --out made >/dev/null
c++ -std=c++17 -O1 -fPIC -shared -Wall -Wextra -Wpedantic -Wconversion -Wshadow -Werror -Imade made/parallel_ankle.cpp \
  made/parallel_ankle_c.cpp -lm -o made/libparallel_ankle_c.so
"$python" "$here/inverse.py" "$mbgen" "$model"
# The ten lines of the page, as a new user runs them, and what the page says they print.
page=$here/../../../docs/use/actuators.md
sed -n '/^```python ankle.py/,/^```$/p' "$page" | sed '1d;$d' > ankle.py
sed -n '/^```python ankle.py/,/^## /p' "$page" | sed -n '/^```text/,/^```$/p' | sed '1d;$d' > expected.out
PYTHONPATH=made "$python" ankle.py | diff expected.out -
