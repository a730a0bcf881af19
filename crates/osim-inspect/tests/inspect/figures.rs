//! Figures of spheres under the body weight, each compared with a number that was computed without this library.

#![allow(
    clippy::unwrap_used,
    clippy::expect_used,
    clippy::panic,
    unreachable_pub,
    reason = "a test fails by panicking"
)]

use std::collections::BTreeSet;

use crate::feet::{HEEL, SmoothContact, TOE, foot};
use osim_inspect::{Figure, Figures, InspectOptions, Inspection, SphereFigures, Stance};
use osim_model::messages::{Call, Dialect, Example, Input};
use osim_model::{Model, Pattern, Selection};

/// A model of 62 kg on 6 equal spheres on each foot.
const HUMAN: &str = include_str!("../../../../fixtures/table1/human_62kg_smooth_sphere.osim");
const HUNT_CROSSLEY: &str = include_str!("../../../../fixtures/table1/human_62kg_hunt_crossley.osim");
/// A model of 61.5 kg on one sphere of 0.0325 m, which two smooth forces press, with E₁* of 1.2345678 and 2 MPa.
const TWO_FORCES: &str = include_str!("../../../../fixtures/format/shared_sphere.osim");
/// A model in which a `SmoothSphereHalfSpaceForce` and a `HuntCrossleyForce` press the same sphere.
const TWO_CLASSES: &str = include_str!("../../../../fixtures/format/shared_sphere_two_classes.osim");
/// A model with two feet whose names do not say which one is the left foot.
const FEET_WITHOUT_SIDES: &str = include_str!("../../../../fixtures/format/no_sides.osim");

fn inspect_with(text: &str, stance: Stance) -> Inspection {
    let model = Model::parse(text).unwrap();
    InspectOptions { stance, ..InspectOptions::default() }.inspect("model.osim", &model, None)
}

fn figures_of_text(text: &str) -> Figures {
    inspect_with(text, Stance::default()).figures
}

/// The figures of the first sphere.
fn first_sphere(figures: &Figures) -> &SphereFigures {
    figures.spheres().next().unwrap()
}

#[track_caller]
fn assert_near(value: f64, expected: f64, what: &str) {
    assert!((value - expected).abs() <= 1e-13 * expected.abs(), "{what}: {value}, expected {expected}");
}

#[track_caller]
fn assert_figures(sphere: &SphereFigures, expected: &[(Figure, f64)]) {
    for &(figure, expected) in expected {
        assert_near(sphere.value(figure).unwrap(), expected, &format!("{figure:?} of {}", sphere.sphere));
    }
}

// mpmath 1.3.0, 40 digits: (3), (C.9) at rest solved for x, the derivative of (1), (B.3), (B.4), (15), (C.2), (C.7), the
// two restitutions of (12) and (13), with M g = 600 N on n = 2.
const FIGURES_OF_HEEL: &[(Figure, f64)] = &[
    (Figure::Radius, 0.05),
    (Figure::CompositeModulus, 1_060_660.171_779_821_3),
    (Figure::Dissipation, 0.3),
    (Figure::Load, 300.0),
    (Figure::Indentation, 0.193_097_876_921_125_95),
    (Figure::IndentationModelLaw, 0.183_455_154_509_831_53),
    (Figure::LevelIndentation, 0.176_379_512_541_541_36),
    (Figure::LevelIndentationModelLaw, 0.167_993_437_339_560_31),
    (Figure::IndentationAtTwo, 0.306_523_772_957_421_2),
    (Figure::IndentationModelLawAtTwo, 0.305_357_675_642_228_63),
    (Figure::LevelIndentationAtTwo, 0.279_985_023_754_081),
    (Figure::LevelIndentationModelLawAtTwo, 0.275_472_198_606_984_15),
    (Figure::ContactStiffness, 46_608.487_589_307_883),
    (Figure::DimensionlessStiffness, 7.768_081_264_884_647),
    (Figure::NaturalFrequency, 6.273_241_540_017_333),
    (Figure::MeanContactStress, 197_812.565_063_349_5),
    (Figure::RestitutionExact, 0.879_944_256_386_059_4),
    (Figure::RestitutionApproximate, 0.863_787_022_221_524_5),
    (Figure::ConstantIndentation, 0.08),
    (Figure::TransitionWidth, 0.235_555_118_333_315_24),
    (Figure::ForceJustTouching, 38.293_949_914_762_29),
    (Figure::TouchingShare, 0.127_646_499_715_874_3),
];
const FIGURES_OF_TOE: &[(Figure, f64)] = &[
    (Figure::Radius, 0.03),
    (Figure::CompositeModulus, 1_767_766.952_966_368_8),
    (Figure::Dissipation, 0.25),
    (Figure::Load, 300.0),
    (Figure::Indentation, 0.271_441_761_659_490_66),
    (Figure::IndentationModelLaw, 0.260_785_365_143_784_02),
    (Figure::LevelIndentation, 0.293_965_854_235_902_27),
    (Figure::LevelIndentationModelLaw, 0.279_989_062_232_600_5),
    (Figure::IndentationAtTwo, 0.430_886_938_006_376_74),
    (Figure::IndentationModelLawAtTwo, 0.421_008_952_392_375_72),
    (Figure::LevelIndentationAtTwo, 0.466_641_706_256_801_7),
    (Figure::LevelIndentationModelLawAtTwo, 0.459_120_331_011_640_25),
    (Figure::ContactStiffness, 55_260.472_479_605_8),
    (Figure::DimensionlessStiffness, 5.526_047_247_960_58),
    (Figure::NaturalFrequency, 6.830_724_998_288_061),
    (Figure::MeanContactStress, 390_887.882_343_240_41),
    (Figure::RestitutionExact, 0.897_954_434_338_726_2),
    (Figure::RestitutionApproximate, 0.886_489_185_184_603_7),
    (Figure::ConstantIndentation, 0.1),
    (Figure::TransitionWidth, 0.490_739_829_861_073_4),
    (Figure::ForceJustTouching, 33.541_019_662_496_84),
    (Figure::TouchingShare, 0.111_803_398_874_989_48),
];

#[test]
fn every_figure_of_a_foot_on_two_sizes_of_sphere() {
    let figures = figures_of_text(&foot(&[HEEL, TOE]));
    let spheres: Vec<&SphereFigures> = figures.spheres().collect();
    assert_eq!(spheres.len(), 2);
    for (sphere, expected) in spheres.into_iter().zip([FIGURES_OF_HEEL, FIGURES_OF_TOE]) {
        let listed: Vec<Figure> = expected.iter().map(|(figure, _)| *figure).collect();
        // // The two figures of the default pose need a pose: see the next test.
        let standing = [Figure::StandingIndentation, Figure::StandingIndentationModelLaw];
        let others: Vec<Figure> = Figure::ALL.iter().copied().filter(|one| !standing.contains(one)).collect();
        assert_eq!(listed, others, "every figure of the register is here");
        assert!(standing.iter().all(|&figure| sphere.value(figure).is_none()), "no joint, no pose");
        let distinct: BTreeSet<u64> = expected.iter().map(|(_, value)| value.to_bits()).collect();
        assert_eq!(distinct.len(), expected.len(), "no figure can stand for another");
        assert_figures(sphere, expected);
    }
    assert_eq!((figures.mass_kg, figures.gravity_m_s2), (Some(60.0), Some(10.0)));
    assert!(figures.why_no_body_weight.is_none());
}

/// On a floor that rises by 3 over 4, 0.8 of the weight presses, in whatever direction it rises. Impact speeds are those of a free fall.
#[test]
fn on_a_slope_the_part_of_the_weight_along_its_normal_presses() {
    const LEVEL_ORIENTATION: &str = "<orientation>0 0 -1.5707963267948966</orientation>";
    let turned = |angles: &str| {
        let orientation = format!("<orientation>{angles}</orientation>");
        let text = foot(&[HEEL]).replace(LEVEL_ORIENTATION, &orientation);
        assert!(text.contains(&orientation));
        figures_of_text(&text)
    };
    let value = |figures: &Figures, figure| first_sphere(figures).value(figure).unwrap();
    let level = figures_of_text(&foot(&[HEEL]));
    // The normal of a half-space that is turned by a about z is (-cos a, -sin a, 0), and sin 0.927295... = 0.8.
    for angles in ["0 0 -0.9272952180016122", "0 0 -2.214297435588181"] {
        let slope = turned(angles);
        assert_near(value(&slope, Figure::Load), 0.8 * 600.0, angles);
        assert_near(value(&slope, Figure::RestitutionExact), value(&level, Figure::RestitutionExact), angles);
        // x grows with load^(2/3), (3).
        let x = value(&level, Figure::Indentation) * 0.8_f64.powf(2.0 / 3.0);
        assert!((value(&slope, Figure::Indentation) - x).abs() < 1e-12);
        assert_eq!(slope.gravity_m_s2, Some(10.0));
    }
    // Upright, upside down and in degrees it is no floor: all of the weight will press on it once it is turned.
    for angles in ["0 0 0", "0 0 1.5707963267948966", "0 0 -90"] {
        assert_eq!(value(&turned(angles), Figure::Load), 600.0, "{angles}");
    }
}

/// The foot with heel and toe, on a joint to ground; the toe is 4 mm higher than the heel.
fn foot_with_a_high_toe() -> String {
    let joint = "<JointSet><objects><FreeJoint name=\"root\"><socket_parent_frame>/ground</socket_parent_frame>\
                 <socket_child_frame>/bodyset/foot_r</socket_child_frame></FreeJoint></objects></JointSet></Model>";
    let text = foot(&[HEEL, TOE]).replace("</Model>", joint);
    text.replace("<location>0 0 0.1</location>", "<location>0 -0.016 0</location>")
}

#[test]
fn spheres_of_two_heights_share_the_load_by_how_deep_each_is() {
    // mpmath 1.3.0, 50 digits: (1) and (C.9) at rest of both spheres, summed to 600 N.
    let seen = figures_of_text(&foot_with_a_high_toe());
    let expected = [
        [0.219_221_911_520_665_5, 0.212_312_155_305_137_72],
        [0.232_036_519_201_109_16, 0.220_520_258_841_896_2],
    ];
    for (sphere, [hertz, model_law]) in seen.spheres().zip(expected) {
        let value = |figure| sphere.value(figure).unwrap();
        // Heights are differences of coordinates, each with a last bit.
        let close = |value: f64, expected: f64| (value - expected).abs() <= 1e-12;
        assert!(close(value(Figure::StandingIndentation), hertz), "{}", sphere.sphere);
        assert!(close(value(Figure::StandingIndentationModelLaw), model_law), "{}", sphere.sphere);
    }
}

#[test]
fn an_impact_is_a_fall_from_a_quarter_of_the_mean_radius() {
    // R² is the mean of 0.05² and 0.03², 0.0017; √(10 √0.0017 / 2).
    assert_near(
        figures_of_text(&foot(&[HEEL, TOE])).impact_speed_m_s.unwrap(),
        0.454_043_259_261_585_2,
        "speed",
    );
    let given = Stance { impact_speed_m_s: Some(0.7), ..Stance::default() };
    let seen = inspect_with(&foot(&[HEEL, TOE]), given).figures;
    assert_eq!(seen.impact_speed_m_s, Some(0.7));
    // 1 − 0.3 s/m · 0.7 m/s.
    assert_near(first_sphere(&seen).value(Figure::RestitutionApproximate).unwrap(), 0.79, "restitution");
}

#[test]
fn spheres_beside_those_of_the_limb_take_their_share() {
    let stance = Stance { spheres: Some(4.0), ..Stance::default() };
    let seen = inspect_with(&foot(&[HEEL, TOE]), stance).figures;
    // As above with 150 N on each sphere and 300 N on the two of them; 15 kg on each.
    let expected = [
        (Figure::Load, 150.0),
        (Figure::LevelIndentation, 0.111_112_130_310_642_37),
        (Figure::LevelIndentationAtTwo, 0.176_379_512_541_541_36),
        (Figure::NaturalFrequency, 7.903_789_067_342_769),
    ];
    assert_figures(first_sphere(&seen), &expected);
}

#[test]
fn a_sphere_that_two_forces_press_has_the_sum_of_their_forces_and_the_most_of_their_smoothing() {
    let softer = TWO_FORCES.replacen(">1.5e-05<", ">1e-05<", 1).replacen(">310<", ">155<", 1);
    let figures = figures_of_text(&softer);
    let sphere = first_sphere(&figures);
    assert_eq!(sphere.forces, ["contact_1", "contact_2"]);
    // E* = (1.2345678 + 2) MPa / 2^(3/2); √1.5e-5 and ln 19 / 155 over 0.0325 m; (C.9) at x = 0 of both.
    let expected = [
        (Figure::CompositeModulus, 1_143_592.412_793_826_2),
        (Figure::Dissipation, 2.25),
        (Figure::ConstantIndentation, 0.119_168_718_344_843_6),
        (Figure::TransitionWidth, 0.584_504_015_715_422_4),
        (Figure::ForceJustTouching, 29.812_169_745_582_941),
    ];
    assert_figures(sphere, &expected);
}

#[test]
fn a_force_without_smoothing_carries_nothing_while_it_just_touches() {
    let figures = figures_of_text(TWO_CLASSES);
    // (C.9) at x = 0 of the smooth one alone: E₁* is 1.2345678 MPa, cf 1.5e-5 m².
    let expected = [
        (Figure::ConstantIndentation, 0.119_168_718_344_843_6),
        (Figure::ForceJustTouching, 12.644_126_080_384_072),
    ];
    assert_figures(first_sphere(&figures), &expected);
}

#[test]
fn forces_of_different_dissipation_on_one_sphere_have_no_restitution() {
    let figures = figures_of_text(&TWO_FORCES.replacen("<dissipation>2.25<", "<dissipation>2<", 1));
    let sphere = first_sphere(&figures);
    for figure in [Figure::Dissipation, Figure::RestitutionExact, Figure::RestitutionApproximate] {
        assert_eq!(sphere.value(figure), None, "{figure:?}");
        assert_eq!(sphere.is_within(figure), None, "{figure:?}");
    }
}

#[test]
fn a_hunt_crossley_force_has_no_figures_of_smoothing() {
    let figures = figures_of_text(HUNT_CROSSLEY);
    let sphere = first_sphere(&figures);
    for figure in [
        Figure::ConstantIndentation,
        Figure::TransitionWidth,
        Figure::ForceJustTouching,
        Figure::TouchingShare,
    ] {
        assert_eq!(sphere.value(figure), None, "{figure:?}");
    }
    assert_eq!(sphere.value(Figure::IndentationModelLaw), sphere.value(Figure::Indentation));
}

#[test]
fn a_limb_is_mixed_if_figures_with_level_bottoms_differ_from_equal_shares() {
    assert!(figures_of_text(&foot(&[HEEL, TOE])).limbs[0].is_mixed());
    assert!(figures_of_text(HUMAN).limbs.iter().all(|limb| !limb.is_mixed()));
    // x̂ by 4e-9 of itself otherwise: x follows E*^(-2/3), and the level is half way between.
    let hardly = SmoothContact { stiffness: HEEL.stiffness * (1.0 + 12e-9), name: "toe_r", ..HEEL };
    assert!(figures_of_text(&foot(&[HEEL, hardly])).limbs[0].is_mixed());
    // By 4e-10 is as good as alike.
    let alike = SmoothContact { stiffness: HEEL.stiffness * (1.0 + 1.2e-9), name: "toe_r", ..HEEL };
    assert!(!figures_of_text(&foot(&[HEEL, alike])).limbs[0].is_mixed());
    assert!(!figures_of_text(FEET_WITHOUT_SIDES).limbs[0].is_mixed(), "nothing is known of shares");
}

#[test]
fn figures_are_given_limb_by_limb() {
    let limbs = figures_of_text(HUMAN).limbs;
    let named: Vec<_> =
        limbs.iter().map(|limb| (limb.limb.as_deref().unwrap(), limb.side.unwrap())).collect();
    assert_eq!(named, [("femur_r", "right"), ("femur_l", "left")]);
    let names = |index: usize| limbs[index].spheres.iter().map(|one| one.sphere.as_str()).collect::<Vec<_>>();
    assert_eq!(names(0), ["s1_r", "s2_r", "s3_r", "s4_r", "s5_r", "s6_r"]);
    assert_eq!(names(1), ["s1_l", "s2_l", "s3_l", "s4_l", "s5_l", "s6_l"]);
    let sphere = &limbs[1].spheres[2];
    assert_eq!(sphere.path, "/contactgeometryset/s3_l");
    assert_eq!(sphere.forces, ["contact_s3_l"]);
}

#[test]
fn spheres_are_in_their_own_order_not_in_that_of_their_forces() {
    let text = foot(&[HEEL, TOE]);
    let (spheres, forces) = text.split_at(text.find("<ForceSet").unwrap());
    let swapped =
        forces.replace("/heel_r<", "/other<").replace("/toe_r<", "/heel_r<").replace("/other<", "/toe_r<");
    let figures = figures_of_text(&format!("{spheres}{swapped}"));
    let named: Vec<&str> = figures.spheres().map(|sphere| sphere.sphere.as_str()).collect();
    assert_eq!(named, ["heel_r", "toe_r"]);
    assert_eq!(first_sphere(&figures).forces, ["contact_toe_r"]);
}

#[test]
fn spheres_that_are_alike_stand_level_with_equal_shares_to_the_last_bit() {
    let spheres =
        ["s1_r", "s2_r", "s3_r", "s4_r", "s5_r", "s6_r", "s7_r"].map(|name| SmoothContact { name, ..TOE });
    for count in 1..=spheres.len() {
        let figures = figures_of_text(&foot(&spheres[..count]));
        for (level, equal) in [
            (Figure::LevelIndentation, Figure::Indentation),
            (Figure::LevelIndentationModelLaw, Figure::IndentationModelLaw),
            (Figure::LevelIndentationAtTwo, Figure::IndentationAtTwo),
            (Figure::LevelIndentationModelLawAtTwo, Figure::IndentationModelLawAtTwo),
        ] {
            let sphere = first_sphere(&figures);
            assert!(sphere.value(level).is_some());
            assert_eq!(sphere.value(level), sphere.value(equal), "{level:?} of {count}");
        }
    }
}

#[test]
fn a_limb_without_a_chosen_sphere_has_no_figures() {
    let select: Vec<Pattern> = vec!["*_l".parse().unwrap()];
    let selection = Selection { select, ..Selection::default() };
    let options = InspectOptions { selection, ..InspectOptions::default() };
    let seen = options.inspect("human.osim", &Model::parse(HUMAN).unwrap(), None);
    let limbs: Vec<_> = seen.figures.limbs.iter().map(|limb| limb.side).collect();
    assert_eq!(limbs, [Some("left")]);
}

/// The reason why figures under body weight are absent.
#[track_caller]
fn why_figures_are_absent(figures: &Figures) -> String {
    assert!(figures.spheres().all(|sphere| sphere.value(Figure::Load).is_none()));
    figures.why_no_body_weight.as_ref().unwrap().to_string()
}

#[test]
fn without_mass_or_gravity_or_count_the_reason_is_given() {
    let no_mass = foot(&[HEEL]).replace("<mass>60</mass>", "<mass>0</mass>");
    assert_eq!(why_figures_are_absent(&figures_of_text(&no_mass)), "the mass of the model is not known");
    let no_gravity = foot(&[HEEL]).replace("0 -10 0", "0 0 0");
    assert!(why_figures_are_absent(&figures_of_text(&no_gravity)).contains("gravity"));
    assert_eq!(figures_of_text(&no_gravity).gravity_m_s2, None);
    assert_eq!(figures_of_text(&no_gravity).impact_speed_m_s, None);
    let why = why_figures_are_absent(&figures_of_text(FEET_WITHOUT_SIDES));
    assert!(why.contains("left or right cannot be determined"), "{why}");
    assert!(why.ends_with("say it with `spheres`"), "{why}");
}

#[test]
fn of_two_reasons_for_absent_figures_the_first_is_given() {
    let why = why_figures_are_absent(&figures_of_text(&FEET_WITHOUT_SIDES.replace("0 -9.81 0", "0 0 0")));
    assert!(why.contains("gravity") && !why.contains("spheres"), "{why}");
}

#[test]
fn a_gravity_of_zero_counts_as_no_gravity() {
    for gravity in [0.0, -10.0, f64::INFINITY, f64::NAN] {
        let stance = Stance { gravity_m_s2: Some(gravity), ..Stance::default() };
        let seen = inspect_with(&foot(&[HEEL]), stance).figures;
        assert_eq!(seen.gravity_m_s2, None, "{gravity}");
        assert!(why_figures_are_absent(&seen).contains("gravity"));
    }
    // On the moon the same foot weighs 60 · 1.62 N.
    let moon = Stance { gravity_m_s2: Some(1.62), ..Stance::default() };
    let seen = inspect_with(&foot(&[HEEL]), moon).figures;
    assert_near(first_sphere(&seen).value(Figure::Load).unwrap(), 97.2, "load");
}

#[test]
fn one_sphere_may_carry_all_the_weight() {
    let stance = Stance { spheres: Some(1.0), ..Stance::default() };
    let seen = inspect_with(FEET_WITHOUT_SIDES, stance).figures;
    assert_eq!(seen.limbs[0].sphere_count, Some(1.0));
    assert!(seen.why_no_body_weight.is_none());
}

/// A front end that writes all texts in capital letters.
struct ShoutingFrontEnd;

impl Dialect for ShoutingFrontEnd {
    fn input(&self, input: Input, _: Option<&Example>) -> String {
        input.name().to_uppercase()
    }

    fn call(&self, call: &Call) -> String {
        call.verb.name().to_uppercase()
    }
}

#[test]
fn the_reason_for_absent_figures_is_in_the_words_of_the_front_end() {
    let mut figures = figures_of_text(FEET_WITHOUT_SIDES);
    figures.spell(&ShoutingFrontEnd);
    let why = figures.why_no_body_weight.unwrap().to_string();
    assert!(why.ends_with("say it with SPHERES"), "{why}");
}

#[test]
fn contacts_stand_beside_measured_feet() {
    // mpmath: 3/(2 x/R) of the human of Table 1; the paper gives 3 to 13 times 4.24 for pads.
    let sentences = inspect_with(HUMAN, Stance::default()).beside_real_feet();
    assert!(
        sentences[0].starts_with("k R n/F at one body weight is 4.246; 12.72 to 55.12 in"),
        "{sentences:?}"
    );
    // Where this fixture's heels are is not known.
    assert_eq!(sentences.len(), 1);
    let Some(corpus) = std::env::var_os("OSIM_CORPUS").map(std::path::PathBuf::from) else { return };
    let falisse = std::fs::read_to_string(corpus.join("v40000_falisse_2022_human.osim")).unwrap();
    let sentences = inspect_with(&falisse, Stance::default()).beside_real_feet();
    // The paper's 27 kN/m of two spheres, exactly 26.896; an impact at sqrt(gR/2) keeps 0.5494 of its speed (mpmath).
    for (sentence, parts) in sentences[1..].iter().zip([
        ["2 spheres under the heel: 26.9 kN/m together", "810 to 1350"],
        ["at 0.3961 m/s loses 69.82 %", "30.9 to 48.2"],
    ]) {
        assert!(parts.iter().all(|part| sentence.contains(part)), "{sentences:?}");
    }
    assert_eq!(sentences.len(), 3);
}
