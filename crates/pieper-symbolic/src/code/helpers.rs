//! The small functions that a generated inverse is made of.

use super::program::Program;
use super::{Language, Precision};
use crate::inverse::{Inverse, Rule, Step};

impl Program<'_> {
    /// Small functions the inverse is made of.
    pub(super) fn helpers(&mut self, inverse: &Inverse) {
        let number = self.number();
        let (slack, free) = match self.emit.precision {
            Precision::Double => ("1e-12", "1e-12"),
            Precision::Float => ("1e-5", "1e-5"),
        };
        let squares = inverse.steps.iter().any(|step| {
            matches!(
                step,
                Step::Joint {
                    rule: Rule::Square { .. },
                    ..
                }
            )
        });
        let name = |function: &str| self.name(function);
        let (two, one, square, wrap) = (name("two"), name("one"), name("square"), name("wrap"));
        let texts = match self.emit.language {
            Language::C | Language::Cpp => {
                let (keyword, f) = match self.emit.language {
                    Language::C => ("static", self.emit.precision == Precision::Float),
                    _ => ("inline", false),
                };
                let m = |function: &str| match (self.emit.language, f) {
                    (Language::Cpp, _) => format!("std::{function}"),
                    (_, true) => format!("{function}f"),
                    _ => function.to_owned(),
                };
                C_HELPERS
                    .replace("{static}", keyword)
                    .replace("{fabs}", &m("fabs"))
                    .replace("{sqrt}", &m("sqrt"))
                    .replace("{atan2}", &m("atan2"))
            }
            Language::Rust => RUST_HELPERS.to_owned(),
            Language::Python => PYTHON_HELPERS.to_owned(),
            Language::Matlab => MATLAB_HELPERS.to_owned(),
        };
        let texts = texts
            .replace("{number}", number)
            .replace("{slack}", slack)
            .replace("{free}", free)
            .replace("{two}", &two)
            .replace("{one}", &one)
            .replace("{square}", &square)
            .replace("{wrap}", &wrap);
        let (always, quadratic) = texts.split_once("---\n").unwrap_or((&texts, ""));
        self.emit.out.push_str(always);
        self.emit.out.push('\n');
        if squares {
            self.emit.out.push_str(quadratic);
            self.emit.out.push('\n');
        }
    }
}

const C_HELPERS: &str = "\
// The angle in (-pi, pi].
{static} {number} {wrap}({number} x) {
    const {number} pi = ({number})3.14159265358979323846;
    return x > pi ? x - 2 * pi : x <= -pi ? x + 2 * pi : x;
}

// Both roots of a cos q + b sin q = k; square is the square of the sine where it is known better, or -1.
{static} int {two}({number} a, {number} b, {number} k, {number} square, {number} free, {number} roots[2]) {
    const {number} radius = {sqrt}(a * a + b * b), size = {fabs}(a) + {fabs}(b) + {fabs}(k);
    if (radius <= ({number}){free}) { roots[0] = free; return 1; }
    if (square < 0) square = (radius - k) * (radius + k);
    const {number} middle = {atan2}(b, a);
    if (square > ({number}){slack} * size * size) {
        const {number} half = {atan2}({sqrt}(square), k);
        roots[0] = {wrap}(middle + half);
        roots[1] = {wrap}(middle - half);
        return 2;
    }
    if (square < -({number}){slack} * size * size) return 0;
    roots[0] = {wrap}(middle + {atan2}(0, k));
    return 1;
}

// The angle with this sine and cosine, up to one positive factor; free where both vanish.
{static} {number} {one}({number} s, {number} c, {number} free) {
    return {fabs}(s) + {fabs}(c) <= ({number}){free} ? free : {atan2}(s, c);
}
---
// Both roots of a q^2 + b q + c = 0.
{static} int {square}({number} c, {number} b, {number} a, {number} roots[2]) {
    const {number} d = b * b - 4 * a * c;
    if (a == 0 || d < 0) return 0;
    roots[0] = (-b + {sqrt}(d)) / (2 * a);
    roots[1] = (-b - {sqrt}(d)) / (2 * a);
    return 2;
}
";

const RUST_HELPERS: &str = "\
/// The angle in (-pi, pi].
fn {wrap}(x: {number}) -> {number} {
    const PI: {number} = core::{number}::consts::PI;
    if x > PI {
        x - 2.0 * PI
    } else if x <= -PI {
        x + 2.0 * PI
    } else {
        x
    }
}

/// Both roots of a cos q + b sin q = k; square is the square of the sine where it is known better, or -1.
fn {two}(a: {number}, b: {number}, k: {number}, square: {number}, free: {number}) -> (usize, [{number}; 2]) {
    let (radius, size) = (math::sqrt(a * a + b * b), math::fabs(a) + math::fabs(b) + math::fabs(k));
    if radius <= {free} {
        return (1, [free, free]);
    }
    let square = if square < 0.0 { (radius - k) * (radius + k) } else { square };
    let middle = math::atan2(b, a);
    if square > {slack} * size * size {
        let half = math::atan2(math::sqrt(square), k);
        (2, [{wrap}(middle + half), {wrap}(middle - half)])
    } else if square < -{slack} * size * size {
        (0, [0.0; 2])
    } else {
        (1, [{wrap}(middle + math::atan2(0.0, k)); 2])
    }
}

/// The angle with this sine and cosine, up to one positive factor; free where both vanish.
fn {one}(s: {number}, c: {number}, free: {number}) -> {number} {
    if math::fabs(s) + math::fabs(c) <= {free} { free } else { math::atan2(s, c) }
}
---
/// Both roots of a q^2 + b q + c = 0.
fn {square}(c: {number}, b: {number}, a: {number}) -> (usize, [{number}; 2]) {
    let d = b * b - 4.0 * a * c;
    if a == 0.0 || d < 0.0 {
        return (0, [0.0; 2]);
    }
    let root = math::sqrt(d);
    (2, [(-b + root) / (2.0 * a), (-b - root) / (2.0 * a)])
}
";

const PYTHON_HELPERS: &str = "\
def {wrap}(x):
    \"\"\"The angle in (-pi, pi].\"\"\"
    return x - 2 * math.pi if x > math.pi else x + 2 * math.pi if x <= -math.pi else x


def {two}(a, b, k, square, free):
    \"\"\"Both roots of a cos q + b sin q = k; square is the square of the sine where it is known better, or -1.\"\"\"
    radius, size = math.hypot(a, b), abs(a) + abs(b) + abs(k)
    if radius <= {free}:
        return [free]
    if square < 0:
        square = (radius - k) * (radius + k)
    middle = math.atan2(b, a)
    if square > {slack} * size * size:
        half = math.atan2(math.sqrt(square), k)
        return [{wrap}(middle + half), {wrap}(middle - half)]
    if square < -{slack} * size * size:
        return []
    return [{wrap}(middle + math.atan2(0.0, k))]


def {one}(s, c, free):
    \"\"\"The angle with this sine and cosine, up to one positive factor; free where both vanish.\"\"\"
    return free if abs(s) + abs(c) <= {free} else math.atan2(s, c)

---
def {square}(c, b, a):
    \"\"\"Both roots of a q^2 + b q + c = 0.\"\"\"
    d = b * b - 4 * a * c
    if a == 0 or d < 0:
        return []
    root = math.sqrt(d)
    return [(-b + root) / (2 * a), (-b - root) / (2 * a)]

";

const MATLAB_HELPERS: &str = "\
% The angle in (-pi, pi].
function x = {wrap}(x)
    if x > pi
        x = x - 2 * pi;
    elseif x <= -pi
        x = x + 2 * pi;
    end
end

% Both roots of a cos q + b sin q = k; square is the square of the sine where it is known better, or -1.
function roots = {two}(a, b, k, square, free)
    radius = hypot(a, b);
    size = abs(a) + abs(b) + abs(k);
    if radius <= {free}
        roots = free;
        return
    end
    if square < 0
        square = (radius - k) * (radius + k);
    end
    middle = atan2(b, a);
    if square > {slack} * size ^ 2
        half = atan2(sqrt(square), k);
        roots = [{wrap}(middle + half), {wrap}(middle - half)];
    elseif square < -{slack} * size ^ 2
        roots = [];
    else
        roots = {wrap}(middle + atan2(0, k));
    end
end

% The angle with this sine and cosine, up to one positive factor; free where both vanish.
function q = {one}(s, c, free)
    if abs(s) + abs(c) <= {free}
        q = free;
    else
        q = atan2(s, c);
    end
end

---
% Both roots of a q^2 + b q + c = 0.
function roots = {square}(c, b, a)
    d = b * b - 4 * a * c;
    if a == 0 || d < 0
        roots = [];
    else
        roots = [(-b + sqrt(d)) / (2 * a), (-b - sqrt(d)) / (2 * a)];
    end
end

";
