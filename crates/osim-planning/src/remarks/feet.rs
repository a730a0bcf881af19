//! Remarks about feet that get spheres: their parts, floors, planes and limbs, and sizes and masses that are probably a slip.

use std::collections::{BTreeSet, HashSet};

use osim_inspect::{KnownContacts, StandingBody};
use osim_model::feet::{Movements, Sole, angle};
use osim_model::messages::{Input, Phrase, four_significant, phrase, readable, shown};
use osim_model::{
    Anatomy, DVec3, Fault, Force, ForceId, JointDistances, Mass, Model, Needed, NeedsAnswer, Question,
    Selected, Side, probable_units, same_mass, without_side,
};
use osim_patch::{Deed, Plan, Rebuilt};
use osim_requests::BodyScale;
use osim_requests::options::CountOptions;

use crate::afterwards::standing_bodies;

/// What a user may not expect of feet with `soles`: one side alone, parts that get nothing, and feet that do not bend.
pub(crate) fn parts_of_feet(model: &Model, soles: &[Sole]) -> Vec<Phrase> {
    let feet = Feet { model, soles };
    [feet.one_side(), feet.left_out(), feet.rigid(), feet.one_piece()].into_iter().flatten().collect()
}

struct Feet<'f> {
    model: &'f Model,
    soles: &'f [Sole],
}

impl<'f> Feet<'f> {
    fn bodies(&self) -> impl Iterator<Item = &'f str> {
        self.soles.iter().flat_map(|sole| &sole.bodies).map(String::as_str)
    }

    /// Each joint from a body of a foot to one below it.
    fn joints_below(&self) -> impl Iterator<Item = (&'f str, &'f str)> {
        let model = self.model;
        self.bodies().flat_map(move |body| {
            let below = model.joints().iter().filter(move |joint| joint.parent.as_deref() == Some(body));
            below.filter_map(move |joint| Some((body, joint.child.as_deref()?)))
        })
    }

    fn has(&self, body: &str) -> bool {
        self.bodies().any(|own| own == body)
    }

    /// The bodies of the other side, where only one side gets spheres.
    fn one_side(&self) -> Option<Phrase> {
        let other = |body: &&str| {
            let is_counterpart = |there: &str| {
                without_side(there) == without_side(body)
                    && Side::of_name(there).is_some_and(|side| Some(side) != Side::of_name(body))
            };
            let there = self.model.bodies().iter().map(|there| there.name.as_str());
            there.filter(|there| is_counterpart(there)).find(|there| !self.has(there))
        };
        let missing: Vec<&str> = self.bodies().filter_map(|body| other(&body)).collect();
        about_bodies(&missing, |bodies| format!("one side alone gets spheres: the other side has {bodies}"))
    }

    /// Bodies that hang on a foot and get nothing.
    fn left_out(&self) -> Option<Phrase> {
        let out: Vec<&str> =
            self.joints_below().map(|(_, child)| child).filter(|child| !self.has(child)).collect();
        about_bodies(&out, |bodies| {
            format!("no spheres under {bodies}: part of the foot, but not among the bodies that were given")
        })
    }

    /// Parts of a foot that do not move against each other.
    fn rigid(&self) -> Option<Phrase> {
        let movements = Movements::of(self.model);
        let inside = self.joints_below().filter(|(_, child)| self.has(child));
        let stiff = inside.filter(|(parent, child)| {
            movements.between(parent, child).is_some_and(|freedom| !freedom.is_any())
        });
        let welded: Vec<&str> = stiff.map(|(_, child)| child).collect();
        about_bodies(&welded, |bodies| {
            format!(
                "the foot does not bend: nothing is free in the joint of {bodies} (welded, locked or prescribed)"
            )
        })
    }

    /// Feet of one body, on which nothing hangs.
    fn one_piece(&self) -> Option<Phrase> {
        let single = self.soles.iter().filter_map(|sole| match sole.bodies.as_slice() {
            [only] => Some(only.as_str()),
            _ => None,
        });
        let single: Vec<&str> =
            single.filter(|body| !self.joints_below().any(|(parent, _)| parent == *body)).collect();
        about_bodies(&single, |bodies| format!("feet of one rigid piece: {bodies}"))
    }
}

fn about_bodies(bodies: &[&str], text: impl FnOnce(String) -> String) -> Option<Phrase> {
    let listed: Vec<String> = bodies.iter().map(|body| shown(body).to_string()).collect();
    (!listed.is_empty()).then(|| text(listed.join(", ")).into())
}

/// How far the spheres that `plan` adds are from the floor of `built`, the model that it makes, at the default pose, and which
/// coordinate puts the body on them. `None` if they press on no floor.
pub(crate) fn standing(plan: &Plan, built: &Model) -> Option<Phrase> {
    let bodies = match standing_bodies(built) {
        Ok((bodies, _)) => bodies,
        Err(fault) => {
            return Some(format!("how far the spheres are from the floor is not known: {fault}").into());
        }
    };
    let new = plan.new_spheres();
    let new: HashSet<&str> = new.iter().map(|sphere| sphere.name).collect();
    let is_new = |body: &StandingBody| body.bottoms.iter().any(|one| new.contains(one.sphere.as_str()));
    bodies.into_iter().find(is_new).and_then(|body| over_the_floor(&body))
}

fn over_the_floor(body: &StandingBody) -> Option<Phrase> {
    let (lowest, place, way) = (body.lowest()?, body.height_in_words()?, body.describe_way_to_stand());
    let lowest = shown(&lowest.sphere);
    Some(format!("at the default pose {lowest}, the lowest sphere, is {place}; {way}").into())
}

// Remarks about planes that new contacts do not meet.

/// A plane that leans by no more than this, degrees, was probably meant to be level.
const LEANING: f64 = 10.0;

/// Planes of `base` that are nearly a floor, beside which a level one was made.
pub(crate) fn leaning(base: &Model, rebuilt: &Rebuilt) -> Option<Phrase> {
    let added = |object: &osim_patch::ObjectChange| object.deed == Deed::Added;
    let made = rebuilt.objects.iter().find(|object| added(object) && object.class == "ContactHalfSpace")?;
    let up = base.up();
    let planes: Vec<String> = base
        .ground_planes()
        .into_iter()
        .filter_map(|plane| {
            let degrees = angle(plane.normal, up).to_degrees();
            (degrees <= LEANING).then(|| format!("{} (by {} degrees)", plane.name, readable(degrees)))
        })
        .collect();
    if planes.is_empty() {
        return None;
    }
    let text = format!(
        "no half-space of the model is level: {} would be a floor, but it leans; the new forces meet {}, which is level",
        planes.join(", "),
        made.name
    );
    Some(text.into())
}

/// Planes that the `removed` forces of `model` met and that those of `rebuilt` do not.
pub(crate) fn planes_left(model: &Model, removed: &[ForceId], rebuilt: &Rebuilt) -> Option<Phrase> {
    let met = |model: &Model, forces: &mut dyn Iterator<Item = &Force>| -> BTreeSet<String> {
        let sets = forces.flat_map(|force| &force.sets);
        sets.flat_map(|set| model.half_spaces_of(set)).map(|plane| plane.name).collect()
    };
    let before = met(model, &mut removed.iter().filter_map(|&id| model.force(id)));
    let built = rebuilt.model();
    let new: BTreeSet<&str> = rebuilt
        .objects
        .iter()
        .filter(|object| object.deed == Deed::Added)
        .map(|object| object.path.as_str())
        .collect();
    let mut made = built.forces().iter().filter(|force| new.contains(force.path.as_str()));
    let after = met(built, &mut made);
    let left: Vec<&str> = before.difference(&after).map(String::as_str).collect();
    if left.is_empty() || after.is_empty() {
        return None;
    }
    let after: Vec<&str> = after.iter().map(String::as_str).collect();
    let text = format!(
        "the forces that were taken out met {}, which is not a level floor on ground; the new ones meet {}",
        left.join(" and "),
        after.join(" and ")
    );
    Some(text.into())
}

// Places, soles and factors that are probably in another unit.

/// A sphere is at most this many times as far from the joints of its body as the longest distance between joints around it.
/// Published ones are closer than half of that distance; in centimetres they would be some tens of times as far.
const FAR: f64 = 3.0;
/// What is usual, as a part of that distance: the ball of a human foot and its shank.
const USUAL: f64 = 0.4;
/// The foot's length over what is usual for its sole below the bones: 0.26 m and 13 mm.
const PADS: f64 = 20.0;
/// Bones of a giraffe are 38 times as long as those of a mouse: the cube root of 1190 kg over 0.0209 kg.
const LARGEST_SCALE: f64 = 50.0;

/// The joints of a model's bodies, and how far they are apart.
pub(crate) struct Bones {
    anatomy: Option<Anatomy>,
    distances: JointDistances,
}

/// How far a place is from its bones.
pub(crate) struct Distance {
    from_joints_m: f64,
    longest_m: f64,
}

impl Bones {
    pub(crate) fn of(model: &Model) -> Self {
        Self { anatomy: Anatomy::of(model).ok(), distances: model.joint_distances().clone() }
    }

    /// How far a place is from the nearest joint of `body`, or its origin; `None` if it is not known how large the bones are.
    pub(crate) fn distance(&self, body: &str, place_m: [f64; 3]) -> Option<Distance> {
        let longest_m = self.distances.longest_around_body(body)?;
        let anatomy = self.anatomy.as_ref()?;
        let above = anatomy.joint_above(body).map(|joint| joint.in_child_m);
        let below = anatomy.joints_below(body).map(|joint| joint.in_parent_m);
        let apart = |joint: DVec3| joint.distance(place_m.into());
        let from_joints_m = below.chain(above).chain([DVec3::ZERO]).map(apart).fold(f64::INFINITY, f64::min);
        Some(Distance { from_joints_m, longest_m })
    }
}

impl Distance {
    /// In distances between joints.
    pub(crate) fn times(&self) -> f64 {
        self.from_joints_m / self.longest_m
    }

    /// What is asked of a place so far away; `at` is where it is in its table.
    pub(crate) fn place_slip(&self, at: &str, name: &str, body: &str) -> Option<NeedsAnswer> {
        if self.times() <= FAR {
            return None;
        }
        let units = probable_units(self.times() / USUAL);
        let units: Vec<String> = units
            .iter()
            .map(|(unit, per_metre)| format!("divide them by {per_metre} if they are in {unit}"))
            .collect();
        let text = format!(
            "{at}{} would be {} m from the nearest joint of {}, and the joints of its body and of those next to it are at most {} m \
             apart: places are in m{}{}",
            shown(name),
            four_significant(self.from_joints_m),
            shown(body),
            four_significant(self.longest_m),
            if units.is_empty() { "" } else { ", " },
            units.join(", or ")
        );
        Some(NeedsAnswer::Other { question: Question::ImplausiblePlace, text: text.into() })
    }
}

/// What is asked where a sole is farther below the bones than the foot is long.
pub(crate) fn pad_slip(sole: &Sole, pad_m: f64) -> Option<NeedsAnswer> {
    let length_m = sole.footprint.length_m;
    if pad_m <= length_m {
        return None;
    }
    let units = probable_units(pad_m * PADS / length_m);
    let units: Vec<String> = units
        .iter()
        .map(|(unit, per_metre)| format!("{} if it is in {unit}", readable(pad_m / per_metre)))
        .collect();
    let write = if units.is_empty() { "" } else { ", write " };
    let bodies: Vec<String> = sole.bodies.iter().map(|body| shown(body).to_string()).collect();
    let text = phrase![
        Input::Pad.with_value(readable(pad_m)),
        format!(
            " is more than the length of the foot of {}, {} m: it is in m{write}{}",
            bodies.join(", "),
            four_significant(length_m),
            units.join(", or ")
        ),
    ];
    Some(NeedsAnswer::Other { question: Question::ImplausiblePlace, text })
}

/// What is asked where a body would be scaled as no two animals differ.
pub(crate) fn scale_slip(scales: &[BodyScale]) -> Option<NeedsAnswer> {
    let usual = 1.0 / LARGEST_SCALE..=LARGEST_SCALE;
    let factors = scales.iter().flat_map(|scale| scale.factors.map(|factor| (scale, factor)));
    let (scale, factor) = factors.into_iter().find(|(_, factor)| !usual.contains(factor))?;
    let percent = match factor > LARGEST_SCALE {
        true => format!("; if it is in percent, write {}", readable(factor / 100.0)),
        false => String::new(),
    };
    let text = phrase![
        Input::BodyScale.with_value(scale.to_string()),
        format!(
            " makes a bone {} times as long as the reference's: between a mouse and a giraffe it is 38 times{percent}",
            readable(factor)
        ),
    ];
    Some(NeedsAnswer::Other { question: Question::ImplausibleScale, text })
}

/// Refuses to take what the bodies weigh where the contacts are known ones that were made for another mass, which `input` can
/// give.
pub(crate) fn refuse_known(
    model: &Model,
    selected: &Selected,
    mass: &Mass,
    input: Input,
) -> Result<(), Fault> {
    if mass.source.is_about_contacts() {
        return Ok(());
    }
    let known = KnownContacts::find(model, &selected.forces, None, Some(mass.kg));
    match known.filter(|known| !same_mass(known.made_for_kg, mass.kg)) {
        Some(known) => Err(Fault::new(Needed::KnownContactsMass {
            title: known.title.to_owned(),
            made_for_kg: known.made_for_kg,
            bodies_kg: mass.kg,
            input,
        })),
        None => Ok(()),
    }
}

/// How many limbs carry the body, where the note in `model` says so and the caller did not.
pub(crate) fn noted_limbs(counts: &CountOptions, model: &Model) -> Option<Phrase> {
    let noted = model.noted_stance_limbs()?;
    let is_said = counts.stance_limbs.is_some() || counts.spheres.is_some();
    let text = format!("{} limbs share the weight, as the note in the model says: ", readable(noted));
    (!is_said).then(|| phrase![text, Input::StanceLimbs, " says another number"])
}
