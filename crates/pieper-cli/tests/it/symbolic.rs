//! `pieper derive`, `check` and `codegen` as a user meets them.

use crate::support::{Temporary, pieper};

#[test]
fn the_misprints_of_the_paper() {
    for claims in ["examples/ar3-claims.txt", "examples/ar3-claims.tex"] {
        let ended = pieper(&["check", "ar3", claims]);
        assert_eq!(ended.code, 1, "{}", ended.stderr);
        let lines: Vec<&str> = ended.stdout.lines().collect();
        assert_eq!(lines.len(), 12, "one line a claim");
        for line in lines {
            let name = line.split_whitespace().next().unwrap().replace('_', "");
            let wrong = matches!(name.as_str(), "t11" | "t13");
            assert_eq!(line.contains(" fails repair: "), wrong, "{line}");
            assert_eq!(line.ends_with(" holds"), !wrong, "{line}");
        }
    }
    let json = pieper(&["check", "ar3", "examples/ar3-claims.txt", "--json"]);
    let verdicts: serde_json::Value = serde_json::from_str(&json.stdout).unwrap();
    assert_eq!(verdicts[0]["repair"]["after"], "c4*c6 - s4*c5*s6");
    assert_eq!(verdicts[1]["holds"], true);
}

#[test]
fn claims_of_a_users_own() {
    let folder = Temporary::new();
    let good = folder.file("good.txt", "t33 = -s234*s5\nA6[3, 4] = d6\n");
    assert_eq!(pieper(&["check", "ur5", &good]).code, 0);
    let numbers = folder.file("numbers.txt", "A6[3, 4] = 0.0823\n");
    assert_eq!(pieper(&["check", "ur5", &numbers, "--numeric"]).code, 0);
    for (text, words) in [
        ("t33 = c9", "bad.txt:1:7"),
        ("", "holds no claim"),
        ("t33 = (", "was expected"),
    ] {
        let bad = folder.file("bad.txt", text);
        let ended = pieper(&["check", "ur5", &bad]);
        assert_eq!(ended.code, 2, "{text}");
        assert!(ended.stderr.contains(words), "{text}: {}", ended.stderr);
    }
    assert_eq!(pieper(&["check", "ur5", "no-such-file.txt"]).code, 2);
}

#[test]
fn sheets_in_every_format_for_every_kind_of_arm() {
    for robot in ["ar3", "six-axis", "puma560", "ur5", "cobra600", "stanford"] {
        for way in [&[][..], &["--inverse"], &["--numeric"]] {
            for (format, starts) in [
                ("text", ""),
                ("markdown", "# "),
                ("latex", "\\documentclass"),
                ("html", "<!DOCTYPE html>"),
            ] {
                let ended = pieper(&[&["derive", robot, "--format", format][..], way].concat());
                assert_eq!(ended.code, 0, "{robot} {way:?} {format}: {}", ended.stderr);
                assert!(ended.stdout.starts_with(starts), "{robot} {format}");
                let outside = ["http://", "https://", "<script", "src="]
                    .iter()
                    .any(|word| ended.stdout.contains(word));
                assert!(
                    format != "html" || !outside,
                    "the page refers to nothing outside"
                );
            }
        }
    }
    let none = pieper(&["derive", "iiwa7", "--inverse"]);
    assert_eq!(none.code, 2);
    assert!(
        none.stderr.contains("7 joints") && none.stderr.contains("pieper ik"),
        "{}",
        none.stderr
    );
}

#[test]
fn a_long_chain_is_refused_and_not_pondered() {
    let folder = Temporary::new();
    let rows: String = (1..=20)
        .map(|i| {
            format!(
                "[[joint]]\ntheta = 'q{i}'\nalpha = '{}'\na = 'l{i}'\n",
                ["pi/2", "-pi/2"][i % 2]
            )
        })
        .collect();
    let lengths: String = (1..=20).map(|i| format!("l{i} = 0.1\n")).collect();
    let snake = folder.file(
        "snake.toml",
        &format!("name = 'snake'\nconvention = 'standard'\n[parameters]\n{lengths}{rows}"),
    );
    let ended = pieper(&["derive", &snake]);
    assert_eq!(ended.code, 2);
    assert!(
        ended.stderr.contains("more than 4000 terms"),
        "{}",
        ended.stderr
    );
}

#[test]
fn code_in_every_language() {
    for (language, words) in [
        ("c", "void ar3_fk("),
        ("cpp", "namespace ar3"),
        ("rust", "pub fn inverse("),
        ("python", "def jacobian(q):"),
        ("matlab", "function k = ar3_kinematics()"),
    ] {
        let ended = pieper(&["codegen", "ar3", "--lang", language]);
        assert_eq!(ended.code, 0, "{}", ended.stderr);
        assert!(ended.stdout.contains(words), "{language}");
    }
    let none = pieper(&["codegen", "jaco2", "--lang", "c", "--what", "inverse"]);
    assert_eq!(none.code, 2);
    assert!(none.stderr.contains("no closed form"), "{}", none.stderr);
}
