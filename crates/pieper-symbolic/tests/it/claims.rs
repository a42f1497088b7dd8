//! Claims: what holds, what fails, and with which repair; and the words for claims that do not read.

use pieper_symbolic::claims::{Outcome, check};
use pieper_symbolic::{Arm, Lengths};

fn arm(id: &str) -> Arm {
    Arm::new(&pieper_robots::find(id).unwrap().robot(), Lengths::Symbols).unwrap()
}

const AR3_PLAIN: &str = include_str!("../../../../examples/ar3-claims.txt");
const AR3_LATEX: &str = include_str!("../../../../examples/ar3-claims.tex");

#[test]
fn the_papers_two_misprints_are_found_and_nothing_else() {
    for (text, latex, t11, t13) in [
        (AR3_PLAIN, false, "c4*c6 - s4*c5*s6", "s4*s6 - c4*c5*c6"),
        (
            AR3_LATEX,
            true,
            "cos(Theta_4)*cos(Theta_6) - sin(Theta_4)*cos(Theta_5)*sin(Theta_6)",
            "cos(Theta_4)*cos(Theta_5)*cos(Theta_6)",
        ),
    ] {
        let verdicts = check(&arm("ar3"), "print", text, latex).unwrap();
        assert_eq!(verdicts.len(), 12);
        for verdict in &verdicts {
            match (&verdict.outcome, verdict.name.replace('_', "").as_str()) {
                (Outcome::Holds, name) => assert!(name != "t11" && name != "t13"),
                (Outcome::Fails(failure), name) => {
                    let after = if name == "t11" { t11 } else { t13 };
                    assert!(name == "t11" || name == "t13", "{name}");
                    assert_eq!(failure.repair.as_ref().unwrap().after, after);
                    assert!((failure.values.0 - failure.values.1).abs() > 1e-3);
                }
                (other, name) => panic!("{name}: {other:?}"),
            }
        }
    }
}

/// One claim and its repair; an empty one stands for a claim that holds.
fn one(id: &str, claim: &str, repaired: &str) {
    verdict(id, claim, false, repaired);
}

fn verdict(id: &str, claim: &str, latex: bool, repaired: &str) {
    let verdicts =
        check(&arm(id), "claim", claim, latex).unwrap_or_else(|error| panic!("{claim}: {error}"));
    assert_eq!(verdicts.len(), 1, "{claim}");
    match (&verdicts[0].outcome, repaired) {
        (Outcome::Holds, "") => {}
        (Outcome::Fails(failure), repaired) if !repaired.is_empty() => {
            let repair = failure
                .repair
                .as_ref()
                .unwrap_or_else(|| panic!("{claim}: no repair"));
            assert_eq!(
                format!("{} -> {}", repair.before, repair.after),
                repaired,
                "{claim}"
            );
        }
        (other, _) => panic!("{claim}: {other:?}"),
    }
}

#[test]
fn claims_of_every_kind() {
    one("ar3", "t32 = s23*c5 - c23*c4*s5", "");
    one(
        "ar3",
        "t32 = sin(q2 - q3) cos q5 - cos(q2 - q3) cos q4 sin q5",
        "",
    );
    one("ar3", "n_z^2 + s_z^2 + a_z^2 = 1", "");
    one(
        "ar3",
        "t32 = s23*c5 - c24*c4*s5",
        "s23*c5 - c24*c4*s5 -> s23*c5 - c23*c4*s5",
    );
    one(
        "ar3",
        "z_c = S1 + l2*s2 + (l4 + l6*c5)*s23 - l4*c23*c4*s5",
        "l4*c23*c4*s5 -> l6*c23*c4*s5",
    );
    one(
        "ar3",
        "t34 = S1 + l2*s2 + (l4 + l6*c5)*s23\n - l6*c23*c4*s5",
        "",
    );
    // The six-axis note's misprint: entry (3,2) of the last matrix.
    let six = "A6 = [c6, -s6, 0, 0; s6, c6, 0, 0; 0, -1, 1, d6; 0, 0, 0, 1]";
    one("six-axis", six, "-1 -> 0");
    one(
        "six-axis",
        "A6 = [[c6, -s6, 0, 0], [s6, c6, 0, 0], [0, 0, 1, d6], [0, 0, 0, 1]]",
        "",
    );
    let latex = r"A_6 = \begin{pmatrix} c_6 & -s_6 & 0 & 0 \\ s_6 & c_6 & 0 & 0 \\ 0 & 0 & 1 & d_6 \\ 0&0&0&1 \end{pmatrix}";
    verdict("six-axis", latex, true, "");
    // The inverse formula at the wrist's singularity: s13 and s33 say nothing about it.
    one(
        "six-axis",
        "q4 + q6 = atan2(R36[2, 1], R36[1, 1]) when q5 = 0",
        "",
    );
    one(
        "six-axis",
        "map s = R36\nq4 + q6 = atan2(s13, s33) when q5 = 0",
        "atan2(s13, s33) -> atan2(s21, s11)",
    );
    one(
        "six-axis",
        "q5 = acos(R36[3, 3])",
        "acos(R36[3, 3]) -> +-acos(R36[3, 3])",
    );
    one("ur5", "J61 = 1", "");
    one("ur5", "t33 = -s234*s5", "");
    one(
        "cobra600",
        "T = [c124, s124, 0, a1 c1 + a2 c12; s124, -c124, 0, a1 s1 + a2 s12; 0, 0, -1, d1 - q3; 0,0,0,1]",
        "",
    );
    one("stanford", "tan(q1)*cos(q1) = s1", "");
    verdict(
        "ar3",
        r"\begin{align} t_{32} &= s_{23} c_5 - \\ &- c_{23} c_4 s_5 \end{align}",
        true,
        "",
    );
}

#[test]
fn claims_that_do_not_read_are_told_where_and_why() {
    for (claim, latex, words) in [
        (
            "t11 = c1*(c4",
            false,
            "claim:1:13: an operator or a closing bracket was expected, the end of the file was found",
        ),
        ("t11 = c1 +\n", false, "was expected"),
        (
            "\n\nt11 = c1*c9",
            false,
            "claim:3:10: \"c9\": it stands for nothing here; the nearest names are",
        ),
        ("t11 = l3*c1", false, "the nearest names are"),
        ("t11", false, "'=' with what the formula is said to be"),
        (
            "t11 = c1^x",
            false,
            "a whole exponent of at most 16 was expected",
        ),
        ("t11 = c1^99", false, "a whole exponent of at most 16"),
        ("t11 = A5", false, "a number was expected, this is a matrix"),
        ("A5 = [1, 2; 3]", false, "a matrix with rows of one length"),
        (
            "A5 = [1, 2; 3, 4]",
            false,
            "a matrix of 3 or 4 rows and columns was expected, this is 2 x 2",
        ),
        (
            "t11 = ?",
            false,
            "claim:1:7: '?': a formula was expected here",
        ),
        ("t11 = c1/(c1 - c1)", false, "this divides by zero"),
        ("t11 = c1 when q9 = 0", false, "\"q9\""),
        ("t11 = sin(q1/2)", false, "an angle made of joint variables"),
        (r"t_{11} = \frac{1}", true, "a group in braces was expected"),
        (
            r"t_{11} = c_",
            true,
            "an index was expected behind its underscore",
        ),
        ("t11 = atan2(c1)", false, "2 argument(s) of atan2"),
        (
            "t11 = (c1 + s1 + c2 + s2 + c4 + s4 + c5 + s5 + c6 + s6 + a1)^16",
            false,
            "too long to decide",
        ),
    ] {
        let error = check(&arm("ar3"), "claim", claim, latex)
            .expect_err(claim)
            .to_string();
        assert!(error.contains(words), "{claim}: {error}");
    }
    let deep = format!("t11 = {}c1{}", "(".repeat(5000), ")".repeat(5000));
    assert!(
        check(&arm("ar3"), "claim", &deep, false)
            .unwrap_err()
            .to_string()
            .contains("less deeply nested")
    );
}
