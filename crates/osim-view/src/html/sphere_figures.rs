//! Figures of spheres: a column for each group of equal spheres and each state of the model.

use std::collections::HashMap;

use indexmap::{IndexMap, IndexSet};
use maud::{Markup, html};
use osim_inspect::{Figure, Figures, SphereFigures};

use crate::html::explained::{first_names_and_count, marked_outside};
use crate::html::fragment::{Fragment, scrollable, table_if_any};
use crate::report::extent::Extent;
use crate::report::inspection::spheres::{
    FigureText, Spheres, UNEVEN_CAPTION, equally_deep, heading, key, limit, value,
};
use crate::report::layout::OUTSIDE_MARK;

/// Id and title of the section with figures of spheres.
pub(super) const SECTION_HEAD: (&str, &str) = ("figures", "Load, indentation and restitution of the spheres");
/// The largest number of columns of numbers in one table.
const MOST_FIGURE_COLUMNS: usize = 6;

/// The figures of the model in one state, and the name of this state.
pub(super) struct ModelState<'s> {
    pub(super) name: String,
    pub(super) figures: &'s Figures,
    /// Whether this state is the reference, so another body, whose spheres may have other names.
    pub(super) is_reference: bool,
}

/// Finds the spheres of a state by path or name.
struct SphereLookup<'s> {
    by_path: HashMap<&'s str, &'s SphereFigures>,
    /// The figures of the reference's spheres, by the name of the sphere.
    by_name: HashMap<&'s str, &'s SphereFigures>,
    /// Any sphere of the reference, if all its spheres are equal.
    any: Option<&'s SphereFigures>,
}

impl<'s> SphereLookup<'s> {
    /// Sorts the spheres of `state` by path and name.
    fn of(state: &ModelState<'s>) -> Self {
        let mut lookup = Self { by_path: HashMap::new(), by_name: HashMap::new(), any: None };
        for sphere in state.figures.spheres() {
            lookup.by_path.entry(&sphere.path).or_insert(sphere);
            if state.is_reference {
                lookup.by_name.entry(&sphere.sphere).or_insert(sphere);
            }
        }
        let first = state.figures.spheres().next().filter(|_| state.is_reference);
        lookup.any = first.filter(|first| {
            let first = key(first, Extent::Brief);
            state.figures.spheres().all(|other| key(other, Extent::Brief) == first)
        });
        lookup
    }

    /// The sphere of this state with which `sphere` of the model is compared: the sphere with the same path; in a reference also the sphere
    /// with the same name, or any sphere if all are equal.
    fn sphere_like(&self, sphere: &SphereFigures) -> Option<&'s SphereFigures> {
        let by_path = self.by_path.get(sphere.path.as_str());
        by_path.or_else(|| self.by_name.get(sphere.sphere.as_str())).copied().or(self.any)
    }
}

/// Spheres whose figures are equal in every state.
struct SphereGroup<'s> {
    names: Vec<&'s str>,
    limbs: IndexSet<&'s str>,
    /// One sphere of the group in each state.
    spheres: Vec<Option<&'s SphereFigures>>,
    mixed: bool,
}

/// Adds the section about the spheres. If figures are missing, a sentence says why.
pub(super) fn section(fragment: &mut Fragment, states: &[ModelState<'_>]) {
    let groups = sphere_groups(states);
    let groups_per_table = (MOST_FIGURE_COLUMNS / states.len().max(1)).max(1);
    let why =
        states.iter().find_map(|state| state.figures.why_no_body_weight.as_ref()).map(ToString::to_string);
    let mut body = html! {
        @if let Some(why) = why { p.aside { "No values under body weight: " (why) "." } }
        @if groups.is_empty() { p { "No sphere of a chosen force touches a half-space." } }
        @else { p { "BW: body weight, on one limb unless the call says otherwise. Restitution is that of a fall from a quarter of the radius, √(gR/2), unless the call says otherwise." } }
    };
    let mut outside = false;
    for (index, chunk) in groups.chunks(groups_per_table).enumerate() {
        let first = index * groups_per_table + 1;
        let table = figures_table(fragment, states, chunk, first, &mut outside);
        body = html! {
            (body)
            ul.groups { @for (index, group) in chunk.iter().enumerate() { li { b { "S" (first + index) } " " (names_with_limbs(group)) } } }
            (table)
        };
    }
    for state in states {
        body = html! { (body) (own_heights_table(state)) };
    }
    if outside {
        body = html! { (body) p.quiet { (OUTSIDE_MARK) " outside the limit; Findings says more." } };
    }
    fragment.add_section(SECTION_HEAD.0, SECTION_HEAD.1, &body);
}

/// The table of spheres at their own heights; empty if all bottoms are at one height.
fn own_heights_table(state: &ModelState<'_>) -> Markup {
    let rows = html! {
        @for row in equally_deep(state.figures, Extent::Brief) {
            tr {
                th scope="row" { (row.limb) }
                @for value in &row.indentation { td { (value) } }
                td.words { (first_names_and_count(&row.spheres)) }
            }
        }
    };
    let caption = format!("{}: {UNEVEN_CAPTION}.", state.name);
    table_if_any(
        "Spheres at their own heights",
        &caption,
        &["limb", "Hertz", "the model's law", " spheres"],
        &rows,
    )
}

fn sphere_groups<'s>(states: &'s [ModelState<'s>]) -> Vec<SphereGroup<'s>> {
    let Some(first) = states.first() else { return Vec::new() };
    let lookups: Vec<SphereLookup<'s>> = states.iter().map(SphereLookup::of).collect();
    let mut groups: IndexMap<Vec<String>, SphereGroup<'s>> = IndexMap::new();
    for limb in &first.figures.limbs {
        let mixed = limb.is_mixed();
        for sphere in &limb.spheres {
            let spheres: Vec<Option<&SphereFigures>> =
                lookups.iter().map(|state| state.sphere_like(sphere)).collect();
            let key = spheres
                .iter()
                .flat_map(|sphere| sphere.map(|sphere| key(sphere, Extent::Brief)).unwrap_or_default())
                .collect();
            let new = SphereGroup { names: Vec::new(), limbs: IndexSet::new(), spheres, mixed };
            let group = groups.entry(key).or_insert(new);
            group.names.push(&sphere.sphere);
            group.limbs.insert(limb.limb.as_deref().unwrap_or_default());
        }
    }
    groups.into_values().collect()
}

fn names_with_limbs(group: &SphereGroup<'_>) -> String {
    let limbs: Vec<&str> = group.limbs.iter().copied().filter(|limb| !limb.is_empty()).collect();
    let limbs = if limbs.is_empty() { String::new() } else { format!(" ({})", limbs.join(", ")) };
    format!("{}{limbs}", first_names_and_count(&group.names))
}

fn figures_table(
    fragment: &mut Fragment,
    states: &[ModelState<'_>],
    groups: &[SphereGroup<'_>],
    first: usize,
    outside: &mut bool,
) -> Markup {
    let several = states.len() > 1;
    let mixed = groups.iter().any(|group| group.mixed);
    let spheres = || groups.iter().flat_map(|group| group.spheres.iter().flatten());
    let speed = states.first().and_then(|state| state.figures.impact_speed_m_s);
    let rows: Vec<Markup> = Spheres::new(mixed, spheres().copied())
        .figures()
        .filter(|&figure| spheres().any(|sphere| value(figure, sphere, Extent::Brief).is_some()))
        .map(|figure| figure_row(fragment, figure, speed.filter(|_| !several), groups, outside))
        .collect();
    let caption = match states.last() {
        Some(last) if last.is_reference => {
            "Figures of the spheres, before and after, and those of the reference"
        }
        _ if several => "Figures of the spheres, before and after",
        _ => "Figures of the spheres",
    };
    let table = html! {
        table {
            caption { span { (caption) } }
            thead {
                tr {
                    th scope="col" rowspan=[several.then_some(2)] { "figure" }
                    th scope="col" rowspan=[several.then_some(2)] { "limit" }
                    @for index in 0..groups.len() {
                        th scope=(if several { "colgroup" } else { "col" }) colspan=[several.then_some(states.len())] {
                            "S" (first + index)
                        }
                    }
                }
                @if several { tr { @for _ in groups { @for state in states { th scope="col" { (state.name) } } } } }
            }
            tbody { @for row in rows { (row) } }
        }
    };
    scrollable("Figures of the spheres", &table)
}

fn figure_row(
    fragment: &mut Fragment,
    figure: Figure,
    speed: Option<f64>,
    groups: &[SphereGroup<'_>],
    outside: &mut bool,
) -> Markup {
    let name = heading(figure, speed, Extent::Brief);
    let part = name.starts_with(' ');
    let name = fragment.topics.with_links_to_equations(name.trim_start_matches(' '));
    html! {
        tr {
            th class=[part.then_some("part")] scope="row" { (name) }
            td { (limit(figure).replace(">=", "≥").replace("<=", "≤")) }
            @for sphere in groups.iter().flat_map(|group| &group.spheres) { (figure_cell(figure, *sphere, outside)) }
        }
    }
}

fn figure_cell(figure: Figure, sphere: Option<&SphereFigures>, outside: &mut bool) -> Markup {
    match sphere.and_then(|sphere| value(figure, sphere, Extent::Brief)) {
        None => html! { td { "–" } },
        Some(FigureText { text, outside: false }) => html! { td { (text) } },
        Some(FigureText { text, outside: true }) => {
            *outside = true;
            html! { td.outside { (marked_outside(&text)) } }
        }
    }
}
