//! Figures in memory: SVG and PNG as bytes, and the remarks beside them.

use osim_planning::plot_bodies;
use osim_requests::spell::CommandLine;
use osim_view::figures;
use serde_json::{Value, json};

use crate::front_end::{files_in_memory, request};
use crate::support::{HUMAN, TestDir};

fn dir_with_two_models() -> TestDir {
    TestDir::with(&[HUMAN, ("table1/mouse_smooth_sphere.osim", "mouse.osim")])
}

/// Draws the figure of the request `json` in memory, and of the arguments `words` by the command. Both figures must be equal.
#[track_caller]
fn assert_same_figure(words: &str, json: &Value) {
    let dir = dir_with_two_models();
    let request = request!(Plot, json);
    request.check_models().unwrap();
    let bodies = plot_bodies(&request, &files_in_memory(&dir)).unwrap();
    let drawing = figures::draw(&request, &bodies, None).unwrap();
    let svg = figures::svg(&drawing, figures::paper_of(&request.looks), &bodies).unwrap();

    let remarks = figures::weights_in_words(&bodies, &CommandLine);
    let run = dir.run(&format!("plot {words} -o figure.svg")).succeeded().wrote(&["figure.svg"]);
    assert_eq!(dir.text("figure.svg"), svg);
    assert_eq!(format!("{remarks}written to figure.svg\n"), run.out());

    #[cfg(feature = "png")]
    {
        let png = contact_plots::png(&svg, f32::from(request.looks.dpi.get())).unwrap();
        dir.run(&format!("plot {words} -o figure.png")).succeeded().wrote(&["figure.png"]);
        assert!(dir.read("figure.png") == png, "{words}");
    }
}

#[test]
fn a_force_plot_equals_the_command() {
    assert_same_figure(
        "force human.osim mouse.osim --title Both",
        &json!({
            "verb": "plot",
            "kind": "force",
            "models": ["human.osim", "mouse.osim"],
            "title": "Both",
            "output": "-",
        }),
    );
}

#[test]
fn a_drop_plot_equals_the_command() {
    assert_same_figure(
        "drop human.osim --height x0.1 --dpi 72 --width 120 --font-size 8 --y-range 0..2 --label one",
        &json!({
            "verb": "plot",
            "kind": "drop",
            "models": "human.osim",
            "height": "x0.1",
            "dpi": 72,
            "width": 120,
            "font_size": 8,
            "y_range": "0..2",
            "label": "one",
            "output": "-",
        }),
    );
}

#[test]
fn a_heat_map_equals_the_command() {
    assert_same_figure(
        "sweep human.osim --quantity restitution --stiffness x0.5..x2/3 --dissipation 0.5..2/4",
        &json!({
            "verb": "plot",
            "kind": "sweep",
            "models": "human.osim",
            "quantity": "restitution",
            "stiffness": "x0.5..x2/3",
            "dissipation": "0.5..2/4",
            "output": "-",
        }),
    );
}

#[test]
fn a_figure_of_the_paper_equals_the_command() {
    assert_same_figure("fig4", &json!({"verb": "plot", "kind": "fig4", "output": "-"}));
}
