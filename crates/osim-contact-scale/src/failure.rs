//! What went wrong with one model, as one line (and a snippet) or as JSON.

use annotate_snippets::{AnnotationKind, Group, Level, Renderer, Snippet};
use osim_patch::Fault;
use serde::Serialize;

/// One model that could not be done.
#[derive(Debug, Clone)]
pub(crate) struct Failure {
    pub model: String,
    pub code: &'static str,
    pub message: String,
    pub line: Option<usize>,
    pub column: Option<usize>,
    pub snippet: Option<String>,
}

#[derive(Serialize)]
struct Json<'f> {
    schema_version: u32,
    model: &'f str,
    error: JsonError<'f>,
}

#[derive(Serialize)]
struct JsonError<'f> {
    code: &'f str,
    message: &'f str,
    line: Option<usize>,
    column: Option<usize>,
}

impl Failure {
    /// A fault in the bytes of `model`.
    pub(crate) fn of_fault(model: &str, fault: Fault, bytes: &[u8]) -> Self {
        let fault = fault.located(bytes);
        let snippet =
            fault.span.clone().or(fault.offset.map(|at| at..at)).and_then(|span| snippet(bytes, span));
        Self {
            model: model.to_owned(),
            code: fault.code(),
            message: fault.to_string(),
            line: fault.position.map(|position| position.line),
            column: fault.position.map(|position| position.column),
            snippet,
        }
    }

    /// Something outside the model's contents: files, folders, permissions.
    pub(crate) fn outside(model: &str, code: &'static str, error: &anyhow::Error) -> Self {
        let message = format!("{error:#}");
        Self { model: model.to_owned(), code, message, line: None, column: None, snippet: None }
    }

    /// One line for standard error, then the place in the file where that helps.
    pub(crate) fn text(&self) -> String {
        let place = match (self.line, self.column) {
            (Some(line), Some(column)) => format!("{}:{line}:{column}", self.model),
            _ => self.model.clone(),
        };
        let line = format!("error: {place}: {}\n", self.message);
        match &self.snippet {
            Some(snippet) => format!("{line}{snippet}\n"),
            None => line,
        }
    }

    pub(crate) fn json(&self) -> String {
        let error =
            JsonError { code: self.code, message: &self.message, line: self.line, column: self.column };
        super::report::json::line(&Json { schema_version: 1, model: &self.model, error })
    }
}

/// The line of `span` with a caret below it; none where the place is the whole file.
fn snippet(bytes: &[u8], span: std::ops::Range<usize>) -> Option<String> {
    let start = bytes.get(..span.start)?.iter().rposition(|&byte| byte == b'\n').map_or(0, |at| at + 1);
    let end = bytes
        .get(span.start..)?
        .iter()
        .position(|&byte| byte == b'\n')
        .map_or(bytes.len(), |at| span.start + at);
    let line = bytes.get(start..end)?;
    // What is not text (UTF-16, an image) has nothing to show.
    let text =
        std::str::from_utf8(line).ok().filter(|text| !text.contains('\0') && !text.trim().is_empty())?;
    let text = text.trim_start_matches('\u{feff}');
    let shift = line.len() - text.len();
    let number = bytes.get(..start)?.iter().filter(|&&byte| byte == b'\n').count() + 1;
    let from = (span.start - start).checked_sub(shift)?;
    let to = span.end.min(end).checked_sub(start + shift)?.max(from);
    let source = Snippet::source(text.trim_end_matches('\r')).line_start(number);
    let report =
        [Group::with_level(Level::ERROR).element(source.annotation(AnnotationKind::Primary.span(from..to)))];
    Some(Renderer::plain().render(&report))
}
