//! The ground reactions of a model as OpenSim reads them: a table, and which of its columns act on which body.

use osim_model::cross;
use osim_model::feet::dot;
use osim_model::messages::shortest;
use osim_motion::{ContactState, ON_BW, Wrench};
use osim_planning::MotionResult;

/// The contacts of one body.
struct Load {
    body: String,
    /// What its columns have between `ground_force_` and `_vx`.
    label: String,
    pairs: Vec<usize>,
}

/// The bodies that contacts press on: a foot of one body has the name of its side.
fn loads(result: &MotionResult) -> Vec<Load> {
    let mut loads: Vec<Load> = Vec::new();
    for foot in &result.summary.feet {
        for body in &foot.foot.bodies {
            let is_own = |pair: &usize| result.states.pairs.get(*pair).is_some_and(|pair| &pair.body == body);
            let side = match (foot.foot.side, foot.foot.bodies.len()) {
                (Some(osim_model::Side::Right), 1) => Some("r"),
                (Some(osim_model::Side::Left), 1) => Some("l"),
                _ => None,
            };
            let label = match side.filter(|side| loads.iter().all(|load| load.label != *side)) {
                Some(side) => side.to_owned(),
                None => body.clone(),
            };
            let pairs = foot.foot.pairs.iter().copied().filter(is_own).collect();
            loads.push(Load { body: body.clone(), label, pairs });
        }
    }
    loads
}

/// The ground reactions as a `.sto`: force, point and free moment of each body, in ground.
#[must_use]
pub fn ground_reactions_sto(result: &MotionResult, name: &str) -> String {
    let loads = loads(result);
    let mut text = format!(
        "{}\nversion=1\nnRows={}\nnColumns={}\ninDegrees=no\nendheader\ntime",
        name.lines().next().unwrap_or_default(),
        result.states.frames(),
        9 * loads.len() + 1
    );
    for load in &loads {
        let label = &load.label;
        for columns in [
            format!("ground_force_{label}_v"),
            format!("ground_force_{label}_p"),
            format!("ground_torque_{label}_"),
        ] {
            for axis in ["x", "y", "z"] {
                text.push_str(&format!("\t{columns}{axis}"));
            }
        }
    }
    text.push('\n');
    let mut points = vec![None; loads.len()];
    for (frame, time_s) in result.states.time_s.iter().enumerate() {
        text.push_str(&shortest(*time_s));
        for (load, last) in loads.iter().zip(&mut points) {
            let states = result.states.frame(frame);
            let own = || load.pairs.iter().filter_map(|&pair| states.get(pair));
            let wrench = Wrench::of(own());
            let point = point_of(result, own().next(), &wrench).or(*last).unwrap_or_default();
            *last = Some(point);
            let arm = cross(point, wrench.force_n);
            let moment: [f64; 3] = std::array::from_fn(|i| wrench.moment_n_m[i] - arm[i]);
            for value in wrench.force_n.iter().chain(&point).chain(&moment) {
                text.push('\t');
                text.push_str(&shortest(*value));
            }
        }
        text.push('\n');
    }
    text
}

/// Where the force of a body acts, where it is large enough.
fn point_of(result: &MotionResult, first: Option<&ContactState>, wrench: &Wrench) -> Option<[f64; 3]> {
    let state = first?;
    let down: f64 = dot(std::array::from_fn(|i| state.centre_m[i] - state.point_m[i]), state.normal);
    let on_plane = std::array::from_fn(|i| state.centre_m[i] - down * state.normal[i]);
    // Below, forces act where they did last.
    let least_n = ON_BW * result.summary.weight_n;
    wrench.centre_of_pressure(state.normal, on_plane, least_n).map(|centre| centre.point_m)
}

/// OpenSim's `ExternalLoads` for the file of [`ground_reactions_sto`], which is beside it as `data_file`.
#[must_use]
pub fn external_loads_xml(result: &MotionResult, data_file: &str) -> String {
    let mut text = String::from(
        "<?xml version=\"1.0\" encoding=\"UTF-8\" ?>\n<OpenSimDocument Version=\"40000\">\n\t<ExternalLoads name=\"contacts\">\n\t\t<objects>\n",
    );
    for load in loads(result) {
        let (label, body) = (escaped(&load.label), escaped(&load.body));
        text.push_str(&format!("\t\t\t<ExternalForce name=\"contacts_{body}\">\n"));
        for (tag, value) in [
            ("applied_to_body", body),
            ("force_expressed_in_body", "ground".to_owned()),
            ("point_expressed_in_body", "ground".to_owned()),
            ("force_identifier", format!("ground_force_{label}_v")),
            ("point_identifier", format!("ground_force_{label}_p")),
            ("torque_identifier", format!("ground_torque_{label}_")),
        ] {
            text.push_str(&format!("\t\t\t\t<{tag}>{value}</{tag}>\n"));
        }
        text.push_str("\t\t\t</ExternalForce>\n");
    }
    text.push_str(&format!(
        "\t\t</objects>\n\t\t<groups />\n\t\t<datafile>{}</datafile>\n\t</ExternalLoads>\n</OpenSimDocument>\n",
        escaped(data_file)
    ));
    text
}

/// As text of XML.
fn escaped(text: &str) -> String {
    maud::html! { (text) }.into_string()
}
