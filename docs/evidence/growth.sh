#!/bin/sh
# Measures anew what docs/evidence/growth.md holds, puts the tables between the markers there and draws docs/evidence/growth.svg:
#   docs/evidence/growth.sh [TABLE]     TABLE: what bench/growth.sh printed, to draw without measuring
#   docs/evidence/growth.sh making      the table of bench/making.sh alone
#   docs/evidence/growth.sh generic     that of bench/generic_steps.sh alone
#   docs/evidence/growth.sh slowest     that of bench/slowest_steps.py alone
# MBGEN: the binary, default as those scripts have it.
# Needs gnuplot (Debian: gnuplot-nox). Some minutes; the machine should have nothing else to do.
set -eu
here=$(cd "$(dirname "$0")" && pwd)
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
bench=$here/../../bench

page=$here/growth.md
. "$here/put_table.sh"

case "${1-}" in
  making) "$bench/making.sh" ${MBGEN:+"$MBGEN"} | put making "$page" && exit ;;
  generic) "$bench/generic_steps.sh" ${MBGEN:+"$MBGEN"} | put generic "$page" && exit ;;
  slowest) "$bench/slowest_steps.py" ${MBGEN:+"$MBGEN"} | put slowest "$page" && exit ;;
  "") "$bench/growth.sh" ${MBGEN:+"$MBGEN"} > "$scratch/table"
    "$bench/making.sh" ${MBGEN:+"$MBGEN"} | put making "$page"
    "$bench/generic_steps.sh" ${MBGEN:+"$MBGEN"} | put generic "$page"
    "$bench/slowest_steps.py" ${MBGEN:+"$MBGEN"} | put slowest "$page" ;;
  *) grep '^|' "$1" > "$scratch/table" ;;
esac
put growth "$page" < "$scratch/table"

for kind in chain four-bar; do
  awk -F'|' -v kind="$kind" '$2 ~ kind { print $3, $6, $8, $9 + $10 }' "$scratch/table" > "$scratch/$kind"
done
gnuplot << END
set terminal svg size 960,320 font "sans,12" background "white"
set output "$here/growth.svg"
set multiplot layout 1,3
set logscale xy
set key top left
set grid
set xlabel "joints of the chain, four-bars"
lines = "with linespoints pointtype 7 pointsize 0.5 linewidth 2"
set title "one evaluation, us"
plot "$scratch/chain" using 1:2 @lines title "chain", "$scratch/four-bar" using 1:2 @lines title "four-bars"
set title "whole solver, kB"
plot "$scratch/chain" using 1:3 @lines title "chain", "$scratch/four-bar" using 1:3 @lines title "four-bars"
set title "generate and compile, s"
plot "$scratch/chain" using 1:4 @lines title "chain", "$scratch/four-bar" using 1:4 @lines title "four-bars"
END
