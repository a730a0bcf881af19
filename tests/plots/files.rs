//! Formats, files and errors of `plot`.

use std::collections::HashSet;

use crate::support::{HUMAN, TestDir};

#[test]
fn a_png_has_the_requested_size_and_is_not_empty() {
    let dir = TestDir::new();
    dir.run("plot force falisse2022 -o force.png --dpi 150").succeeded().wrote(&["force.png"]);
    let bytes = dir.read("force.png");
    let mut reader = png::Decoder::new(std::io::Cursor::new(&bytes)).read_info().unwrap();
    let mut pixels = vec![0; reader.output_buffer_size().unwrap()];
    let info = reader.next_frame(&mut pixels).unwrap();
    // 90 mm at 150 pixels to the inch are 531.5.
    assert!((531..=532).contains(&info.width), "{}", info.width);
    let colours: HashSet<&[u8]> = pixels.chunks_exact(3).collect();
    assert!(colours.len() > 50, "{}", colours.len());
}

#[test]
fn an_svg_can_go_to_standard_output() {
    let dir = TestDir::new();
    let run = dir.run("plot state falisse2022 -o -").succeeded().wrote_nothing();
    assert!(run.out().starts_with("<svg ") && run.out().ends_with("</svg>\n"), "{}", run.out());
    assert!(run.err().contains("falisse2022: 62 kg on 6 spheres"), "{}", run.err());
}

#[test]
fn an_existing_file_is_replaced_only_with_force() {
    let dir = TestDir::new();
    dir.write("force.svg", "mine");
    let call = "plot force falisse2022 -o force.svg";
    let run = dir.run(call).usage_error().wrote_nothing();
    // A figure has no folder to be written into.
    run.says(&["exists already: choose another name, or replace it with --force"]).says_not(&["-d"]);
    dir.run(&format!("{call} --force")).succeeded().wrote(&["force.svg"]);
}

#[test]
fn a_figure_never_replaces_a_model() {
    let dir = TestDir::with(&[(HUMAN.0, "human.svg")]);
    dir.run("plot force ./human.svg -o human.svg --force")
        .usage_error()
        .wrote_nothing()
        .says(&["is an input of this run"]);
}

#[test]
fn wrong_options_are_refused_with_what_is_expected() {
    let dir = TestDir::with_human();
    let assert_refused = |arguments: &str, words: &[&str]| {
        dir.run(&format!("plot {arguments}")).usage_error().wrote_nothing().says(words);
    };
    assert_refused("force human.osim -o figure.jpg", &["expected a name that ends in .svg, .pdf or .png"]);
    assert_refused("force human.osim", &["--output <FILE>"]);
    assert_refused("force -o figure.svg", &["name a model, or a preset"]);
    assert_refused("cake human.osim -o figure.svg", &["cake", "force", "fig-c5"]);
    assert_refused("force nobody1900 -o figure.svg", &["no such preset", "falisse2022"]);
    assert_refused("fig4 human.osim -o figure.svg", &["leave out models"]);
    assert_refused("sweep human.osim -o figure.svg --stiffness 1..2", &["FROM..TO/COUNT"]);
    assert_refused("sweep human.osim -o figure.svg --stiffness x1..2/5", &["both are factors"]);
}

#[test]
fn a_model_that_cannot_be_drawn_fails_with_its_reason() {
    let dir = TestDir::with(&[
        HUMAN,
        ("table1/mouse_hunt_crossley.osim", "mouse.osim"),
        ("format/zero_dissipation.osim", "elastic.osim"),
        ("format/unequal_radii.osim", "unequal.osim"),
        ("bad/truncated.osim", "truncated.osim"),
    ]);
    let assert_fails = |arguments: &str, words: &[&str]| {
        dir.run(&format!("plot {arguments} -o figure.svg")).failed().wrote_nothing().says(words);
    };
    assert_fails("force truncated.osim", &["truncated.osim:"]);
    assert_fails("force missing.osim", &["missing.osim"]);
    assert_fails("state mouse.osim", &["HuntCrossleyForce has no contact state"]);
    assert_fails("sweep elastic.osim", &["no dissipation", "--dissipation 0.1..4/25"]);
    assert_fails("sweep unequal.osim --spheres 2", &["--select GLOB"]);
    assert_fails("sweep human.osim mouse.osim", &["about one body"]);
}
