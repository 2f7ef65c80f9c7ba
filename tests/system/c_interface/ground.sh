#!/bin/sh
# Ground of a host through the C interface of examples/c_interface/hosted_wheel.json: a plane against inputs, and hills
# against the same hills as an expression, to which the motion tends with the square of the step:
#   tests/system/c_interface/ground.sh MBGEN
set -eu
here=$(cd "$(dirname "$0")" && pwd)
mbgen=$(realpath "$1")
examples=$here/../../../examples/c_interface
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
cd "$scratch"
"$mbgen" generate "$examples/hosted_wheel.json" --c-api --out wheel >/dev/null
for source in hosted_wheel hosted_wheel_c; do
  c++ -std=c++17 -O1 -fno-exceptions -ffp-contract=off -Wall -Wextra -Wpedantic -Wconversion -Wshadow -Werror -Iwheel \
    -c wheel/$source.cpp -o $source.o
done
for program in "$here/ground.c" "$examples/hosted_wheel.c"; do
  cc -std=c99 -Wall -Wextra -Wpedantic -Werror -Iwheel "$program" hosted_wheel.o hosted_wheel_c.o -lm \
    -o "$(basename "$program" .c)"
done
./ground
echo "a plane of a host: the motion that inputs give"
hills='"height": "0.02*x + 0.04*sin(1.5*x - t)*cos(y - 0.5)", "friction": "0.9 + 0.1*sin(x)"'
sed "s|\"host\": true|$hills|" "$examples/hosted_wheel.json" >hills.json
"$mbgen" simulate hills.json --engine generic --step 2.5e-4 -o hills.csv >/dev/null
for step in 4e-3 2e-3 1e-3; do ./hosted_wheel $step; done >hosted.txt
awk -F, 'NR == 1 { for (i = 1; i <= NF; ++i) at[$i] = i } END { print $at["load [N]"], $at["bounce [m]"], $at["aside [m]"] }' \
  hills.csv >exact.txt
# Errors of load, bounce and way aside: a quarter of themselves at half the step.
awk '
  NR == FNR { for (i = 1; i <= 3; ++i) exact[i] = $i; next }
  {
    for (i = 1; i <= 3; ++i) {
      error = $i - exact[i]
      if (FNR > 1 && !(before[i] / error > 3.6 && before[i] / error < 4.4)) wrong = 1
      before[i] = error
    }
    print $1, $2, $3, "off by", before[1], before[2], before[3]
  }
  END { exit wrong || FNR != 3 }' exact.txt hosted.txt
echo "hills of a host that wander: the error falls with the square of the step"
