//! Projection onto a half-space without a ball: the set of `[G12]` example 9.1.

use super::{Projection, ProjectionError, distance};

/// `nᵀ x <= d` and `‖x - c‖ >= r`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct BesideBall {
    /// Unit normal out of the allowed side.
    pub normal: [f64; 3],
    /// Distance of the plane from the origin along the normal.
    pub offset: f64,
    /// Centre of the ball to keep out of.
    pub centre: [f64; 3],
    /// Its radius.
    pub radius: f64,
}

fn dot(a: &[f64; 3], b: &[f64; 3]) -> f64 {
    a.iter().zip(b).map(|(x, y)| x * y).sum()
}

fn along(a: &[f64; 3], s: f64, b: &[f64; 3]) -> [f64; 3] {
    std::array::from_fn(|i| a[i] + s * b[i])
}

impl BesideBall {
    /// The larger of `nᵀ x - d` and `r - ‖x - c‖`.
    #[must_use]
    pub fn violation(&self, x: &[f64; 3]) -> f64 {
        (dot(&self.normal, x) - self.offset).max(self.radius - distance(x, &self.centre))
    }

    /// The nearest point of the set, in closed form.
    ///
    /// A nearest point satisfies the conditions of Fritz John with one of four active sets: none, the plane, the sphere,
    /// both. For each the nearest point of the equality set is known (the foot on the plane, on the sphere, on their
    /// circle), so the nearest feasible of the four is the global optimum. From the centre of the sphere every direction
    /// is as good; there one is chosen.
    ///
    /// # Errors
    ///
    /// [`ProjectionError::NotFinite`].
    pub fn project(&self, p: &[f64; 3]) -> Result<Projection<3>, ProjectionError> {
        if !p.iter().all(|x| x.is_finite()) {
            return Err(ProjectionError::NotFinite);
        }
        let plane = along(p, self.offset - dot(&self.normal, p), &self.normal);
        let sphere = self.on_sphere(p, &self.centre, self.radius, None);
        let height = self.offset - dot(&self.normal, &self.centre);
        let circle = (height.abs() <= self.radius).then(|| {
            let middle = along(&self.centre, height, &self.normal);
            let radius = (self.radius * self.radius - height * height).max(0.0).sqrt();
            self.on_sphere(&plane, &middle, radius, Some(&self.normal))
        });
        // A foot lies on a boundary up to rounding of numbers as large as these.
        let size = 1.0 + self.radius + self.offset.abs() + dot(&self.centre, &self.centre).sqrt() + dot(p, p).sqrt();
        let mut best: Option<([f64; 3], f64)> = None;
        for x in [Some(*p), Some(plane), Some(sphere), circle].into_iter().flatten() {
            let length = distance(p, &x);
            if self.violation(&x) <= 4e-16 * size && best.is_none_or(|(_, shortest)| length < shortest) {
                best = Some((x, length));
            }
        }
        let (point, length) = best.ok_or(ProjectionError::Empty)?;
        Ok(Projection { point, distance: length, lower_bound: length, violation: self.violation(&point) })
    }

    /// Foot of `p` on the sphere about `middle`, or on its circle in the plane through `middle` across `axis`.
    fn on_sphere(&self, p: &[f64; 3], middle: &[f64; 3], radius: f64, axis: Option<&[f64; 3]>) -> [f64; 3] {
        let away = along(p, -1.0, middle);
        let length = dot(&away, &away).sqrt();
        if length > 0.0 {
            return along(middle, radius / length, &away);
        }
        let axis = axis.unwrap_or(&self.normal);
        let i = (0..3).min_by(|&i, &j| axis[i].abs().total_cmp(&axis[j].abs())).unwrap_or(0);
        let mut any = [0.0; 3];
        any[i] = 1.0;
        let any = along(&any, -dot(axis, &any), axis);
        along(middle, radius / dot(&any, &any).sqrt(), &any)
    }
}
