//! Remedies, in the words of each front end.

use std::path::Path;

use osim_inspect::InspectOptions;
use osim_model::compare::SpherePlacements;
use osim_model::{Anatomy, Pattern};
use osim_planning::check_with_trials;
use osim_requests::Request;
use osim_requests::spell::{CommandLine, FrontEnd, JsonRequest, Page, Python};

use crate::support::open;

const MODELS: [&str; 10] = [
    "check/sunk_in.osim",
    "check/beyond_hertz_at_two.osim",
    "check/beyond_hunt_crossley.osim",
    "check/contacts_of_another_mass.osim",
    "check/floats.osim",
    "check/large_constant_indentation.osim",
    "check/wide_transition.osim",
    "format/left_out_stiffness.osim",
    "format/unequal_stiffness.osim",
    "format/mixed_radii.osim",
];

/// The remedies for the findings of a model, in the words of `front_end`.
fn remedies(options: &InspectOptions, name: &str, front_end: &dyn FrontEnd) -> Vec<String> {
    let model = open(name);
    let inspected = options.inspect(name, &model.model, None);
    let mut found = check_with_trials(options, &model.model, &inspected, &[]);
    found.spell(front_end);
    found.findings.into_iter().filter_map(|finding| finding.command).collect()
}

fn text_of_remedies(options: &InspectOptions, models: &[&str]) -> String {
    let mut review = String::new();
    for name in models {
        let [command, python, page, json] = [&CommandLine as &dyn FrontEnd, &Python, &Page, &JsonRequest]
            .map(|words| remedies(options, name, words));
        for (((command, python), page), json) in command.iter().zip(&python).zip(&page).zip(&json) {
            assert!(!python.contains("--") && !page.contains("--"), "{python}\n{page}");
            // It can be sent back as it is.
            let request = Request::from_json(json.as_bytes()).map(|request| request.to_json());
            assert_eq!(request.as_ref(), Ok(json));
            review.push_str(&format!(
                "command: {command}\npython:  {python}\npage:    {page}\nrequest: {json}\n\n"
            ));
        }
    }
    review
}

#[test]
fn remedies_are_given_in_the_words_of_each_front_end() {
    insta::assert_snapshot!("remedies", text_of_remedies(&InspectOptions::default(), &MODELS));
}

#[test]
fn remedies_say_again_what_was_said_of_the_model() {
    let patterns =
        |texts: &[&str]| -> Vec<Pattern> { texts.iter().map(|text| text.parse().unwrap()).collect() };
    let mut options = InspectOptions::default();
    options.masses.model_kg = Some(700.0);
    options.masses.exclude_bodies = patterns(&["a rider", "saddle"]);
    options.stance.spheres = Some(3.0);
    options.stance.limbs = Some(2.0);
    options.selection.exclude = patterns(&["hand_*"]);
    options.selection.skip_disabled = true;
    options.geometry = Some("my geometry.xml".into());
    insta::assert_snapshot!(
        "remedies_with_options",
        text_of_remedies(
            &options,
            &["check/sunk_in.osim", "check/beyond_hunt_crossley.osim", "format/mixed_radii.osim"]
        )
    );
}

#[test]
fn spheres_follow_by_the_words_of_each_front_end() {
    let model = open("scale_tool/scaled_smooth.osim");
    let original = Anatomy::of(&open("scale_tool/generic_smooth.osim").model).unwrap();
    let options = InspectOptions::default();
    let mut review = String::new();
    for file in [None, Some(Path::new("scale set.xml"))] {
        let mut inspected = options.inspect("scaled.osim", &model.model, None);
        let from = Path::new("generic.osim");
        inspected.placement =
            Some(SpherePlacements::compare(&model.model, from, file, &original, None, None));
        for words in [&CommandLine as &dyn FrontEnd, &Python, &Page, &JsonRequest] {
            let mut found = check_with_trials(&options, &model.model, &inspected, &[]);
            found.spell(words);
            review.push_str(found.findings[0].command.as_deref().unwrap());
            review.push('\n');
        }
    }
    insta::assert_snapshot!("remedies_that_follow", review);
}
