#!/bin/sh
# Functions for CasADi, called as CasADi calls them: tests/system/casadi/check.sh MBGEN
set -eu
here=$(cd "$(dirname "$0")" && pwd)
mbgen=$(realpath "$1")
models=$here/../../../models
. "$here/../c_interface/python_and_scratch.sh"
cd "$scratch"
strict="-std=c99 -O2 -fPIC -shared -fvisibility=hidden -Wall -Wextra -Wpedantic -Wconversion -Wshadow -Werror"

# The library by the CMake file of the solver, the others by hand without a warning.
"$mbgen" generate "$models/four_bar.json" --casadi --out four_bar >/dev/null
cmake -S four_bar -B four_bar/build -DCMAKE_BUILD_TYPE=Release >/dev/null
cmake --build four_bar/build --target four_bar_casadi >/dev/null
cp four_bar/build/libfour_bar_casadi.so four_bar
"$python" "$here/check.py" "$mbgen" "$models/four_bar.json" four_bar 0.3
"$python" "$here/revolution.py" "$mbgen" "$models/four_bar.json" four_bar

# compare MODEL NAME SPREAD [OPTION ...]
compare() {
  model=$1 name=$2 spread=$3
  shift 3
  "$mbgen" generate "$model" --casadi "$@" --out "$name" >/dev/null
  cc $strict "$name"/*.c -lm -o "$name/lib${name}_casadi.so"
  "$python" "$here/check.py" "$mbgen" "$model" "$name" "$spread"
}
compare "$models/fit/quarter_vehicle.json" quarter_vehicle 0.05
compare "$models/robots/parallel_ankle.json" parallel_ankle 0.2 --states motor_a,motor_b
grep -q '"z.motor_a", "rad"' parallel_ankle/parallel_ankle_acados.py
compare "$here/arm.json" arm 0.4
"$python" "$here/limits.py" arm

# Against the solver with derivatives, whose lengths are parameters.
"$mbgen" generate "$models/sensitivities/four_bar.json" --casadi --sensitivities k,l2 --out made >/dev/null 2>&1
for file in made/*_casadi*.c; do cc -std=c99 -O2 -c "$file" -o "$file.o"; done
c++ -std=c++17 -O1 -Wno-psabi -Imade "$here/tangents.cpp" made/sensitive_four_bar_tangents.cpp made/*.o -lm -o compare
./compare

# States that are no choice.
refuses() {
  if "$mbgen" generate "$models/four_bar.json" "$@" --out none >/dev/null 2>message; then
    echo "$* was not refused"; exit 1
  fi
}
refuses --casadi --states crank_pin,rocker_pin
grep -q -- '--states: crank_pin, rocker_pin do not determine their loops at the start of the model' message
refuses --casadi --states crank_pin,crank_pin
grep -q -- '--states: "crank_pin" is named twice' message
refuses --casadi --states crank
grep -q -- '--states: the model has no coordinate "crank"' message
if "$mbgen" generate "$here/pole.json" --casadi --out none >/dev/null 2>message; then echo "a pole was not refused"; exit 1; fi
grep -q -- '--casadi: a ball joint starts in the pole of its angles' message
refuses --states crank_pin
grep -q -- '--states: needs --casadi' message

# The same bytes again; models that are no differential equation of independent coordinates.
"$mbgen" generate "$here/arm.json" --casadi --out again >/dev/null
rm -f arm/*.so arm/states.json
rm -rf arm/__pycache__
diff -r arm again
for model in rolling_disc hydraulic_arm published/kuka_iiwa; do
  if "$mbgen" generate "$models/$model.json" --casadi --out none >/dev/null 2>message; then
    echo "$model was not refused"; exit 1
  fi
  grep -q -- '--casadi: the model is no differential equation of its independent coordinates: ' message
done
