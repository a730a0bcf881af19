//! Tests of scenes as SVG documents: equal axes, names that do not touch, no ids.

#![allow(clippy::disallowed_methods, reason = "tests cut their own texts")]
#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic, reason = "a test fails by panicking")]

use crate::document::Svg;
use contact_plots::{
    Ball, Block, Level, LevelKind, Outline, Paper, PlotError, Scene, SceneNames, Spot, State, View, scene,
};
use resvg::usvg;

fn named_ball(name: &str, centre: (f64, f64), radius: f64) -> Ball {
    Ball { name: name.to_owned(), centre, radius, state: State::Now, misplaced: false }
}

fn named_spot(name: &str, at: (f64, f64)) -> Spot {
    Spot { name: name.to_owned(), at, state: State::Now }
}

fn view_of_balls(balls: Vec<Ball>) -> View {
    View {
        title: "from the right".to_owned(),
        x_label: "x (mm)".to_owned(),
        y_label: "y (mm)".to_owned(),
        balls,
        ..View::default()
    }
}

fn scene_names() -> SceneNames {
    SceneNames {
        now: "sphere".to_owned(),
        before: "before".to_owned(),
        misplaced: "misplaced".to_owned(),
        spot: "joint".to_owned(),
        outline: "bone".to_owned(),
        ground: "floor".to_owned(),
        lowest: "lowest bottom".to_owned(),
    }
}

/// The SVG of a scene in its default width.
fn drawn_scene(data: &Scene) -> Result<String, PlotError> {
    scene(data, Paper::default())
}

fn scene_of_blocks(blocks: Vec<Block>) -> Scene {
    Scene {
        title: "Feet".to_owned(),
        description: "Feet from two sides.".to_owned(),
        blocks,
        names: scene_names(),
    }
}

fn foot_block(title: &str) -> Block {
    let balls = [
        ("s1", (1.9, -10.0), -4.0),
        ("s2", (148.0, -10.0), -19.0),
        ("s3", (133.0, -10.0), 22.0),
        ("s4", (66.0, -10.0), 21.0),
        ("s5", (239.0, -10.0), 14.0),
        ("s6", (224.0, -10.0), -29.0),
    ];
    let mut side = view_of_balls(balls.map(|(name, at, _)| named_ball(name, at, 32.0)).to_vec());
    let mut top = view_of_balls(balls.map(|(name, (x, _), z)| named_ball(name, (x, z), 32.0)).to_vec());
    side.spots = vec![named_spot("subtalar_r", (0.0, 30.0)), named_spot("mtp_r", (163.0, -1.8))];
    top.spots = vec![named_spot("subtalar_r", (0.0, 0.0)), named_spot("mtp_r", (163.0, 1.0))];
    side.outlines = vec![Outline {
        points: vec![(-20.0, 0.0), (10.0, 50.0), (180.0, 10.0), (180.0, -5.0), (70.0, 5.0)],
        state: State::Now,
    }];
    side.levels = vec![
        Level { name: "lowest bottom".to_owned(), at: -42.0, kind: LevelKind::Lowest },
        Level { name: "floor".to_owned(), at: -60.0, kind: LevelKind::Ground },
    ];
    top.y_down = true;
    top.title = "from above".to_owned();
    Block { title: title.to_owned(), remarks: vec![], views: vec![side, top] }
}

/// The texts of an SVG with their boxes in the font of PNG pictures, in pixels of 1/96 inch.
fn text_boxes(svg: &str) -> Vec<(String, usvg::Rect)> {
    let mut fonts = usvg::fontdb::Database::new();
    let font = concat!(env!("CARGO_MANIFEST_DIR"), "/fonts/Arimo-subset.ttf");
    fonts.load_font_data(std::fs::read(font).unwrap());
    fonts.set_sans_serif_family("Arimo");
    let options =
        usvg::Options { fontdb: fonts.into(), font_family: "Arimo".to_owned(), ..usvg::Options::default() };
    let tree = usvg::Tree::from_str(svg, &options).unwrap();
    let mut boxes = Vec::new();
    collect_texts(tree.root(), &mut boxes);
    boxes
}

fn collect_texts(group: &usvg::Group, boxes: &mut Vec<(String, usvg::Rect)>) {
    for node in group.children() {
        match node {
            usvg::Node::Group(inner) => collect_texts(inner, boxes),
            usvg::Node::Text(text) => {
                let words = text.chunks().iter().map(usvg::TextChunk::text).collect();
                boxes.push((words, text.abs_bounding_box()));
            }
            _ => {}
        }
    }
}

/// Asserts that no two texts of the figure touch, and that there are at least `least` texts.
#[track_caller]
fn assert_texts_apart(svg: &str, least: usize) {
    let boxes = text_boxes(svg);
    assert!(boxes.len() >= least, "{} texts", boxes.len());
    for (index, (text, first)) in boxes.iter().enumerate() {
        for (other, second) in &boxes[..index] {
            // usvg's pixels; a tenth of one is a fortieth of a millimetre.
            let apart = first.left() >= second.right() - 0.1
                || second.left() >= first.right() - 0.1
                || first.top() >= second.bottom() - 0.1
                || second.top() >= first.bottom() - 0.1;
            assert!(apart, "'{text}' {first:?} touches '{other}' {second:?}");
        }
    }
}

#[test]
fn hundreds_of_names_are_left_out_with_a_remark() {
    let block = Block {
        title: "Platform".to_owned(),
        remarks: vec![],
        views: vec![view_of_balls(balls_at_scattered_places(300))],
    };
    let svg = Svg::read(&drawn_scene(&scene_of_blocks(vec![block])).unwrap());
    assert_eq!(svg.circles("#0072B2").len(), 300 + 1);
    svg.says(&["Without names, as there are more than 80."]);
    assert!(!svg.texts.iter().any(|text| text.starts_with("Obstacle")));
}

/// Circles at places that look random and are the same in every run.
fn balls_at_scattered_places(count: u32) -> Vec<Ball> {
    let fraction = |value: f64| value - value.floor();
    let at = |index: u32| {
        let along = 6000.0 * fraction(f64::from(index) * 0.618_033_988_75);
        (along, if index.is_multiple_of(2) { -200.0 } else { 200.0 })
    };
    (0..count)
        .map(|index| named_ball(&format!("Obstacle{index}"), at(index), 50.0 + f64::from(index % 30)))
        .collect()
}

#[test]
fn circles_are_circles_in_their_places() {
    let svg = Svg::read(
        &drawn_scene(&scene_of_blocks(vec![foot_block("calcn_r (right)"), foot_block("calcn_l (left)")]))
            .unwrap(),
    );
    // Twice six spheres in each of two feet; the legend's is smaller.
    let circles = svg.circles("#0072B2");
    let legend = circles.iter().filter(|circle| circle.radius < 100.0).count();
    assert_eq!((circles.len(), legend), (25, 1));
    let expected = foot_block("");
    let (side, top) = (&expected.views[0].balls, &expected.views[1].balls);
    // The scale, from the spheres of the first view that are furthest apart; then everything follows.
    let scale = (circles[4].centre.0 - circles[0].centre.0) / (side[4].centre.0 - side[0].centre.0);
    for (index, group) in circles[..24].chunks(6).enumerate() {
        let (balls, up) = if index % 2 == 0 { (side, -1.0) } else { (top, 1.0) };
        for (circle, ball) in group.iter().zip(balls) {
            let x = group[0].centre.0 + scale * (ball.centre.0 - balls[0].centre.0);
            let y = group[0].centre.1 + up * scale * (ball.centre.1 - balls[0].centre.1);
            let off = (circle.centre.0 - x).abs().max((circle.centre.1 - y).abs());
            let of_radius = (circle.radius - scale * ball.radius).abs();
            // Drawing units are whole numbers.
            assert!(off <= 1.01 && of_radius <= 0.51, "{circle:?} is not {ball:?}");
        }
    }
    // The numbers along the axis of one foot go up, too.
    let svg = Svg::read(&drawn_scene(&scene_of_blocks(vec![foot_block("calcn_r (right)")])).unwrap());
    let (x, circles) = (svg.scale_of_x(), svg.circles("#0072B2"));
    for (circle, ball) in circles[..6].iter().zip(side) {
        assert!((x.value(circle.centre.0) - ball.centre.0).abs() < 0.15, "{circle:?} is not {ball:?}");
    }
}

#[test]
fn height_lines_are_drawn_at_their_heights() {
    let document = drawn_scene(&scene_of_blocks(vec![foot_block("calcn_r (right)")])).unwrap();
    let svg = Svg::read(&document);
    let circle = svg.circles("#0072B2")[0];
    let dashed = svg.longest_line("#666666");
    assert!((dashed[0].1 - (circle.centre.1 + circle.radius)).abs() <= 1.5, "{circle:?} {:?}", dashed[0]);
    svg.says(&[
        "lowest bottom",
        "floor",
        "sphere",
        "joint",
        "bone",
        "calcn_r (right)",
        "from above",
        "s6",
        "mtp_r",
    ]);
}

/// A scene of one foot in a column; the texts at its level lines are longer than any name.
#[test]
fn texts_at_level_lines_are_not_cut() {
    let mut block = foot_block("calcn_r (right)");
    let (lowest, ground) = ("lowest bottom, y = \u{2212}13.71 mm", "floor, y = \u{2212}31.71 mm");
    for (level, name) in block.views[0].levels.iter_mut().zip([lowest, ground]) {
        level.name = name.to_owned();
    }
    for apart in [18.0, 4.0, -4.0] {
        block.views[0].levels[1].at = -42.0 - apart;
        let document = drawn_scene(&scene_of_blocks(vec![block.clone()])).unwrap();
        let boxes = text_boxes(&document);
        assert!([lowest, ground].iter().all(|name| boxes.iter().any(|(text, _)| text == name)), "{boxes:?}");
        assert_texts_apart(&document, 24);
    }
    // A long one is cut: nothing leaves the figure.
    block.views[0].levels[0].name = "W".repeat(300);
    assert!(
        text_boxes(&drawn_scene(&scene_of_blocks(vec![block])).unwrap())
            .iter()
            .any(|(text, _)| text.ends_with('\u{2026}'))
    );
}

/// A foot of 0.2 m beside a sphere 20 m away is too small to be seen.
#[test]
fn the_legend_has_only_visible_elements() {
    let legend = |far: f64| {
        let mut block = foot_block("calcn_r (right)");
        block.views[0].balls.push(named_ball("far", (0.0, -far), 32.0));
        text_boxes(&drawn_scene(&scene_of_blocks(vec![block])).unwrap())
            .iter()
            .any(|(text, _)| text == "bone")
    };
    assert!(legend(100.0));
    assert!(!legend(20_000.0));
}

#[test]
fn names_of_spheres_never_touch_in_a_drawing() {
    assert_texts_apart(
        &drawn_scene(&scene_of_blocks(vec![foot_block("calcn_r (right)"), foot_block("calcn_l (left)")]))
            .unwrap(),
        40,
    );
    assert_texts_apart(&drawn_scene(&scene_of_blocks(vec![foot_block("calcn_r (right)")])).unwrap(), 24);
    for count in [1, 12, 13, 46, 80] {
        let block = Block {
            title: "Platform".to_owned(),
            remarks: vec![],
            views: vec![view_of_balls(balls_at_scattered_places(count))],
        };
        assert_texts_apart(
            &drawn_scene(&scene_of_blocks(vec![block])).unwrap(),
            5 + usize::try_from(count).unwrap(),
        );
    }
    // Long names, all in one place.
    let long = |index: usize| named_ball(&format!("{index} {}", "WiM".repeat(40)), (0.0, 0.0), 10.0);
    let block = Block {
        title: "W".repeat(300),
        remarks: vec![],
        views: vec![view_of_balls((0..20).map(long).collect())],
    };
    assert_texts_apart(&drawn_scene(&scene_of_blocks(vec![block.clone(), block])).unwrap(), 45);
}

#[test]
fn earlier_and_misplaced_circles_differ_without_colour() {
    let mut block = foot_block("calcn_r (right)");
    block.views[0].balls[0].misplaced = true;
    let before = Ball { name: String::new(), state: State::Before, ..block.views[0].balls[1].clone() };
    block.views[0].balls.push(before);
    let svg = Svg::read(&drawn_scene(&scene_of_blocks(vec![block])).unwrap());
    svg.says(&["before", "misplaced", "sphere"]);
    // The one that is astray, and its sample in the legend: a line twice as wide, in its own colour.
    assert_eq!(svg.circles("#D55E00").len(), 2);
    // Dashes are lines.
    assert_eq!(svg.circles("#222222").len(), 0);
}

#[test]
fn hostile_names_are_text_and_nothing_has_an_id() {
    let odd = "<script>&\"'\u{0}\u{1b}[31m]]>";
    let mut block = foot_block(odd);
    block.remarks = vec![odd.to_owned(), String::new(), "x".repeat(400)];
    block.views[0].balls[0].name = odd.to_owned();
    block.views[0].spots[0].name = odd.to_owned();
    block.views[0].levels[0].name = odd.to_owned();
    let document = drawn_scene(&Scene { title: odd.to_owned(), ..scene_of_blocks(vec![block]) }).unwrap();
    let svg = Svg::read(&document);
    svg.says(&["<script>&\"'[31m]]>"]);
    assert!(!document.contains(" id=") && !document.contains("<script") && !document.contains('\u{1b}'));
}

#[test]
fn objects_of_another_size_have_their_own_scale() {
    let ball_of = |radius: f64| Block {
        views: vec![view_of_balls(vec![named_ball("ball", (0.0, 0.0), radius)])],
        ..Block::default()
    };
    let svg = Svg::read(
        &drawn_scene(&scene_of_blocks(vec![ball_of(10.0), ball_of(20.0), ball_of(1000.0)])).unwrap(),
    );
    let radii: Vec<f64> = svg.circles("#0072B2").iter().map(|circle| circle.radius).collect();
    assert!((radii[1] - 2.0 * radii[0]).abs() <= 1.0, "{radii:?}");
    assert!((radii[2] - radii[1]).abs() <= 1.0, "{radii:?}");
    svg.says(&["Drawn smaller than the others."]);
}

#[test]
fn scenes_that_cannot_be_drawn_are_refused() {
    let refused = |blocks| drawn_scene(&scene_of_blocks(blocks)).unwrap_err();
    assert!(matches!(refused(vec![]), PlotError::Empty(_)));
    assert!(matches!(refused(vec![Block::default()]), PlotError::Empty(_)));
    let with = |ball: Ball| vec![Block { views: vec![view_of_balls(vec![ball])], ..Block::default() }];
    for (at, radius) in [((f64::NAN, 0.0), 1.0), ((0.0, f64::INFINITY), 1.0), ((0.0, 0.0), f64::NAN)] {
        assert_eq!(refused(with(named_ball("s1", at, radius))), PlotError::NotFinite("s1".to_owned()));
    }
    // Nothing but a point, and nothing at all, have a picture.
    let mut point = View { spots: vec![named_spot("mtp_r", (5.0, 5.0))], ..view_of_balls(vec![]) };
    assert!(
        drawn_scene(&scene_of_blocks(vec![Block { views: vec![point.clone()], ..Block::default() }])).is_ok()
    );
    point.spots.clear();
    assert!(drawn_scene(&scene_of_blocks(vec![Block { views: vec![point], ..Block::default() }])).is_ok());
}
