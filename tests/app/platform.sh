#!/usr/bin/env bash
# shellcheck disable=SC2154 source-path=SCRIPTDIR source=../support/app.sh
# The window's own tests, which need a display.   platform.sh BINARY OUTDIR
source "$(dirname -- "$0")/../support/app.sh"
tests=$(dirname -- "$binary")/tests/gpu_tests
[[ -x $tests ]] || skip "$tests is not built"
start_display 640 480
"$tests" --gtest_filter='Window*' | tee tests.log
if grep -q SKIPPED tests.log; then fail "some were skipped although there is a display"; fi
