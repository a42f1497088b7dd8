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
mkdir -p corpus/measurement_table corpus/mesh
i=0
for table in 'q1_deg,q2_deg,x_mm,x,y,z,sigma_mm\n1,2,3,0.1,0.2,0,0.1\n4,5,6,0.2,0.3,0.1,\n' \
    'm1_deg,m2_deg,m3,x,y,z,qw,qx,qy,qz\n90,1,0.1,0.4,0.1,0.1,1,0,0,0\n80,2,0.1,0.3,0.1,0.1,1,0,0,0\n' \
    'q1,q2,q3,distance,anchor,plane,contact,px,py,pz\n0,0,0,1,a,,,0,0,0\n1,0,0,,,p,,0,0,0\n1,1,0,,,,c,0,0,0\n'; do
    i=$((i + 1))
    printf "$table" > "corpus/measurement_table/seed-$i"
done
# The first byte tells the format: 0 STL, 1 OBJ, 2 Collada, 3 glTF.
printf '\000solid s\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1 0\nendloop\nendfacet\nendsolid\n' > corpus/mesh/stl
printf '\001v 0 0 0\nv 1 0 0\nv 0 1 0\nvn 0 0 1\nusemtl a\nf 1//1 2//1 -1//1\n' > corpus/mesh/obj
printf '\002<COLLADA><asset><unit meter="0.1"/><up_axis>Z_UP</up_axis></asset><library_geometries><geometry id="g"><mesh><source id="p"><float_array id="a" count="9">0 0 0 1 0 0 0 1 0</float_array><technique_common><accessor source="#a" count="3" stride="3"/></technique_common></source><vertices id="v"><input semantic="POSITION" source="#p"/></vertices><triangles count="1"><input semantic="VERTEX" source="#v" offset="0"/><p>0 1 2</p></triangles></mesh></geometry></library_geometries><library_visual_scenes><visual_scene id="s"><node><instance_geometry url="#g"/></node></visual_scene></library_visual_scenes><scene><instance_visual_scene url="#s"/></scene></COLLADA>' > corpus/mesh/dae
printf '\003{"asset":{"version":"2.0"},"scene":0,"scenes":[{"nodes":[0]}],"nodes":[{"mesh":0}],"meshes":[{"primitives":[{"attributes":{"POSITION":0}}]}],"accessors":[{"bufferView":0,"componentType":5126,"count":3,"type":"VEC3","min":[0,0,0],"max":[1,1,0]}],"bufferViews":[{"buffer":0,"byteLength":36}],"buffers":[{"byteLength":36,"uri":"data:application/octet-stream;base64,AAAAAAAAAAAAAAAAAACAPwAAAAAAAAAAAAAAAAAAgD8AAAAA"}]}' > corpus/mesh/gltf
