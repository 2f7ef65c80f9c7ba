#!/bin/sh
# Inputs without their rates, and assignments in Python, through the C interface of the driven cart:
#   tests/system/c_interface/rates.sh MBGEN
set -eu
here=$(cd "$(dirname "$0")" && pwd)
mbgen=$(realpath "$1")
. "$here/python_and_scratch.sh"
"$mbgen" generate "$here/../../data/models/driven_cart.json" --c-api --out "$scratch/driven_cart" >/dev/null
cmake -S "$scratch/driven_cart" -B "$scratch/driven_cart/build" >/dev/null
cmake --build "$scratch/driven_cart/build" >/dev/null
c++ -std=c++17 -Wall -Wextra -Wpedantic -Wconversion -Wshadow -Werror -fsyntax-only -I "$scratch/driven_cart" \
  "$scratch/driven_cart/driven_cart_c.cpp"
"$python" "$here/rates.py" "$scratch/driven_cart"
