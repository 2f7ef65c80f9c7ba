#!/bin/sh
# A launcher of compilers (CMAKE_CXX_COMPILER_LAUNCHER) for tests of anything but optimised code: QUICK has the last word
# on its level, -O0 by default.
exec "$@" "${QUICK:--O0}"
