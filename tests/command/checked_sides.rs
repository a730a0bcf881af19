//! `check --from`: which side of a model is the slip.

use crate::checked::{Report, report};
use crate::support::Bench;

/// Nobody's contacts, all of the left ten times stiffer: only the model that it was made from shows which side is the slip.
#[test]
fn the_reference_shows_which_side_is_the_slip() {
    let bench = Bench::with(&[("scale_tool/generic_smooth.osim", "published.osim")]);
    bench.run("set published.osim stiffness=x1.3 dissipation=x1.2 --no-note -o own.osim").done();
    bench.run("set own.osim stiffness=x10 --select *_l --no-note -o slip.osim").done();
    let differ = |report: &Report| {
        let of_sides = report.findings.iter().find(|finding| finding.code == "left-right-differ");
        of_sides.unwrap().message.clone()
    };
    let (alone, compared) = (report(&bench, "slip.osim"), report(&bench, "slip.osim --from own.osim"));
    let copies = |report: &Report| report.commands.iter().any(|command| command.contains(" set slip.osim"));
    assert!(!differ(&alone).contains("is the odd one") && !copies(&alone), "{}", differ(&alone));
    let expected =
        "the one on the left is the odd one, since the contacts on the right are those of own.osim";
    assert!(differ(&compared).ends_with(expected), "{}", differ(&compared));
    let advised = compared.commands.iter().find(|command| command.contains("set slip.osim")).unwrap();
    bench.run(advised.strip_prefix("osim-contact-scale ").unwrap()).done();
}

/// What nobody may set is not proposed.
#[test]
fn no_number_that_is_none_is_proposed_for_the_other_side() {
    let bench = Bench::with(&[("table1/human_62kg_smooth_sphere.osim", "model.osim")]);
    let (text, tag) = (bench.text("model.osim"), "<transition_velocity>");
    // The first force is one of the right side, which the left would be made like.
    let at = text.find(tag).unwrap() + tag.len();
    let end = at + text[at..].find('<').unwrap();
    bench.write("model.osim", format!("{}nan{}", &text[..at], &text[end..]));
    let found = bench.run("check model.osim").out();
    assert!(found.contains("not-finite") && !found.contains("transition_velocity=NaN"), "{found}");
}
