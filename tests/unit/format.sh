#!/usr/bin/env bash
# The C++ is laid out as .clang-format says; prints the differences.   format.sh
set -euo pipefail
cd -- "$(dirname -- "$0")/../.."
tool=clang-format-14 # other versions lay the same code out differently
command -v "$tool" > /dev/null || { printf 'skipped: %s is not installed\n' "$tool" && exit 77; }
code=0
while IFS= read -r file; do
  "$tool" "$file" | diff -u --label "$file" --label "formatted" "$file" - || code=1
done < <(find engine game tests -name '*.cpp' -o -name '*.h')
if ((code)); then printf 'to format: %s -i FILE...\n' "$tool"; fi
exit "$code"
