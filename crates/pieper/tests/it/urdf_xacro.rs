//! Xacro: what each feature becomes, a whole arm, and the words for mistakes.

use pieper::describe::urdf;
use pieper::describe::xacro::{self, NoResources, Resources};
use pieper::{Error, Result};

/// The files of `tests/data`.
struct Data;

impl Resources for Data {
    fn read(&self, path: &str) -> Result<String> {
        let text = match path.strip_prefix("data/").unwrap_or(path) {
            "common.xacro" => include_str!("../data/common.xacro"),
            "limits.yaml" => include_str!("../data/limits.yaml"),
            "bad.xacro" => "<robot>\n<link></robot>",
            "bad.yaml" => "a: [1,\nb: 2}",
            "unit.yaml" => "a:\n  b: !hours 3",
            "loop.xacro" => "<robot xmlns:xacro='x'>\n<xacro:include filename='f.xacro'/></robot>",
            _ => return Err(Error::resource(path, "no such file")),
        };
        Ok(text.to_owned())
    }

    fn package(&self, name: &str) -> Option<String> {
        (name == "made_up_description").then(|| "data".to_owned())
    }

    fn environment(&self, name: &str) -> Option<String> {
        (name == "ROBOT").then(|| "left".to_owned())
    }
}

/// The text as the only content of a robot, from line 2 on.
fn robot(body: &str) -> String {
    format!("<robot name=\"r\" xmlns:xacro=\"http://www.ros.org/wiki/xacro\">\n{body}\n</robot>")
}

/// A document without the spaces between its elements.
fn squeezed(document: &str) -> String {
    document.lines().map(str::trim).collect()
}

#[test]
fn expressions() {
    for line in include_str!("../data/expressions.txt").lines().skip(1) {
        let Some((expression, expected)) = line.split_once(" ~ ") else {
            continue;
        };
        let text = robot(&format!(
            "<t>[${{{}}}]</t>",
            expression.replace('<', "&lt;")
        ));
        let expanded = xacro::expand("f.xacro", &text, &[], &NoResources);
        let expanded = expanded.unwrap_or_else(|error| panic!("{line}: {error}"));
        let inner = expanded
            .split_once("<t>[")
            .unwrap()
            .1
            .split_once("]</t>")
            .unwrap()
            .0;
        assert_eq!(inner, expected, "{expression}");
    }
}

#[test]
fn features() {
    for case in include_str!("../data/xacro.txt").split("\n== ").skip(1) {
        let (title, case) = case.split_once('\n').unwrap();
        let (text, expected) = case.split_once("\n--\n").unwrap();
        let expanded = xacro::expand("data/f.xacro", &robot(text), &[], &Data);
        let expanded = squeezed(&expanded.unwrap_or_else(|error| panic!("{title}: {error}")));
        let inner = expanded.split_once("<robot name=\"r\">").unwrap().1;
        let inner = inner.strip_suffix("</robot>").unwrap();
        assert_eq!(inner, squeezed(expected), "{title}");
    }
}

#[test]
fn a_whole_arm() {
    let text = include_str!("../data/arm.xacro");
    let arguments = [("prefix", "left_"), ("gripper", "false")];
    let tree = xacro::read("data/arm.xacro", text, &arguments, &Data).unwrap();
    assert_eq!(tree.name(), "made_up");
    let links: Vec<&str> = tree.links().iter().map(|l| l.name.as_str()).collect();
    assert_eq!(links, ["left_base", "left_upper", "left_hand"]);
    let limits: Vec<_> = tree.variables().iter().map(|v| v.limits.unwrap()).collect();
    assert_eq!(
        (limits[0].lower(), limits[1].upper()),
        (-std::f64::consts::FRAC_PI_2, 0.015)
    );
    let poses = tree.link_poses(&[0.0, 0.01]).unwrap();
    assert_eq!(
        poses[2].translation.vector,
        nalgebra::Vector3::new(0.0, 0.31, 0.3)
    );
    // Reading the expanded text is the same as reading the xacro.
    let expanded = xacro::expand("data/arm.xacro", text, &arguments, &Data).unwrap();
    assert_eq!(urdf::read("expanded.urdf", &expanded).unwrap(), tree);
    // A URDF is a xacro that uses none of it.
    let plain = include_str!("../data/arm.urdf");
    let same = xacro::read("arm.urdf", plain, &[], &NoResources).unwrap();
    assert_eq!(same, urdf::read("arm.urdf", plain).unwrap());
}

#[test]
fn the_environment_and_our_own_additions() {
    let inner = |text: &str| {
        let expanded = xacro::expand("data/f.xacro", &robot(text), &[], &Data).unwrap();
        squeezed(&expanded)
            .replace("<?xml version=\"1.0\"?><robot name=\"r\">", "")
            .replace("</robot>", "")
    };
    assert_eq!(
        inner(
            "<l n=\"$(env ROBOT) $(optenv ROBOT x) $(optenv HOME /a b) [$(optenv HOME)] $(dirname)\"/>"
        ),
        "<l n=\"left left /a b [] data\"/>"
    );
    assert_eq!(
        inner("<xacro:arg name=\"a\" default=\"2\"/><l n=\"$(eval arg('a') + 'x')\"/>"),
        "<l n=\"2x\"/>"
    );
    assert_eq!(
        inner("<l n=\"${{'a': {'b': 3}}['a']['b']} ${'}'} ${(1, 2)[1]} ${(1)}\"/>"),
        "<l n=\"3 } 2 1\"/>"
    );
    assert_eq!(
        inner("<l xmlns:k=\"http://k\"><k:m k:n=\"1\"/></l>"),
        "<l xmlns:k=\"http://k\"><k:m k:n=\"1\"/></l>"
    );
}

#[track_caller]
fn check(body: &str, expected: &str) {
    let error = xacro::read("data/f.xacro", &robot(body), &[], &Data).expect_err(expected);
    assert_eq!(error.to_string(), expected);
    assert!(error.place().is_some(), "{error:?}");
}

/// A mistake in `${...}` in line 2.
#[track_caller]
fn check_expression(expression: &str, expected: &str) {
    let text = format!(
        "<link name='${{{}}}'/>",
        expression.replace('<', "&lt;").replace('\'', "\"")
    );
    let text = text.replace("name='", "name=\"").replace("}'/>", "}\"/>");
    let text = text
        .replace("\"/>", "\u{1}")
        .replace("name=\"", "\u{2}")
        .replace('"', "&quot;");
    let text = text.replace('\u{1}', "\"/>").replace('\u{2}', "name=\"");
    let expected = format!(
        "data/f.xacro:2:15: ${{{}}}: {expected}",
        expression.replace('\'', "\"")
    );
    check(&text, &expected);
}

#[test]
fn mistakes_in_expressions() {
    let cases = [
        ("", "a value was expected, the expression ends"),
        ("1 +", "a value was expected, the expression ends"),
        ("1 2", "the end of the expression was expected, not 2"),
        ("(1", "',' or ')' was expected, the expression ends"),
        ("1 if 2", "'else' was expected, the expression ends"),
        ("a", "there is no property or constant a here"),
        ("f(1)", "there is no function f()"),
        ("math.f(1)", "there is no function f()"),
        ("math.x", "there is no constant math.x"),
        ("1 / 0", "division by zero"),
        ("1 % 0", "division by zero"),
        ("1 + 'a'", "an integer 1 + the text 'a' has no meaning"),
        ("'a' < 1", "a text and an integer cannot be compared"),
        ("[1][1]", "index 1 is out of range: there are 1 items"),
        ("dict(a=1)['b']", "there is no key b; the keys are a"),
        ("sqrt(-1)", "sqrt(-1) is no finite number"),
        ("sin()", "sin() does not take 0 such arguments"),
        ("sin('x')", "a number was expected, not the text 'x'"),
        ("len(3)", "an integer 3 has no length"),
        ("9 ** 99", "9 ** 99 is too large for an integer"),
        ("1x", "1 is followed directly by 'x'"),
        ("1 ; 2", "';' has no meaning here"),
        ("__import__('os')", "there is no function __import__()"),
        ("xacro.fatal('no', 1)", "the description gives up: no 1"),
        (
            "[x for x in range(3)]",
            "',' or ']' was expected, not 'for'",
        ),
    ];
    for (expression, expected) in cases {
        // Quotes are written as entities, so the text of the message shows double ones.
        check_expression(expression, expected);
    }
}

#[test]
fn mistakes_in_elements() {
    let cases = [
        (
            "<link name=\"${1\"/>",
            "2:13: ${1: the closing } is missing",
        ),
        (
            "<link name=\"$(arg a)\"/>",
            "2:15: $(arg a): the argument a has no value here: it was not given, and no <xacro:arg> before gives a default",
        ),
        (
            "<link name=\"$(find a)\"/>",
            "2:15: $(find a): there is no package of this name",
        ),
        (
            "<link name=\"$(env A)\"/>",
            "2:15: $(env A): there is no environment variable of this name",
        ),
        (
            "<link name=\"$(anon a)\"/>",
            "2:15: $(anon a): $(arg name), $(find package), $(env name), $(optenv name default), $(dirname) or $(eval expression) was expected",
        ),
        (
            "<xacro:property name=\"1a\" value=\"\"/>",
            "2:23: name=\"1a\": a name without a prefix was expected, not '1a'",
        ),
        (
            "<xacro:property name=\"a\" value=\"1\" default=\"2\"/>",
            "2:1: <xacro:property name=\"a\">: only one of value, default and remove was expected",
        ),
        (
            "<xacro:property name=\"a\" value=\"1\" scope=\"all\"/>",
            "2:43: scope=\"all\": scope=\"parent\" or scope=\"global\" was expected",
        ),
        (
            "<xacro:property name=\"a\" value=\"${b}\"/><xacro:property name=\"b\"\nvalue=\"${a}\"/><l n=\"${a}\"/>",
            "3:10: ${a}: the property a is defined by itself",
        ),
        (
            "<xacro:if value=\"maybe\"/>",
            "2:18: value=\"maybe\": true or false was expected, not the text 'maybe'",
        ),
        (
            "<xacro:if/>",
            "2:1: <xacro:if>: an attribute value=\"...\" was expected",
        ),
        (
            "<xacro:m/>",
            "2:1: <xacro:m>: there is no macro m; none is defined here",
        ),
        (
            "<xacro:macro name=\"m\"/><xacro:n/>",
            "2:24: <xacro:n>: there is no macro n; those defined here are m",
        ),
        (
            "<xacro:macro name=\"m\" params=\"a b:=1\"/>\n<xacro:m/>",
            "3:1: <xacro:m>: the macro m expects a value for its parameter a",
        ),
        (
            "<xacro:macro name=\"m\" params=\"a b:=1\"/>\n<xacro:m a=\"1\" c=\"2\"/>",
            "3:19: c=\"2\": the macro m has no such parameter; its parameters are a, b",
        ),
        (
            "<xacro:macro name=\"m\" params=\"*a\"/>\n<xacro:m/>",
            "3:1: <xacro:m>: the macro m expects an element a within",
        ),
        (
            "<xacro:macro name=\"m\"/>\n<xacro:m><a/></xacro:m>",
            "3:10: <a>: the macro m does not use it",
        ),
        (
            "<xacro:macro name=\"m\" params=\":=1\"/>",
            "2:31: params=\":=1\": a parameter was expected at ':=1'",
        ),
        (
            "<xacro:macro name=\"a.b\"/>",
            "2:20: name=\"a.b\": a macro cannot be called 'call', nor have a dot in its name",
        ),
        (
            "<xacro:insert_block name=\"b\"/>",
            "2:27: name=\"b\": there is no block of this name here",
        ),
        (
            "<xacro:element xacro:name=\"a b\"/>",
            "2:28: xacro:name=\"a b\": a name without a prefix was expected, not 'a b'",
        ),
        (
            "<xacro:element xacro:name=\"${'li:' + 'nk'}\"/>",
            "2:28: xacro:name=\"${'li:' + 'nk'}\": a name without a prefix was expected, not 'li:nk'",
        ),
        (
            "<xacro:include filename=\"none.xacro\"/>",
            "2:26: data/none.xacro: no such file",
        ),
        (
            "<xacro:include filename=\"*.xacro\"/>",
            "2:26: filename=\"*.xacro\": patterns of file names are not read: name each file",
        ),
        // Mistakes of the URDF stand where they were written.
        (
            "<xacro:macro name=\"m\" params=\"x\">\n<link name=\"${x}\"/></xacro:macro><xacro:m x=\"a\"/><xacro:m x=\"a\"/>",
            "3:1: <link name=\"a\">: there is a link of this name already",
        ),
    ];
    for (body, expected) in cases {
        check(body, &format!("data/f.xacro:{expected}"));
    }
}

#[test]
fn mistakes_in_other_files() {
    check(
        "<xacro:include filename=\"bad.xacro\"/>",
        "data/bad.xacro:2:7: XML: expected 'link' tag, not 'robot'",
    );
    check(
        "<xacro:include filename=\"loop.xacro\"/>",
        "data/loop.xacro:2:26: filename=\"f.xacro\": files include each other in a circle: \
         data/f.xacro -> data/loop.xacro -> data/f.xacro",
    );
    check(
        "<l n=\"${xacro.load_yaml('none.yaml')}\"/>",
        "data/f.xacro:2:9: data/none.yaml: no such file",
    );
    check(
        "<l n=\"${xacro.load_yaml('bad.yaml')}\"/>",
        "data/bad.yaml:2:1: YAML: invalid indentation in flow construct",
    );
    check(
        "<l n=\"${xacro.load_yaml('unit.yaml')}\"/>",
        "data/unit.yaml:2:6: YAML: no such unit: !hours; there are !radians, !degrees, !meters, !millimeters, !foot and !inches",
    );
}

#[test]
fn unknown_arguments() {
    let text = robot("<xacro:arg name=\"prefix\" default=\"\"/>");
    let error = xacro::expand("f.xacro", &text, &[("prefx", "a")], &NoResources).unwrap_err();
    assert!(error.is_input());
    assert_eq!(
        error.to_string(),
        "argument prefx: the description has no argument of this name; it has prefix"
    );
}

/// Small texts that would become huge, or never end: an error in good time, on half the stack that threads get.
#[test]
fn bombs() {
    let thread = std::thread::Builder::new().stack_size(1 << 20);
    thread.spawn(explode).unwrap().join().unwrap();
}

fn explode() {
    let twice = |body: &str| {
        let mut text = String::from("<xacro:macro name=\"m0\"><l/></xacro:macro>");
        for n in 1..60 {
            let call = format!("<xacro:m{}/>", n - 1);
            text += &format!("<xacro:macro name=\"m{n}\">{call}{call}</xacro:macro>");
        }
        text + body
    };
    let mut lists = String::from("<xacro:property name=\"p0\" value=\"${[1]}\"/>");
    let mut texts = String::from("<xacro:property name=\"p0\" value=\"ab\"/>");
    for n in 1..60 {
        lists += &format!(
            "<xacro:property name=\"p{n}\" value=\"${{[p{0}, p{0}]}}\"/>",
            n - 1
        );
        texts += &format!(
            "<xacro:property name=\"p{n}\" value=\"${{p{0} + p{0}}}\"/>",
            n - 1
        );
    }
    let mut lazy = String::from("<xacro:property name=\"p0\" value=\"1\"/>");
    for n in 1..10_000 {
        lazy += &format!("<xacro:property name=\"p{n}\" value=\"${{p{}}}\"/>", n - 1);
    }
    let mut brackets = String::from("<xacro:property name=\"p0\" value=\"1\"/>");
    for n in 1..100 {
        let (open, close) = ("[".repeat(39), "][0]".repeat(39));
        brackets += &format!(
            "<xacro:property name=\"p{n}\" value=\"${{{open}p{}{close}}}\"/>",
            n - 1
        );
    }
    let cases = [
        (brackets + "<l n=\"${p99}\"/>", "nested too deeply"),
        ("<xacro:macro name=\"m\"><xacro:m/></xacro:macro><xacro:m/>".to_owned(), "m -> m -> m -> m -> m: macro calls are nested too deeply"),
        ("<xacro:macro name=\"m\"><a><xacro:m/></a></xacro:macro><xacro:m/>".to_owned(), "nested"),
        ("<xacro:macro name=\"m\"><xacro:m/><xacro:m/></xacro:macro><xacro:m/>".to_owned(), "nested"),
        ("<xacro:property name=\"b\"><xacro:insert_block name=\"b\"/></xacro:property><xacro:insert_block name=\"b\"/>".to_owned(), "nested"),
        ("<xacro:macro name=\"m\" params=\"**b\"><xacro:if value=\"true\"><xacro:call macro=\"m\"><b><xacro:insert_block name=\"b\"/></b></xacro:call></xacro:if></xacro:macro><xacro:m><b/></xacro:m>".to_owned(), "nested"),
        ("<xacro:macro name=\"m\"><xacro:element xacro:name=\"a\"><xacro:m/></xacro:element></xacro:macro><xacro:m/>".to_owned(), "nested"),
        (twice("<xacro:m59/>"), "becomes too large"),
        // What the fuzzer took longest for: a macro that calls itself twice, n times over.
        ("<xacro:macro name=\"m\" params=\"n\"><xacro:if value=\"${n > 0}\"><l/><xacro:m n=\"${n - 2}\"/><xacro:m n=\"${n - 2}\"/></xacro:if></xacro:macro><xacro:m n=\"60\"/>".to_owned(), "becomes too large"),
        (lists + "<l n=\"${p59}\"/>", "larger than 1048576"),
        (texts + "<l n=\"${p59}\"/>", "larger than 1048576"),
        (lazy + "<l n=\"${p9999}\"/>", "nested too deeply"),
        (format!("<l n=\"${{{}1{}}}\"/>", "(".repeat(9999), ")".repeat(9999)), "nested more than"),
        (format!("<l n=\"${{{}1}}\"/>", "2**".repeat(9999)), "nested more than"),
        (format!("<l n=\"{}1{}\"/>", "${".repeat(9999), "}".repeat(9999)), "nested too deeply"),
        (format!("<l n=\"${{'a' * {}}}\"/>", i64::MAX), "too long"),
        ("<l n=\"${range(1, 9223372036854775807)}\"/>".to_owned(), "more than 10000 values"),
    ];
    for (body, expected) in cases {
        let error = xacro::expand("data/f.xacro", &robot(&body), &[], &Data)
            .unwrap_err()
            .to_string();
        assert!(error.contains(expected), "{error}\ninstead of {expected}");
    }
    for harmless in [
        "-".repeat(9999) + "1",
        "not ".repeat(9999) + "1",
        "1+".repeat(9999) + "1",
        "0 or ".repeat(9999) + "1",
    ] {
        let text = robot(&format!("<l n=\"${{{harmless}}}\"/>"));
        assert!(
            xacro::expand("f.xacro", &text, &[], &NoResources).is_ok(),
            "{harmless:.20}"
        );
    }
}
