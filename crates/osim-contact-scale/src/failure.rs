//! What went wrong with one model, as one line and a snippet of the file.

use annotate_snippets::{AnnotationKind, Group, Level, Renderer, Snippet};
use osim_model::Excerpt;
use osim_model::files::Failure;

use crate::terminal::Terminal;
use crate::words::Words;

/// Reports it on standard error: one sentence, then the place in the file where that helps.
pub(crate) fn report(failure: &Failure, words: Words, terminal: &mut Terminal) {
    let place = match (failure.line, failure.column) {
        (Some(line), Some(column)) => format!("{}:{line}:{column}", failure.model),
        _ => failure.model.to_string(),
    };
    let message = failure.message.spelled(words);
    // Messages about outputs name them. If an output is the model itself, it is named already.
    let message = message.strip_prefix(&format!("{} ", failure.model)).unwrap_or(&message);
    terminal.error(&format!("error: {place}: {message}\n"));
    if let Some(excerpt) = &failure.excerpt {
        terminal.excerpt(&format!("{}\n", snippet(excerpt)));
    }
}

/// The line with carets below it.
fn snippet(excerpt: &Excerpt) -> String {
    let source = Snippet::source(excerpt.text.as_str()).line_start(excerpt.line);
    let marked = source.annotation(AnnotationKind::Primary.span(excerpt.marked.clone()));
    Renderer::plain().render(&[Group::with_level(Level::ERROR).element(marked)])
}
