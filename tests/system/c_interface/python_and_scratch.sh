# Sets python to one that has numpy, else the test is skipped (77), and scratch to a directory that goes at the end.
# Sourced by the tests of this folder.
for python in python3 /usr/bin/python3 none; do
  "$python" -c 'import numpy' 2>/dev/null && break
done
[ "$python" != none ] || { echo "skipped, python3 with numpy is not installed (apt-get install python3-numpy)"; exit 77; }
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
