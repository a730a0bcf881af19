//! Whether a floor is a floor: how it is turned against gravity, and what it hangs on.

use foldhash::{HashMap, HashMapExt, HashSet};
use osim_model::feet::{ContactPlane, DefaultPose, Movements, STEEPEST_FLOOR_RAD};
use osim_model::{DVec3, ForceId, Model, Orientation, Side, Sphere, SphereId};

// Each plane that spheres press on, judged.

#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) enum PlaneKind {
    /// A level floor, or a plane that is meant to be none, such as the net of a goal; or nothing is known.
    Fine,
    /// A slope of so many degrees.
    Slope(f64),
    /// A floor that leans by so many degrees, more than anything stands on.
    Steep(f64),
    /// A floor; gravity points so many degrees away from straight into it.
    GravityAside(f64),
    /// A floor that hangs on the limbs that press on it.
    OnLimb,
}

#[derive(Debug)]
pub(crate) struct JudgedPlane {
    pub(crate) plane: ContactPlane,
    pub(crate) kind: PlaneKind,
}

/// All planes on which the forces of a model that apply press moving spheres.
#[derive(Debug)]
pub(crate) struct Floors(Vec<JudgedPlane>);

impl Floors {
    pub(crate) fn of(model: &Model) -> Self {
        let pose = DefaultPose::of(model);
        let planes = ContactPlane::all(model, &model.force_ids(), &pose);
        if planes.is_empty() {
            return Self(Vec::new());
        }
        let judge = Judge::new(Stance::of(model, &pose), &planes);
        let kinds: Vec<PlaneKind> = planes.iter().map(|plane| judge.kind(plane)).collect();
        let judged = planes.into_iter().zip(kinds);
        Self(judged.map(|(plane, kind)| JudgedPlane { plane, kind }).collect())
    }

    /// Whether there is any plane that moving spheres press on.
    pub(crate) fn are_any(&self) -> bool {
        !self.0.is_empty()
    }

    pub(crate) fn iter(&self) -> impl Iterator<Item = &JudgedPlane> {
        self.0.iter()
    }
}

/// The cosine of 45 degrees: directions that are nearer than that to each other are about the same.
const NEAR: f64 = std::f64::consts::FRAC_1_SQRT_2;

struct Judge<'m> {
    stance: Stance<'m>,
    /// Spheres with a floor that they can stand on, or with one that nothing is known about.
    with_floor: HashSet<SphereId>,
    /// The trees of bodies that have such spheres.
    trees_with_floor: HashSet<String>,
    /// Whether a limb presses on any plane.
    has_limbs: bool,
}

impl<'m> Judge<'m> {
    fn new(stance: Stance<'m>, planes: &[ContactPlane]) -> Self {
        let is_floor = |plane: &&ContactPlane| !matches!(Lie::of(stance.model, plane), Some(Lie::Steep(_)));
        let floors = planes.iter().filter(is_floor).filter(|plane| hung_on(&stance, plane).is_empty());
        let with_floor: HashSet<SphereId> = floors.flat_map(|plane| plane.spheres.iter().copied()).collect();
        let trees =
            with_floor.iter().filter_map(|&sphere| stance.top_of(sphere).map(str::to_owned)).collect();
        let has_limbs = planes.iter().any(|plane| !stance.limb_spheres(plane).is_empty());
        Self { with_floor, trees_with_floor: trees, has_limbs, stance }
    }

    fn kind(&self, plane: &ContactPlane) -> PlaneKind {
        if !self.without_floor(hung_on(&self.stance, plane)).is_empty() {
            return PlaneKind::OnLimb;
        }
        match Lie::of(self.stance.model, plane) {
            None | Some(Lie::Level) => PlaneKind::Fine,
            Some(Lie::Slope(degrees)) => PlaneKind::Slope(degrees),
            Some(Lie::Steep(degrees)) => self.steep(plane, degrees),
        }
    }

    fn without_floor(&self, mut spheres: Vec<SphereId>) -> Vec<SphereId> {
        spheres.retain(|sphere| !self.with_floor.contains(sphere));
        spheres
    }

    /// A wall is not a floor: nothing stands on it. Hands lean on one while the feet of the same body have their floor, and a ball meets
    /// a net while something else has one.
    fn steep(&self, plane: &ContactPlane, degrees: f64) -> PlaneKind {
        let standing = self.standing_on(plane);
        if standing.is_empty() {
            PlaneKind::Fine
        } else if self.is_gravity_to_blame(plane, &standing) {
            PlaneKind::GravityAside(degrees)
        } else {
            PlaneKind::Steep(degrees)
        }
    }

    /// The spheres of `plane` that have no other floor and should have one; all where the model has no limbs, and nothing has a floor.
    fn standing_on(&self, plane: &ContactPlane) -> Vec<SphereId> {
        if self.with_floor.is_empty() && !self.has_limbs {
            return plane.spheres.clone();
        }
        let mut standing = self.without_floor(self.stance.limb_spheres(plane));
        standing.retain(|&sphere| {
            let top = self.stance.top_of(sphere);
            !top.is_some_and(|top| self.trees_with_floor.contains(top)) || self.stance.is_low(sphere)
        });
        standing
    }

    /// Whether the body is where the floor's normal points, seen from its spheres, and not where gravity has up. Where it is at
    /// neither, as in a kicker whose foot is far back, whether the floor faces y, which is up in nearly all models.
    fn is_gravity_to_blame(&self, plane: &ContactPlane, spheres: &[SphereId]) -> bool {
        let Some(surface) = plane.surface else { return false };
        let body = self.stance.towards_body(spheres).unwrap_or_default();
        let near = |direction| body.dot(direction) > NEAR * body.length();
        match (near(surface.normal), near(self.stance.model.up())) {
            (true, false) => true,
            (false, true) => false,
            _ => surface.normal.y > NEAR,
        }
    }
}

/// The spheres of `plane` that hang on the same limbs as the body that carries it, and cannot be lifted from it: between both,
/// joints turn, and none slides. Spheres that do not move in ground are terrain, such as those on a platform.
fn hung_on(stance: &Stance<'_>, plane: &ContactPlane) -> Vec<SphereId> {
    let Some(carrier) = plane.body.as_deref().filter(|body| stance.movements.can_move(body)) else {
        return Vec::new();
    };
    let is_hung = |id: &SphereId| {
        let body = stance.model.sphere(*id).and_then(|sphere| sphere.body.as_deref());
        let moving = body.filter(|body| stance.movements.can_move(body));
        let freedom = moving.and_then(|body| stance.movements.between(carrier, body));
        freedom.is_some_and(|freedom| freedom.turns && !freedom.slides)
    };
    plane.spheres.iter().copied().filter(is_hung).collect()
}

// Slopes: how steep a floor may be, and which part of the weight presses spheres on it.

/// A floor that leans by no more than this, degrees, is level: 180 of 204 planes under spheres in published models are.
const LEVEL_DEGREES: f64 = 1.0;

/// How a plane lies in the field of gravity.
#[derive(Debug, Clone, Copy, PartialEq)]
enum Lie {
    /// Level, within a degree.
    Level,
    /// A slope of so many degrees.
    Slope(f64),
    /// Something stands or rolls on it by no means: it leans by so many degrees.
    Steep(f64),
}

impl Lie {
    /// That of `plane`; `None` where it is not known: a number cannot be read or is in another unit, or up is not known.
    pub(crate) fn of(model: &Model, plane: &ContactPlane) -> Option<Self> {
        let known = model.gravity().is_some_and(|size| size > 0.0 && size.is_finite());
        let in_degrees = plane.orientations.iter().any(Orientation::is_in_degrees);
        let surface = plane.surface.filter(|_| known && !in_degrees)?;
        Some(match surface.tilt_rad.to_degrees() {
            degrees if degrees <= LEVEL_DEGREES => Self::Level,
            degrees if surface.tilt_rad <= STEEPEST_FLOOR_RAD => Self::Slope(degrees),
            degrees => Self::Steep(degrees),
        })
    }
}

/// The part of the weight that presses the spheres of `forces` on their floor: the cosine of the angle of a slope, else 1. Where
/// they press on several floors, that of the least steep. On a plane that is not a floor nothing presses; once it is turned as it
/// should be, all of the weight does.
pub fn weight_share(model: &Model, forces: &[ForceId]) -> f64 {
    weight_share_at(model, forces, &DefaultPose::of(model))
}

/// The share where the default pose is known.
pub(crate) fn weight_share_at(model: &Model, forces: &[ForceId], pose: &DefaultPose) -> f64 {
    let share = |plane: &ContactPlane| match Lie::of(model, plane) {
        Some(Lie::Slope(degrees)) => degrees.to_radians().cos(),
        _ => 1.0,
    };
    ContactPlane::all(model, forces, pose).iter().map(share).reduce(f64::max).unwrap_or(1.0)
}

// Which spheres a body stands on, and in which direction the body is from them.

/// Spheres below this share of the height of their body's tree, from its lowest origin, are under its feet: those of hands that
/// lean on a wall are above.
const FOOT_HEIGHT: f64 = 0.25;

struct Stance<'m> {
    model: &'m Model,
    pose: &'m DefaultPose,
    movements: Movements,
    /// The trees by the body on top.
    trees: HashMap<String, Tree>,
}

/// The bodies of one tree, as far as they are known.
#[derive(Default)]
struct Tree {
    count: usize,
    /// Mass (kg) and origin (m, in ground) of each.
    bodies: Vec<(f64, DVec3)>,
    /// The lowest and the highest of these origins along up, m.
    heights_m: Option<[f64; 2]>,
}

impl<'m> Stance<'m> {
    fn of(model: &'m Model, pose: &'m DefaultPose) -> Self {
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
    fn limb_spheres(&self, plane: &ContactPlane) -> Vec<SphereId> {
        let is_limb = |sphere: &Sphere, body: &str| {
            let has_side = Side::of_name(body).or_else(|| Side::of_name(&sphere.name)).is_some();
            self.movements.can_move(body) && (has_side || self.has_others(body))
        };
        let of_limb = |id: &SphereId| {
            let Some(sphere) = self.model.sphere(*id) else { return false };
            sphere.body.as_deref().is_some_and(|body| is_limb(sphere, body))
        };
        plane.spheres.iter().copied().filter(of_limb).collect()
    }

    /// The body on top of the tree that carries the sphere.
    fn top_of(&self, sphere: SphereId) -> Option<&str> {
        Some(self.movements.top(self.body_of(sphere)?))
    }

    /// Whether the sphere is under a foot of its tree at the default pose.
    fn is_low(&self, sphere: SphereId) -> bool {
        let own = self.centre(sphere).map(|centre| centre.dot(self.model.up()));
        let heights = self.body_of(sphere).and_then(|body| self.tree(body)?.heights_m);
        own.zip(heights).is_some_and(|(own, [low, high])| own <= low + FOOT_HEIGHT * (high - low))
    }

    /// From the `spheres` to the middle of the mass above them, in ground, at the default pose; `None` where it is not known.
    fn towards_body(&self, spheres: &[SphereId]) -> Option<DVec3> {
        let tree = self.tree(self.body_of(*spheres.first()?)?)?;
        let centres = spheres.iter().filter_map(|&sphere| Some((1.0, self.centre(sphere)?)));
        Some(middle(tree.bodies.iter().copied())? - middle(centres)?)
    }

    fn tree(&self, body: &str) -> Option<&Tree> {
        self.trees.get(self.movements.top(body))
    }

    fn body_of(&self, sphere: SphereId) -> Option<&str> {
        self.model.sphere(sphere)?.body.as_deref()
    }

    fn centre(&self, sphere: SphereId) -> Option<DVec3> {
        let body = self.body_of(sphere)?;
        Some(self.pose.placement(body).ok()?.point(self.model.centre_m(sphere)?))
    }
}

impl Tree {
    fn add(&mut self, mass_kg: f64, origin_m: DVec3, up: DVec3) {
        let height_m = origin_m.dot(up);
        let [low, high] = self.heights_m.unwrap_or([height_m; 2]);
        self.heights_m = Some([low.min(height_m), high.max(height_m)]);
        self.bodies.push((mass_kg, origin_m));
    }
}

/// The mean of points by their weights; `None` without any weight.
fn middle(points: impl Iterator<Item = (f64, DVec3)>) -> Option<DVec3> {
    let start = (0.0, DVec3::ZERO);
    let (weight, sum) = points.fold(start, |(weight, sum), (own, point)| (weight + own, sum + own * point));
    (weight > 0.0).then(|| sum / weight)
}
