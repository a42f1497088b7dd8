#!/bin/sh
# Fills the corpora from the tests' data: every description, every case of xacro, every expression.
set -eu
cd "$(dirname "$0")"
data=../crates/pieper/tests/data
mkdir -p corpus/urdf corpus/xacro
cp "$data"/*.urdf corpus/urdf/
cp "$data"/*.urdf "$data"/*.xacro corpus/xacro/
awk '
    /^== / { n++; file = "corpus/xacro/case-" n; skip = 0; print "<robot name=\"r\" xmlns:xacro=\"x\">" > file; next }
    /^--$/ { skip = 1; print "</robot>" > file; close(file); next }
    n && !skip { print > file }
' "$data/xacro.txt"
awk -F ' ~ ' '
    NR > 1 {
        gsub(/&/, "\\&amp;", $1); gsub(/</, "\\&lt;", $1)
        file = "corpus/xacro/expression-" NR
        print "<robot name=\"r\"><t>${" $1 "}</t></robot>" > file
        close(file)
    }
' "$data/expressions.txt"
