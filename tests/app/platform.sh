#!/usr/bin/env bash
# The window's own tests, which need a display.   platform.sh BINARY OUTDIR
source "$(dirname -- "$0")/../support/app.sh"
tests=$(dirname -- "$binary")/tests/gpu_tests
[[ -x $tests ]] || skip "$tests is not built"
start_display 640 480
"$tests" --gtest_filter='Window*' --gtest_brief=1
