# Sets python to one that has numpy; skipped (77) without. Sourced by the tests of this folder.
for python in python3 /usr/bin/python3 none; do
  "$python" -c 'import numpy' 2>/dev/null && break
done
[ "$python" != none ] || { echo "skipped, python3 with numpy is not installed (apt-get install python3-numpy)"; exit 77; }
