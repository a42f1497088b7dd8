//! Sines and cosines of all angles at once, where a compiler can make vector instructions of them.
//!
//! A mathematics library takes its sines and cosines one after the other, which is four fifths of the time of forward
//! kinematics. In C, C++ and Rust with doubles they are computed in one loop without branches instead: the angle less
//! the nearest multiple of a quarter turn (Cody and Waite, in two parts), polynomials for sine and cosine within an
//! eighth of a turn (fdlibm's, by Sun Microsystems), and the quadrant's exchange and signs as products with 0, 1 and -1.

use super::emit::Emit;
use super::program::Program;
use super::{Language, Precision};
use crate::names::{AngleMeaning, Var, VarKind};

/// Joint angles from which the loop pays.
const LEAST: usize = 2;

impl Program<'_> {
    /// Whether the program has the function.
    pub(super) fn has_turns(&self) -> bool {
        let turning = self.emit.arm.rows.iter().filter(|row| row.turns).count();
        together(&self.emit) && turning >= LEAST
    }

    /// The function, if the arm's forward kinematics is to use it.
    pub(super) fn turns_helper(&mut self) {
        if !self.has_turns() {
            return;
        }
        let name = self.name("turns");
        let template = match self.emit.language {
            Language::Rust => RUST,
            _ => C,
        };
        let library = |function: &str| self.emit.function(function);
        let text = template
            .replace("{body}", BODY)
            .replace("{turns}", &name)
            .replace("{fabs}", &library("fabs"))
            .replace("{sin}", &library("sin"))
            .replace("{cos}", &library("cos"));
        let text = match self.emit.language {
            Language::Rust => text.replace("const double ", "let "),
            _ => text,
        };
        self.emit.line("");
        self.emit.out.push_str(&text);
    }

    /// Declares the sines and cosines among `vars`, all taken at once.
    pub(super) fn declare_turns(&mut self, vars: &[Var], declared: &mut Vec<Var>) {
        if !together(&self.emit) {
            return;
        }
        let mut angles = Vec::new();
        for var in vars {
            let (VarKind::Sin(angle) | VarKind::Cos(angle)) = var.kind() else {
                continue;
            };
            let is_joint = matches!(
                self.emit.names.meaning(angle),
                AngleMeaning::Joint(_) | AngleMeaning::Sum(_)
            );
            if is_joint && !angles.contains(&angle) {
                angles.push(angle);
            }
        }
        if angles.len() < LEAST {
            return;
        }
        let arguments: Vec<String> = angles
            .iter()
            .filter_map(|angle| self.emit.argument(*angle))
            .collect();
        let (count, list, turns) = (angles.len(), arguments.join(", "), self.name("turns"));
        match self.emit.language {
            Language::Rust => self.emit.line(&format!("let (s, c) = {turns}([{list}]);")),
            _ => {
                self.emit
                    .line(&format!("const double x[{count}] = {{{list}}};"));
                self.emit.line(&format!("double s[{count}], c[{count}];"));
                self.emit.line(&format!("{turns}(x, s, c, {count});"));
            }
        }
        for var in vars {
            let (from, angle) = match var.kind() {
                VarKind::Sin(angle) => ("s", angle),
                VarKind::Cos(angle) => ("c", angle),
                _ => continue,
            };
            let Some(place) = angles.iter().position(|one| *one == angle) else {
                continue;
            };
            let name = self.emit.var(*var);
            self.emit.declare(&name, &format!("{from}[{place}]"));
            declared.push(*var);
        }
    }
}

/// Whether the language's compilers make vectors of loops over doubles.
fn together(emit: &Emit<'_>) -> bool {
    emit.precision == Precision::Double
        && matches!(emit.language, Language::C | Language::Cpp | Language::Rust)
}

/// One angle: what C and Rust have in common.
const BODY: &str = "\
const double k = (x[i] * 0.63661977236758134308 + m) - m;
            const double r = (x[i] - k * 1.57079632673412561417e+00) - k * 6.07710050650619224932e-11;
            const double z = r * r;
            const double y = z * z;
            const double sine = r + r * z * ((-1.66666666666666324348e-01 + z * 8.33333333332248946124e-03)
                + y * ((-1.98412698298579493134e-04 + z * 2.75573137070700676789e-06)
                + y * (-2.50507602534068634195e-08 + z * 1.58969099521155010221e-10)));
            const double cosine = 1.0 - z * (0.5 - z * ((4.16666666666666019037e-02 - z * 1.38888888888741095749e-03)
                + y * ((2.48015872894767294178e-05 - z * 2.75573143513906633035e-07)
                + y * (2.08757232129817482790e-09 - z * 1.13596475577881948265e-11))));
            const double j = k - 4.0 * ((k * 0.25 + m) - m); // from -2 to 2
            const double even = 1.0 - {fabs}(j);
            const double odd = j * (2.0 - {fabs}(j));
            s[i] = even * sine + odd * cosine;
            c[i] = even * cosine - odd * sine;
";

const C: &str = "\
// Sines and cosines of n angles, in one loop that compilers turn into vector instructions: x less k quarter turns,
// a polynomial each, and the quadrant's exchange and signs. Within a unit in the last place of 1. Angles far from 0,
// and arithmetic that is not plain IEEE double precision, go to the mathematics library.
static inline void {turns}(const double *x, double *s, double *c, int n) {
    double size = 0;
    for (int i = 0; i < n; ++i) size += {fabs}(x[i]);
#if FLT_EVAL_METHOD == 0 && DBL_MANT_DIG == 53 && !defined(__FAST_MATH__) && !defined(_M_FP_FAST)
    if (size < 1e5) {
        const double m = 6755399441055744.0; // 1.5 * 2^52: adding it rounds to a whole number
        for (int i = 0; i < n; ++i) {
            {body}        }
        return;
    }
#endif
    for (int i = 0; i < n; ++i) {
        s[i] = {sin}(x[i]);
        c[i] = {cos}(x[i]);
    }
}
";

const RUST: &str = "\
/// Sines and cosines of angles, in one loop that the compiler turns into vector instructions: x less k quarter turns,
/// a polynomial each, and the quadrant's exchange and signs. Within a unit in the last place of 1. Angles far from 0
/// go to the mathematics library.
#[inline(always)]
fn {turns}<const N: usize>(x: [f64; N]) -> ([f64; N], [f64; N]) {
    let (mut s, mut c) = ([0.0; N], [0.0; N]);
    let mut size = 0.0;
    for i in 0..N {
        size += {fabs}(x[i]);
    }
    // The old x87 unit rounds to more than double precision.
    let plain = cfg!(not(all(target_arch = \"x86\", not(target_feature = \"sse2\"))));
    if plain && size < 1e5 {
        let m = 6755399441055744.0; // 1.5 * 2^52: adding it rounds to a whole number
        for i in 0..N {
            {body}        }
    } else {
        for i in 0..N {
            s[i] = {sin}(x[i]);
            c[i] = {cos}(x[i]);
        }
    }
    (s, c)
}
";
