//! Draws the body of a built-in arm: `cargo run -p pieper-scene --example preview -- ar3 ar3.png [joint values in degrees]`.

use std::error::Error;
use std::fs::File;

use nalgebra::{Isometry3, Point3, Vector3};
use pieper_scene::{Body, Frames};

const SIZE: usize = 640;

fn main() -> Result<(), Box<dyn Error>> {
    let arguments: Vec<String> = std::env::args().skip(1).collect();
    let [id, file, values @ ..] = &arguments[..] else {
        return Err("an arm and a file were expected, as in: preview ar3 ar3.png 0 -30 60".into());
    };
    let robot = pieper_robots::find(id)
        .ok_or("no such built-in arm")?
        .robot();
    let chain = robot.chain()?;
    let mut q = vec![0.0; chain.dof()];
    for ((q, value), variable) in q.iter_mut().zip(values).zip(chain.variables()) {
        let value: f64 = value.parse()?;
        *q = if variable.kind.is_angular() {
            value.to_radians()
        } else {
            value
        };
    }
    let body = Body::of_chain(&chain, &Vector3::z_axis());
    let mut poses = Vec::new();
    Frames::Axes.at(&chain, &q, &mut poses);
    let mut picture = vec![[238_u8, 240, 243]; SIZE * SIZE];
    draw(&body, &poses, &mut picture);
    let mut encoder = png::Encoder::new(File::create(file)?, SIZE as u32, SIZE as u32);
    encoder.set_color(png::ColorType::Rgb);
    encoder
        .write_header()?
        .write_image_data(picture.as_flattened())?;
    Ok(())
}

/// A z-buffer, lit from the viewer's upper left.
fn draw(body: &Body, poses: &[Isometry3<f64>], picture: &mut [[u8; 3]]) {
    let view = Isometry3::look_at_rh(
        &Point3::new(1.0, -1.5, 0.8),
        &Point3::origin(),
        &Vector3::z(),
    );
    let light = Vector3::new(-0.4, 0.7, 0.6).normalize();
    let mut corners = Vec::new();
    for (link, part) in body.shown() {
        let pose = view * poses[link] * part.placed;
        for t in 0..part.mesh.triangles() {
            let corner = |k: usize| {
                let index = part.mesh.indices[3 * t + k] as usize;
                let n = pose * Vector3::from(part.mesh.normals[index].map(f64::from));
                (pose * part.mesh.triangle(t)[k], n)
            };
            corners.push(([corner(0), corner(1), corner(2)], part.color));
        }
    }
    let all = || corners.iter().flat_map(|(t, _)| t.iter().map(|(p, _)| p));
    let low = all().fold(Point3::from([f64::INFINITY; 3]), |a, b| a.inf(b));
    let high = all().fold(Point3::from([f64::NEG_INFINITY; 3]), |a, b| a.sup(b));
    let scale = 0.9 * SIZE as f64 / (high - low).xy().max();
    let middle = nalgebra::center(&low, &high);
    let mut depth = vec![f64::NEG_INFINITY; SIZE * SIZE];
    for (t, color) in &corners {
        let at = t.map(|(p, _)| {
            (
                (p.x - middle.x) * scale + SIZE as f64 / 2.0,
                SIZE as f64 / 2.0 - (p.y - middle.y) * scale,
            )
        });
        let area =
            (at[1].0 - at[0].0) * (at[2].1 - at[0].1) - (at[2].0 - at[0].0) * (at[1].1 - at[0].1);
        let range = |f: fn(&(f64, f64)) -> f64| {
            let low = at.iter().map(f).fold(f64::INFINITY, f64::min).max(0.0) as usize;
            let high = at.iter().map(f).fold(0.0, f64::max) as usize + 1;
            low..high.min(SIZE)
        };
        for y in range(|p| p.1) {
            for x in range(|p| p.0) {
                let (px, py) = (x as f64 + 0.5, y as f64 + 0.5);
                let weight = |i: usize, j: usize| {
                    ((at[i].0 - px) * (at[j].1 - py) - (at[j].0 - px) * (at[i].1 - py)) / area
                };
                let w = [weight(1, 2), weight(2, 0), weight(0, 1)];
                if w.iter().any(|w| *w < 0.0 || w.is_nan()) {
                    continue;
                }
                let z: f64 = (0..3).map(|k| w[k] * t[k].0.z).sum();
                let place = y * SIZE + x;
                if z > depth[place] {
                    depth[place] = z;
                    let n: Vector3<f64> = (0..3)
                        .map(|k| t[k].1 * w[k])
                        .sum::<Vector3<f64>>()
                        .normalize();
                    let shade = 0.42 + 0.58 * n.dot(&light).max(0.0);
                    picture[place] =
                        std::array::from_fn(|k| (255.0 * f64::from(color[k]) * shade) as u8);
                }
            }
        }
    }
}
