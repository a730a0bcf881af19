//! Numbers that look like slips: a mass in another unit, a sphere larger than the bones around it.

use std::collections::{BTreeMap, BTreeSet};

use crate::components::{Base, ComponentId, Components};
use crate::contacts::Sphere;
use crate::fault::{MassSlip, NeedsAnswer};
use crate::mass::MassRequest;
use crate::model::Model;
use crate::wording::Input;

/// How near to a factor between units a ratio of masses counts as that factor.
const NEAR: f64 = 0.15;
/// Pounds in a kilogram.
const POUNDS: f64 = 2.2046;
/// Lighter than any animal that contacts are made for, kg: 1 mg.
const LIGHTEST_KG: f64 = 1e-6;
/// Heavier than any: 200 t, kg.
const HEAVIEST_KG: f64 = 200e3;

/// Whether `kg`, which the caller said as `input`, looks like a slip for a model whose bodies weigh `bodies_kg` together.
#[must_use]
pub fn mass_slip(input: Input, kg: f64, bodies_kg: Option<f64>) -> Option<NeedsAnswer> {
    let near = |factor: f64| bodies_kg.is_some_and(|bodies| (kg / bodies / factor - 1.0).abs() <= NEAR);
    let slip = match () {
        () if near(1000.0) => MassSlip::Grams,
        () if near(1.0 / 1000.0) => MassSlip::Tonnes,
        () if near(POUNDS) => MassSlip::Pounds,
        () if near(1.0 / POUNDS) => MassSlip::BodiesInPounds,
        () if !(LIGHTEST_KG..=HEAVIEST_KG).contains(&kg) => MassSlip::NoAnimal,
        () => return None,
    };
    Some(NeedsAnswer::Mass { input, kg, bodies_kg, slip })
}

impl MassRequest {
    /// The sum of the bodies, whatever the caller says that the model weighs; `None` where it is not known.
    #[must_use]
    pub fn bodies_kg(&self, model: &Model) -> Option<f64> {
        let bodies = Self { model_kg: None, ..self.clone() };
        bodies.of_model(model).ok().map(|mass| mass.kg)
    }

    /// The first of the masses said that looks like a slip for this model.
    #[must_use]
    pub fn slip(&self, model: &Model) -> Option<NeedsAnswer> {
        let said = [
            (Input::TargetMass, self.target_mass_kg),
            (Input::ContactsMass, self.contacts_kg),
            (Input::Mass, self.model_kg),
        ];
        if said.iter().all(|(_, kg)| kg.is_none()) {
            return None;
        }
        let bodies_kg = self.bodies_kg(model);
        said.into_iter().find_map(|(input, kg)| mass_slip(input, kg?, bodies_kg))
    }
}

/// Joints on each body, in its frame, m; and the bodies that each is joined to.
#[derive(Default)]
struct Joints {
    places: BTreeMap<ComponentId, Vec<[f64; 3]>>,
    neighbours: BTreeMap<ComponentId, BTreeSet<ComponentId>>,
}

impl Joints {
    fn of(components: &Components) -> Self {
        let mut joints = Self::default();
        for (joint, _) in components.tree.iter().filter(|(id, _)| components.tag(*id).ends_with("Joint")) {
            let ends = components.joint_ends(joint);
            for (body, place) in ends.iter().flatten() {
                joints.places.entry(*body).or_default().push(*place);
            }
            if let [Some((parent, _)), Some((child, _))] = ends {
                joints.neighbours.entry(parent).or_default().insert(child);
                joints.neighbours.entry(child).or_default().insert(parent);
            }
        }
        joints
    }

    /// The longest distance between two joints of one body, of all of `bodies`; `None` where no body has two that are apart.
    fn longest_m<'b>(&self, bodies: impl Iterator<Item = &'b ComponentId>) -> Option<f64> {
        let places = bodies.filter_map(|body| self.places.get(body));
        let pairs =
            places.flat_map(|places| places.iter().flat_map(move |a| places.iter().map(move |b| (a, b))));
        let apart = pairs.map(|(a, b)| a.iter().zip(b).map(|(a, b)| (a - b).powi(2)).sum::<f64>().sqrt());
        apart.filter(|metres| metres.is_finite() && *metres > 0.0).reduce(f64::max)
    }
}

impl Components {
    /// Parent and child body of a joint, each with the joint's place in its frame; `None` for ground and for what leads nowhere.
    fn joint_ends(&self, joint: ComponentId) -> [Option<(ComponentId, [f64; 3])>; 2] {
        let owner = self.tree.get(joint).and_then(|object| object.parent);
        let inside = owner.filter(|&id| self.tag(id) == "Body");
        let frame = |end: &str| {
            let (socket, legacy) = (format!("{end}_frame"), format!("{end}_body"));
            let named =
                self.connectee(joint, &socket, &[&legacy]).or_else(|| self.connectee(joint, &legacy, &[]));
            named.and_then(|named| self.frame(joint, &named)?.component)
        };
        // Documents of version 3 have the places in the joint, later ones in frames.
        let own = |tag| self.doc(joint).triple(self.element(joint), tag).unwrap_or([0.0; 3]);
        let end = |frame: Option<ComponentId>, tag| {
            let place = self.in_body(frame, own(tag))?;
            match self.base(frame).ok()? {
                Base::Body(body) => Some((body, place)),
                Base::Ground | Base::Unknown => None,
            }
        };
        [end(frame("parent"), "location_in_parent"), end(frame("child").or(inside), "location")]
    }
}

impl Model {
    /// The longest distance between two joints of one body: of the body that carries `sphere` and of those that it is joined
    /// to; where none of them has two joints that are apart, of all bodies. `None` where no body has.
    #[must_use]
    pub fn longest_joint_distance_m(&self, sphere: &Sphere) -> Option<f64> {
        let Base::Body(body) = sphere.base else { return None };
        let joints = Joints::of(self.components());
        let near = joints.neighbours.get(&body).into_iter().flatten().chain([&body]);
        joints.longest_m(near).or_else(|| joints.longest_m(joints.places.keys()))
    }

    /// Whether `sphere` would be larger than the bones around it with this radius. `said` where the caller said it as a length,
    /// which may be in another unit.
    #[must_use]
    pub fn radius_slip(&self, sphere: &Sphere, radius_m: f64, said: bool) -> Option<NeedsAnswer> {
        let longest_m = self.longest_joint_distance_m(sphere)?;
        let said_for = said.then_some(sphere.radius.number);
        let sphere = sphere.name.clone();
        (radius_m > longest_m).then_some(NeedsAnswer::Radius { sphere, radius_m, longest_m, said_for })
    }
}
