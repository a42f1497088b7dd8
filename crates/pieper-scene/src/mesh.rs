//! Triangles with normals.

use std::collections::HashMap;

use nalgebra::{Point3, Vector3};

/// Triangles in metres, with a normal at each corner.
///
/// ```
/// use pieper_scene::{Mesh, shapes};
/// let ball = shapes::sphere(0.1);
/// assert_eq!(ball.indices.len() % 3, 0);
/// assert_eq!(Mesh::from_bytes(&ball.to_bytes()), Some(ball));
/// ```
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Mesh {
    /// Corners.
    pub positions: Vec<[f32; 3]>,
    /// One for each corner, of length 1.
    pub normals: Vec<[f32; 3]>,
    /// Three for each triangle, counter-clockwise seen from outside.
    pub indices: Vec<u32>,
}

/// The most triangles of one mesh: beyond, it is no arm's link and a viewer would stall.
pub const MOST_TRIANGLES: usize = 4_000_000;

const MAGIC: &[u8; 4] = b"PPM1";

impl Mesh {
    /// A mesh of loose triangles: equal corners are joined, and normals are smooth across edges that bend by less than
    /// `crease` (radians).
    ///
    /// Triangles with corners that are not finite, or without area, are left out.
    pub fn of_triangles(triangles: &[[[f64; 3]; 3]], crease: f64) -> Self {
        let normal = |t: &[[f64; 3]; 3]| {
            let [a, b, c] = t.map(Vector3::from);
            (b - a).cross(&(c - a))
        };
        let kept: Vec<(&[[f64; 3]; 3], Vector3<f64>)> = triangles
            .iter()
            .map(|t| (t, normal(t)))
            .filter(|(_, n)| n.norm_squared() > 0.0 && n.norm_squared().is_finite())
            .filter(|(t, _)| t.iter().flatten().all(|x| (*x as f32).is_finite()))
            .collect();
        // Faces around each place.
        let key = |p: &[f64; 3]| p.map(|x| (x as f32 + 0.0).to_bits());
        let mut around: HashMap<[u32; 3], Vec<usize>> = HashMap::new();
        for (face, (triangle, _)) in kept.iter().enumerate() {
            for corner in triangle.iter() {
                around.entry(key(corner)).or_default().push(face);
            }
        }
        let smooth = crease.cos();
        let mut mesh = Self::default();
        let mut known: HashMap<([u32; 3], [u32; 3]), u32> = HashMap::new();
        for (triangle, own) in &kept {
            let direction = own.normalize();
            for corner in triangle.iter() {
                let place = key(corner);
                let mut sum = Vector3::zeros();
                for &face in around.get(&place).map(Vec::as_slice).unwrap_or_default() {
                    let other = kept[face].1;
                    if other.normalize().dot(&direction) >= smooth {
                        sum += other;
                    }
                }
                let n = sum.try_normalize(0.0).unwrap_or(direction);
                let n = [n.x as f32, n.y as f32, n.z as f32];
                let next = mesh.positions.len() as u32;
                let index = *known
                    .entry((place, n.map(|x| (x + 0.0).to_bits())))
                    .or_insert(next);
                if index == next {
                    mesh.positions.push(corner.map(|x| x as f32));
                    mesh.normals.push(n);
                }
                mesh.indices.push(index);
            }
        }
        mesh
    }

    /// The number of triangles.
    pub fn triangles(&self) -> usize {
        self.indices.len() / 3
    }

    /// The corners of one triangle.
    pub fn triangle(&self, index: usize) -> [Point3<f64>; 3] {
        std::array::from_fn(|k| {
            let corner = self.positions[self.indices[3 * index + k] as usize];
            Point3::from(corner.map(f64::from))
        })
    }

    /// Adds another mesh, moved.
    pub fn append(&mut self, other: &Self, pose: &nalgebra::Isometry3<f64>) {
        let from = self.positions.len() as u32;
        for (position, normal) in other.positions.iter().zip(&other.normals) {
            let p = pose * Point3::from(position.map(f64::from));
            let n = pose * Vector3::from(normal.map(f64::from));
            self.positions.push([p.x as f32, p.y as f32, p.z as f32]);
            self.normals.push([n.x as f32, n.y as f32, n.z as f32]);
        }
        self.indices.extend(other.indices.iter().map(|i| i + from));
    }

    /// The box around it: lowest and highest corner; `None` if it is empty.
    pub fn bounds(&self) -> Option<[[f32; 3]; 2]> {
        let first = *self.positions.first()?;
        Some(
            self.positions
                .iter()
                .fold([first, first], |[low, high], p| {
                    [
                        std::array::from_fn(|k| low[k].min(p[k])),
                        std::array::from_fn(|k| high[k].max(p[k])),
                    ]
                }),
        )
    }

    /// `PPM1`, the numbers of corners and of indices (u32), positions and normals (f32), indices (u32), little endian.
    pub fn to_bytes(&self) -> Vec<u8> {
        let mut out = Vec::with_capacity(12 + 24 * self.positions.len() + 4 * self.indices.len());
        out.extend(MAGIC);
        out.extend((self.positions.len() as u32).to_le_bytes());
        out.extend((self.indices.len() as u32).to_le_bytes());
        for value in self.positions.iter().chain(&self.normals).flatten() {
            out.extend(value.to_le_bytes());
        }
        for index in &self.indices {
            out.extend(index.to_le_bytes());
        }
        out
    }

    /// Reads what [`Mesh::to_bytes`] writes; `None` for anything else.
    pub fn from_bytes(bytes: &[u8]) -> Option<Self> {
        let body = bytes.strip_prefix(MAGIC)?;
        let (words, rest) = body.as_chunks::<4>();
        let [corners, indices, data @ ..] = words else {
            return None;
        };
        let corners = u32::from_le_bytes(*corners) as usize;
        let indices = u32::from_le_bytes(*indices) as usize;
        if !rest.is_empty() || data.len() != corners.checked_mul(6)?.checked_add(indices)? {
            return None;
        }
        let (floats, indices) = data.split_at(6 * corners);
        let triples: Vec<[f32; 3]> = floats
            .as_chunks::<3>()
            .0
            .iter()
            .map(|t| t.map(f32::from_le_bytes))
            .collect();
        let (positions, normals) = triples.split_at(corners);
        let indices: Vec<u32> = indices.iter().map(|i| u32::from_le_bytes(*i)).collect();
        (indices.len().is_multiple_of(3) && indices.iter().all(|i| (*i as usize) < corners)).then(
            || Self {
                positions: positions.to_vec(),
                normals: normals.to_vec(),
                indices,
            },
        )
    }

    /// A name for the content: 32 hexadecimal digits, the same for the same mesh.
    pub fn hash(&self) -> String {
        blake3::hash(&self.to_bytes()).to_hex()[..32].to_owned()
    }
}
