//! Tests of pages: sections, escapes, and omissions on the page of a large library.

use osim_inspect::InspectOptions;
use osim_model::files::{Failure, OpenModel};
use osim_model::messages::Verb;
use osim_planning::{BeforeAfter, ModelFeet};
use osim_requests::spell::{CommandLine, FrontEnd, Python};
use osim_view::html::{
    ChangedModelOnPage, Columns, DeferredParts, DetailLevel, Entry, InspectedModelOnPage, ListedFiles,
    NamedDigest, Page, PageHead, RunRow, entry_of_changed_model, entry_of_inspected_model,
};

use crate::support::{self, open, rescaled};

fn page_text(head: PageHead, front_end: &dyn FrontEnd, entries: impl IntoIterator<Item = Entry>) -> String {
    let mut page = Page::new(head, DeferredParts::<String>::default(), front_end);
    entries.into_iter().for_each(|entry| page.add(entry));
    let mut bytes = Vec::new();
    page.finish(&mut bytes).unwrap();
    String::from_utf8(bytes).unwrap()
}

fn head_of_check(model: Option<&str>) -> PageHead {
    let call = "osim-contact-scale check a.osim".to_owned();
    PageHead { verb: Verb::Check, model: model.map(str::to_owned), columns: Columns::Inspections, call }
}

fn head_of_changes(model: Option<&str>) -> PageHead {
    let call = "osim-contact-scale a.osim".to_owned();
    PageHead { verb: Verb::Rescale, model: model.map(str::to_owned), columns: Columns::Changes, call }
}

fn entry_of_model(model: &OpenModel, detail: DetailLevel, front_end: &dyn FrontEnd) -> Entry {
    let options = InspectOptions::default();
    let (seen, found) = support::inspected(&options, model, front_end);
    let shown = InspectedModelOnPage {
        options: &options,
        model,
        examined: (&seen, &found),
        files: &[NamedDigest { name: model.name().to_string(), sha256: "0123".to_owned() }],
        feet: ModelFeet::for_page(model.name(), model, &options.selection),
        recording: None,
    };
    entry_of_inspected_model(shown, detail, front_end)
}

/// Asserts that the page has the target of every link, and no target twice.
fn assert_anchors(page: &str) {
    let values = |attribute: &str| -> Vec<String> {
        let starts = page.split(attribute).skip(1);
        starts.map(|rest| rest.split('"').next().unwrap_or_default().to_owned()).collect()
    };
    let anchors = values(" id=\"");
    for anchor in &anchors {
        assert_eq!(anchors.iter().filter(|other| *other == anchor).count(), 1, "{anchor} is there twice");
    }
    for link in values(" href=\"#") {
        assert!(anchors.contains(&link), "{link} leads nowhere");
    }
}

/// x/R of this model is 0.3533 (Falisse 2022, Hertz), beyond the limit of 0.16.
#[test]
fn a_figure_and_its_mark_stay_together_and_nothing_is_shown_as_an_escape() {
    let model = open("table1/human_62kg_smooth_sphere.osim");
    let detail = DetailLevel::Alone;
    for name in [Some(&**model.name()), None] {
        let text =
            page_text(head_of_check(name), &CommandLine, [entry_of_model(&model, detail, &CommandLine)]);
        assert!(text.contains("0.3533\u{a0}!"), "{name:?}");
        assert!(!text.contains("\\u{"), "{name:?}");
    }
}

#[test]
fn one_model_has_sections_plots_and_explanations() {
    let model = open("check/beyond_hertz.osim");
    let text = page_text(
        head_of_check(Some(model.name())),
        &CommandLine,
        [entry_of_model(&model, DetailLevel::Alone, &CommandLine)],
    );
    assert!(text.starts_with("<!DOCTYPE html>\n<html lang=\"en\">"));
    assert!(text.contains("<title>Check of contacts: beyond_hertz.osim</title>"));
    for section in [
        "glance",
        "asked",
        "findings",
        "feet",
        "plots",
        "figures",
        "contacts",
        "model",
        "explained",
        "origin",
    ] {
        assert!(text.contains(&format!("<a href=\"#{section}\">")), "{section}");
    }
    assert_eq!(text.matches("<svg").count(), 4);
    assert!(text.contains("SHA-256 <code class=\"digest\">0123</code>"));
    assert_anchors(&text);
}

#[test]
fn names_from_files_are_escaped_on_a_page() {
    let failure = Failure::outside("<b>.osim", "unreadable", "it is \"not\" <there>".to_owned());
    let call = "inspect '<b>.osim'".to_owned();
    let head = PageHead { verb: Verb::Inspect, model: None, columns: Columns::Inspections, call };
    let text = page_text(head, &CommandLine, [Entry::failed(&failure, &CommandLine)]);
    assert!(!text.contains("<b>.osim") && !text.contains("<there>"));
    assert!(text.contains("&lt;b&gt;.osim") && text.contains("failed: it is &quot;not&quot; &lt;there&gt;"));
    assert_anchors(&text);
}

#[test]
fn a_change_is_shown_before_and_after() {
    let model = open("table1/human_62kg_smooth_sphere.osim");
    let plan = rescaled(&model.model, 500.0, &CommandLine);
    let options = InspectOptions::default();
    let states = BeforeAfter {
        before: support::inspected(&options, &model, &CommandLine),
        before_under_new_weight: None,
        after: None,
        bodies: Vec::new(),
        feet: Vec::new(),
        reference: None,
        recording: None,
        target_gravity_m_s2: None,
    };
    let mut row = RunRow::new(&**model.name(), "dry run: nothing written");
    row.contacts_mass_kg = Some(62.0);
    row.target_mass_kg = Some(500.0);
    row.changes = plan.changes.len();
    let change = || ChangedModelOnPage::new(&plan, &states, ListedFiles::default());
    let one = entry_of_changed_model(&row, change(), DetailLevel::Alone, &CommandLine);
    let text = page_text(head_of_changes(Some(model.name())), &CommandLine, [one]);
    assert!(text.contains("<h2 id=\"changes-title\">What changed</h2>"));
    assert!(text.contains("<code>stiffness</code>"), "{text}");
    assert_anchors(&text);
    let one = entry_of_changed_model(&row, change(), DetailLevel::OneOfMany, &CommandLine);
    let text = page_text(head_of_changes(None), &CommandLine, [one]);
    assert!(text.contains(">62 → 500</td>") && !text.contains("<svg"), "{text}");
    // R follows M^(1/3): 0.032 m × (500/62)^(1/3) = 0.06417 m; E1* likewise, from 1e6 N/m².
    assert!(text.contains("0.032 → 0.06417 <br><span class=\"quiet\">×2.005</span>"), "{text}");
    assert!(text.contains("1000000 → 2005000"), "{text}");
    assert_anchors(&text);
}

#[test]
fn special_models_have_plots_and_the_others_say_how_to_get_them() {
    let models = ["table1/human_62kg_smooth_sphere.osim", "table1/mouse_hunt_crossley.osim"];
    let models: Vec<OpenModel> = models.iter().chain(&[models[1]; 10]).map(|name| open(name)).collect();
    let entries = |front_end: &dyn FrontEnd, detail: DetailLevel| -> Vec<Entry> {
        models.iter().map(|model| entry_of_model(model, detail, front_end)).collect()
    };
    let text = page_text(head_of_check(None), &CommandLine, entries(&CommandLine, DetailLevel::OneOfFew));
    // Two bodies, each with three plots and its feet; and the chart of all models.
    assert_eq!(text.matches("<svg").count(), 2 * 4 + 1);
    // Table 1: the mouse's sphere sinks in by 0.56 of its radius, the human's by 0.35.
    let why = [
        "heaviest (62 kg)",
        "lightest (0.0209 kg)",
        "deepest at rest (x̂ = 0.56",
        "the first of 11 with the most common",
    ];
    for why in why {
        assert!(text.contains(why), "{why}");
    }
    assert!(text.contains("<title>Check of contacts: 12 models</title>"));
    assert!(text.contains("<b>12 of 12</b> deeper at rest than x̂ = 0.16"), "{text}");
    assert!(text.contains("limit, x̂ = 0.16"));
    assert_anchors(&text);
    let text = page_text(head_of_check(None), &Python, entries(&Python, DetailLevel::OneOfMany));
    assert!(text.contains("ocs.plot(&quot;force&quot;, &quot;model.osim&quot;).save(&quot;FILE.svg&quot;)"));
}

#[test]
fn a_page_says_what_it_leaves_out_only_where_it_does() {
    let model = open("check/within_limits.osim");
    let of = |models: usize| {
        let entries = (0..models).map(|_| entry_of_model(&model, DetailLevel::OneOfMany, &CommandLine));
        page_text(head_of_check(None), &CommandLine, entries)
    };
    let text = of(1000);
    assert_eq!(text.matches("<details>").count(), 1000);
    assert!(!text.contains("shown in full."));
    let text = of(1001);
    assert_eq!(text.matches("<details>").count(), 1000);
    assert!(text.contains("Only the first 1000 models are shown in full. For any other"), "{text}");
}

#[test]
fn names_may_be_broken_at_folders() {
    let row = |name: &str| Entry::of_row(&RunRow::new(name, "unchanged"));
    let text = page_text(head_of_changes(None), &CommandLine, [row("a/b<c>.osim"), row(r"C:\models\d.osim")]);
    assert!(
        text.contains("a/<wbr>b&lt;c&gt;.osim") && text.contains(r"C:\<wbr>models\<wbr>d.osim"),
        "{text}"
    );
}

#[test]
fn rows_say_what_became_of_models_that_are_not_shown() {
    let mut row = RunRow::new("a.osim", "written");
    row.row = Some(3);
    row.output = Some("b.osim".to_owned());
    let failed = RunRow::new("c.osim", "failed");
    let entries = [
        Entry::of_earlier_run(&row, [None, Some(2.0), None], "radius", 0),
        Entry::failed_row(&failed, "no-mass", "body 'a' has no mass", (Some(4), Some(2))),
        Entry::of_row(&RunRow::new("d.osim", "not begun: the run was stopped")),
        Entry::without_contacts("e.osim"),
    ];
    let text = page_text(head_of_changes(None), &CommandLine, entries);
    assert!(text.contains("row 3: a.osim → b.osim"));
    assert!(text.contains(
        "written †</td><td></td><td>0</td><td><span class=\"quiet\">unequal</span></td><td><span class=\"quiet\">×2</span></td>"
    ));
    assert!(text.contains("1 model done by an earlier run of this call, marked with †."));
    assert!(text.contains(
        "failed: line 4, column 2: body 'a' has no mass</td><td class=\"words\"><a class=\"code\" href=\"#error-no-mass\">"
    ));
    // Failures come before everything else.
    assert!(text.find("c.osim").unwrap() < text.find("The command of this page</h2>").unwrap());
    assert!(text.contains("not begun: the run was stopped") && text.contains("skipped: no contacts"));
    assert_anchors(&text);
}

#[test]
fn a_page_that_cannot_be_kept_says_so_at_the_end() {
    struct FullDisk;

    impl osim_view::html::DeferredText for FullDisk {
        fn add(&mut self, _: &str) -> std::io::Result<()> {
            Err(std::io::Error::other("the disk is full"))
        }

        fn write_to(&mut self, _: &mut dyn std::io::Write) -> std::io::Result<()> {
            Ok(())
        }
    }

    let mut page = Page::new(
        head_of_check(None),
        DeferredParts { failures: FullDisk, rows: FullDisk, details: FullDisk },
        &CommandLine,
    );
    page.add(Entry::without_contacts("a.osim"));
    page.add(Entry::without_contacts("b.osim"));
    let error = page.finish(&mut Vec::new()).unwrap_err();
    assert_eq!(error.to_string(), "the disk is full");
}
