#!/bin/sh
# Actuators of an FMU of an ankle: tests/fmi/actuators.sh MBGEN
set -eu
here=$(cd "$(dirname "$0")" && pwd)
mbgen=$(realpath "$1")
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
cd "$scratch"
python3 "$here/actuators.py" "$mbgen" "$here/../../models/robots/parallel_ankle.json"
