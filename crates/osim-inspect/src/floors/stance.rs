//! Which spheres a body stands on, and in which direction the body is from them.

use std::collections::HashSet;

use osim_feet::{ContactPlane, DefaultPose, Movements, dot};
use osim_model::{Model, Side, Sphere, SphereId};

/// Spheres below this share of the height of their body's tree, from its lowest origin, are under its feet: those of hands that
/// lean on a wall are above.
const FOOT_HEIGHT: f64 = 0.25;

/// What stands on planes.
pub(super) struct Stance<'m> {
    pub(super) model: &'m Model,
    pub(super) pose: &'m DefaultPose,
    pub(super) movements: Movements,
    /// The bodies on top of their trees that carry other bodies.
    with_others: HashSet<String>,
}

impl<'m> Stance<'m> {
    pub(super) fn of(model: &'m Model, pose: &'m DefaultPose) -> Self {
        let movements = Movements::of(model);
        let names = model.bodies().iter().map(|body| body.name.as_str());
        let with_others = names.filter(|body| movements.top(body) != *body);
        let with_others = with_others.map(|body| movements.top(body).to_owned()).collect();
        Self { model, pose, movements, with_others }
    }

    /// The spheres of limbs among those of `plane`: they move in ground, and their bodies have a side or hang together with others.
    /// A ball does not.
    pub(super) fn limb_spheres(&self, plane: &ContactPlane) -> Vec<SphereId> {
        let is_limb = |sphere: &Sphere, body: &str| {
            let has_side = Side::of_name(body).or_else(|| Side::of_name(&sphere.name)).is_some();
            self.movements.moves(body) && (has_side || self.with_others.contains(self.movements.top(body)))
        };
        let of_limb = |id: &SphereId| {
            let Some(sphere) = self.model.sphere(*id) else { return false };
            sphere.body.as_deref().is_some_and(|body| is_limb(sphere, body))
        };
        plane.spheres.iter().copied().filter(of_limb).collect()
    }

    /// The body on top of the tree that carries the sphere.
    pub(super) fn top_of(&self, sphere: SphereId) -> Option<&str> {
        let body = self.model.sphere(sphere)?.body.as_deref()?;
        Some(self.movements.top(body))
    }

    /// Whether the sphere is under a foot of its tree at the default pose.
    pub(super) fn is_low(&self, sphere: SphereId) -> bool {
        let height = |point: [f64; 3]| dot(point, self.model.up());
        let own = self.centre(sphere).map(height);
        let Some((top, own)) = self.top_of(sphere).zip(own) else { return false };
        let heights = self.tree(top).map(|(_, origin)| height(origin));
        let (low, high) =
            heights.fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), at| (low.min(at), high.max(at)));
        own <= low + FOOT_HEIGHT * (high - low)
    }

    /// From the `spheres` to the middle of the mass above them, in ground, at the default pose; `None` where it is not known.
    pub(super) fn towards_body(&self, spheres: &[SphereId]) -> Option<[f64; 3]> {
        let top = self.top_of(*spheres.first()?)?;
        let centres = spheres.iter().filter_map(|&sphere| Some((1.0, self.centre(sphere)?)));
        let (body, below) = (middle(self.tree(top))?, middle(centres)?);
        Some(std::array::from_fn(|i| body[i] - below[i]))
    }

    /// Mass (kg) and origin (m, in ground) of each body below `top`, with it, as far as they are known.
    fn tree(&self, top: &str) -> impl Iterator<Item = (f64, [f64; 3])> {
        let own = self.model.bodies().iter().filter(move |body| self.movements.top(&body.name) == top);
        own.filter_map(|body| {
            let origin = self.pose.placement(&body.name).ok()?.translation_m;
            Some((body.mass_kg().ok()?, origin))
        })
    }

    fn centre(&self, sphere: SphereId) -> Option<[f64; 3]> {
        let body = self.model.sphere(sphere)?.body.as_deref()?;
        Some(self.pose.placement(body).ok()?.point(self.model.centre_m(sphere)?))
    }
}

/// The mean of points by their weights; `None` without any weight.
fn middle(points: impl Iterator<Item = (f64, [f64; 3])>) -> Option<[f64; 3]> {
    let (weight, sum) = points.fold((0.0, [0.0; 3]), |(weight, sum), (own, point)| {
        (weight + own, std::array::from_fn(|i| sum[i] + own * point[i]))
    });
    (weight > 0.0).then(|| sum.map(|value: f64| value / weight))
}
