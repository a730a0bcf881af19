//! Tests of the explanations of all topics.

use osim_requests::spell::{CommandLine, FrontEnd, Page, Python};
use osim_view::report::explain::{self, Alphabet, Topic, TopicRecord};
use osim_view::report::json::line;
use osim_view::report::layout::WIDTH;

/// The width of a line in columns. The hat of x̂ needs no column.
fn columns(line: &str) -> usize {
    line.chars().filter(|letter| *letter != '\u{302}').count()
}

#[test]
fn every_topic_is_explained_in_the_words_of_each_front_end() {
    for topic in Topic::all() {
        for front_end in [&CommandLine as &dyn FrontEnd, &Python, &Page] {
            let text = explain::text(topic, front_end, Alphabet::Unicode, WIDTH);
            assert!(!text.contains('`'), "{text}");
            assert!(text.lines().all(|line| columns(line) <= 80), "{text}");
        }
        for text in [
            explain::text(topic, &Python, Alphabet::Unicode, WIDTH),
            explain::text(topic, &Page, Alphabet::Unicode, WIDTH),
        ] {
            assert!(!text.contains(" --") && !text.contains("(--"), "{text}");
        }
    }
}

#[test]
fn topics_are_told_with_what_to_do() {
    let text = |name: &str, letters| -> String {
        let topics = Topic::find(name).unwrap();
        topics.into_iter().map(|topic| explain::text(topic, &CommandLine, letters, WIDTH)).collect()
    };
    insta::assert_snapshot!("explain_equation", text("C.8", Alphabet::Unicode));
    insta::assert_snapshot!("explain_equation_ascii", text("C.8", Alphabet::Ascii));
    insta::assert_snapshot!("explain_rule", text("follow", Alphabet::Unicode));
    insta::assert_snapshot!("explain_warning", text("already-at-target", Alphabet::Unicode));
    insta::assert_snapshot!("explain_error", text("output", Alphabet::Unicode));
}

#[test]
fn records_of_topics_begin_with_their_kind() {
    let record = |name| line(&TopicRecord::new(Topic::find(name).unwrap()[0], &CommandLine));
    let equation = record("level");
    assert!(
        equation.starts_with(r#"{"kind":"equation","schema_version":1,"label":"level","title":"#),
        "{equation}"
    );
    assert!(
        equation.contains(r#""source":"your request: --level","used":"--level: centre of spheres"}"#),
        "{equation}"
    );
    assert_eq!(
        record("several-trees"),
        "{\"kind\":\"error\",\"schema_version\":1,\"code\":\"several-trees\",\"means\":\"contact spheres are on bodies that are joined only through ground (player and ball): which of them have to be changed?\",\"way_out\":\"--select GLOB\"}\n"
    );
    assert!(record("sunk-in").starts_with(
        r#"{"kind":"finding","schema_version":1,"code":"sunk-in","severity":"error","checked":true,"what":"#
    ));
}

#[test]
fn the_list_of_topics_names_every_topic() {
    let all = Topic::all();
    let list = explain::list(&all, &CommandLine, Alphabet::Ascii, WIDTH);
    assert!(list.is_ascii() && list.lines().all(|line| line.chars().count() <= 80), "{list}");
    for topic in all {
        assert!(list.contains(topic.name()), "{}", topic.name());
    }
}
