#!/bin/sh
# Fills the corpora from the tests' data: every description, every case of xacro, every expression; the built-in
# robots; a few motion tables.
set -eu
cd "$(dirname "$0")"
data=../crates/pieper/tests/data
mkdir -p corpus/urdf corpus/xacro corpus/motion_table corpus/robot_file
cp ../robots/*.toml corpus/robot_file/
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
i=0
for table in 't,q1_deg,q2_mm,mark\n0,1,2,"a ""b"""\n' 't,q1,x\r\n# x\r\n-1.5,1e-3,.5\r\n2,0,0\r\n' \
    't,x,y,z,qw,qx,qy,qz\n0,1,2,3,1,0,0,0\n' 't,x,y,z,roll,pitch,yaw\n0,1,2,3,1,0,0\n' \
    't,Dx,Dy,Dz,Kx,Ky,Kz,Ex,Ey,Ez\n0,0,0,0,0,0,1,0,1,0\n'; do
    i=$((i + 1))
    printf "$table" > "corpus/motion_table/seed-$i"
done
mkdir -p corpus/claims
cp ../examples/ar3-claims.* corpus/claims/
