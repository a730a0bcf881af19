//! All rules in the order of their codes; and the rules about the result of a change and about files beside a model.

use std::collections::{BTreeSet, HashSet};
use std::path::Path;
use std::sync::LazyLock;

use contact_scaling::{RatioValues, Ratios};
use osim_inspect::{Bottom, SizeList, StandingBody};
use osim_model::feet::{DefaultPose, FootBodies, MeshFolders, odd_meshes};
use osim_model::files::Files;
use osim_model::messages::{four_significant, readable, shown, three_significant};
use osim_model::rule;
use osim_model::{
    Anatomy, Example, Finding, FindingCode, Model, Repair, Rule, loaded_round_spheres, root_mean_square,
};
use osim_patch::forms_of_dissipation;

/// The rules of this crate: about results of changes, recordings, and files beside a model.
const RULES: &[&Rule] = &[
    &BOTTOMS_MOVED,
    &COMPILED_MODEL_BESIDE,
    &DISSIPATION_FORMS,
    &HARD_LINKED,
    &MASS_AGAINST_LENGTH,
    &ODD_MESH,
    &UNLIKE_RECORDING,
    &LARGE_CORRECTION,
    &HORIZONTAL_ERROR,
];

/// All rules of all crates: one rule for each code.
pub fn all() -> &'static [&'static Rule] {
    static ALL: LazyLock<Vec<&Rule>> = LazyLock::new(|| {
        let below = [osim_model::RULES, osim_patch::RULES, RULES].concat();
        let mut all: Vec<&Rule> = osim_inspect::rules().chain(below).collect();
        all.sort_by_key(|rule| rule.code);
        all
    });
    &ALL
}

/// The rules whose code `codes` accepts, in the order of the codes.
pub fn with_code<'c>(codes: impl Fn(FindingCode) -> bool + 'c) -> impl Iterator<Item = &'static Rule> + 'c {
    all().iter().copied().filter(move |rule| codes(rule.code))
}

rule! { BOTTOMS_MOVED: BottomsMoved, Warning;
    what: "A change moves the lowest points of spheres so far that the default pose is no longer on the floor, or that the spheres of a level foot become uneven.",
    why: "Radii grow around centres that stay. A simulation that starts from the default pose starts inside the floor then, and lower spheres carry what all should carry. Contacts that are made for a body which is still to be scaled are not judged by the pose of the one that is there, nor are spheres that follow their bodies.",
    advice: "Give the coordinate its new value, or keep the lowest points of the spheres where they are with `level`; nothing, if simulations start from a pose of their own and the foot should be uneven",
    repair: Repair::OnlyInChange("it is about a change, not about a model"),
    example: Example::Request {
        good: r#"{"verb": "set", "models": ["check/within_limits.osim"], "set": {"radius": "x1.05"}}"#,
        bad: r#"{"verb": "set", "models": ["check/within_limits.osim"], "set": {"radius": "x2"}}"# },
}

/// The finding about a body that stood `before` the change and does not stand `now`. It names the body if there are `several` bodies.
pub(crate) fn bottoms_moved_of_body(
    before: &StandingBody,
    now: &StandingBody,
    several: bool,
) -> Option<Finding> {
    let which = if several { format!(" of {}", shown(&now.body)) } else { String::new() };
    let (was, is) = (before.pose_in_words()?, now.pose_in_words()?);
    let text = format!("the default pose{which} was {was} and is {is} now; {}", now.describe_way_to_stand());
    Some(Finding::new(&BOTTOMS_MOVED, text).with_place(&now.lowest()?.path))
}

/// The finding about a limb whose bottoms are less level after the change: their heights differed by `before_m`, and now by that of
/// `lowest` and `highest`.
pub(crate) fn bottoms_moved_of_limb(limb: &str, before_m: f64, lowest: &Bottom, highest: &Bottom) -> Finding {
    let millimetres = |metres: f64| readable((metres * 1e4).round() / 10.0);
    let now_m = highest.height_m - lowest.height_m;
    let text = format!(
        "the lowest points of {} differed by {} mm at the default pose and differ by {} mm now, {} R, from {} to {}",
        shown(limb),
        millimetres(before_m),
        millimetres(now_m),
        three_significant(now_m / lowest.radius_m),
        shown(&lowest.sphere),
        shown(&highest.sphere),
    );
    Finding::new(&BOTTOMS_MOVED, text).with_place(&highest.path)
}

rule! { COMPILED_MODEL_BESIDE: CompiledModelBeside, Warning;
    what: "A compiled file, F_ and the name of the model, lies beside the output.",
    why: "PredSim and OpenCap compile a model to F_<name> and reuse it without looking at the model's content: the old contacts would stay in use.",
    advice: "Delete the compiled file, or write the model under a new name",
    repair: Repair::NotPossible("the program does not change files of other programs"),
    example: Example::InWords { good: "`model.osim` is written to a folder of its own",
        bad: "`F_model.dll` lies in the folder that `model.osim` is written to" },
}

/// The finding that other programs would use the file `compiled` instead of the output.
pub fn compiled_model_beside(compiled: &Path) -> Finding {
    let text = format!(
        "{} lies beside the output: PredSim and OpenCap would continue to use it",
        compiled.display()
    );
    Finding::new(&COMPILED_MODEL_BESIDE, text)
}

rule! { HARD_LINKED: HardLinked, Warning;
    what: "A model that is changed itself has other names too.",
    why: "A changed model is a new file that takes the name of the old one, so that no moment is without a whole file. Hard links to the old one are names of the old file: they keep the old model.",
    advice: "Make the other names again, or change the model under one of its names into a file of its own",
    repair: Repair::OnlyInChange("only you know what the other names are for"),
    example: Example::InWords { good: "`model.osim` is the only name of its file",
        bad: "`model.osim` and `copy.osim` are two names of one file, and one of them is changed in place" },
}

/// The finding that the file `path` has `others` other names (hard links), under which the old model stays.
pub fn hard_linked(path: &Path, others: u64) -> Finding {
    let names = if others == 1 { "one more name".to_owned() } else { format!("{others} more names") };
    let text = format!("{} has {names} (hard links), under which the old model stays", path.display());
    Finding::new(&HARD_LINKED, text)
}

/// The largest number of bodies of feet whose meshes are read. Each mesh is a file.
const MOST_FEET_BODIES: usize = 40;
/// In a model without spheres and with more bodies than this, the program does not look for bodies near the ground, because this takes
/// longer than all other rules.
const MOST_BODIES_TO_SEARCH: usize = 200;

rule! { ODD_MESH: OddMesh, Warning, Sizes;
    what: "The mesh of a foot does not fit the skeleton.",
    why: "`add MODEL` with `feet` lays spheres under the lowest points of meshes, and factors between models come from them: with a file in millimetres, another animal's bone of the same name, or one broken vertex, spheres are far from where the foot is. Real feet, toes and tali are 0.136 to 0.6 of the longest bone of their limb, the longest distance between two joints of one body.",
    advice: "Correct the scale factors of the mesh, or put the right file beside the model",
    repair: Repair::NotPossible("only numbers of contacts are changed"),
    example: Example::Models { good: "feet/human_40000.osim", bad: "feet/human_in_millimetres.osim" },
}

/// The finding about the first mesh of a foot that does not fit the skeleton; the model is the file at `path`.
pub(crate) fn find_odd_mesh(model: &Model, path: &Path, files: &dyn Files) -> Option<Finding> {
    let feet = bodies_of_feet(model);
    if feet.is_empty() {
        return None;
    }
    let bodies: HashSet<&str> = feet.iter().take(MOST_FEET_BODIES).map(String::as_str).collect();
    let odd = odd_meshes(model, &bodies, &MeshFolders::of_model(path), files);
    let first = odd.first()?;
    let more = match odd.len() {
        1 => String::new(),
        2 => "; another mesh, too".to_owned(),
        count => format!("; {} other meshes, too", count - 1),
    };
    Some(Finding::new(&ODD_MESH, format!("{}{more}", first.text)))
}

/// The bodies of feet: those with spheres, or those near the ground in a model without spheres.
fn bodies_of_feet(model: &Model) -> BTreeSet<String> {
    let moving = model.spheres().iter().filter(|sphere| !sphere.fixed);
    let carriers: BTreeSet<String> = moving.filter_map(|sphere| sphere.body.clone()).collect();
    if !carriers.is_empty() || model.bodies().len() > MOST_BODIES_TO_SEARCH {
        return carriers;
    }
    let Ok(anatomy) = Anatomy::of(model) else { return carriers };
    let feet = FootBodies::find(model, &anatomy, &[], &[], &DefaultPose::of(model));
    feet.into_iter().flat_map(|foot| foot.bodies).collect()
}

/// Two bodies are not similar if their densities differ by more than this factor.
const UNLIKE_DENSITY_RATIO: f64 = 2.5;

rule! { MASS_AGAINST_LENGTH: MassAgainstLength, Remark, Mass;
    what: "The mass of a model does not fit its lengths, compared with the model that was scaled.",
    why: "Bodies of one shape and one density have masses that follow the third power of their lengths. If lengths are multiplied by the ratio of masses, the body is several times as dense, and no contact that fits its mass fits its feet.",
    advice: "Scale lengths by the third root of the ratio of masses; nothing, if the animal really has that density",
    repair: Repair::NotPossible("only numbers of contacts are changed"),
    example: Example::Request {
        good: r#"{"verb": "check", "models": ["scale_tool/scaled_smooth.osim"], "from": "scale_tool/generic_smooth.osim"}"#,
        bad: r#"{"verb": "check", "models": ["check/mass_against_length.osim"], "from": "check/known_contacts.osim"}"# },
}

/// The remark that a model is much more dense, or much less dense, than the model before scaling.
pub(crate) fn find_mass_against_length(sizes: &SizeList) -> Option<Finding> {
    let (mass, length) = sizes.mass_ratio.zip(sizes.length_ratio_of_joints())?;
    let similar = length.powi(3);
    let density = mass / similar;
    let is_unlike = density >= UNLIKE_DENSITY_RATIO || density * UNLIKE_DENSITY_RATIO <= 1.0;
    let text = format!(
        "lengths are {} and the mass {} times those of the model that was scaled: a body of the same density would have {} of its mass, so this one is {} times as dense",
        three_significant(length),
        three_significant(mass),
        three_significant(similar),
        three_significant(density),
    );
    is_unlike.then(|| Finding::new(&MASS_AGAINST_LENGTH, text).with_measure(density.ln().abs(), ""))
}

rule! { DISSIPATION_FORMS: DissipationForms, Remark, Mass;
    what: "By radius and by mass, dissipation follows from the model that was scaled by clearly different factors.",
    why: "(14) has two forms, R^(-1/2) and M^(-1/6), which agree where radii go with M^(1/3). Each keeps the restitution at other speeds; legs move at speeds in proportion to the root of their length.",
    advice: "Take the form that fits the speeds that you simulate, with `dissipation_by`",
    repair: Repair::NotPossible("only you know at which speeds the feet land"),
    example: Example::Request {
        good: r#"{"verb": "check", "models": ["scale_tool/scaled_smooth.osim"], "from": "scale_tool/generic_smooth.osim"}"#,
        bad: r#"{"verb": "check", "models": ["table1/horse_smooth_sphere.osim"], "from": "table1/human_62kg_smooth_sphere.osim"}"# },
}

/// The root mean square of the radii of a model's contacts, m, and the dissipation of its first contact, s/m; `None` without contacts.
pub(crate) fn radius_and_dissipation(model: &Model) -> Option<[f64; 2]> {
    let loaded = loaded_round_spheres(model, &model.force_ids()).ok()?;
    let radius_m = root_mean_square(loaded.iter().map(|sphere| sphere.radius_m));
    Some([radius_m, loaded.first()?.contact.dissipation()])
}

/// The remark that (14) gives different dissipations by radius and by mass. The reference has the radius `reference_m` and the dissipation
/// `from`; the scaled model has `radius_m` and `now`.
pub(crate) fn find_dissipation_forms(
    sizes: &SizeList,
    [reference_m, from]: [f64; 2],
    [radius_m, now]: [f64; 2],
) -> Option<Finding> {
    let gravity = sizes.gravity_ratio.unwrap_or(1.0);
    let (mass, radius) = (sizes.mass_ratio?, radius_m / reference_m);
    let ratios = Ratios::new(RatioValues { mass, sphere_count: 1.0, radius, gravity }).ok()?;
    let length = sizes.length_ratio_of_joints();
    let forms = forms_of_dissipation(&ratios, from, length)?;
    let share = length.map(|length| {
        let share = three_significant(radius / length);
        format!(
            "; its radii over its bones are {share} times the other model's, and 1 would be strict similarity"
        )
    });
    let text = format!("{forms}; this model has {}{}", four_significant(now), share.unwrap_or_default());
    Some(Finding::new(&DISSIPATION_FORMS, text))
}

rule! { pub(crate) UNLIKE_RECORDING: UnlikeRecording, Warning, Recording;
    what: "Contacts, motion and force plates do not agree, and the reason is seen.",
    why: "Feet are swapped, a unit, a sign or an axis is wrong, the plates are late or early, or one foot is higher than the other.",
    advice: "correct the cause that is named, before contacts or motion are changed",
    repair: Repair::NotPossible("the recording has to be corrected"),
    example: Example::Request { good: r#"{"verb": "check", "models": ["motion/walker.osim"]}"#,
        bad: r#"{"verb": "check", "models": ["motion/walker.osim"], "motion": "motion/walk.mot", "plates": "motion/kilonewtons.sto"}"# },
}

rule! { pub(crate) LARGE_CORRECTION: LargeCorrection, Remark, Recording;
    what: "Contacts and force plates agree after a large correction of the motion only, or not even then.",
    why: "The smallest correction with which the contacts give the measured forces moves spheres by more than 12 mm, or leaves 0.1 body weights. Half of all measured recordings are so.",
    advice: "`motion MODEL correct=FILE`, with the motion and its plates, writes a corrected motion: a start for simulations",
    repair: Repair::NotPossible("the recording is as it is"),
    example: Example::Request { good: r#"{"verb": "check", "models": ["motion/walker.osim"]}"#,
        bad: r#"{"verb": "check", "models": ["motion/walker.osim"], "motion": "motion/pitched.mot", "plates": "motion/plates.sto"}"# },
}

rule! { pub(crate) HORIZONTAL_ERROR: HorizontalError, Remark;
    what: "After the correction, a foot's horizontal force is further from the plates than if nothing touched.",
    why: "Friction follows the slip of the spheres, and small jumps of a motion that was not smoothed are slip. The verdict on the recording is made of the vertical force and of the size of the correction.",
    advice: "Smooth the motion: `motion MODEL low_pass=10 correct=FILE`, with the motion and its plates",
    repair: Repair::NotPossible("the recording is as it is"),
    example: Example::InWords { good: "The motion was smoothed with a cutoff of 10 Hz",
        bad: "The motion is that of inverse kinematics, and markers jump from frame to frame" },
}
