//! Each plane that spheres press on, judged.

use foldhash::HashSet;
use osim_model::feet::{ContactPlane, DefaultPose, dot};
use osim_model::{Model, SphereId};

use super::slope::Lie;
use super::stance::Stance;

/// What kind of plane it is.
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

/// A plane and what it is.
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
        let near = |direction| dot(body, direction) > NEAR * dot(body, body).sqrt();
        match (near(surface.normal), near(self.stance.model.up())) {
            (true, false) => true,
            (false, true) => false,
            _ => surface.normal[1] > NEAR,
        }
    }
}

/// The spheres of `plane` that hang on the same limbs as the body that carries it, and cannot be lifted from it: between both,
/// joints turn, and none slides. Spheres that do not move in ground are terrain, such as those on a platform.
fn hung_on(stance: &Stance<'_>, plane: &ContactPlane) -> Vec<SphereId> {
    let Some(carrier) = plane.body.as_deref().filter(|body| stance.movements.moves(body)) else {
        return Vec::new();
    };
    let is_hung = |id: &SphereId| {
        let body = stance.model.sphere(*id).and_then(|sphere| sphere.body.as_deref());
        let moving = body.filter(|body| stance.movements.moves(body));
        let freedom = moving.and_then(|body| stance.movements.between(carrier, body));
        freedom.is_some_and(|freedom| freedom.turns && !freedom.slides)
    };
    plane.spheres.iter().copied().filter(is_hung).collect()
}
