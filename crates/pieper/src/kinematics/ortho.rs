//! Poses of the most common kind of industrial arm, one register of them at a time, by its formulas.

use pulp::Simd;

use super::kernel::{Frame, Turn};
use super::lanes::{self, LaneColumn, Lanes};
use crate::model::Ortho;
use crate::scalar::Scalar;

/// The tool's poses for one register of joint vectors, those that drive step 0 to 5; and a bound of the angles'
/// sizes, which is not a number where one of them is none.
///
/// With `P` the exchange of the second and third axis, the rotation is `Rz(1) P Rz(2+3) P Rz(4) P Rz(5) P Rz(6)`: written
/// out for two columns, the first being their cross product. That is two thirds of the products of the general way, and
/// nothing is stored on the way.
#[inline(always)]
pub(super) fn poses<S: Simd>(
    simd: S,
    ortho: &Ortho,
    joints: [S::f64s; 6],
) -> (Frame<LaneColumn<S>>, Lanes<S>) {
    let splat = |value: f64| Lanes::splat(simd, value);
    let [q1, q2, q3, q4, q5, q6] = joints;
    let [d1, d2, d3, d4, d5, d6] = ortho.drives;
    let (a1, a2, a3) = (
        angle(simd, q1, d1),
        angle(simd, q2, d2),
        angle(simd, q3, d3),
    );
    let (a4, a5, a6) = (
        angle(simd, q4, d4),
        angle(simd, q5, d5),
        angle(simd, q6, d6),
    );
    // Unlike a maximum, a sum keeps what is not a number.
    let sizes = ((size(a1) + size(a2)) + (size(a3) + size(a4))) + (size(a5) + size(a6));
    let one = lanes::sin_cos(a1);
    let two = lanes::sin_cos(a2);
    let elbow = lanes::sin_cos(a2 + a3);
    let four = lanes::sin_cos(a4);
    let five = lanes::sin_cos(a5);
    let six = lanes::sin_cos(a6);

    // Columns two and three of the wrist, Rz(4) P Rz(5) P Rz(6), from above downwards.
    let fold = five.cos * six.sin;
    let wrist_y = [
        -product(four.cos, fold, four.sin, six.cos),
        product(four.cos, six.cos, -four.sin, fold),
        -(five.sin * six.sin),
    ];
    let wrist_z = [-(four.cos * five.sin), -(four.sin * five.sin), five.cos];
    // The world's y and z may be the stored ones turned round.
    let [sign_y, sign_z] = ortho.signs;
    let ([sin_y, cos_y], [sin_z, cos_z]) = (signed(one, sign_y), signed(elbow, sign_z));
    let columns = Columns {
        sines: [one.sin, sin_y, elbow.sin, sin_z],
        cosines: [one.cos, cos_y, elbow.cos, cos_z],
    };
    let ([yx, yy, yz], [zx, zy, zz]) = (columns.of(wrist_y), columns.of(wrist_z));

    // The wrist's centre in the plane that axis 1 turns, then in the world.
    let upper = match sign_z < 0.0 {
        true => -two.sin,
        false => two.sin,
    };
    let mut reach = (-elbow.sin).mul_add(splat(ortho.d4), splat(ortho.a1));
    let mut height = cos_z.mul_add(splat(ortho.d4), splat(ortho.base[2]));
    reach = two.cos.mul_add(splat(ortho.a2), reach);
    height = upper.mul_add(splat(ortho.a2), height);
    if ortho.a3 != 0.0 {
        reach = elbow.cos.mul_add(splat(ortho.a3), reach);
        height = sin_z.mul_add(splat(ortho.a3), height);
    }
    let [mut across, mut along] = [ortho.base[0], ortho.base[1]].map(splat);
    if ortho.side != 0.0 {
        across = (-one.sin).mul_add(splat(ortho.side), across);
        along = cos_y.mul_add(splat(ortho.side), along);
    }
    let d6 = splat(ortho.d6);
    let position = [
        zx.mul_add(d6, one.cos.mul_add(reach, across)),
        zy.mul_add(d6, sin_y.mul_add(reach, along)),
        zz.mul_add(d6, height),
    ];

    let p = stored(simd, position);
    let (y, z) = match ortho.swapped {
        true => ([zx, zy, zz], [yx, yy, yz]),
        false => ([yx, yy, yz], [zx, zy, zz]),
    };
    let x = [
        product(y[1], z[2], -y[2], z[1]),
        product(y[2], z[0], -y[0], z[2]),
        product(y[0], z[1], -y[1], z[0]),
    ];
    let (x, y, z) = (stored(simd, x), stored(simd, y), stored(simd, z));
    (Frame { x, y, z, p }, sizes)
}

/// From the wrist's axes to the world's: the sines and cosines of axis 1, the same for the world's y, of axes 2 and 3
/// together, and the same for the world's z.
struct Columns<S: Simd> {
    sines: [Lanes<S>; 4],
    cosines: [Lanes<S>; 4],
}

impl<S: Simd> Columns<S> {
    #[inline(always)]
    fn of(&self, [u, v, w]: [Lanes<S>; 3]) -> [Lanes<S>; 3] {
        let ([sin, sin_y, elbow_sin, sin_z], [cos, cos_y, elbow_cos, cos_z]) =
            (self.sines, self.cosines);
        let along = product(elbow_cos, u, -elbow_sin, w);
        [
            product(cos, along, -sin, v),
            product(sin_y, along, cos_y, v),
            product(sin_z, u, cos_z, w),
        ]
    }
}

/// The angle of a joint at a value of its variable.
#[inline(always)]
fn angle<S: Simd>(simd: S, value: S::f64s, (flip, offset): (f64, f64)) -> Lanes<S> {
    let value = simd.xor_f64s(value, simd.splat_f64s(flip));
    Lanes { simd, value } + Lanes::splat(simd, offset)
}

#[inline(always)]
fn size<S: Simd>(Lanes { simd, value }: Lanes<S>) -> Lanes<S> {
    let value = lanes::magnitude(simd, value);
    Lanes { simd, value }
}

/// `a b + c d`
#[inline(always)]
fn product<S: Simd>(a: Lanes<S>, b: Lanes<S>, c: Lanes<S>, d: Lanes<S>) -> Lanes<S> {
    a.mul_add(b, c * d)
}

/// Sine and cosine, both with the sign.
#[inline(always)]
fn signed<S: Simd>(Turn { sin, cos }: Turn<Lanes<S>>, sign: f64) -> [Lanes<S>; 2] {
    if sign < 0.0 { [-sin, -cos] } else { [sin, cos] }
}

#[inline(always)]
fn stored<S: Simd>(simd: S, [x, y, z]: [Lanes<S>; 3]) -> LaneColumn<S> {
    LaneColumn {
        simd,
        x: x.value,
        y: y.value,
        z: z.value,
    }
}
