//! The number n of spheres that share the weight is the same whichever forces were chosen.

#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic, reason = "a test fails by panicking")]

use osim_inspect::series::ContactBody;
use osim_inspect::{Figure, InspectOptions, LoadSharing, Stance};
use osim_model::files::Failure;
use osim_model::{CountedSpheres, Fault, ForceId, Model, Pattern, Selection};

/// A human of 62 kg on 6 spheres on each foot, R = 0.032 m, E₁* = 1e6 N/m²: Table 1 of the paper, where x̂ is 0.353.
const HUMAN: &str = include_str!("../../../../fixtures/table1/human_62kg_smooth_sphere.osim");
/// A player on two feet, and a ball with its own joint to ground.
const PLAYER_AND_BALL: &str = include_str!("../../../../fixtures/format/player_and_ball.osim");
/// A model whose limbs have different numbers of spheres.
const UNEQUAL_SPHERE_COUNTS: &str = include_str!("../../../../fixtures/format/unequal_counts.osim");

fn options_selecting(pattern: &str) -> InspectOptions {
    let select: Vec<Pattern> = vec![pattern.parse().unwrap()];
    InspectOptions { selection: Selection { select, ..Selection::default() }, ..InspectOptions::default() }
}

fn ids_of_forces(model: &Model, ends_with: &str) -> Vec<ForceId> {
    let chosen = model.forces().iter().filter(|force| force.name.ends_with(ends_with));
    chosen.map(|force| force.id).collect()
}

#[test]
fn chosen_spheres_carry_their_share_of_all_that_stand() {
    let model = Model::parse(HUMAN).unwrap();
    for pattern in ["*", "contact_s1_*", "contact_s3_r", "*_l"] {
        let seen = options_selecting(pattern).inspect("human.osim", &model, None);
        assert_eq!(seen.spheres_per_limb, Some(6), "{pattern}");
        for limb in &seen.figures.limbs {
            assert_eq!(limb.sphere_count, Some(6.0), "{pattern}");
            for sphere in &limb.spheres {
                let x_hat = sphere.value(Figure::Indentation).unwrap();
                assert!((x_hat - 0.353).abs() < 5e-4, "{pattern}: {x_hat}");
            }
        }
    }
    let some = options_selecting("contact_s1_*").inspect("human.osim", &model, None);
    assert_eq!(some.figures.spheres().count(), 2, "figures are those of chosen spheres alone");
}

#[test]
fn a_falling_body_has_the_same_weight_on_chosen_spheres() {
    let model = Model::parse(HUMAN).unwrap();
    let failed = |fault: Fault| Failure::outside("human.osim", "plot", fault.to_string());
    for pattern in ["*", "contact_s1_*", "contact_s3_r"] {
        let body = ContactBody::from_inspected_model(
            "human".to_owned(),
            &model,
            &options_selecting(pattern),
            &failed,
        )
        .unwrap();
        let weight = body.weight().unwrap();
        let carried: f64 = weight.spheres.iter().map(contact_scaling::Spheres::count).sum();
        assert_eq!((weight.sphere_count, carried), (6.0, 6.0), "{pattern}");
    }
}

#[test]
fn a_body_that_only_ground_connects_does_not_count() {
    let model = Model::parse(PLAYER_AND_BALL).unwrap();
    let named = |names: &[&str]| -> Vec<ForceId> {
        let chosen = model.forces().iter().filter(|force| names.contains(&force.name.as_str()));
        chosen.map(|force| force.id).collect()
    };
    // The kick is between foot and ball: it belongs to both, and presses no sphere on the floor.
    let feet = ["contact_heel_r", "contact_toe_r", "contact_heel_l", "contact_toe_l", "kick"];
    assert_eq!(model.forces_of_same_body(&named(&["ball_floor"])), named(&["ball_floor", "kick"]));
    assert_eq!(model.forces_of_same_body(&named(&["contact_toe_l"])), named(&feet));
    let sharing = LoadSharing::of(&model, &named(&["contact_toe_l"]));
    assert_eq!(sharing.count(None, 1.0, CountedSpheres::Model), Ok(2.0));
    assert!(model.forces_of_same_body(&[]).is_empty());
}

#[test]
fn a_sphere_count_is_given_or_found_or_asked_for() {
    let human = Model::parse(HUMAN).unwrap();
    let sharing = LoadSharing::of(&human, &ids_of_forces(&human, "_r"));
    assert_eq!(sharing.limbs.if_known().map(<[_]>::len), Some(2));
    assert_eq!(sharing.count(None, 1.0, CountedSpheres::Model), Ok(6.0));
    assert_eq!(sharing.count(None, 2.0, CountedSpheres::Model), Ok(12.0));
    assert_eq!(sharing.count(Some(5.0), 2.0, CountedSpheres::Model), Ok(5.0));

    let unequal = Model::parse(UNEQUAL_SPHERE_COUNTS).unwrap();
    let sharing = LoadSharing::of(&unequal, &unequal.force_ids());
    let asked = sharing.count(None, 1.0, CountedSpheres::Reference).unwrap_err();
    assert_eq!(asked.code(), "sphere-count");
    // Figures are given for each limb all the same.
    let limbs = sharing.limbs.if_known().unwrap();
    let counts: Vec<f64> = limbs.iter().map(|limb| LoadSharing::count_on_limb(limb, None, 1.0)).collect();
    let spheres: Vec<usize> = limbs.iter().map(|limb| limb.spheres.len()).collect();
    assert!(spheres[0] != spheres[1]);
    assert_eq!(counts, [spheres[0] as f64, spheres[1] as f64]);
    assert_eq!(LoadSharing::count_on_limb(&limbs[0], Some(7.0), 2.0), 7.0);
}

#[test]
fn a_count_of_less_than_one_sphere_gives_no_figures() {
    let model = Model::parse(HUMAN).unwrap();
    let stance = Stance { spheres: Some(0.5), ..Stance::default() };
    let seen = InspectOptions { stance, ..InspectOptions::default() }.inspect("human.osim", &model, None);
    assert!(seen.figures.limbs.iter().all(|limb| limb.sphere_count.is_none()));
    assert!(seen.figures.spheres().all(|sphere| sphere.value(Figure::Load).is_none()));
}

#[test]
fn a_limb_stands_level_on_all_its_spheres() {
    // A larger heel: spheres of two sizes do not share a load equally where they stand level.
    let from = HUMAN.find("<ContactSphere name=\"s1_r\">").unwrap();
    let (before, after) = HUMAN.split_at(from);
    let text = format!("{before}{}", after.replacen("<radius>0.032", "<radius>0.048", 1));
    assert_ne!(text, HUMAN);
    let model = Model::parse(text).unwrap();
    let level = |pattern: &str| {
        let seen = options_selecting(pattern).inspect("human.osim", &model, None);
        let figures = seen.figures;
        let speed = figures.impact_speed_m_s;
        let sphere = figures.spheres().find(|sphere| sphere.sphere == "s2_r").unwrap();
        (sphere.value(Figure::LevelIndentation).unwrap(), sphere.value(Figure::Indentation).unwrap(), speed)
    };
    let (all, some) = (level("*"), level("contact_s2_r"));
    assert_eq!(all, some);
    // The larger heel carries more than its share, so that the others sink in less.
    assert!(all.0 < all.1, "{all:?}");
    // Level, x = (F / (4/3 E* sum of sqrt(R)))^(2/3), with F = 62 kg x 9.81 m/s2 on 5 spheres of 0.032 m and one of 0.048 m.
    let composite = 1e6 / 2_f64.powf(1.5);
    let roots = 5.0 * 0.032_f64.sqrt() + 0.048_f64.sqrt();
    let x = (62.0 * 9.81 / (4.0 / 3.0 * composite * roots)).powf(2.0 / 3.0);
    assert!((all.0 - x / 0.032).abs() < 1e-9, "{} and {}", all.0, x / 0.032);
}
