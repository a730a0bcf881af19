//! A motion in words, with figures of each foot and sphere.

use osim_model::messages::{Dialect, readable, shown};
use osim_motion::{Comparison, SphereSummary};
use osim_planning::{MotionRemark, MotionResult};

use crate::report::layout::{table, wrapped};

/// What the contacts do, in words first.
#[must_use]
pub fn motion_text(result: &MotionResult, remarks: &[MotionRemark], dialect: &dyn Dialect) -> String {
    let states = &result.states;
    let (first, last) = (states.time_s.first().copied(), states.time_s.last().copied());
    let mut text = format!(
        "{}, {}: {} frames from {} to {} s, {} kg, {} m/s2\n\n",
        result.opened.name(),
        result.motion,
        states.frames(),
        readable(first.unwrap_or_default()),
        readable(last.unwrap_or_default()),
        readable(result.mass_kg),
        readable(result.gravity_m_s2)
    );
    for remark in remarks {
        let mark = if remark.code == "foot" { "" } else { "note: " };
        text.push_str(&wrapped(&format!("{mark}{}", remark.message.spelled(dialect)), ""));
        text.push('\n');
    }
    text.push_str(&feet(result));
    text.push('\n');
    text.push_str(&spheres(result));
    text
}

fn feet(result: &MotionResult) -> String {
    let (columns, rows) = motion_feet(result);
    let mut all = table(&columns);
    for row in rows {
        all.add_row(row);
    }
    all.right_aligned(&(1..columns.len()).collect::<Vec<_>>());
    format!("{}\n", all.trim_fmt())
}

/// The headers and the rows of the table of feet: one row each, and one for all together.
#[must_use]
pub fn motion_feet(result: &MotionResult) -> (Vec<&'static str>, Vec<Vec<String>>) {
    let weight_n = result.summary.weight_n;
    let bw = |force_n: f64| format!("{:.3}", force_n / weight_n);
    let with_plates = result.measured.is_some();
    let mut columns = vec!["foot", "stances", "peak, BW"];
    if with_plates {
        columns.extend(["plates, BW", "rms, N", "rms, BW", "COP, mm"]);
    }
    let mut rows = Vec::new();
    let mut add = |name: &str, stances: Option<usize>, peak_n: f64, comparison: Option<&Comparison>| {
        let stances = stances.map(|count| count.to_string()).unwrap_or_default();
        let mut row = vec![shown(name).to_string(), stances, bw(peak_n)];
        if with_plates {
            let cell = |value: Option<String>| value.unwrap_or_else(|| "-".to_owned());
            row.push(cell(comparison.map(|one| bw(one.measured_peak_n))));
            row.push(cell(comparison.map(|one| format!("{:.0}", one.normal_rms_n))));
            row.push(cell(comparison.map(|one| bw(one.normal_rms_n))));
            row.push(cell(
                comparison.and_then(|one| one.cop_rms_m).map(|cop_m| format!("{:.0}", 1e3 * cop_m)),
            ));
        }
        rows.push(row);
    };
    for foot in &result.summary.feet {
        add(&foot.foot.name, Some(foot.stances.len()), foot.peak_n, foot.comparison.as_ref());
    }
    add("all feet", None, result.summary.peak_n, result.summary.comparison.as_ref());
    (columns, rows)
}

fn spheres(result: &MotionResult) -> String {
    let mut all = table(&[
        "sphere",
        "peak, N",
        "x/R",
        "at, s",
        "x/R > 0.16, s",
        "slip, m/s",
        "impact, m/s",
        "restitution",
    ]);
    for foot in &result.summary.feet {
        for sphere in &foot.spheres {
            all.add_row(sphere_row(result, sphere));
        }
    }
    all.right_aligned(&[1, 2, 3, 4, 5, 6, 7]);
    format!("{}\n", all.trim_fmt())
}

fn sphere_row(result: &MotionResult, sphere: &SphereSummary) -> Vec<String> {
    let pair = result.states.pairs.get(sphere.pair);
    let name =
        pair.and_then(|pair| result.opened.model.sphere(pair.sphere)).map(|sphere| sphere.name.as_str());
    let fastest = sphere.touch_downs.iter().max_by(|a, b| a.impact_speed_m_s.total_cmp(&b.impact_speed_m_s));
    let cell = |value: Option<f64>| value.map_or_else(|| "-".to_owned(), |value| format!("{value:.3}"));
    vec![
        shown(name.unwrap_or_default()).to_string(),
        format!("{:.0}", sphere.peak_n),
        format!("{:.3}", sphere.largest_relative_indentation),
        format!("{:.3}", sphere.largest_at_s),
        format!("{:.3}", sphere.beyond_hertz_s),
        cell(sphere.slip_m_s),
        cell(fastest.map(|touch| touch.impact_speed_m_s)),
        cell(fastest.and_then(|touch| touch.restitution)),
    ]
}
