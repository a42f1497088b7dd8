#!/bin/sh
# Fills the corpora with what the tests read: every description, and every text of the tests on a line of its own.
set -eu
cd "$(dirname "$0")"
mkdir -p corpus/urdf corpus/xacro
cp ../crates/pieper/tests/data/*.urdf corpus/urdf/
cp ../crates/pieper/tests/data/*.xacro corpus/xacro/
cp ../crates/pieper/tests/data/*.urdf corpus/xacro/
number=0
grep -ho '<[a-z:]* .*' ../crates/pieper/tests/it/xacro*.rs | sed 's/\\"/"/g' | while read -r line; do
    number=$((number + 1))
    printf '<robot name="r" xmlns:xacro="x">\n%s\n</robot>\n' "${line%%\"#*}" >"corpus/xacro/test-$number"
done
