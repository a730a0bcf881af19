//! `plot feet`: circles are at the places of the spheres, and messages name the bodies that cannot be drawn.

use crate::document::Svg;
use crate::support::TestDir;

const SIX_SPHERES: (&str, &str) = ("drawn_feet/six_spheres.osim", "six.osim");
const SPHERES_LEFT_BEHIND: (&str, &str) = ("drawn_feet/left_behind.osim", "left.osim");
const COLOUR_OF_PLACED_SPHERES: &str = "#0072B2";
const COLOUR_OF_MISPLACED_SPHERES: &str = "#D55E00";
/// Circles in the legend are smaller than this, and all spheres are larger, in drawing units.
const LARGEST_CIRCLE_OF_LEGEND: f64 = 100.0;

#[track_caller]
fn plot_feet(dir: &TestDir, arguments: &str) -> (Svg, String) {
    let call = format!("plot feet {arguments} -o feet.svg --force");
    let run = dir.run(&call).succeeded().wrote(&["feet.svg"]);
    (Svg::read(&dir.text("feet.svg")), run.out().to_owned())
}

fn count_spheres(svg: &Svg, colour: &str) -> usize {
    svg.circles(colour).iter().filter(|circle| circle.radius > LARGEST_CIRCLE_OF_LEGEND).count()
}

/// Centres of the right foot's spheres in ground at the default pose, mm, computed by OpenSim 4.6 (`tests/oracle/opensim_scene.py`).
const SPHERES_OF_RIGHT_FOOT: [(&str, f64, f64, f64); 6] = [
    ("heel_r", -105.043, 2.0, 91.718),
    ("midfoot_r", -26.745, 2.0, 127.348),
    ("ball_med_r", 58.665, 2.0, 87.284),
    ("ball_lat_r", 36.076, 2.0, 140.966),
    ("toe_med_r", 107.707, 2.0, 98.234),
    ("toe_lat_r", 92.751, 2.0, 138.735),
];

#[test]
fn circles_are_at_the_places_of_the_spheres() {
    let dir = TestDir::with(&[SIX_SPHERES]);
    let (svg, output) = plot_feet(&dir, "six.osim --select *_r");
    assert!(output.contains("six: 1 foot, 6 spheres, at the default pose"), "{output}");
    svg.says(&["calcn_r, right", "from the right", "from above", "heel_r", "toe_lat_r", "floor, y = 0 mm"]);
    let circles = svg.circles(COLOUR_OF_PLACED_SPHERES);
    let x = svg.scale_of_x();
    let (side, above) = circles[..12].split_at(6);
    for (index, (name, along, ..)) in SPHERES_OF_RIGHT_FOOT.iter().enumerate() {
        for circle in [side[index], above[index]] {
            assert!((x.value(circle.centre.0) - along).abs() < 0.2, "{name}: {}", x.value(circle.centre.0));
            // One scale in both directions: 25 mm.
            let radius = x.value(circle.radius) - x.value(0.0);
            assert!((radius - 25.0).abs() < 0.1, "{name}: {radius}");
        }
        // From above, to the right is down.
        let across = (x.value(above[index].centre.1) - x.value(above[0].centre.1))
            - (SPHERES_OF_RIGHT_FOOT[index].3 - SPHERES_OF_RIGHT_FOOT[0].3);
        assert!(across.abs() < 0.3, "{name}: {across}");
    }
}

#[test]
fn spheres_left_behind_have_another_colour() {
    let dir = TestDir::with(&[SIX_SPHERES, SPHERES_LEFT_BEHIND]);
    let (svg, output) = plot_feet(&dir, "left.osim");
    assert!(output.contains("left: spheres-left-behind: bodies were scaled after"), "{output}");
    assert_eq!(
        (count_spheres(&svg, COLOUR_OF_PLACED_SPHERES), count_spheres(&svg, COLOUR_OF_MISPLACED_SPHERES)),
        (0, 24)
    );
    svg.says(&["sphere that is where it should not be"]);
    let (svg, _) = plot_feet(&dir, "six.osim");
    assert_eq!(
        (count_spheres(&svg, COLOUR_OF_PLACED_SPHERES), count_spheres(&svg, COLOUR_OF_MISPLACED_SPHERES)),
        (24, 0)
    );
    // Both: the first dashed.
    let (svg, _) = plot_feet(&dir, "six.osim left.osim");
    svg.says(&["sphere, six", "sphere that is where it should not be"]);
}

#[test]
fn a_target_mass_draws_the_scaled_spheres() {
    let dir = TestDir::with(&[SIX_SPHERES]);
    let (svg, output) = plot_feet(&dir, "six.osim --select *_r --target-mass 496");
    assert!(output.contains("scaled to 496 kg: 1 foot, 6 spheres"), "{output}");
    // Eight times the mass: twice the radius.
    let x = svg.scale_of_x();
    let radius = x.value(svg.circles(COLOUR_OF_PLACED_SPHERES)[0].radius) - x.value(0.0);
    assert!((radius - 50.0).abs() < 0.1, "{radius}");
}

#[test]
fn models_are_drawn_or_refused_with_a_reason() {
    let dir = TestDir::with(&[
        ("feet/human_40000.osim", "human.osim"),
        ("table1/mouse_hunt_crossley.osim", "mouse.osim"),
        ("format/no_sides.osim", "no_sides.osim"),
        ("check/floats.osim", "floats.osim"),
        ("bad/no_contacts.osim", "none.osim"),
    ]);
    let (svg, output) = plot_feet(&dir, "human.osim");
    assert!(output.contains("no bones are drawn of") && output.contains("--geometry-dir DIR"), "{output}");
    assert_eq!(count_spheres(&svg, COLOUR_OF_PLACED_SPHERES), 0);
    plot_feet(&dir, "mouse.osim");
    plot_feet(&dir, "no_sides.osim");
    plot_feet(&dir, "floats.osim");
    let assert_refused = |arguments: &str, words: &[&str]| {
        dir.run(&format!("plot feet {arguments} -o no.svg")).says(words).wrote_nothing();
    };
    assert_refused("none.osim", &["there are no feet to draw"]);
    assert_refused("falisse2022", &["falisse2022 is a preset, which has no feet"]);
    assert_refused("mouse.osim human.osim floats.osim", &["one model, or two"]);
    assert_refused("mouse.osim --select nothing*", &["no contact force is left by --select"]);
}

#[test]
fn names_with_markup_are_drawn_as_text() {
    let dir = TestDir::with(&[SIX_SPHERES]);
    let odd = "&lt;b onclick=&quot;x&quot;&gt;&amp;";
    let text = dir.text("six.osim").replace("heel_r", odd);
    dir.write("odd.osim", text);
    let (svg, _) = plot_feet(&dir, "odd.osim");
    svg.says(&["<b onclick=\"x\">&"]);
    let document = dir.text("feet.svg");
    assert!(!document.contains("<b ") && !document.contains(" id="));
}

#[test]
fn reports_show_the_feet() {
    let dir = TestDir::with(&[SIX_SPHERES]);
    let page = |call: &str, page: &str| {
        dir.run(&format!("{call} --report {page} --quiet"));
        dir.text(page)
    };
    let changed = page("rescale six.osim --target-mass 80 -o out.osim", "changed.html");
    for words in
        ["Feet from the side and from above", "sphere, before", "sphere, after", "heel_r", "r_human_foot.vtp"]
    {
        assert!(changed.contains(words), "{words}");
    }
    dir.run("inspect six.osim --report inspected.html").succeeded();
    let inspected = dir.text("inspected.html");
    assert!(inspected.contains("Feet from the side and from above") && !inspected.contains("sphere, before"));
    dir.run("check six.osim --report checked.html");
    assert!(dir.text("checked.html").contains("Feet from the side and from above"));
}
