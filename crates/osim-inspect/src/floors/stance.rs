//! Which spheres a body stands on, and in which direction the body is from them.

use foldhash::{HashMap, HashMapExt};
use osim_model::feet::{ContactPlane, DefaultPose, Movements, dot};
use osim_model::{Model, Side, Sphere, SphereId};

/// Spheres below this share of the height of their body's tree, from its lowest origin, are under its feet: those of hands that
/// lean on a wall are above.
const FOOT_HEIGHT: f64 = 0.25;

/// What stands on planes.
pub(super) struct Stance<'m> {
    pub(super) model: &'m Model,
    pub(super) pose: &'m DefaultPose,
    pub(super) movements: Movements,
    /// The trees by the body on top.
    trees: HashMap<String, Tree>,
}

/// The bodies of one tree, as far as they are known.
#[derive(Default)]
struct Tree {
    /// How many bodies it has.
    count: usize,
    /// Mass (kg) and origin (m, in ground) of each.
    bodies: Vec<(f64, [f64; 3])>,
    /// The lowest and the highest of these origins along up, m.
    heights_m: Option<[f64; 2]>,
}

impl<'m> Stance<'m> {
    pub(super) fn of(model: &'m Model, pose: &'m DefaultPose) -> Self {
        let movements = Movements::of(model);
        let mut trees: HashMap<String, Tree> = HashMap::new();
        for body in model.bodies() {
            let tree = trees.entry(movements.top(&body.name).to_owned()).or_default();
            tree.count += 1;
            if let (Ok(placed), Ok(mass_kg)) = (pose.placement(&body.name), body.mass_kg()) {
                tree.add(mass_kg, placed.translation_m, model.up());
            }
        }
        Self { model, pose, movements, trees }
    }

    /// Whether the body hangs together with others.
    fn has_others(&self, body: &str) -> bool {
        self.tree(body).is_some_and(|tree| tree.count > 1)
    }

    /// The spheres of limbs among those of `plane`: they move in ground, and their bodies have a side or hang together with others.
    /// A ball does not.
    pub(super) fn limb_spheres(&self, plane: &ContactPlane) -> Vec<SphereId> {
        let is_limb = |sphere: &Sphere, body: &str| {
            let has_side = Side::of_name(body).or_else(|| Side::of_name(&sphere.name)).is_some();
            self.movements.moves(body) && (has_side || self.has_others(body))
        };
        let of_limb = |id: &SphereId| {
            let Some(sphere) = self.model.sphere(*id) else { return false };
            sphere.body.as_deref().is_some_and(|body| is_limb(sphere, body))
        };
        plane.spheres.iter().copied().filter(of_limb).collect()
    }

    /// The body on top of the tree that carries the sphere.
    pub(super) fn top_of(&self, sphere: SphereId) -> Option<&str> {
        Some(self.movements.top(self.body_of(sphere)?))
    }

    /// Whether the sphere is under a foot of its tree at the default pose.
    pub(super) fn is_low(&self, sphere: SphereId) -> bool {
        let own = self.centre(sphere).map(|centre| dot(centre, self.model.up()));
        let heights = self.body_of(sphere).and_then(|body| self.tree(body)?.heights_m);
        own.zip(heights).is_some_and(|(own, [low, high])| own <= low + FOOT_HEIGHT * (high - low))
    }

    /// From the `spheres` to the middle of the mass above them, in ground, at the default pose; `None` where it is not known.
    pub(super) fn towards_body(&self, spheres: &[SphereId]) -> Option<[f64; 3]> {
        let tree = self.tree(self.body_of(*spheres.first()?)?)?;
        let centres = spheres.iter().filter_map(|&sphere| Some((1.0, self.centre(sphere)?)));
        let (body, below) = (middle(tree.bodies.iter().copied())?, middle(centres)?);
        Some(std::array::from_fn(|i| body[i] - below[i]))
    }

    /// The tree that `body` is in.
    fn tree(&self, body: &str) -> Option<&Tree> {
        self.trees.get(self.movements.top(body))
    }

    fn body_of(&self, sphere: SphereId) -> Option<&str> {
        self.model.sphere(sphere)?.body.as_deref()
    }

    fn centre(&self, sphere: SphereId) -> Option<[f64; 3]> {
        let body = self.body_of(sphere)?;
        Some(self.pose.placement(body).ok()?.point(self.model.centre_m(sphere)?))
    }
}

impl Tree {
    fn add(&mut self, mass_kg: f64, origin_m: [f64; 3], up: [f64; 3]) {
        let height_m = dot(origin_m, up);
        let [low, high] = self.heights_m.unwrap_or([height_m; 2]);
        self.heights_m = Some([low.min(height_m), high.max(height_m)]);
        self.bodies.push((mass_kg, origin_m));
    }
}

/// The mean of points by their weights; `None` without any weight.
fn middle(points: impl Iterator<Item = (f64, [f64; 3])>) -> Option<[f64; 3]> {
    let (weight, sum) = points.fold((0.0, [0.0; 3]), |(weight, sum), (own, point)| {
        (weight + own, std::array::from_fn(|i| sum[i] + own * point[i]))
    });
    (weight > 0.0).then(|| sum.map(|value: f64| value / weight))
}
