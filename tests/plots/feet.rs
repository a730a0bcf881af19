//! Feet: circles are where the spheres are, names do not touch, and what cannot be drawn is said.

use crate::document::Svg;
use crate::support::Bench;

const SIX: (&str, &str) = ("drawn_feet/six_spheres.osim", "six.osim");
const LEFT: (&str, &str) = ("drawn_feet/left_behind.osim", "left.osim");
const NOW: &str = "#0072B2";
const MISPLACED: &str = "#D55E00";
/// The legend's samples are smaller than any sphere here, in drawing units.
const SAMPLE: f64 = 100.0;

#[track_caller]
fn drawn(bench: &Bench, arguments: &str) -> (Svg, String) {
    let call = format!("plot feet {arguments} -o feet.svg --force");
    let ran = bench.run(&call).done().wrote(&["feet.svg"]);
    (Svg::read(&bench.text("feet.svg")), ran.out().to_owned())
}

fn spheres(svg: &Svg, colour: &str) -> usize {
    svg.circles(colour).iter().filter(|circle| circle.radius > SAMPLE).count()
}

/// Centres of the right foot's spheres in ground at the default pose, mm, as OpenSim 4.6 has them (`tests/oracle/opensim_scene.py`).
const RIGHT: [(&str, f64, f64, f64); 6] = [
    ("heel_r", -105.043, 2.0, 91.718),
    ("midfoot_r", -26.745, 2.0, 127.348),
    ("ball_med_r", 58.665, 2.0, 87.284),
    ("ball_lat_r", 36.076, 2.0, 140.966),
    ("toe_med_r", 107.707, 2.0, 98.234),
    ("toe_lat_r", 92.751, 2.0, 138.735),
];

#[test]
fn circles_are_where_the_spheres_are() {
    let bench = Bench::with(&[SIX]);
    let (svg, said) = drawn(&bench, "six.osim --select *_r");
    assert!(said.contains("six: 1 foot, 6 spheres, at the default pose"), "{said}");
    svg.says(&["calcn_r, right", "from the right", "from above", "heel_r", "toe_lat_r", "floor, y = 0 mm"]);
    let circles = svg.circles(NOW);
    let x = svg.scale_of_x();
    let (side, above) = circles[..12].split_at(6);
    for (index, (name, along, ..)) in RIGHT.iter().enumerate() {
        for circle in [side[index], above[index]] {
            assert!((x.value(circle.centre.0) - along).abs() < 0.2, "{name}: {}", x.value(circle.centre.0));
            // One scale in both directions: 25 mm.
            let radius = x.value(circle.radius) - x.value(0.0);
            assert!((radius - 25.0).abs() < 0.1, "{name}: {radius}");
        }
        // From above, to the right is down.
        let across =
            (x.value(above[index].centre.1) - x.value(above[0].centre.1)) - (RIGHT[index].3 - RIGHT[0].3);
        assert!(across.abs() < 0.3, "{name}: {across}");
    }
}

#[test]
fn spheres_that_stayed_behind_stand_out() {
    let bench = Bench::with(&[SIX, LEFT]);
    let (svg, said) = drawn(&bench, "left.osim");
    assert!(said.contains("left: spheres-left-behind: bodies were scaled after"), "{said}");
    assert_eq!((spheres(&svg, NOW), spheres(&svg, MISPLACED)), (0, 24));
    svg.says(&["sphere that is where it should not be"]);
    let (svg, _) = drawn(&bench, "six.osim");
    assert_eq!((spheres(&svg, NOW), spheres(&svg, MISPLACED)), (24, 0));
    // Both: the first dashed.
    let (svg, _) = drawn(&bench, "six.osim left.osim");
    svg.says(&["sphere, six", "sphere that is where it should not be"]);
}

#[test]
fn a_target_mass_draws_the_spheres_that_follow_from_it() {
    let bench = Bench::with(&[SIX]);
    let (svg, said) = drawn(&bench, "six.osim --select *_r --target-mass 496");
    assert!(said.contains("scaled to 496 kg: 1 foot, 6 spheres"), "{said}");
    // Eight times the mass: twice the radius.
    let x = svg.scale_of_x();
    let radius = x.value(svg.circles(NOW)[0].radius) - x.value(0.0);
    assert!((radius - 50.0).abs() < 0.1, "{radius}");
}

#[test]
fn models_of_all_kinds_are_drawn_or_refused_in_words() {
    let bench = Bench::with(&[
        ("feet/human_40000.osim", "human.osim"),
        ("table1/mouse_hunt_crossley.osim", "mouse.osim"),
        ("format/no_sides.osim", "no_sides.osim"),
        ("check/floats.osim", "floats.osim"),
        ("bad/no_contacts.osim", "none.osim"),
    ]);
    let (svg, said) = drawn(&bench, "human.osim");
    assert!(said.contains("no bones are drawn of") && said.contains("--geometry-dir DIR"), "{said}");
    assert_eq!(spheres(&svg, NOW), 0);
    drawn(&bench, "mouse.osim");
    drawn(&bench, "no_sides.osim");
    drawn(&bench, "floats.osim");
    let refused = |arguments: &str, words: &[&str]| {
        bench.run(&format!("plot feet {arguments} -o no.svg")).says(words).wrote_nothing();
    };
    refused("none.osim", &["there are no feet to draw"]);
    refused("falisse2022", &["falisse2022 is a preset, which has no feet"]);
    refused("mouse.osim human.osim floats.osim", &["one model, or two"]);
    refused("mouse.osim --select nothing*", &["no contact force is left by --select"]);
}

#[test]
fn names_from_outside_are_only_text() {
    let bench = Bench::with(&[SIX]);
    let odd = "&lt;b onclick=&quot;x&quot;&gt;&amp;";
    let text = bench.text("six.osim").replace("heel_r", odd);
    bench.write("odd.osim", text);
    let (svg, _) = drawn(&bench, "odd.osim");
    svg.says(&["<b onclick=\"x\">&"]);
    let document = bench.text("feet.svg");
    assert!(!document.contains("<b ") && !document.contains(" id="));
}

#[test]
fn reports_show_the_feet() {
    let bench = Bench::with(&[SIX]);
    let page = |call: &str, page: &str| {
        bench.run(&format!("{call} --report {page} --quiet"));
        bench.text(page)
    };
    let changed = page("rescale six.osim --target-mass 80 -o out.osim", "changed.html");
    for words in
        ["Feet from the side and from above", "sphere, before", "sphere, after", "heel_r", "r_human_foot.vtp"]
    {
        assert!(changed.contains(words), "{words}");
    }
    bench.run("inspect six.osim --report inspected.html").done();
    let inspected = bench.text("inspected.html");
    assert!(inspected.contains("Feet from the side and from above") && !inspected.contains("sphere, before"));
    bench.run("check six.osim --report checked.html");
    assert!(bench.text("checked.html").contains("Feet from the side and from above"));
}
