//! `check --from`: finds which side of a model, left or right, is wrong.

use crate::check::{Report, check_report};
use crate::support::TestDir;

/// All left contacts are ten times stiffer than the right ones. Only the original model shows which side is wrong.
#[test]
fn the_reference_shows_which_side_is_wrong() {
    let dir = TestDir::with(&[("scale_tool/generic_smooth.osim", "published.osim")]);
    dir.run("set published.osim stiffness=x1.3 dissipation=x1.2 --no-note -o own.osim").succeeded();
    dir.run("set own.osim stiffness=x10 --select *_l --no-note -o slip.osim").succeeded();
    let difference_message = |report: &Report| {
        let finding = report.findings.iter().find(|finding| finding.code == "left-right-differ");
        finding.unwrap().message.clone()
    };
    let (alone, compared) =
        (check_report(&dir, "slip.osim"), check_report(&dir, "slip.osim --from own.osim"));
    let proposes_set =
        |report: &Report| report.commands.iter().any(|command| command.contains(" set slip.osim"));
    assert!(
        !difference_message(&alone).contains("differs from the others") && !proposes_set(&alone),
        "{}",
        difference_message(&alone)
    );
    let expected =
        "the one on the left differs from the others, since the contacts on the right are those of own.osim";
    assert!(difference_message(&compared).ends_with(expected), "{}", difference_message(&compared));
    let advised = compared.commands.iter().find(|command| command.contains("set slip.osim")).unwrap();
    dir.run(advised.strip_prefix("osim-contact-scale ").unwrap()).succeeded();
}

/// `check` does not propose a value that `set` refuses.
#[test]
fn nan_of_one_side_is_never_proposed_for_the_other_side() {
    let dir = TestDir::with(&[("table1/human_62kg_smooth_sphere.osim", "model.osim")]);
    let (text, tag) = (dir.text("model.osim"), "<transition_velocity>");
    // The first force is on the right side, which the proposal would copy to the left.
    let at = text.find(tag).unwrap() + tag.len();
    let end = at + text[at..].find('<').unwrap();
    dir.write("model.osim", format!("{}nan{}", &text[..at], &text[end..]));
    let check = dir.run("check model.osim").out();
    assert!(check.contains("not-finite") && !check.contains("transition_velocity=NaN"), "{check}");
}
