#!/bin/sh
# MAT files that mbgen writes, read by scipy: tests/report/mat.sh MBGEN. Skipped (77) without scipy.
set -eu
mbgen=$(realpath "$1")
model=$(cd "$(dirname "$0")/../.." && pwd)/models/coach.json
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
cd "$scratch"
python=python3
"$python" -c 'import scipy.io' 2> /dev/null || python=/usr/bin/python3  # another may hide Debian's
"$python" -c 'import scipy.io' 2> /dev/null || { echo "skipped: no scipy (apt-get install python3-scipy)"; exit 77; }

"$mbgen" simulate "$model" --duration 0.2 --step 1e-3 --engine generic --out coach.csv > summary_csv
"$mbgen" simulate "$model" --duration 0.2 --step 1e-3 --engine generic --out coach.mat > summary_mat
"$mbgen" simulate "$model" --duration 0.2 --step 1e-3 --engine generic --out coach.data --format mat > /dev/null
cmp coach.mat coach.data
[ ! -e coach.mat.run.json ] || { echo "a MAT file holds its run itself"; exit 1; }
"$python" - << 'END'
import csv, json, math
import scipy.io
mat = scipy.io.loadmat("coach.mat")
rows = list(csv.reader(open("coach.csv")))
names, units = ([text.rstrip() for text in mat[key]] for key in ("names", "units"))
assert [f"{name} [{unit}]" for name, unit in zip(names, units)] == rows[0], "names and units are those of the CSV table"
assert mat["data"].shape == (201, len(names)), mat["data"].shape
for row, wanted in zip(mat["data"], rows[1:]):
    assert list(row) == [float(field) for field in wanted], "every number is the same to the last bit"
run = json.loads(str(mat["run"][0]))
beside = json.load(open("coach.csv.run.json"))
assert run == beside and run["rows"] == 201 and run["model"] == "coach", "the same run in the file and beside it"
END
"$mbgen" plot coach.mat --columns roll -o from_mat.svg
"$mbgen" plot coach.csv --columns roll -o from_csv.svg
cmp from_mat.svg from_csv.svg
