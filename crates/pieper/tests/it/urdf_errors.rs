//! Mistakes in a URDF: the exact words, the place included.

use pieper::describe::urdf;

/// A robot of two links and this joint text, from line 4 on.
fn with_joint(joint: &str) -> String {
    format!("<robot name=\"r\">\n<link name=\"a\"/>\n<link name=\"b\"/>\n{joint}\n</robot>")
}

#[track_caller]
fn check(text: &str, expected: &str) {
    let error = urdf::read("f.urdf", text).expect_err(expected);
    assert_eq!(error.to_string(), expected);
    assert!(error.is_parse() && error.place().is_some(), "{error:?}");
}

/// `inner` stands in line 5 of a joint `j` of this type from a to b.
#[track_caller]
fn check_joint(kind: &str, inner: &str, expected: &str) {
    let ends = "<parent link=\"a\"/><child link=\"b\"/>";
    let joint = format!("<joint name=\"j\" type=\"{kind}\">{ends}\n{inner}</joint>");
    check(&with_joint(&joint), expected);
}

#[test]
fn not_xml() {
    check("", "f.urdf:1:1: no XML element was found");
    check(
        "<robot name=\"r\">\n <link>",
        "f.urdf:2:8: end of file: the closing tag of the root is missing",
    );
    check(
        "<robot>\n</robo>",
        "f.urdf:2:1: XML: expected 'robot' tag, not 'robo'",
    );
    check(
        "<robot a=\"1\" a=\"2\"/>",
        "f.urdf:1:14: XML: attribute 'a' is already defined",
    );
    check(
        "<robot name=r/>",
        "f.urdf:1:13: XML: expected a quote not 'r'",
    );
    check(
        "<robot>\n<x:y/></robot>",
        "f.urdf:2:2: XML: an unknown namespace prefix 'x'",
    );
    check(
        "<?xml version=\"1.0\"?>\n<!DOCTYPE lolz [<!ENTITY lol \"lol\">]>\n<robot>&lol;</robot>",
        "f.urdf:2:1: <!DOCTYPE: document types and their entities are not read",
    );
    let deep = format!(
        "<robot>{}{}</robot>",
        "<a>".repeat(100_000),
        "</a>".repeat(100_000)
    );
    check(
        &deep,
        "f.urdf:1:608: <a>: elements are nested more than 200 deep",
    );
}

/// What the parser would take its time for.
#[test]
fn too_much() {
    let many = |text: fn(usize) -> String| (0..2000).map(text).collect::<String>();
    let attributes = many(|i| format!(" a{i}=\"1\""));
    check(
        &format!("<robot>\n<link{attributes}/></robot>"),
        "f.urdf:2:2: there are more than 1000 attributes in one tag",
    );
    let declarations = many(|i| format!("<a xmlns:a{i}=\"1\"/>\n"));
    check(
        &format!("<robot>{declarations}</robot>"),
        "f.urdf:1001:4: there are more than 1000 namespace declarations",
    );
}

#[test]
fn not_a_robot() {
    check(
        "<sdf/>",
        "f.urdf:1:1: <sdf>: an element <robot> was expected",
    );
    check(
        "<robot name=\"r\"/>",
        "f.urdf:1:1: <robot name=\"r\">: it has no links",
    );
    check(
        "<robot xmlns:xacro=\"x\">\n <xacro:arm/></robot>",
        "f.urdf:2:2: <xacro:arm>: a xacro must be expanded before it is read as URDF",
    );
}

#[test]
fn names() {
    check(
        "<robot><link/></robot>",
        "f.urdf:1:8: <link>: an attribute name=\"...\" was expected",
    );
    check(
        "<robot><link name=\" \"/></robot>",
        "f.urdf:1:20: name=\" \": a name was expected",
    );
    check(
        "<robot><link name=\"a\"/>\n<link name=\"a\"/></robot>",
        "f.urdf:2:1: <link name=\"a\">: there is a link of this name already",
    );
    let joint = "<joint name=\"j\" type=\"fixed\"><parent link=\"a\"/><child link=\"b\"/></joint>";
    check(
        &with_joint(&format!("{joint}\n{joint}")),
        "f.urdf:5:1: <joint name=\"j\">: there is a joint of this name already",
    );
    check(
        &with_joint(
            "<joint name=\"j\" type=\"fixed\"><parent link=\"a\"/><child link=\"c\"/></joint>",
        ),
        "f.urdf:4:61: link=\"c\": there is no link of this name",
    );
    check(
        &with_joint("<joint name=\"j\" type=\"fixed\"><parent link=\"a\"/></joint>"),
        "f.urdf:4:1: <joint name=\"j\">: an element <child link=\"...\"/> was expected",
    );
    check(
        &with_joint("<joint name=\"j\" type=\"fixed\"><parent/><child link=\"b\"/></joint>"),
        "f.urdf:4:30: <parent>: an attribute link=\"...\" was expected",
    );
}

#[test]
fn joint_types() {
    check_joint(
        "floating",
        "",
        "f.urdf:4:23: type=\"floating\": six degrees of freedom are more than a joint of an arm has; \
         revolute, continuous, prismatic and fixed are read",
    );
    check_joint(
        "planar",
        "",
        "f.urdf:4:23: type=\"planar\": three degrees of freedom are more than a joint of an arm has; \
         revolute, continuous, prismatic and fixed are read",
    );
    check_joint(
        "hinge",
        "",
        "f.urdf:4:23: type=\"hinge\": no such joint type; revolute, continuous, prismatic and fixed are read",
    );
}

#[test]
fn numbers() {
    let xyz = |value: &str, expected: &str| {
        check_joint("revolute", &format!("<origin xyz=\"{value}\"/>"), expected);
    };
    xyz(
        "1 2",
        "f.urdf:5:14: xyz=\"1 2\": 3 finite numbers were expected, 2 were found",
    );
    xyz(
        "1 2 3 4",
        "f.urdf:5:14: xyz=\"1 2 3 4\": 3 finite numbers were expected, 4 were found",
    );
    xyz(
        "",
        "f.urdf:5:14: xyz=\"\": 3 finite numbers were expected, none was found",
    );
    for word in [
        "nan",
        "inf",
        "-Infinity",
        "1e999",
        "1,5",
        "0x10",
        "--1",
        "1e",
        "${a}",
        ".",
    ] {
        xyz(
            &format!("0 {word} 1"),
            &format!(
                "f.urdf:5:16: xyz=\"0 {word} 1\": {word:?} is not one; 3 finite numbers were expected"
            ),
        );
    }
    check_joint(
        "revolute",
        "<limit lower=\"-pi\" upper=\"1\"/>",
        "f.urdf:5:15: lower=\"-pi\": \"-pi\" is not one; a finite number was expected",
    );
    check_joint(
        "revolute",
        "<limit lower=\"1\" upper=\"-1\"/>",
        "f.urdf:5:1: <limit>: the lower limit 1 lies above the upper limit -1",
    );
    check_joint(
        "revolute",
        "<axis xyz=\"0 0 -0\"/>",
        "f.urdf:5:12: xyz=\"0 0 -0\": an axis of length zero has no direction",
    );
    check_joint(
        "revolute",
        "<origin quat_xyzw=\"0 0 0 0\"/>",
        "f.urdf:5:20: quat_xyzw=\"0 0 0 0\": a quaternion of length zero is no rotation",
    );
    check_joint(
        "revolute",
        "<origin rpy=\"0 0 0\" quat_xyzw=\"0 0 0 1\"/>",
        "f.urdf:5:32: quat_xyzw=\"0 0 0 1\": either rpy or quat_xyzw was expected, not both",
    );
}

#[test]
fn shapes() {
    let shape = |solid: &str, expected: &str| {
        let text = format!(
            "<robot><link name=\"a\"><visual><geometry>\n{solid}</geometry></visual></link></robot>"
        );
        check(&text, expected);
    };
    shape(
        "<mesh/>",
        "f.urdf:2:1: <mesh>: an attribute filename=\"...\" was expected",
    );
    shape(
        "<sphere radius=\"-1\"/>",
        "f.urdf:2:17: radius=\"-1\": a length must not be negative",
    );
    shape(
        "<box size=\"1\"/>",
        "f.urdf:2:12: size=\"1\": 3 finite numbers were expected, 1 was found",
    );
}

#[test]
fn mimic() {
    check_joint(
        "revolute",
        "<mimic joint=\"k\"/>",
        "f.urdf:5:15: joint=\"k\": there is no joint of this name",
    );
    check_joint(
        "revolute",
        "<mimic joint=\"j\"/>",
        "f.urdf:4:1: <joint name=\"j\">: joints follow each other in a circle: j -> j",
    );
    let joint = |name: &str, child: &str, kind: &str, leader: &str| {
        format!(
            "<link name=\"{child}\"/><joint name=\"{name}\" type=\"{kind}\"><parent link=\"a\"/>\
             <child link=\"{child}\"/><mimic joint=\"{leader}\" multiplier=\"1e200\"/></joint>\n"
        )
    };
    let text =
        |joints: &[String]| format!("<robot><link name=\"a\"/>\n{}</robot>", joints.concat());
    let three = |first| {
        [
            first,
            joint("m", "c", "revolute", "n"),
            joint("n", "d", "revolute", "m"),
        ]
    };
    check(
        &text(&three(joint("l", "b", "revolute", "m"))),
        "f.urdf:4:17: <joint name=\"n\">: joints follow each other in a circle: n -> m -> n",
    );
    check(
        &text(&[
            joint("l", "b", "revolute", "m"),
            joint("m", "c", "fixed", "m"),
        ]),
        "f.urdf:2:98: joint=\"m\": the joint of this name is fixed: there is no motion to follow",
    );
}

#[test]
fn not_a_tree() {
    let joint = |name: &str, parent: &str, child: &str| {
        format!(
            "<joint name=\"{name}\" type=\"fixed\"><parent link=\"{parent}\"/><child link=\"{child}\"/></joint>\n"
        )
    };
    check(
        &with_joint(&(joint("j", "a", "b") + &joint("k", "a", "b"))),
        "f.urdf:5:61: link=\"b\": joint j carries this link already",
    );
    check(
        &with_joint(&(joint("j", "a", "b") + &joint("k", "b", "a"))),
        "f.urdf:4:1: <joint name=\"j\">: joint and links form a loop",
    );
    check(
        &with_joint(&joint("j", "b", "b")),
        "f.urdf:4:1: <joint name=\"j\">: joint and links form a loop",
    );
    check(
        &with_joint(""),
        "f.urdf:3:1: <link name=\"b\">: no joint carries it, nor link a: one root link was expected",
    );
}

#[test]
fn line_ends_and_byte_order_marks_do_not_shift_places() {
    check(
        "\u{feff}<robot>\r\n<link name=\"a\"/>\r\n <link name=\"a\"/></robot>",
        "f.urdf:3:2: <link name=\"a\">: there is a link of this name already",
    );
    check(
        "\u{feff}<sdf/>",
        "f.urdf:1:1: <sdf>: an element <robot> was expected",
    );
    // Columns count characters, not bytes.
    check(
        "<robot><link name=\"Schlüssel\"/><link name=\"Schlüssel\"/></robot>",
        "f.urdf:1:32: <link name=\"Schlüssel\">: there is a link of this name already",
    );
}
