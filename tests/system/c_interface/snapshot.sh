#!/bin/sh
# Ranges of parameters and inputs, and saved solvers, through the C interface: abm4 with sampled values and bristles, rk4
# and abm4 after coordinates were chosen again, rosenbrock, inputs without rates:
#   tests/system/c_interface/snapshot.sh MBGEN
set -eu
here=$(cd "$(dirname "$0")" && pwd)
mbgen=$(realpath "$1")
data=$here/../../data
. "$here/python_and_scratch.sh"
cd "$scratch"

build() {  # NAME MODEL
  "$mbgen" generate "$2" --c-api --out "$1" >/dev/null
  for source in "$1" "${1}_c"; do
    c++ -std=c++17 -O1 -fPIC -fno-exceptions -ffp-contract=off -Wall -Wextra -Wpedantic -Wconversion -Wshadow -Werror \
      -I"$1" -c "$1/$source.cpp" -o "$1/$source.o"
  done
  c++ -shared "$1/$1.o" "$1/${1}_c.o" -lm -o "$1/lib${1}_c.so"
}

build ranges "$here/ranges.json"
"$python" "$here/ranges.py" ranges
build quantities "$here/quantities.json"
"$python" "$here/quantities.py" quantities
"$mbgen" export "$here/quantities.json" --fmi 2 -o quantities.fmu >/dev/null
"$python" -m zipfile -e quantities.fmu unit
"$python" "$here/quantities_fmu.py" "$(find unit/binaries -name 'quantities.so')" unit/modelDescription.xml
build bounded "$here/bounded.json"
"$python" "$here/bounded.py" bounded "$mbgen" "$here/bounded.json"
"$mbgen" generate "$here/bounded.json" --batch 4 --out lanes >/dev/null
c++ -std=c++17 -O1 -march=native -Wall -Wextra -Werror -I lanes "$here/bounded.cpp" lanes/bounded.cpp lanes/bounded_batch.cpp -o bounded_host
./bounded_host
"$python" "$here/snapshot.py" ranges ranges 1e-3 pull=3 brake=1
for integrator in rk4 abm4; do
  sed "s/\"integrator\": \"rk4\"/\"integrator\": \"$integrator\"/; s/\"name\": \"triple_rocker\"/\"name\": \"rocker_$integrator\"/" \
    "$data/fmi/triple_rocker.json" >$integrator.json
  build rocker_$integrator $integrator.json
  "$python" "$here/snapshot.py" rocker_$integrator rocker_$integrator 5e-4
done
sed 's/"integrator": "abm4"/"integrator": "rosenbrock"/; s/"name": "ranges"/"name": "implicit"/' "$here/ranges.json" >implicit.json
build implicit implicit.json
"$python" "$here/snapshot.py" implicit implicit 1e-3 pull=3
build driven_cart "$data/models/driven_cart.json"
"$python" "$here/snapshot.py" driven_cart driven_cart 1e-3 way=0.01 speed=0 acceleration=0
