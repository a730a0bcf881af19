//! Tests of reading: for each peculiarity of the file format, the values that OpenSim 4.6 uses, as `fixtures/README.md` describes them.
//!
//! The expected numbers are those with which the fixtures were written (see `fixtures/quirks/`). `tests/oracle` compared them with OpenSim
//! itself.

#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic, reason = "a test fails by panicking")]

use osim_model::{
    Companion, Document, Irregularity, Limbs, Model, Property, Selection, SetId, ValueOrigin,
    are_equal_masses, rounding_of_places_m,
};

/// The stiffness and radius in the fixtures of `format/`: a foot of 61.5 kg on a sphere of radius 0.0325 m.
const STIFFNESS_OF_FILE: f64 = 1_234_567.8;
const RADIUS_OF_FILE: f64 = 0.0325;

/// Bytes of a file in `fixtures/`.
#[track_caller]
fn fixture(name: &str) -> Vec<u8> {
    let path = format!("{}/../../fixtures/{name}", env!("CARGO_MANIFEST_DIR"));
    std::fs::read(&path).unwrap_or_else(|error| panic!("fixtures/{name}: {error}"))
}

#[track_caller]
fn fixture_model(name: &str) -> Model {
    Model::parse(fixture(name)).unwrap_or_else(|fault| panic!("{name}: {fault}"))
}

#[track_caller]
fn read<T>(file: &str, then: impl FnOnce(&Model) -> T) -> T {
    then(&fixture_model(&format!("format/{file}.osim")))
}

/// The effective value of `property` in the first force; for a radius, in the first sphere of the force.
fn value_in_first_force(model: &Model, property: Property) -> (f64, ValueOrigin) {
    let force = &model.forces()[0];
    let value = match property {
        Property::Radius => &model.sphere(force.spheres()[0]).unwrap().radius,
        property => force.value(SetId::FIRST, property).unwrap(),
    };
    (value.number, value.origin)
}

#[track_caller]
fn assert_property(file: &str, property: Property, expected: f64, origin: ValueOrigin) {
    let seen = read(file, |model| value_in_first_force(model, property));
    assert_eq!(seen, (expected, origin), "{property} of {file}");
}

#[test]
fn numbers_are_read_as_opensim_reads_them() {
    for (file, expected) in [
        ("number_plus_sign", 8e6),
        ("number_bare_point", 0.5e6),
        ("number_trailing_point", 2e6),
        ("number_padded", 1e4),
        ("number_entity", 1e6),
        ("number_cdata", 3e6),
        ("number_after_comment", 4e6),
        ("number_before_comment", 4e6),
        ("number_instruction", 4e6),
        ("number_exponent_reference", 1e6),
        ("number_long", 1e6),
        ("markup_upper_case_tag", STIFFNESS_OF_FILE),
        ("markup_nested_property", STIFFNESS_OF_FILE),
        ("markup_commented_force", STIFFNESS_OF_FILE),
        ("markup_blanks_in_tags", STIFFNESS_OF_FILE),
        ("markup_more_attributes", STIFFNESS_OF_FILE),
        ("markup_same_tags_elsewhere", STIFFNESS_OF_FILE),
        ("duplicate_stiffness", STIFFNESS_OF_FILE),
        ("duplicate_objects", STIFFNESS_OF_FILE),
        ("duplicate_forceset", STIFFNESS_OF_FILE),
    ] {
        assert_property(file, Property::Stiffness, expected, ValueOrigin::Element);
    }
    assert_property("number_17_digits", Property::StaticFriction, 0.8, ValueOrigin::Element);
}

#[test]
fn the_first_of_duplicate_elements_counts() {
    read("duplicate_radius_and_mass", |model| {
        assert_eq!(value_in_first_force(model, Property::Radius).0, 0.041);
        assert_eq!(model.bodies()[0].mass.number, 62.25);
        assert_eq!(model.gravity(), Some(9.5));
    });
    for file in ["duplicate_forceset", "duplicate_objects", "markup_commented_force"] {
        assert_eq!(read(file, |model| model.forces().len()), 1, "{file}");
    }
    assert_eq!(read("duplicate_model", |model| model.name.clone()), "one_foot");
}

#[test]
fn contact_parameters_are_found_in_all_their_spellings() {
    for file in [
        "parameters_in_wrapper",
        "parameters_named",
        "parameters_unnamed",
        "parameters_empty_name",
        "parameters_named_wins",
        "parameters_twice",
        "parameters_commented_first",
        "components_hunt_crossley",
        "v20001",
    ] {
        assert_property(file, Property::Stiffness, STIFFNESS_OF_FILE, ValueOrigin::Element);
    }
    assert_property("parameters_wrapper_wins", Property::Stiffness, 77.0, ValueOrigin::Element);
    read("parameters_misnamed", |model| {
        assert!(model.forces()[0].sets.is_empty());
        let said = &model.irregularities;
        assert!(said.iter().any(|one| matches!(one, Irregularity::MisnamedSet { .. })), "{said:?}");
    });
}

#[test]
fn defaults_replace_missing_elements() {
    assert_property("defaults_smooth", Property::HertzSmoothing, 111.0, ValueOrigin::Defaults);
    assert_property("defaults_smooth", Property::Dissipation, 2.25, ValueOrigin::Element);
    assert_property("defaults_contact_parameters", Property::Stiffness, 765_432.1, ValueOrigin::Defaults);
    assert_property("defaults_contact_parameters", Property::Dissipation, 1.75, ValueOrigin::Defaults);
    assert_property("defaults_sphere_radius", Property::Radius, 0.044, ValueOrigin::Defaults);
    assert_eq!(read("defaults_body_mass", |model| model.bodies()[0].mass.number), 58.5);
    assert_property("defaults_twice", Property::HertzSmoothing, 111.0, ValueOrigin::Defaults);
    assert_property("defaults_after_forces", Property::HertzSmoothing, 111.0, ValueOrigin::Defaults);
    // These do not count.
    assert_property("defaults_after_model", Property::HertzSmoothing, 300.0, ValueOrigin::ClassDefault);
    assert_property("defaults_in_forceset", Property::HertzSmoothing, 300.0, ValueOrigin::ClassDefault);
    assert_property("defaults_of_materials_only", Property::Dissipation, 0.0, ValueOrigin::ClassDefault);
    assert!(!read("defaults_applies_force", |model| model.forces()[0].applies));
}

#[test]
fn defaults_give_surfaces_and_sockets_too() {
    for file in [
        "defaults_comment_only",
        "defaults_self_closing_material",
        "defaults_hunt_crossley",
        "defaults_hold_everything",
    ] {
        read(file, |model| {
            assert_eq!(model.forces().len(), 1, "{file}");
            assert_eq!(value_in_first_force(model, Property::Stiffness).0, STIFFNESS_OF_FILE, "{file}");
            assert_eq!(value_in_first_force(model, Property::Radius).0, RADIUS_OF_FILE, "{file}");
        });
    }
}

#[test]
fn class_defaults_are_those_of_opensim() {
    assert_property("left_out_smoothing", Property::ConstantContactForce, 1e-5, ValueOrigin::ClassDefault);
    assert_property("left_out_smoothing", Property::HertzSmoothing, 300.0, ValueOrigin::ClassDefault);
    assert_property("left_out_smoothing", Property::HuntCrossleySmoothing, 50.0, ValueOrigin::ClassDefault);
    assert_property("left_out_stiffness", Property::Stiffness, 1.0, ValueOrigin::ClassDefault);
    assert_property(
        "left_out_transition_velocity",
        Property::TransitionVelocity,
        0.01,
        ValueOrigin::ClassDefault,
    );
    for (file, gravity) in [("left_out_gravity", 9.80665), ("no_gravity", 0.0), ("gravity_sideways", 3.71)] {
        read(file, |model| assert_eq!(model.gravity(), Some(gravity), "{file}"));
    }
}

#[test]
fn forces_and_spheres_are_found_wherever_they_stand() {
    for (file, force, sphere) in [
        ("components_force", "/contact_heel_r", "/contactgeometryset/heel_r"),
        ("components_force_and_sphere", "/contact_heel_r", "/heel_r"),
        ("components_in_body", "/bodyset/calcn_r/contact_heel_r", "/bodyset/calcn_r/heel_r"),
        ("components_deep", "/bodyset/calcn_r/sole/contact_heel_r", "/bodyset/calcn_r/sole/heel_r"),
        ("components_of_forceset", "/forceset/contact_heel_r", "/contactgeometryset/heel_r"),
        ("set_named_otherwise", "/forceset/contact_heel_r", "/contactgeometryset/heel_r"),
        ("set_unnamed", "/forceset/contact_heel_r", "/contactgeometryset/heel_r"),
        ("geometry_by_component_path", "/forceset/contact_heel_r", "/bodyset/calcn_r/heel_r"),
        ("geometry_by_component_name", "/forceset/contact_heel_r", "/heel_r"),
    ] {
        read(file, |model| {
            assert_eq!(model.forces().len(), 1, "{file}");
            let of_force = &model.sphere(model.forces()[0].spheres()[0]).unwrap();
            assert_eq!(
                (model.forces()[0].path.as_str(), of_force.path.as_str(), of_force.body.as_deref()),
                (force, sphere, Some("calcn_r")),
                "{file}"
            );
        });
    }
    let refused = read("components_unknown_class", |model| Selection::default().apply(model).unwrap_err());
    assert_eq!(refused.code(), "no-contacts");
}

#[test]
fn surfaces_are_recognised_by_class_not_by_name_or_order() {
    for file in [
        "geometry_half_space_last",
        "geometry_half_space_called_platform",
        "geometry_half_space_called_ground",
        "geometry_by_path",
        "geometry_by_relative_path",
        "geometry_many_blanks",
        "connectee_relative_sphere",
        "connectee_padded",
        "frame_of_half_space",
        "other_geometry",
    ] {
        read(file, |model| {
            let set = &model.forces()[0].sets[0];
            assert_eq!((set.spheres.len(), set.half_spaces), (1, 1), "{file}");
            assert_eq!(model.sphere(set.spheres[0]).unwrap().name, "heel_r", "{file}");
            assert_eq!(Selection::default().apply(model).unwrap().forces, model.force_ids(), "{file}");
        });
    }
    // The component counts before the member of the set of the same name.
    assert_property("geometry_two_of_a_name", Property::Radius, 0.055, ValueOrigin::Element);
    let fault = Model::parse(fixture("format/geometry_unknown.osim")).unwrap_err();
    assert_eq!(fault.code(), "unresolved");
    assert!(fault.to_string().contains("'heel_l'") && fault.position.is_some(), "{fault}");
}

#[test]
fn frames_lead_to_their_body_in_every_spelling() {
    for file in [
        "connectee_relative",
        "connectee_padded",
        "frame_on_body",
        "frame_in_joint",
        "frame_on_frame",
        "v20001",
        "v20302",
        "v30000",
        "v30500",
        "v30505",
        "v30508",
        "v30509",
        "v30510",
        "v30516",
        "v30517",
        "v40000",
        "v40500",
        "v40600",
        "v49999_newer",
    ] {
        read(file, |model| {
            let sphere = &model.sphere(model.forces()[0].spheres()[0]).unwrap();
            assert_eq!(sphere.body.as_deref(), Some("calcn_r"), "{file}");
            assert!(!sphere.fixed, "{file}");
            assert_eq!(sphere.radius.number, RADIUS_OF_FILE, "{file}");
            let limbs = model.limbs(&model.force_ids()[..1]);
            assert_eq!(limbs.if_known().map(<[_]>::len), Some(1), "{file}: {limbs:?}");
        });
    }
    // OpenSim 4.6 does not find these; the only component of that name is taken, and it is said.
    for file in ["connectee_one_up", "connectee_bare", "connectee_bare_sphere", "geometry_by_nested_name"] {
        read(file, |model| {
            let sphere = &model.sphere(model.forces()[0].spheres()[0]).unwrap();
            assert_eq!(sphere.body.as_deref(), Some("calcn_r"), "{file}");
            let said = &model.irregularities;
            assert!(
                said.iter().any(|one| matches!(one, Irregularity::TakenByName { .. })),
                "{file}: {said:?}"
            );
        });
    }
}

#[test]
fn the_document_version_decides_how_forces_are_switched_off() {
    for (file, expected) in [
        ("applies_force_false", vec![true, false]),
        ("applies_force_odd_text", vec![false]),
        ("applies_force_zero", vec![false]),
        ("applies_force_word", vec![true]),
        ("is_disabled_in_4", vec![true]),
        ("is_disabled_30508", vec![false]),
        ("all_disabled", vec![false]),
        ("v30000_disabled", vec![true, false]),
    ] {
        let applies: Vec<bool> =
            read(file, |model| model.forces().iter().map(|force| force.applies).collect());
        assert_eq!(applies, expected, "{file}");
    }
}

#[test]
fn a_location_is_three_numbers_or_the_origin() {
    for (file, expected) in [
        ("location_commas", [0.01, -0.02, 0.003]),
        ("location_four", [0.0; 3]),
        ("left_out_smoothing", [0.01, -0.02, 0.003]),
    ] {
        let location = read(file, |model| model.sphere(model.forces()[0].spheres()[0]).unwrap().location_m);
        assert_eq!(location, expected, "{file}");
    }
}

/// A limb as its name, its side and the names of its spheres.
type LimbSummary = (String, &'static str, Vec<String>);

fn limbs_of_model(model: &Model) -> Result<Vec<LimbSummary>, String> {
    let selected = Selection::default().apply(model).map_err(|fault| fault.to_string())?;
    match model.limbs(&selected.forces) {
        Limbs::Unknown(why) => Err(why.to_string()),
        Limbs::Known(limbs) => Ok(limbs
            .into_iter()
            .map(|limb| {
                let names =
                    limb.spheres.iter().map(|&sphere| model.sphere(sphere).unwrap().name.clone()).collect();
                (limb.name, limb.side.as_str(), names)
            })
            .collect()),
    }
}

#[test]
fn limbs_are_split_below_bodies_with_left_and_right_limbs() {
    for file in ["v30000_two_feet", "one_force_for_all", "both_classes", "mixed_radii"] {
        let found = read(file, limbs_of_model).unwrap();
        let names = |side: &str| vec![format!("heel_{side}"), format!("toe_{side}")];
        assert_eq!(
            found,
            [("calcn_r".to_owned(), "right", names("r")), ("calcn_l".to_owned(), "left", names("l"))],
            "{file}"
        );
    }
    // The limb is named by the first body below the split, though that may carry no sphere.
    let found = read("massless_inner_body", limbs_of_model).unwrap();
    assert_eq!((found[0].0.as_str(), found[1].0.as_str()), ("hip", "calcn_l"));
    let found = limbs_of_model(&fixture_model("table1/human_62kg_smooth_sphere.osim"));
    let found: Vec<_> =
        found.unwrap().into_iter().map(|(name, side, spheres)| (name, side, spheres.len())).collect();
    assert_eq!(found, [("femur_r".to_owned(), "right", 6), ("femur_l".to_owned(), "left", 6)]);
    for (animal, limbs_expected, spheres) in [
        ("mouse", 4, 1),
        ("emu_10_spheres", 2, 10),
        ("emu_2_spheres", 2, 2),
        ("horse", 4, 5),
        ("giraffe", 4, 4),
    ] {
        for class in ["hunt_crossley", "smooth_sphere"] {
            let file = format!("table1/{animal}_{class}.osim");
            let found = limbs_of_model(&fixture_model(&file)).unwrap();
            let counts: Vec<usize> = found.iter().map(|(_, _, spheres)| spheres.len()).collect();
            assert_eq!(counts, vec![spheres; limbs_expected], "{file}");
        }
    }
}

#[test]
fn unknown_limbs_have_a_reason() {
    assert!(read("no_sides", limbs_of_model).unwrap_err().contains("calcn_a"));
    assert!(read("player_and_ball", limbs_of_model).unwrap_err().contains("joined only through ground"));
    assert!(read("all_disabled", limbs_of_model).is_err());
    let per_limb = read("unequal_counts", |model| {
        let selected = Selection::default().apply(model).unwrap();
        model.limbs(&selected.forces).spheres_per_limb()
    });
    assert!(per_limb.unwrap_err().to_string().contains("has 3"));
    let player = read("player_and_ball", |model| Selection::default().apply(model).unwrap_err());
    assert_eq!(player.code(), "several-trees");
    assert!(player.to_string().contains("`select`"), "{player}");
}

#[test]
fn masses_are_summed_in_file_order_without_ground_and_fixed_bodies() {
    for (file, kg) in [
        ("left_out_smoothing", 61.5),
        ("v20001", 61.5),
        ("v40000", 53.0),
        ("v30000_two_feet", 53.0),
        ("terrain_welded", 53.0),
    ] {
        let mass = read(file, |model| osim_model::MassRequest::default().model_mass(model).unwrap().kg);
        assert_eq!(mass, kg, "{file}");
    }
}

#[test]
fn included_files_are_named() {
    let bytes = fixture("format/file_both_sets.osim");
    let files: Vec<String> =
        Document::parse(bytes).unwrap().included_files().into_iter().map(|(_, file)| file).collect();
    assert_eq!(files, ["standalone_ForceSet.xml", "standalone_ContactGeometrySet.xml"]);
    let bytes = fixture("format/v40000.osim");
    assert_eq!(Document::parse(bytes).unwrap().included_files(), []);
}

/// The force set of a model as a separate document.
fn force_set_of(text: &str) -> Document {
    let (start, end) = (text.find("<ForceSet").unwrap(), text.find("</ForceSet>").unwrap());
    let set = &text[start..end];
    let text = format!("<OpenSimDocument Version=\"40000\">{set}</ForceSet></OpenSimDocument>");
    Document::parse(text).unwrap()
}

#[test]
fn a_separate_set_replaces_the_set_of_the_model() {
    for file in ["v40000", "floor_of_its_own", "frame_on_body", "connectee_relative"] {
        let text = String::from_utf8(fixture(&format!("format/{file}.osim"))).unwrap();
        let alone = Model::parse(text.as_str()).unwrap();
        // As geometry or as the model that it belongs to, and as both.
        for times in [1, 2] {
            let beside = Companion { document: Document::parse(text.as_str()).unwrap(), included_by: None };
            let read = Model::read_with(force_set_of(&text), vec![beside; times]).unwrap();
            let spheres = |model: &Model| -> Vec<_> {
                let each = model.spheres().iter();
                each.map(|sphere| (sphere.path.clone(), sphere.body.clone(), sphere.radius.number)).collect()
            };
            let forces = |model: &Model| -> Vec<_> {
                let each = model.forces().iter();
                each.map(|force| (force.path.clone(), force.spheres().to_vec(), force.applies)).collect()
            };
            assert_eq!(spheres(&read), spheres(&alone), "{file}, {times} times");
            assert_eq!(forces(&read), forces(&alone), "{file}, {times} times");
            let bodies = |model: &Model| -> Vec<_> {
                model.bodies().iter().map(|body| (body.name.clone(), body.mass_kg().unwrap())).collect()
            };
            assert_eq!(bodies(&read), bodies(&alone), "{file}, {times} times");
            assert_eq!(read.joints().len(), alone.joints().len(), "{file}, {times} times");
            assert_eq!(read.gravity(), alone.gravity(), "{file}, {times} times");
        }
    }
}

#[test]
fn gravity_comes_from_the_model_and_not_from_the_geometry_file() {
    let text = String::from_utf8(fixture("format/v40000.osim")).unwrap();
    let beside = |gravity: &str| {
        let text =
            text.replace("<gravity>0 -9.81 0</gravity>", &format!("<gravity>0 -{gravity} 0</gravity>"));
        Companion { document: Document::parse(text).unwrap(), included_by: None }
    };
    let read = Model::read_with(force_set_of(&text), vec![beside("1.62"), beside("9.81")]).unwrap();
    assert_eq!(read.gravity(), Some(9.81));
    assert_eq!(read.gravity_position(), Model::parse(text.as_str()).unwrap().gravity_position());
}

/// A body of 100 kg and one of 102.01 kg differ by 2.01 % of the first and 1.97 % of the second.
#[test]
fn masses_are_equal_whichever_comes_first() {
    for (other_kg, are_equal) in [(102.0, true), (98.1, true), (102.01, false), (98.0, false)] {
        assert_eq!(are_equal_masses(100.0, other_kg), are_equal);
        assert_eq!(are_equal_masses(other_kg, 100.0), are_equal);
    }
}

#[test]
fn frames_at_stations_that_are_on_themselves_or_each_other_are_refused() {
    let text = String::from_utf8(fixture("format/v40000.osim")).unwrap();
    let frame = |name: &str, on: &str| {
        let stations = [("a", "0 0 0"), ("b", "1 0 0"), ("c", "0 1 0")].map(|(point, at)| {
            let parent = format!("<socket_parent_frame>{on}</socket_parent_frame>");
            format!("<Station name=\"{name}{point}\">{parent}<location>{at}</location></Station>")
        });
        let sockets = [("point_a", "a"), ("point_b", "b"), ("point_c", "c"), ("origin_point", "a")]
            .map(|(socket, point)| format!("<socket_{socket}>/{name}{point}</socket_{socket}>"));
        let (stations, sockets) = (stations.concat(), sockets.concat());
        format!("{stations}<StationDefinedFrame name=\"{name}\">{sockets}</StationDefinedFrame>")
    };
    let model = |one: &str, other: &str| {
        let frames = frame("one", one) + &frame("other", other);
        let text = text.replacen("<gravity>", &format!("<components>{frames}</components><gravity>"), 1);
        Model::parse(text.replacen("<socket_frame>/bodyset/calcn_r<", "<socket_frame>/one<", 1))
    };
    assert!(model("/bodyset/calcn_r", "/bodyset/calcn_l").is_ok());
    for (one, other) in [("/one", "/bodyset/calcn_l"), ("/other", "/one"), ("/other", "/bodyset/calcn_l")] {
        let fault = model(one, other).unwrap_err().to_string();
        assert!(fault.contains("the points of /one are not found"), "{one}, {other}: {fault}");
    }
}

/// Scripts write four decimals, or four significant digits; the last one of the largest number counts.
#[test]
fn places_with_few_digits_are_rounded() {
    for (place_m, unit_m) in [
        ([0.1335, -0.0093, 0.0017], 1e-4),
        ([0.1335, -0.0093, 0.001711], 1e-4),
        ([0.134, -0.0093, 0.00171], 1e-3),
        ([0.133547, -0.0093, 0.001711], 0.0),
        ([0.13, -0.01, 0.05], 0.0),
        ([0.0; 3], 0.0),
    ] {
        let rounding_m = rounding_of_places_m([place_m].into_iter());
        assert!((rounding_m - 0.5 * unit_m).abs() < 1e-8, "{place_m:?}: {rounding_m}");
    }
}
