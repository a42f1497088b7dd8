//! What a ray touches: triangles by Moeller and Trumbore (1997), found through a hierarchy of boxes.

use std::collections::HashMap;
use std::sync::Arc;

use nalgebra::{Isometry3, Point3, Vector3};

use crate::{Body, Mesh};

/// Where a ray meets a body.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Hit {
    /// Index of the link.
    pub link: usize,
    /// The place, in the world.
    pub point: Point3<f64>,
    /// The surface's normal there, towards the ray's origin.
    pub normal: Vector3<f64>,
    /// From the ray's origin, in lengths of its direction.
    pub distance: f64,
}

/// A body prepared for rays.
#[derive(Clone, Debug)]
pub struct Picker {
    parts: Vec<(usize, Isometry3<f64>, Arc<Boxes>)>,
}

impl Picker {
    /// Prepares the parts for looks. Meshes that occur several times are prepared once.
    pub fn new(body: &Body) -> Self {
        let mut known: HashMap<*const Mesh, Arc<Boxes>> = HashMap::new();
        let mut prepared = |mesh: &Arc<Mesh>| {
            let boxes = known.entry(Arc::as_ptr(mesh));
            Arc::clone(boxes.or_insert_with(|| Arc::new(Boxes::new(mesh))))
        };
        let parts = body
            .shown()
            .map(|(link, part)| (link, part.placed, prepared(&part.mesh)));
        Self {
            parts: parts.collect(),
        }
    }

    /// The first triangle that the ray from `origin` along `direction` meets, the links standing at `poses`.
    ///
    /// `None` if there is none, or if the ray has no direction.
    pub fn pick(
        &self,
        origin: &Point3<f64>,
        direction: &Vector3<f64>,
        poses: &[Isometry3<f64>],
    ) -> Option<Hit> {
        if !(direction.norm_squared() > 0.0 && direction.norm_squared().is_finite()) {
            return None;
        }
        let mut best: Option<Hit> = None;
        for (link, placed, boxes) in &self.parts {
            let pose = poses.get(*link)? * placed;
            let ray = Ray::new(
                pose.inverse_transform_point(origin),
                pose.inverse_transform_vector(direction),
            );
            let nearest = best.map_or(f64::INFINITY, |hit| hit.distance);
            if let Some((distance, normal)) = boxes.first(&ray, nearest) {
                let normal = pose * normal;
                let normal = if normal.dot(direction) > 0.0 {
                    -normal
                } else {
                    normal
                };
                best = Some(Hit {
                    link: *link,
                    point: origin + direction * distance,
                    normal,
                    distance,
                });
            }
        }
        best
    }
}

struct Ray {
    origin: Point3<f64>,
    direction: Vector3<f64>,
    inverse: Vector3<f64>,
}

impl Ray {
    fn new(origin: Point3<f64>, direction: Vector3<f64>) -> Self {
        Self {
            origin,
            direction,
            inverse: direction.map(|x| 1.0 / x),
        }
    }
}

/// Triangles in a binary tree of boxes, split in the middle of their centres' longest edge.
#[derive(Debug)]
struct Boxes {
    nodes: Vec<Node>,
    triangles: Vec<[Point3<f64>; 3]>,
}

#[derive(Debug)]
struct Node {
    low: Point3<f64>,
    high: Point3<f64>,
    /// A leaf's triangles, or the number of its second child (the first is the next node) and 0.
    from: usize,
    count: usize,
}

/// Triangles in a leaf, at most.
const LEAF: usize = 6;

impl Boxes {
    fn new(mesh: &Mesh) -> Self {
        let triangles = (0..mesh.triangles()).map(|t| mesh.triangle(t)).collect();
        let mut boxes = Self {
            nodes: Vec::new(),
            triangles,
        };
        let count = boxes.triangles.len();
        if count > 0 {
            boxes.split(0, count);
        }
        boxes
    }

    fn split(&mut self, from: usize, count: usize) {
        let slice = &mut self.triangles[from..from + count];
        let corners = || slice.iter().flatten();
        let low = corners().fold(Point3::from([f64::INFINITY; 3]), |a, b| a.inf(b));
        let high = corners().fold(Point3::from([f64::NEG_INFINITY; 3]), |a, b| a.sup(b));
        let index = self.nodes.len();
        self.nodes.push(Node {
            low,
            high,
            from,
            count,
        });
        if count <= LEAF {
            return;
        }
        let axis = (high - low).imax();
        let centre = |t: &[Point3<f64>; 3]| t[0][axis] + t[1][axis] + t[2][axis];
        let half = count / 2;
        slice.select_nth_unstable_by(half, |a, b| centre(a).total_cmp(&centre(b)));
        self.split(from, half);
        let second = self.nodes.len();
        self.split(from + half, count - half);
        (self.nodes[index].from, self.nodes[index].count) = (second, 0);
    }

    /// The first triangle nearer than `nearest`: how far, and its normal.
    fn first(&self, ray: &Ray, nearest: f64) -> Option<(f64, Vector3<f64>)> {
        let mut best = None;
        let mut nearest = nearest;
        let mut open = [0_usize; 64];
        let mut depth = usize::from(!self.nodes.is_empty());
        while depth > 0 {
            depth -= 1;
            let index = open[depth];
            let node = &self.nodes[index];
            if !node.is_met(ray, nearest) {
                continue;
            }
            if node.count == 0 {
                // Depth grows by halves of the count: 64 levels are never reached.
                for child in [node.from, index + 1] {
                    open[depth] = child;
                    depth += 1;
                }
                continue;
            }
            for triangle in &self.triangles[node.from..node.from + node.count] {
                if let Some((distance, normal)) = meet(ray, triangle).filter(|hit| hit.0 < nearest)
                {
                    nearest = distance;
                    best = Some((distance, normal));
                }
            }
        }
        best
    }
}

impl Node {
    fn is_met(&self, ray: &Ray, nearest: f64) -> bool {
        let a = (self.low - ray.origin).component_mul(&ray.inverse);
        let b = (self.high - ray.origin).component_mul(&ray.inverse);
        // f64's min and max drop the NaN of a ray along a face: the other two axes decide.
        let enter = a.x.min(b.x).max(a.y.min(b.y)).max(a.z.min(b.z));
        let leave = a.x.max(b.x).min(a.y.max(b.y)).min(a.z.max(b.z));
        leave >= enter.max(0.0) && enter < nearest
    }
}

/// Where a ray meets a triangle, from either side: how far, and the normal of length 1.
fn meet(ray: &Ray, [a, b, c]: &[Point3<f64>; 3]) -> Option<(f64, Vector3<f64>)> {
    let (u, v) = (b - a, c - a);
    let p = ray.direction.cross(&v);
    let determinant = u.dot(&p);
    if determinant == 0.0 {
        return None;
    }
    let s = ray.origin - a;
    let first = s.dot(&p) / determinant;
    let q = s.cross(&u);
    let second = ray.direction.dot(&q) / determinant;
    let distance = v.dot(&q) / determinant;
    let inside = first >= 0.0 && second >= 0.0 && first + second <= 1.0 && distance > 0.0;
    inside.then(|| (distance, u.cross(&v).normalize()))
}
