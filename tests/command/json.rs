//! Reads the JSON of each verb strictly, so that a new, missing or changed field fails a test.

use serde_json::Value;

use crate::bytes::assert_close;
use crate::json_types::{Failure, Inspection, Plan, SphereFigures};
use crate::support::{CommandRun, HUMAN, TestDir};

/// The JSON objects that a run prints: one object on each line, and no other text on standard output.
#[track_caller]
pub(crate) fn json_lines<T: serde::de::DeserializeOwned>(run: &CommandRun) -> Vec<T> {
    let out = run.out();
    assert!(out.ends_with('\n'), "{out}");
    out.lines()
        .map(|line| serde_json::from_str(line).unwrap_or_else(|error| panic!("{error}: {line}")))
        .collect()
}

const SMOOTH_PARAMETERS: [&str; 9] = [
    "constant_contact_force",
    "dissipation",
    "dynamic_friction",
    "hertz_smoothing",
    "hunt_crossley_smoothing",
    "static_friction",
    "stiffness",
    "transition_velocity",
    "viscous_friction",
];

/// Under the weight of the 62 kg human, its six level spheres have x/R 0.3396 (from OpenSim with Falisse's smoothing).
#[test]
fn inspect_reports_the_standing_pose() {
    let dir = TestDir::with_human();
    let run = dir.run("inspect human.osim --format json").succeeded().wrote_nothing();
    let [inspection]: [Inspection; 1] = json_lines(&run).try_into().unwrap();
    let [body] = &inspection.standing[..] else { panic!("one body: {:?}", inspection.standing) };
    assert_eq!((body.body.as_str(), body.coordinate.as_deref()), ("pelvis", Some("pelvis_ty")));
    assert_eq!((inspection.why_no_standing, &body.why_no_coordinate), (None, &None));
    assert!(body.joint.is_some());
    let (mass, weight) = (body.mass_kg.unwrap(), body.weight_n.unwrap());
    assert!((mass - 62.0).abs() < 1e-9 && (weight - 62.0 * 9.81).abs() < 1e-6);
    let lowest = body.bottoms.iter().map(|one| one.height_m).fold(f64::INFINITY, f64::min);
    assert!((body.default_m.unwrap() - lowest - body.touching_m.unwrap()).abs() < 1e-12);
    let one = body.on_one_limb.as_ref().unwrap();
    assert_eq!((one.limb.as_deref(), one.carried, one.spheres.len()), (Some("femur_r"), true, 6));
    let carried: f64 = one.spheres.iter().map(|sphere| sphere.force_n).sum();
    assert!((carried - weight).abs() < 1e-6 && (one.load_n - weight).abs() < 1e-9);
    assert!((body.default_m.unwrap() - one.down_m - one.value_m.unwrap()).abs() < 1e-12);
    for (sphere, bottom) in one.spheres.iter().zip(&body.bottoms) {
        assert_eq!((&sphere.sphere, &sphere.path), (&bottom.sphere, &bottom.path));
        assert!(bottom.tilt_rad < 1e-6, "feet are flat: {bottom:?}");
        assert!(
            (sphere.relative_indentation - 0.3396).abs() < 5e-5 && bottom.radius_m == 0.032,
            "{sphere:?}"
        );
    }
    let all = body.as_posed.as_ref().unwrap();
    assert_eq!((&all.limb, all.carried, all.spheres.len()), (&None, true, 12));
}

#[test]
fn inspect_reports_spheres_forces_and_bodies() {
    let dir = TestDir::with_human();
    let run = dir.run("inspect human.osim --format json").succeeded().wrote_nothing();
    let [inspection]: [Inspection; 1] = json_lines(&run).try_into().unwrap();
    assert_eq!(
        (inspection.schema_version, inspection.model.as_str(), inspection.document_version),
        (1, "human.osim", 40000)
    );
    assert_eq!(
        (inspection.name.as_str(), inspection.mass_kg, inspection.gravity_m_s2),
        ("human_62kg", Some(62.0), Some(9.81))
    );
    let known_contacts = inspection.known_contacts.unwrap();
    assert_eq!((known_contacts.name.as_str(), known_contacts.made_for_kg), ("falisse2022", 62.0));
    assert!(known_contacts.title == "Falisse et al. (2022)" && known_contacts.source.contains("PLoS ONE"));
    let mass = inspection.contacts_mass_kg.unwrap();
    assert_eq!((mass.value, mass.source.as_str()), (62.0, "bodies"));
    let limbs = inspection.limbs.unwrap();
    let sides: Vec<_> =
        limbs.iter().map(|limb| (limb.name.as_str(), limb.side.as_str(), limb.spheres.len())).collect();
    assert_eq!(sides, [("femur_r", "right", 6), ("femur_l", "left", 6)]);
    assert_eq!((inspection.spheres_per_limb, inspection.limbs_unknown), (Some(6), None));
    assert_eq!(inspection.stance_limbs, 1.0);
    assert!(inspection.note.is_none());
    assert_eq!((inspection.spheres.len(), inspection.forces.len(), inspection.bodies.len()), (12, 12, 9));
    let text = dir.text("human.osim");
    let line = |number: usize| text.lines().nth(number - 1).unwrap();
    for sphere in &inspection.spheres {
        assert_eq!(sphere.radius_m, Some(0.032));
        assert_eq!(sphere.path, format!("/contactgeometryset/{}", sphere.name));
        assert_eq!(sphere.frame, format!("/bodyset/{}", sphere.body.as_deref().unwrap()));
        assert!(sphere.location_m.iter().all(|x| x.is_finite()));
        assert!(line(sphere.line).contains(&format!("<ContactSphere name=\"{}\">", sphere.name)));
    }
    for force in &inspection.forces {
        assert_eq!(
            (force.kind.as_str(), force.set, force.applies, force.selected),
            ("SmoothSphereHalfSpaceForce", None, true, true)
        );
        assert_eq!(force.path, format!("/forceset/{}", force.name));
        assert_eq!(force.spheres.len(), 1);
        assert!(line(force.line).contains(&format!("name=\"{}\"", force.name)));
        assert_eq!(force.parameters.keys().collect::<Vec<_>>(), SMOOTH_PARAMETERS);
        assert_eq!(force.origin.keys().collect::<Vec<_>>(), SMOOTH_PARAMETERS);
        // The real OpenSim rests at 0.3533 with these numbers (Table 1 prints 0.353).
        let dimensionless = force.dimensionless.as_ref().unwrap();
        assert!((dimensionless["relative_indentation"].unwrap() - 0.3533).abs() < 5e-5);
        let value = |name: &str| (force.parameters[name], force.origin[name].as_str());
        assert_eq!(value("stiffness"), (Some(1e6), "element"));
        assert_eq!(value("constant_contact_force"), (Some(1e-5), "class default"));
        assert_eq!(value("hertz_smoothing"), (Some(300.0), "class default"));
    }
    let weight: f64 = inspection.bodies.iter().map(|body| body.mass_kg.unwrap()).sum();
    assert_eq!(weight, 62.0);
    assert!(inspection.bodies.iter().all(|body| body.path == format!("/bodyset/{}", body.name)));
    assert!(inspection.findings.is_empty(), "{:?}", inspection.findings);
}

#[test]
fn figures_refer_to_the_spheres_and_forces_of_the_model() {
    for model in ["table1/human_62kg_smooth_sphere.osim", "format/mixed_radii.osim", "format/no_sides.osim"] {
        let dir = TestDir::with(&[(model, "model.osim")]);
        let [inspection]: [Inspection; 1] =
            json_lines(&dir.run("inspect model.osim --format json --impact-speed 0.3").succeeded())
                .try_into()
                .unwrap();
        let figures = inspection.figures;
        assert_eq!(
            (figures.mass_kg, figures.gravity_m_s2, figures.impact_speed_m_s),
            (inspection.mass_kg, Some(9.81), Some(0.3))
        );
        assert_eq!(figures.why_no_body_weight.is_some(), inspection.limbs.is_none(), "{model}");
        for limb in figures.limbs {
            assert_eq!(limb.limb.is_some(), limb.side.is_some());
            assert_eq!(limb.sphere_count, inspection.spheres_per_limb.map(|count| count as f64));
            for one in limb.spheres {
                let sphere = inspection.spheres.iter().find(|sphere| sphere.path == one.path).unwrap();
                assert_eq!((&sphere.name, sphere.radius_m), (&one.sphere, Some(one.radius_m)));
                assert_eq!(sphere.limb, limb.limb);
                // These feet are level, and the frames are those of the bodies.
                let [x, y, z] = sphere.location_m;
                assert_eq!(sphere.lowest_point_m, Some([x, y - one.radius_m, z]));
                let force = inspection.forces.iter().find(|force| force.name == one.forces[0]).unwrap();
                assert!(force.spheres.contains(&one.sphere));
                assert_eq!(force.composite_modulus_n_m2, Some(one.composite_modulus_n_m2));
                assert_eq!(one.dissipation_s_m, force.parameters["dissipation"]);
                check_figures(&one, limb.sphere_count.is_some());
            }
        }
    }
}

/// Checks the computed numbers of a sphere. The numbers under body weight are all present or all absent, and so are the numbers about
/// smoothing. Each limit is the limit in the paper, and the verdict follows from the value.
#[track_caller]
fn check_figures(sphere: &SphereFigures, weight: bool) {
    let all = |values: &[Option<f64>], known_contacts: bool| {
        values.iter().all(|value| value.is_some() == known_contacts)
    };
    assert!(all(
        &[
            sphere.contact_stiffness_n_m,
            sphere.dimensionless_stiffness,
            sphere.natural_frequency_hz,
            sphere.mean_contact_stress_n_m2
        ],
        weight
    ));
    assert!(all(
        &[
            sphere.load_n,
            sphere.relative_indentation_hertz,
            sphere.relative_indentation_model_law,
            sphere.relative_indentation_hertz_level,
            sphere.relative_indentation_model_law_level,
            sphere.relative_indentation_hertz_standing,
            sphere.relative_indentation_model_law_standing,
            sphere.relative_indentation_hertz_at_two,
            sphere.relative_indentation_model_law_at_two,
            sphere.relative_indentation_hertz_level_at_two,
            sphere.relative_indentation_model_law_level_at_two,
        ],
        weight
    ));
    assert!(sphere.relative_indentation_hertz_at_two >= sphere.relative_indentation_hertz);
    let smooth = sphere.constant_indentation.is_some();
    assert!(all(&[sphere.transition_width, sphere.force_just_touching_n], smooth));
    assert_eq!(sphere.touching_share.is_some(), smooth && weight);
    assert!(sphere.restitution_exact > sphere.restitution_approximate);
    assert!(!sphere.limits.is_empty());
    for check in &sphere.limits {
        let (limit, sign) = match check.figure.as_str() {
            "restitution_approximate" => (0.8, -1.0),
            "constant_indentation" | "touching_share" => (0.1, 1.0),
            "transition_width" => (0.31, 1.0),
            name => {
                assert!(name.starts_with("relative_indentation_"));
                (0.16, 1.0)
            }
        };
        assert_eq!(check.limit, limit, "{}", check.figure);
        assert_eq!(check.within_limit, sign * (check.value.unwrap() - limit) <= 0.0, "{}", check.figure);
    }
}

#[test]
fn a_hunt_crossley_force_has_an_entry_for_each_parameter_set() {
    let dir = TestDir::with(&[("format/three_materials.osim", "model.osim")]);
    let [inspection]: [Inspection; 1] =
        json_lines(&dir.run("inspect model.osim --format json").succeeded()).try_into().unwrap();
    let entries: Vec<_> = inspection
        .forces
        .iter()
        .map(|force| (force.name.as_str(), force.set, force.parameters["stiffness"], force.spheres.clone()))
        .collect();
    let spheres = |name: &str| if name.is_empty() { vec![] } else { vec![name.to_owned()] };
    let expected: Vec<_> = [("contact_r", "heel_r", "toe_r"), ("contact_l", "heel_l", "toe_l")]
        .into_iter()
        .flat_map(|(force, heel, toe)| {
            [
                (force, Some(0), Some(5e6), spheres("")),
                (force, Some(1), Some(1e6), spheres(heel)),
                (force, Some(2), Some(8e5), spheres(toe)),
            ]
        })
        .collect();
    assert_eq!(entries, expected);
    for force in &inspection.forces {
        assert_eq!(force.kind, "HuntCrossleyForce");
        assert_eq!(
            force.parameters.keys().collect::<Vec<_>>(),
            [
                "dissipation",
                "dynamic_friction",
                "static_friction",
                "stiffness",
                "transition_velocity",
                "viscous_friction"
            ]
        );
        assert_eq!(force.parameters["transition_velocity"], Some(0.17));
    }
}

#[test]
fn rescale_lists_every_change() {
    let dir = TestDir::with_human();
    let run =
        dir.run("human.osim --target-mass 1190 --format json").succeeded().wrote(&["human.scaled.osim"]);
    let [plan]: [Plan; 1] = json_lines(&run).try_into().unwrap();
    assert_eq!(
        (plan.schema_version, plan.model.as_str(), plan.output.as_deref()),
        (1, "human.osim", Some("human.scaled.osim"))
    );
    assert_eq!(plan.masses(), (62.0, "bodies", 1190.0));
    assert!(plan.geometry_output.is_none() && !plan.remarks.is_empty());
    assert!(plan.objects.is_empty());
    // Of the result: the first two are new.
    let findings: Vec<_> = plan.findings.iter().map(|one| (one.code.as_str(), one.had_before)).collect();
    assert_eq!(plan.findings.iter().filter(|one| one.as_published).count(), 3);
    let expected = [
        ("mass-sources-disagree", false),
        ("not-on-floor", false),
        ("beyond-hertz", true),
        ("beyond-hunt-crossley", true),
        ("known-contacts", true),
    ];
    assert!(findings.len() == 5 && expected.iter().all(|one| findings.contains(one)), "{findings:?}");
    assert!(plan.findings.iter().all(|one| one.severity == "remark"));
    assert!(plan.credits.unwrap().contains("[contacts made for 1190 kg at 9.81 m/s2 (osim-contact-scale "));
    // Python 3, decimal, 60 digits, from μ = 1190/62.
    let expected = [
        ("radius", "8", 0.032, 2.677_431_841_571_791, false),
        ("stiffness", "10", 1e6, 2.677_431_841_571_791, false),
        ("dissipation", "14", 2.0, 0.611_140_109_991_618_7, false),
        ("constant_contact_force", "C.2", 1e-5, 7.168_641_266_262_512_5, true),
        ("hertz_smoothing", "C.5", 300.0, 0.373_492_234_040_567_86, true),
        ("hunt_crossley_smoothing", "C.10", 50.0, 0.611_140_109_991_618_7, true),
    ];
    assert_eq!(plan.changes.len(), 72);
    let (before, after) = (dir.text("human.osim"), dir.text("human.scaled.osim"));
    for change in &plan.changes {
        let (_, equation, from, factor, inserted) = *expected
            .iter()
            .find(|(name, ..)| *name == change.property)
            .unwrap_or_else(|| panic!("{}", change.property));
        assert_eq!(
            (change.equation.as_str(), change.from, change.inserted, change.set),
            (equation, from, inserted, None)
        );
        assert_close(change.factor.unwrap(), factor, 4e-15, &change.property);
        assert_close(change.to, from * factor, 4e-15, &change.property);
        let radius = change.property == "radius";
        assert_eq!((change.sphere.is_some(), change.force.is_none()), (radius, radius));
        assert!(change.path.ends_with(change.sphere.as_deref().or(change.force.as_deref()).unwrap()));
        let line = before.lines().nth(change.line - 1).unwrap();
        assert!(
            if inserted {
                line.contains("<SmoothSphereHalfSpaceForce")
            } else {
                line.contains(&format!("<{}>", change.property))
            },
            "{line}"
        );
        // What JSON says is what is in the file, bit for bit.
        let written = after.lines().filter(|line| line.trim().starts_with(&format!("<{}>", change.property)));
        assert!(
            written
                .map(crate::bytes::number_between_tags)
                .any(|number| number.to_bits() == change.to.to_bits()),
            "{change:?}"
        );
    }
}

#[test]
fn json_names_the_output_or_null() {
    let dir = TestDir::with_human();
    let plan = |arguments: &str| -> Plan {
        let [plan]: [Plan; 1] = json_lines(&dir.run(arguments).succeeded()).try_into().unwrap();
        plan
    };
    assert_eq!(plan("human.osim --target-mass 5 --format json --dry-run").output, None);
    let same = plan("human.osim --target-mass 62 --format json");
    assert_eq!((same.output.as_deref(), same.changes.len()), (None, 0));
    let (contacts_mass_kg, _, target_mass_kg) = same.masses();
    assert_eq!((contacts_mass_kg, target_mass_kg), (62.0, 62.0));
    assert_eq!(same.findings[0].code, "already-at-target");
    assert!(same.findings[0].line.is_none() && same.findings[0].message.contains("--contacts-mass"));
    assert_eq!(
        plan("human.osim --target-mass 5 --format json -d out").output.as_deref(),
        Some("out/human.osim")
    );
    assert_eq!(
        plan("human.osim --target-mass 5 --format json --in-place").output.as_deref(),
        Some("human.osim")
    );
    assert_eq!(plan("human.osim --target-mass 6 --format json --dry-run").masses().1, "note");
    assert_eq!(
        plan("human.osim --target-mass 6 --contacts-mass 9 --format json --dry-run").masses().1,
        "contacts-mass"
    );
    let preset = plan("transfer human.osim --from falisse2022 --spheres 3 --format json --dry-run");
    assert_eq!((preset.masses().0, preset.masses().1), (62.0, "preset"));
    assert!(preset.changes.iter().all(|change| change.factor.is_none()));
}

#[test]
fn json_has_one_line_for_each_model_also_for_failures() {
    let dir = TestDir::with(&[
        HUMAN,
        ("bad/number_decimal_comma.osim", "comma.osim"),
        ("format/v40000.osim", "feet.osim"),
    ]);
    let run = dir.run("human.osim comma.osim feet.osim nowhere.osim --target-mass 5 --format json").failed();
    let values: Vec<Value> = json_lines(&run);
    let models: Vec<_> = values.iter().map(|value| value["model"].as_str().unwrap()).collect();
    assert_eq!(models, ["human.osim", "comma.osim", "feet.osim", "nowhere.osim"]);
    let failure = |index: usize| -> Failure { serde_json::from_value(values[index].clone()).unwrap() };
    let comma = failure(1);
    assert_eq!(
        (comma.schema_version, comma.model.as_str(), comma.error.code.as_str()),
        (1, "comma.osim", "not-a-number")
    );
    assert!(comma.error.message.contains("1,5e6"));
    let text = dir.text("comma.osim");
    let line = text.lines().nth(comma.error.line.unwrap() - 1).unwrap();
    assert_eq!(&line[comma.error.column.unwrap() - 1..][..5], "1,5e6");
    let nowhere = failure(3);
    assert_eq!(
        (nowhere.error.code.as_str(), nowhere.error.line, nowhere.error.column),
        ("unreadable", None, None)
    );
}

#[test]
fn numbers_that_are_not_finite_are_null_with_a_warning() {
    for (fixture, code) in
        [("bad/number_nan", "not-finite"), ("bad/number_inf", "not-finite"), ("bad/mass_nan", "not-finite")]
    {
        let dir = TestDir::with(&[(&format!("{fixture}.osim"), "model.osim")]);
        let [inspection]: [Inspection; 1] =
            json_lines(&dir.run("inspect model.osim --format json").succeeded()).try_into().unwrap();
        let nulls = inspection
            .forces
            .iter()
            .flat_map(|force| force.parameters.values())
            .filter(|value| value.is_none())
            .count()
            + inspection.bodies.iter().filter(|body| body.mass_kg.is_none()).count();
        assert_eq!(nulls, 1, "{fixture}");
        assert!(
            inspection.findings.iter().any(|finding| finding.code == code && finding.line.is_some()),
            "{fixture}: {:?}",
            inspection.findings
        );
    }
}

#[test]
fn json_and_table_give_the_same_model() {
    let dir = TestDir::with_human();
    dir.run("human.osim --target-mass 1190 -o table.osim").succeeded();
    dir.run("human.osim --target-mass 1190 --format json -o json.osim").succeeded();
    assert_eq!(dir.read("table.osim"), dir.read("json.osim"));
    // A diff goes beside JSON, not into it.
    let run = dir.run("human.osim --target-mass 1190 --format json --diff --dry-run").succeeded();
    let plans: Vec<Plan> = json_lines(&run);
    assert_eq!(plans.len(), 1);
    assert!(run.err().contains("@@"));
}

#[test]
fn added_and_removed_objects_are_listed_with_their_bodies() {
    let dir = TestDir::with(&[("feet/human_40000.osim", "bare.osim"), ("contact_tables/own.csv", "own.csv")]);
    let added = dir
        .run("add bare.osim --from falisse2022 --contacts own.csv -o with.osim --format json")
        .succeeded()
        .wrote(&["with.osim"]);
    let [plan]: [Plan; 1] = json_lines(&added).try_into().unwrap();
    let objects_of = |change: &str, class: &str| -> Vec<(String, Option<String>)> {
        let objects = plan.objects.iter().filter(|object| object.change == change && object.class == class);
        objects.map(|object| (object.name.clone(), object.body.clone())).collect()
    };
    // The rows of own.csv.
    let expected =
        [("heel_r", "calcn_r"), ("ball_r", "calcn_r"), ("heel_l", "calcn_l"), ("ball_l", "calcn_l")];
    let spheres = expected.map(|(name, body)| (name.to_owned(), Some(body.to_owned())));
    assert_eq!(objects_of("added", "ContactSphere"), spheres);
    assert_eq!(objects_of("added", "ContactHalfSpace"), [("floor".to_owned(), None)]);
    assert_eq!(objects_of("added", "SmoothSphereHalfSpaceForce").len(), 4);
    assert_eq!(plan.objects.len(), 9);
    // Numbers of what is added are changes.
    assert!(plan.objects.iter().all(|object| object.parameters.is_none()));
    let heel = plan.objects.iter().find(|object| object.path == "/contactgeometryset/heel_r").unwrap();
    assert_eq!((heel.location_m, heel.radius_m), (Some([0.02, 0.01, -0.005]), Some(0.03)));
    let with_places =
        plan.objects.iter().filter(|object| object.location_m.is_some() || object.radius_m.is_some());
    assert_eq!(with_places.count(), 4);

    let removed =
        dir.run("remove with.osim -o without.osim --format json").succeeded().wrote(&["without.osim"]);
    let [plan]: [Plan; 1] = json_lines(&removed).try_into().unwrap();
    assert_eq!(plan.objects.len(), 9);
    assert!(plan.objects.iter().all(|object| object.change == "removed"));
}
