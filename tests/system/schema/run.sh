#!/bin/sh
# Holds the JSON Schema to the reader's verdicts: tests/system/schema/run.sh MBGEN [--update]. Needs node and npm; 77: skipped.
set -eu
here=$(cd "$(dirname "$0")" && pwd)
mbgen=$1
if ! command -v node >/dev/null || ! command -v npm >/dev/null; then
  echo "schema: skipped, there is no node or npm"
  exit 77
fi
work=$(dirname "$mbgen")/schema_test
mkdir -p "$work"
cp "$here/package.json" "$here/package-lock.json" "$here/verdicts.mjs" "$work"
if [ ! -d "$work/node_modules/ajv" ] && ! (cd "$work" && npm ci --no-audit --no-fund >npm.log 2>&1); then
  echo "schema: skipped, npm could not fetch ajv, see $work/npm.log"
  exit 77
fi
node "$work/verdicts.mjs" "$here/../../.." "$mbgen" ${2:-}
