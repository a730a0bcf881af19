//! Figures: SVG and PNG as bytes, and what is said beside them.

use osim_planning::plot_bodies;
use osim_requests::spell::CommandLine;
use osim_view::figures;
use serde_json::{Value, json};

use crate::front_end::{files_of, request};
use crate::support::{Bench, HUMAN};

fn bench() -> Bench {
    Bench::with(&[HUMAN, ("table1/mouse_smooth_sphere.osim", "mouse.osim")])
}

/// Draws the figure of `json` in memory, and that of `words` by the command: both are the same.
#[track_caller]
fn same(words: &str, json: &Value) {
    let bench = bench();
    let request = request!(Plot, json);
    request.check_models().unwrap();
    let bodies = plot_bodies(&request, &files_of(&bench)).unwrap();
    let drawing = figures::draw(&request, &bodies, None).unwrap();
    let svg = figures::svg(&drawing, figures::paper_of(&request.looks), &bodies).unwrap();

    let said = figures::weights_in_words(&bodies, &CommandLine);
    let ran = bench.run(&format!("plot {words} -o figure.svg")).done().wrote(&["figure.svg"]);
    assert_eq!(bench.text("figure.svg"), svg);
    assert_eq!(format!("{said}written to figure.svg\n"), ran.out());

    #[cfg(feature = "png")]
    {
        let png = contact_plots::png(&svg, f32::from(request.looks.dpi.get())).unwrap();
        bench.run(&format!("plot {words} -o figure.png")).done().wrote(&["figure.png"]);
        assert!(bench.read("figure.png") == png, "{words}");
    }
}

#[test]
fn force() {
    same(
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
fn one_drop() {
    same(
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
fn a_heat_map() {
    same(
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
fn a_figure_of_the_paper() {
    same("fig4", &json!({"verb": "plot", "kind": "fig4", "output": "-"}));
}
