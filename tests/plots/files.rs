//! Formats, files and errors.

use std::collections::HashSet;

use crate::support::{Bench, HUMAN};

#[test]
fn a_png_has_the_size_asked_for_and_something_on_it() {
    let bench = Bench::new();
    bench.run("plot force falisse2022 -o force.png --dpi 150").done().wrote(&["force.png"]);
    let bytes = bench.read("force.png");
    let mut reader = png::Decoder::new(std::io::Cursor::new(&bytes)).read_info().unwrap();
    let mut pixels = vec![0; reader.output_buffer_size().unwrap()];
    let info = reader.next_frame(&mut pixels).unwrap();
    // 90 mm at 150 pixels to the inch are 531.5.
    assert!((531..=532).contains(&info.width), "{}", info.width);
    let colours: HashSet<&[u8]> = pixels.chunks_exact(3).collect();
    assert!(colours.len() > 50, "{}", colours.len());
}

#[test]
fn standard_output_takes_svg() {
    let bench = Bench::new();
    let ran = bench.run("plot state falisse2022 -o -").done().wrote_nothing();
    assert!(ran.out().starts_with("<svg ") && ran.out().ends_with("</svg>\n"), "{}", ran.out());
    assert!(ran.err().contains("falisse2022: 62 kg on 6 spheres"), "{}", ran.err());
}

#[test]
fn an_existing_file_is_replaced_only_with_force() {
    let bench = Bench::new();
    bench.write("force.svg", "mine");
    let again = "plot force falisse2022 -o force.svg";
    bench.run(again).usage().wrote_nothing().says(&["exists already", "--force"]);
    bench.run(&format!("{again} --force")).done().wrote(&["force.svg"]);
}

#[test]
fn a_model_is_never_drawn_over() {
    let bench = Bench::with(&[(HUMAN.0, "human.svg")]);
    bench
        .run("plot force ./human.svg -o human.svg --force")
        .usage()
        .wrote_nothing()
        .says(&["is an input of this run"]);
}

#[test]
fn wrong_usage_says_what_was_expected() {
    let bench = Bench::human();
    let refused = |arguments: &str, words: &[&str]| {
        bench.run(&format!("plot {arguments}")).usage().wrote_nothing().says(words);
    };
    refused("force human.osim -o figure.jpg", &["expected a name that ends in .svg, .pdf or .png"]);
    refused("force human.osim", &["--output <FILE>"]);
    refused("force -o figure.svg", &["name a model, or a preset"]);
    refused("cake human.osim -o figure.svg", &["cake", "force", "fig-c5"]);
    refused("force nobody1900 -o figure.svg", &["no such preset", "falisse2022"]);
    refused("fig4 human.osim -o figure.svg", &["leave out models"]);
    refused("sweep human.osim -o figure.svg --stiffness 1..2", &["FROM..TO/COUNT"]);
    refused("sweep human.osim -o figure.svg --stiffness x1..2/5", &["both are factors"]);
}

#[test]
fn a_model_that_cannot_be_drawn_fails_with_its_reason() {
    let bench = Bench::with(&[
        HUMAN,
        ("table1/mouse_hunt_crossley.osim", "mouse.osim"),
        ("format/zero_dissipation.osim", "elastic.osim"),
        ("format/unequal_radii.osim", "unequal.osim"),
        ("bad/truncated.osim", "truncated.osim"),
    ]);
    let failed = |arguments: &str, words: &[&str]| {
        bench.run(&format!("plot {arguments} -o figure.svg")).failed().wrote_nothing().says(words);
    };
    failed("force truncated.osim", &["truncated.osim:"]);
    failed("force missing.osim", &["missing.osim"]);
    failed("state mouse.osim", &["HuntCrossleyForce has no contact state"]);
    failed("sweep elastic.osim", &["no dissipation", "--dissipation 0.1..4/25"]);
    failed("sweep unequal.osim --spheres 2", &["--select GLOB"]);
    failed("sweep human.osim mouse.osim", &["about one body"]);
}
