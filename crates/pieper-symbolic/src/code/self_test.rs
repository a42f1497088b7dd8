//! The generated test of a generated program: one pose against its known matrix, and that the inverse finds it.

use super::program::Program;
use super::{Language, Precision};
use crate::inverse::Inverse;

impl Program<'_> {
    pub(super) fn self_test(&mut self, inverse: Option<&Inverse>) {
        let arm = self.emit.arm;
        let (language, precision) = (self.emit.language, self.emit.precision);
        let most = inverse.map_or(0, Inverse::most);
        let (count, number, fk, name) = (
            arm.dof(),
            self.number(),
            self.name("fk"),
            self.name("inverse"),
        );
        let lengths: Vec<f64> = (0..self.open.len())
            .map(|index| 0.25 + 0.125 * index as f64)
            .collect();
        let extra: String = lengths
            .iter()
            .map(|value| format!(", {}", language.number(*value, precision)))
            .collect();
        let parameter = |name: &str| match self.open.iter().position(|open| open == name) {
            Some(index) => lengths[index],
            None => arm.parameter(name),
        };
        let q: Vec<f64> = (0..count)
            .map(|joint| 0.3 + 0.2 * joint as f64 - 0.7 * (joint % 2) as f64)
            .collect();
        let pose = arm.pose_at(&q, &parameter);
        let list = |values: &[f64]| {
            values
                .iter()
                .map(|value| language.number(*value, precision))
                .collect::<Vec<_>>()
                .join(", ")
        };
        let rows: Vec<String> = pose.iter().map(|row| list(row)).collect();
        let tolerance = if precision == Precision::Float {
            "1e-5"
        } else {
            "1e-12"
        };
        let q = list(&q);
        let solves = inverse.is_some();
        let text = match language {
            Language::C | Language::Cpp => {
                let fabs = self.emit.function("fabs");
                let (close, scope) = match language {
                    Language::Cpp => (
                        format!("}} // namespace {}\n\n", self.id),
                        format!("{}::", self.id),
                    ),
                    _ => (String::new(), String::new()),
                };
                let solve = match solves {
                    true => format!(
                        "    {number} found[{most}][{count}];\n    if ({scope}{name}(T, 0, found{extra}) < 1) return 2;\n"
                    ),
                    false => String::new(),
                };
                format!(
                    "{close}#ifdef PIEPER_SELF_TEST\nint main(void) {{\n    const {number} q[{count}] = {{{q}}};\n    const {number} expected[3][4] = {{{{{}}}}};\n    {number} T[3][4];\n    {scope}{fk}(q, T{extra});\n    for (int i = 0; i < 3; ++i)\n        for (int j = 0; j < 4; ++j)\n            if (!({fabs}(T[i][j] - expected[i][j]) < {tolerance})) return 1;\n{solve}    return 0;\n}}\n#endif\n",
                    rows.join("}, {")
                )
            }
            Language::Rust => {
                let solve = match solves {
                    true => format!(
                        "        let mut found = [[0.0; {count}]; {most}];\n        assert!(super::{name}(&pose, 0.0, &mut found{extra}) >= 1);\n"
                    ),
                    false => String::new(),
                };
                format!(
                    "#[cfg(test)]\nmod tests {{\n    #[test]\n    fn agrees_with_the_formulas() {{\n        let pose = super::{fk}(&[{q}]{extra});\n        let expected: [[{number}; 4]; 3] = [[{}]];\n        for i in 0..3 {{\n            for j in 0..4 {{\n                assert!(super::math::fabs(pose[i][j] - expected[i][j]) < {tolerance});\n            }}\n        }}\n{solve}    }}\n}}\n",
                    rows.join("], [")
                )
            }
            Language::Python => {
                let solve = match solves {
                    true => format!("    assert len({name}(pose, 0.0{extra})) >= 1\n"),
                    false => String::new(),
                };
                format!(
                    "\nif __name__ == \"__main__\":\n    pose = {fk}([{q}]{extra})\n    expected = [[{}]]\n    assert all(abs(pose[i][j] - expected[i][j]) < {tolerance} for i in range(3) for j in range(4))\n{solve}    print(\"passed\")\n",
                    rows.join("], [")
                )
            }
            Language::Matlab => {
                let solve = match solves {
                    true => format!("    assert(rows({name}(pose, 0{extra})) >= 1);\n")
                        .replace("rows(", "size("),
                    false => String::new(),
                };
                let solve = solve.replace(") >= 1", ", 1) >= 1");
                format!(
                    "function self_test()\n    pose = {fk}([{q}]{extra});\n    expected = [{}];\n    assert(max(max(abs(pose - expected))) < {tolerance});\n{solve}    disp('passed');\nend\n",
                    rows.join("; ")
                )
            }
        };
        self.emit.out.push_str(&text);
    }
}
