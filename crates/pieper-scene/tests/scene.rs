//! Bodies of every built-in arm, files that are right and wrong, rays against all triangles.

use nalgebra::{Isometry3, Point3, Vector3};
use pieper_scene::{Body, Frames, Mesh, Picker, formats, outline, shapes};

#[test]
fn every_built_in_arm_has_a_body() {
    let mut random = fastrand::Rng::with_seed(1);
    for built_in in pieper_robots::ALL {
        let robot = built_in.robot();
        let Ok(chain) = robot.chain() else { continue };
        let body = Body::of_chain(&chain, &Vector3::z_axis());
        assert_eq!(
            body.links.len(),
            Frames::Axes.count(&chain),
            "{}",
            built_in.id
        );
        assert!(
            body.links.iter().skip(1).all(|parts| !parts.is_empty()),
            "{}",
            built_in.id
        );
        assert!(
            body.shown().count() <= 40,
            "{}: what is drawn in one go",
            built_in.id
        );
        let reach = pieper::kinematics::reach(&chain).unwrap().from_base;
        let q: Vec<f64> = chain
            .variables()
            .iter()
            .map(|_| random.f64() - 0.5)
            .collect();
        let mut poses = Vec::new();
        Frames::Axes.at(&chain, &q, &mut poses);
        for (link, part) in body.shown() {
            for (p, n) in part.mesh.positions.iter().zip(&part.mesh.normals) {
                let place = poses[link] * part.placed * Point3::from(p.map(f64::from));
                assert!(
                    place.coords.norm() < 2.5 * reach,
                    "{}: {place}",
                    built_in.id
                );
                assert!(
                    (Vector3::from(*n).norm() - 1.0).abs() < 1e-5,
                    "{}",
                    built_in.id
                );
            }
        }
    }
}

#[test]
fn axes_frames_end_at_the_tool() {
    let chain = pieper_robots::find("ar3").unwrap().robot().chain().unwrap();
    let q = [0.3, -0.4, 0.9, 1.2, -0.7, 0.2];
    let mut poses = Vec::new();
    Frames::Axes.at(&chain, &q, &mut poses);
    let last = poses.last().unwrap() * pieper_scene::frames::isometry(&chain.canonical().link(5));
    let tool = pieper::kinematics::tool_pose(&chain, &q).unwrap();
    assert!((last.to_homogeneous() - tool.to_homogeneous()).amax() < 1e-14);
}

#[test]
fn rays_meet_what_all_triangles_say() {
    let chain = pieper_robots::find("irb2400")
        .unwrap()
        .robot()
        .chain()
        .unwrap();
    let body = Body::of_chain(&chain, &Vector3::z_axis());
    let picker = Picker::new(&body);
    let mut random = fastrand::Rng::with_seed(2);
    let mut poses = Vec::new();
    let mut hits = 0;
    for _ in 0..400 {
        let q: Vec<f64> = (0..6).map(|_| 2.0 * random.f64() - 1.0).collect();
        Frames::Axes.at(&chain, &q, &mut poses);
        let mut any = || Vector3::new(random.f64() - 0.5, random.f64() - 0.5, random.f64() - 0.5);
        let origin = Point3::from(any() * 6.0);
        let direction = poses[3].translation.vector + any() - origin.coords;
        let hit = picker.pick(&origin, &direction, &poses);
        let slow = body
            .shown()
            .flat_map(|(link, part)| {
                let pose = poses[link] * part.placed;
                (0..part.mesh.triangles()).filter_map(move |t| {
                    distance(&origin, &direction, part.mesh.triangle(t).map(|p| pose * p))
                })
            })
            .fold(f64::INFINITY, f64::min);
        match hit {
            Some(hit) => {
                assert!(
                    (hit.distance - slow).abs() < 1e-9,
                    "{} {slow}",
                    hit.distance
                );
                assert!(hit.normal.dot(&direction) <= 0.0);
                hits += 1;
            }
            None => assert!(slow.is_infinite(), "{slow}"),
        }
    }
    assert!(hits > 50, "{hits}");
    assert_eq!(
        picker.pick(&Point3::origin(), &Vector3::zeros(), &poses),
        None
    );
    assert_eq!(
        picker.pick(&Point3::origin(), &Vector3::from([f64::NAN; 3]), &poses),
        None
    );
}

/// By solving for the place in the triangle's own coordinates.
fn distance(
    origin: &Point3<f64>,
    direction: &Vector3<f64>,
    [a, b, c]: [Point3<f64>; 3],
) -> Option<f64> {
    let m = nalgebra::Matrix3::from_columns(&[b - a, c - a, -direction]);
    let x = m.try_inverse()? * (origin - a);
    (x.x >= 0.0 && x.y >= 0.0 && x.x + x.y <= 1.0 && x.z > 0.0).then_some(x.z)
}

#[test]
fn stl_and_obj_say_the_same() {
    let cube = shapes::block([0.2, 0.4, 0.6], 0.0);
    let mut binary = vec![0; 80];
    binary.extend((cube.triangles() as u32).to_le_bytes());
    let (mut text, mut obj) = (String::from("solid cube\n"), String::new());
    for t in 0..cube.triangles() {
        binary.extend([0; 12]);
        for corner in cube.triangle(t) {
            for k in 0..3 {
                binary.extend((corner[k] as f32).to_le_bytes());
            }
            text += &format!("  vertex {} {} {}\n", corner.x, corner.y, corner.z);
            obj += &format!("v {} {} {}\n", corner.x, corner.y, corner.z);
        }
        binary.extend([0; 2]);
        obj += "f -3/1/1 -2//1 -1\n";
    }
    let read = |name: &str, bytes: &[u8]| formats::read(name, bytes).unwrap().remove(0).mesh;
    let first = read("cube.STL", &binary);
    assert_eq!(first, read("cube.stl", text.as_bytes()));
    assert_eq!(first, read("cube.obj", obj.as_bytes()));
    assert_eq!(first.bounds(), cube.bounds());
}

/// A unit square of two triangles, placed, scaled and coloured, as Collada writes it.
const SQUARE_DAE: &str = r##"<?xml version="1.0"?>
<COLLADA xmlns="http://www.collada.org/2005/11/COLLADASchema" version="1.4.1">
 <asset><unit name="millimeter" meter="0.001"/><up_axis>Z_UP</up_axis></asset>
 <library_effects><effect id="e"><profile_COMMON><technique sid="c"><phong><diffuse><color>0.2 0.4 0.6 1</color></diffuse></phong></technique></profile_COMMON></effect></library_effects>
 <library_materials><material id="m"><instance_effect url="#e"/></material></library_materials>
 <library_geometries><geometry id="g"><mesh>
  <source id="p"><float_array id="a" count="12">0 0 0 1 0 0 1 1 0 0 1 0</float_array><technique_common><accessor source="#a" count="4" stride="3"/></technique_common></source>
  <vertices id="v"><input semantic="POSITION" source="#p"/></vertices>
  <polylist material="s" count="1"><input semantic="VERTEX" source="#v" offset="0"/><input semantic="NORMAL" source="#n" offset="1"/><vcount>4</vcount><p>0 0 1 0 2 0 3 0</p></polylist>
 </mesh></geometry></library_geometries>
 <library_visual_scenes><visual_scene id="w"><node><translate>10 0 0</translate><rotate>0 0 1 90</rotate><scale>2 2 2</scale>
  <instance_geometry url="#g"><bind_material><technique_common><instance_material symbol="s" target="#m"/></technique_common></bind_material></instance_geometry></node></visual_scene></library_visual_scenes>
 <scene><instance_visual_scene url="#w"/></scene>
</COLLADA>"##;

#[test]
fn collada_is_placed_scaled_and_coloured() {
    let piece = formats::read("square.dae", SQUARE_DAE.as_bytes())
        .unwrap()
        .remove(0);
    assert_eq!(piece.color, Some([0.2, 0.4, 0.6, 1.0]));
    assert_eq!(piece.mesh.triangles(), 2);
    let [low, high] = piece.mesh.bounds().unwrap();
    // Ten millimetres aside, turned by a quarter, two millimetres wide.
    for (found, wanted) in low
        .iter()
        .chain(&high)
        .zip([0.008, 0.0, 0.0, 0.010, 0.002, 0.0])
    {
        assert!((found - wanted).abs() < 1e-7, "{low:?} {high:?}");
    }
    for (from, to, words) in [
        ("0 0 1 0 2 0 3 0", "0 0 1 0 2 0 9 0", "corner 9"),
        ("0 0 1 0 2 0 3 0", "0 0 one", "\"one\""),
        ("<vcount>4", "<vcount>5", "vcount"),
        ("10 0 0</tr", "10 0</tr", "translate"),
        ("url=\"#g\"", "url=\"#none\"", "no triangles"),
        (
            "<?xml version=\"1.0\"?>",
            "<!DOCTYPE x [<!ENTITY a \"b\">]>",
            "DTD",
        ),
        ("</COLLADA>", "", "closed"),
    ] {
        let error =
            formats::read("square.dae", SQUARE_DAE.replace(from, to).as_bytes()).unwrap_err();
        assert!(error.contains(words), "{words}: {error}");
    }
}

#[test]
fn gltf_is_placed_and_coloured() {
    use base64::Engine as _;
    let mut data = Vec::new();
    for value in [0.0_f32, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0, 0.0] {
        data.extend(value.to_le_bytes());
    }
    for index in [0_u16, 1, 2] {
        data.extend(index.to_le_bytes());
    }
    let uri = format!(
        "data:application/octet-stream;base64,{}",
        base64::engine::general_purpose::STANDARD.encode(&data)
    );
    let text = format!(
        r#"{{"asset":{{"version":"2.0"}},"scene":0,"scenes":[{{"nodes":[0]}}],"nodes":[{{"mesh":0,"translation":[0,0,3],"scale":[2,2,2]}}],
        "materials":[{{"pbrMetallicRoughness":{{"baseColorFactor":[1,0,0,1]}}}}],
        "meshes":[{{"primitives":[{{"attributes":{{"POSITION":0}},"indices":1,"material":0}}]}}],
        "accessors":[{{"bufferView":0,"componentType":5126,"count":3,"type":"VEC3","min":[0,0,0],"max":[1,1,0]}},{{"bufferView":1,"componentType":5123,"count":3,"type":"SCALAR"}}],
        "bufferViews":[{{"buffer":0,"byteOffset":0,"byteLength":36}},{{"buffer":0,"byteOffset":36,"byteLength":6}}],
        "buffers":[{{"byteLength":{},"uri":"{uri}"}}]}}"#,
        data.len()
    );
    let piece = formats::read("t.gltf", text.as_bytes()).unwrap().remove(0);
    let [red, rest @ ..] = piece.color.unwrap();
    assert!((red - 1.0).abs() < 1e-6 && rest == [0.0, 0.0, 1.0]);
    assert_eq!(
        piece.mesh.bounds(),
        Some([[0.0, 0.0, 3.0], [2.0, 2.0, 3.0]])
    );
    assert!(
        formats::read("t.gltf", text.replace(&uri, "outside.bin").as_bytes())
            .unwrap_err()
            .contains("outside.bin")
    );
    assert!(formats::read("t.glb", b"glTF").is_err());
    // Numbers that point elsewhere are said, and looked up nowhere.
    for (from, to, words) in [
        (
            r#""POSITION":0"#,
            r#""POSITION":7"#,
            "positions are accessor 7, there are 2",
        ),
        (
            r#""count":3,"type":"VEC3""#,
            r#""count":4,"type":"VEC3""#,
            "accessor 0 reaches past",
        ),
        (
            r#""byteLength":6}"#,
            r#""byteLength":600}"#,
            "view 1 reaches past",
        ),
        (
            r#""byteOffset":36"#,
            r#""byteOffset":18446744073709551600"#,
            "view 1 reaches past",
        ),
    ] {
        let error = formats::read("t.gltf", text.replace(from, to).as_bytes()).unwrap_err();
        assert!(error.contains(words), "{error}");
    }
}

/// A few lines can ask for a picture without end: each node shows the next one twice.
#[test]
fn repeated_nodes_come_to_an_end() {
    let nodes: Vec<String> = (0..60)
        .map(|k| format!(r#"{{"children":[{},{}]}}"#, 2 * k + 1, 2 * k + 2))
        .collect();
    // glTF: its nodes are a tree, or the file is at fault; either way it ends.
    let text = format!(
        r#"{{"asset":{{"version":"2.0"}},"scene":0,"scenes":[{{"nodes":[0]}}],"nodes":[{},{{}}]}}"#,
        nodes.join(",").replace("[1,2]", "[1,1]")
    );
    assert!(formats::read("t.gltf", text.as_bytes()).is_err());
    let twice = |k: usize| {
        let next = format!("<instance_node url='#n{}'/>", k + 1);
        format!("<node id='n{k}'>{next}{next}</node>")
    };
    let nodes: String = (0..40).map(twice).collect();
    let text = format!(
        "<COLLADA><library_nodes>{nodes}<node id='n40'/></library_nodes><library_visual_scenes><visual_scene id='s'><node><instance_node \
         url='#n0'/></node></visual_scene></library_visual_scenes></COLLADA>"
    );
    let error = formats::read("t.dae", text.as_bytes()).unwrap_err();
    assert!(error.contains("more than 100000 nodes"), "{error}");
}

#[test]
fn broken_meshes_say_what_is_wrong() {
    for (name, bytes, words) in [
        ("a.stl", &b""[..], "no triangles"),
        ("a.stl", b"solid x\nvertex 1 2\n", "line 2"),
        ("a.stl", &[0xff; 200], "announces"),
        ("a.obj", b"v 1 2 3\nf 1 2 3\n", "line 2"),
        ("a.obj", b"v 1 two 3\n", "line 1"),
        ("a.step", b"", ".step"),
    ] {
        let error = formats::read(name, bytes).unwrap_err();
        assert!(error.contains(words), "{error}");
    }
}

#[test]
fn whatever_is_read_does_not_panic() {
    let mut random = fastrand::Rng::with_seed(3);
    for round in 0..20_000 {
        let mut bytes: Vec<u8> = match round % 4 {
            3 => SQUARE_DAE.as_bytes().to_vec(),
            0 => b"v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n".to_vec(),
            1 => b"solid\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1 0\n".to_vec(),
            _ => shapes::block([1.0; 3], 0.0).to_bytes(),
        };
        for _ in 0..1 + random.usize(..6) {
            let place = random.usize(..bytes.len());
            bytes[place] = random.u8(..);
        }
        if random.bool() {
            bytes.truncate(1 + random.usize(..bytes.len()));
        }
        let _ = formats::read("x.stl", &bytes);
        let _ = formats::read("x.obj", &bytes);
        let _ = formats::read("x.dae", &bytes);
        let _ = formats::read("x.gltf", &bytes);
        let _ = formats::read("x.glb", &bytes);
        if let Some(mesh) = Mesh::from_bytes(&bytes) {
            assert!(
                mesh.indices
                    .iter()
                    .all(|i| (*i as usize) < mesh.positions.len())
            );
        }
    }
}

#[test]
fn outlines_hold_what_is_reached() {
    let chain = pieper_robots::find("ar3").unwrap().robot().chain().unwrap();
    let line = outline::outline(&chain);
    let reach = pieper::kinematics::reach(&chain).unwrap().from_first_axis;
    let far = line.iter().map(|p| p[0]).fold(0.0, f64::max);
    assert!(
        far <= reach + 1e-12 && far > 0.97 * reach,
        "{far} of {reach}"
    );
    let gantry = pieper_robots::find("gantry")
        .unwrap()
        .robot()
        .chain()
        .unwrap();
    assert!(outline::outline(&gantry).is_empty());
}

#[test]
fn shapes_are_closed_and_face_out() {
    for mesh in [
        shapes::sphere(0.5),
        shapes::cylinder(0.3, 1.0, 0.05),
        shapes::cylinder(0.3, 1.0, 0.0),
        shapes::limb(0.3, 0.2, 1.0),
        shapes::block([1.0, 2.0, 3.0], 0.1),
    ] {
        // The volume by the divergence theorem is positive, and independent of where the origin is.
        let volume = |from: Vector3<f64>| -> f64 {
            (0..mesh.triangles())
                .map(|t| {
                    let [a, b, c] = mesh.triangle(t).map(|p| p.coords - from);
                    a.dot(&b.cross(&c)) / 6.0
                })
                .sum()
        };
        let (here, there) = (
            volume(Vector3::zeros()),
            volume(Vector3::new(5.0, -3.0, 7.0)),
        );
        assert!(here > 0.0 && (here - there).abs() < 1e-4, "{here} {there}");
    }
    let moved = shapes::along(&Point3::origin(), &Point3::new(0.0, 0.0, -2.0)).unwrap();
    assert!(((moved * Vector3::z()) + Vector3::z()).norm() < 1e-12);
    assert!(shapes::along(&Point3::origin(), &Point3::origin()).is_none());
    let _: Isometry3<f64> = moved;
}
