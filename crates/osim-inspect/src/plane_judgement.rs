//! Judges the floors that spheres press on: how each plane is turned against gravity, which body carries it, and which part of the weight
//! presses on it.

use foldhash::{HashMap, HashMapExt, HashSet};
use osim_model::feet::{ContactPlane, DefaultPose, Movements, STEEPEST_FLOOR_RAD};
use osim_model::{DVec3, ForceId, Model, Orientation, Side, Sphere, SphereId};

/// What is wrong with a plane under spheres, such as a slope, or that nothing is wrong.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) enum PlaneJudgement {
    /// Nothing is wrong: a level floor, a plane that need not be a floor, such as the net of a goal, or a plane whose tilt is not known.
    Fine,
    /// A floor that slopes against level ground by this angle, degrees.
    Slope(f64),
    /// A floor that leans by this angle, degrees: too steep to stand on.
    Steep(f64),
    /// A floor that is right, under a gravity that is wrong. The angle between gravity and straight into the floor, degrees.
    GravityMisaligned(f64),
    /// A floor on a body of the same limbs that press on it.
    OnLimb,
}

/// A plane that moving spheres press on, and what is wrong with it.
pub(crate) struct JudgedPlane {
    pub(crate) plane: ContactPlane,
    pub(crate) kind: PlaneJudgement,
}

/// All planes that moving spheres press on by forces that are switched on, with the judgement of each.
pub(crate) struct Floors(Vec<JudgedPlane>);

impl Floors {
    /// Judges every plane that moving spheres of `model` press on.
    pub(crate) fn of(model: &Model) -> Self {
        let pose = DefaultPose::of(model);
        let planes = ContactPlane::all(model, &model.force_ids(), &pose);
        let judge = PlaneJudge::new(PosedTrees::of(model, &pose), &planes);
        let judged = |plane| JudgedPlane { kind: judge.judge_plane(&plane), plane };
        Self(planes.into_iter().map(judged).collect())
    }

    /// Whether there is any plane that moving spheres press on.
    pub(crate) fn are_any(&self) -> bool {
        !self.0.is_empty()
    }

    pub(crate) fn iter(&self) -> impl Iterator<Item = &JudgedPlane> {
        self.0.iter()
    }
}

/// Cosine of 45 degrees. Two directions whose angle has a larger cosine are taken for about the same.
const COS_45_DEGREES: f64 = std::f64::consts::FRAC_1_SQRT_2;

/// Judges the planes of a model by its joint trees at the default pose, and by which spheres have a floor.
struct PlaneJudge<'m> {
    trees: PosedTrees<'m>,
    /// Spheres that press on a floor which is not too steep to stand on, or on a plane whose tilt is not known.
    with_floor: HashSet<SphereId>,
    /// The top bodies of the joint trees that have spheres in `with_floor`.
    trees_with_floor: HashSet<String>,
    /// Whether a limb presses on any plane.
    has_limbs: bool,
}

impl<'m> PlaneJudge<'m> {
    /// Finds which spheres and joint trees have a floor among `planes`.
    fn new(trees: PosedTrees<'m>, planes: &[ContactPlane]) -> Self {
        let is_floor =
            |plane: &&ContactPlane| !matches!(PlaneTilt::of(trees.model, plane), Some(PlaneTilt::Steep(_)));
        let floors =
            planes.iter().filter(is_floor).filter(|plane| spheres_bound_to(&trees, plane).is_empty());
        let with_floor: HashSet<SphereId> = floors.flat_map(|plane| plane.spheres.iter().copied()).collect();
        let trees_with_floor =
            with_floor.iter().filter_map(|&sphere| trees.top_of(sphere).map(str::to_owned)).collect();
        let has_limbs = planes.iter().any(|plane| !trees.limb_spheres(plane).is_empty());
        Self { with_floor, trees_with_floor, has_limbs, trees }
    }

    /// What is wrong with `plane`.
    fn judge_plane(&self, plane: &ContactPlane) -> PlaneJudgement {
        if !self.spheres_without_floor(spheres_bound_to(&self.trees, plane)).is_empty() {
            return PlaneJudgement::OnLimb;
        }
        match PlaneTilt::of(self.trees.model, plane) {
            None | Some(PlaneTilt::Level) => PlaneJudgement::Fine,
            Some(PlaneTilt::Slope(degrees)) => PlaneJudgement::Slope(degrees),
            Some(PlaneTilt::Steep(degrees)) => self.judge_steep_plane(plane, degrees),
        }
    }

    /// The given `spheres` without those that press on a floor.
    fn spheres_without_floor(&self, mut spheres: Vec<SphereId>) -> Vec<SphereId> {
        spheres.retain(|sphere| !self.with_floor.contains(sphere));
        spheres
    }

    /// The kind of a steep plane. It is fine as a wall: hands lean on a wall while the feet of the same body have a floor, or a ball meets
    /// a net while other bodies have a floor.
    fn judge_steep_plane(&self, plane: &ContactPlane, degrees: f64) -> PlaneJudgement {
        let standing = self.spheres_standing_on(plane);
        if standing.is_empty() {
            PlaneJudgement::Fine
        } else if self.is_gravity_to_blame(plane, &standing) {
            PlaneJudgement::GravityMisaligned(degrees)
        } else {
            PlaneJudgement::Steep(degrees)
        }
    }

    /// The spheres of `plane` that have no other floor and need one; all its spheres if the model has no limbs and no sphere has a floor.
    fn spheres_standing_on(&self, plane: &ContactPlane) -> Vec<SphereId> {
        if self.with_floor.is_empty() && !self.has_limbs {
            return plane.spheres.clone();
        }
        let mut standing = self.spheres_without_floor(self.trees.limb_spheres(plane));
        standing.retain(|&sphere| {
            let top = self.trees.top_of(sphere);
            !top.is_some_and(|top| self.trees_with_floor.contains(top))
                || self.trees.is_at_foot_height(sphere)
        });
        standing
    }

    /// Whether gravity is turned wrongly, and not the floor: seen from the spheres, the body is in the direction of the floor's normal, and
    /// not opposite to gravity. If the body is in neither direction, as in a kicker whose foot is far back, a floor that faces y is right,
    /// because y is up in nearly all models.
    fn is_gravity_to_blame(&self, plane: &ContactPlane, spheres: &[SphereId]) -> bool {
        let Some(surface) = plane.surface else { return false };
        let body = self.trees.vector_to_centre_of_mass(spheres).unwrap_or_default();
        let is_towards = |direction| body.dot(direction) > COS_45_DEGREES * body.length();
        match (is_towards(surface.normal), is_towards(self.trees.model.up())) {
            (true, false) => true,
            (false, true) => false,
            _ => surface.normal.y > COS_45_DEGREES,
        }
    }
}

/// The spheres of `plane` that cannot be lifted from it, because all joints between them and the body that carries the plane turn, and
/// none slides. Spheres that do not move in ground, such as those on a platform, are not among them.
fn spheres_bound_to(trees: &PosedTrees<'_>, plane: &ContactPlane) -> Vec<SphereId> {
    let Some(carrier) = plane.body.as_deref().filter(|body| trees.movements.can_move(body)) else {
        return Vec::new();
    };
    let is_bound = |id: &SphereId| {
        let body = trees.model.sphere(*id).and_then(|sphere| sphere.body.as_deref());
        let moving = body.filter(|body| trees.movements.can_move(body));
        let freedom = moving.and_then(|body| trees.movements.between(carrier, body));
        freedom.is_some_and(|freedom| freedom.turns && !freedom.slides)
    };
    plane.spheres.iter().copied().filter(is_bound).collect()
}

// How steep a floor is, and which part of the weight presses spheres on it.

/// A floor that leans by no more than this, degrees, is level, as 180 of 204 planes under spheres in published models are.
const MOST_SLOPE_OF_LEVEL_DEGREES: f64 = 1.0;

/// The tilt of a plane against gravity.
#[derive(Debug, Clone, Copy, PartialEq)]
enum PlaneTilt {
    /// The plane is level, to within a degree.
    Level,
    /// The plane slopes by this angle against level ground, degrees.
    Slope(f64),
    /// The plane leans by this angle, degrees, so much that nothing stands on it.
    Steep(f64),
}

impl PlaneTilt {
    /// The tilt of `plane`. `None` if it is not known: a number cannot be read or is in degrees, or the model has no gravity.
    fn of(model: &Model, plane: &ContactPlane) -> Option<Self> {
        let is_up_known = model.gravity().is_some_and(|size| size > 0.0 && size.is_finite());
        let in_degrees = plane.orientations.iter().any(Orientation::is_in_degrees);
        let surface = plane.surface.filter(|_| is_up_known && !in_degrees)?;
        Some(match surface.tilt_rad.to_degrees() {
            degrees if degrees <= MOST_SLOPE_OF_LEVEL_DEGREES => Self::Level,
            degrees if surface.tilt_rad <= STEEPEST_FLOOR_RAD => Self::Slope(degrees),
            degrees => Self::Steep(degrees),
        })
    }
}

/// The part of the weight that presses the spheres of `forces` on their floor: the cosine of the angle of a slope, and 1 on level ground.
/// Of several floors, the least steep counts. A plane that is too steep counts as level, because it will be level once it is turned
/// correctly.
pub fn weight_share_on_floor(model: &Model, forces: &[ForceId]) -> f64 {
    weight_share_at_pose(model, forces, &DefaultPose::of(model))
}

/// [`weight_share_on_floor`] for a caller that has the default pose already.
pub(crate) fn weight_share_at_pose(model: &Model, forces: &[ForceId], pose: &DefaultPose) -> f64 {
    let share = |plane: &ContactPlane| match PlaneTilt::of(model, plane) {
        Some(PlaneTilt::Slope(degrees)) => degrees.to_radians().cos(),
        _ => 1.0,
    };
    ContactPlane::all(model, forces, pose).iter().map(share).reduce(f64::max).unwrap_or(1.0)
}

// Which spheres a body stands on, and in which direction the body is from them.

/// Spheres up to this part of the height of a joint tree, from its lowest origin, count as under its feet. The spheres of hands that lean
/// on a wall are higher.
const FOOT_HEIGHT_SHARE: f64 = 0.25;

/// The joint trees of a model at its default pose.
struct PosedTrees<'m> {
    model: &'m Model,
    pose: &'m DefaultPose,
    movements: Movements,
    /// Each tree, by the name of its top body.
    trees: HashMap<String, BodyTree>,
}

/// The bodies that joints connect to one top body.
#[derive(Default)]
struct BodyTree {
    count: usize,
    /// Mass (kg) and origin (m, in ground) of each body for which both are known.
    bodies: Vec<(f64, DVec3)>,
    /// The lowest and the highest of the origins in `bodies` along the direction up, m.
    heights_m: Option<[f64; 2]>,
}

impl<'m> PosedTrees<'m> {
    /// The joint trees of `model` at its default pose.
    fn of(model: &'m Model, pose: &'m DefaultPose) -> Self {
        let movements = Movements::of(model);
        let mut trees: HashMap<String, BodyTree> = HashMap::new();
        for body in model.bodies() {
            let tree = trees.entry(movements.top(&body.name).to_owned()).or_default();
            tree.count += 1;
            if let (Ok(placed), Ok(mass_kg)) = (pose.placement(&body.name), body.mass_kg()) {
                let height_m = placed.translation_m.dot(model.up());
                let [low, high] = tree.heights_m.unwrap_or([height_m; 2]);
                tree.heights_m = Some([low.min(height_m), high.max(height_m)]);
                tree.bodies.push((mass_kg, placed.translation_m));
            }
        }
        Self { model, pose, movements, trees }
    }

    /// The spheres of `plane` that belong to limbs: they move in ground, and their bodies have a side or are connected with other bodies.
    /// The sphere of a ball has neither.
    fn limb_spheres(&self, plane: &ContactPlane) -> Vec<SphereId> {
        let is_limb = |sphere: &Sphere, body: &str| {
            let has_side = Side::of_name(body).or_else(|| Side::of_name(&sphere.name)).is_some();
            self.movements.can_move(body)
                && (has_side || self.tree_of_body(body).is_some_and(|tree| tree.count > 1))
        };
        let is_on_limb = |id: &SphereId| {
            let Some(sphere) = self.model.sphere(*id) else { return false };
            sphere.body.as_deref().is_some_and(|body| is_limb(sphere, body))
        };
        plane.spheres.iter().copied().filter(is_on_limb).collect()
    }

    /// The name of the top body of the tree that carries the sphere.
    fn top_of(&self, sphere: SphereId) -> Option<&str> {
        Some(self.movements.top(self.body_of(sphere)?))
    }

    /// Whether the sphere is at the height of the feet of its tree at the default pose.
    fn is_at_foot_height(&self, sphere: SphereId) -> bool {
        let height = self.centre_of_sphere(sphere).map(|centre| centre.dot(self.model.up()));
        let heights = self.body_of(sphere).and_then(|body| self.tree_of_body(body)?.heights_m);
        height
            .zip(heights)
            .is_some_and(|(height, [low, high])| height <= low + FOOT_HEIGHT_SHARE * (high - low))
    }

    /// The vector from the middle of the `spheres` to the centre of mass of their tree, in ground, at the default pose, m.
    fn vector_to_centre_of_mass(&self, spheres: &[SphereId]) -> Option<DVec3> {
        let tree = self.tree_of_body(self.body_of(*spheres.first()?)?)?;
        let centres = spheres.iter().filter_map(|&sphere| Some((1.0, self.centre_of_sphere(sphere)?)));
        Some(weighted_mean(tree.bodies.iter().copied())? - weighted_mean(centres)?)
    }

    /// The joint tree to which `body` belongs.
    fn tree_of_body(&self, body: &str) -> Option<&BodyTree> {
        self.trees.get(self.movements.top(body))
    }

    /// The name of the body that carries the sphere.
    fn body_of(&self, sphere: SphereId) -> Option<&str> {
        self.model.sphere(sphere)?.body.as_deref()
    }

    /// The centre of the sphere in ground at the default pose, m.
    fn centre_of_sphere(&self, sphere: SphereId) -> Option<DVec3> {
        let body = self.body_of(sphere)?;
        Some(self.pose.placement(body).ok()?.point(self.model.centre_m(sphere)?))
    }
}

/// The mean of the points with their weights; `None` if the sum of the weights is not above 0.
fn weighted_mean(points: impl Iterator<Item = (f64, DVec3)>) -> Option<DVec3> {
    let start = (0.0, DVec3::ZERO);
    let (weight, sum) =
        points.fold(start, |(total, sum), (weight, point)| (total + weight, sum + weight * point));
    (weight > 0.0).then(|| sum / weight)
}
