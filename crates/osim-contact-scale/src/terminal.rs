//! Writes to standard output and standard error. A reader that ends early (`… | head`) is no failure.
//! On Windows, the window of a model that was dropped on the program stays open.
//!
//! Text for people is broken at blanks into lines that fit the terminal. Files and pipes get unbroken lines, because programs search
//! in lines. The variable `COLUMNS` does not count for files and pipes: readline sets it in an interactive Python or Octave, which
//! hand it on to this program.

use std::borrow::Cow;
use std::fmt::Write;
use std::io::{self, ErrorKind, IsTerminal, Write as _};
use std::sync::atomic::{AtomicUsize, Ordering};

use indicatif::{ProgressBar, ProgressState, ProgressStyle};
use osim_model::messages::{one_line, terminal_safe};
use osim_view::report::layout::{WIDTH, break_long_lines};
use terminal_size::Width;

/// Standard output and standard error of the command.
pub(crate) struct Terminal {
    gone: bool,
    /// Whether texts for people are left out, except errors.
    is_quiet: bool,
    /// Columns of standard output; `None` if its lines are not broken.
    out: Option<usize>,
    err: Option<usize>,
}

impl Terminal {
    /// The standard streams of this process.
    pub(crate) fn new() -> Self {
        let (out, err) = (io::stdout(), io::stderr());
        Self {
            gone: false,
            is_quiet: false,
            out: columns(out.is_terminal(), terminal_size::terminal_size_of(&out).map(|(width, _)| width)),
            err: columns(err.is_terminal(), terminal_size::terminal_size_of(&err).map(|(width, _)| width)),
        }
    }

    /// Prints only errors and results for programs from now on.
    pub(crate) fn keep_quiet(&mut self) {
        self.is_quiet = true;
    }

    /// Breaks no lines from now on, because a program reads the text for people.
    pub(crate) fn never_break_lines(&mut self) {
        (self.out, self.err) = (None, None);
    }

    /// Prints a result for people on standard output.
    pub(crate) fn print(&mut self, text: &str) -> io::Result<()> {
        if self.is_quiet {
            return Ok(());
        }
        let text = fitted(&terminal_safe(text), self.out).into_owned();
        self.write_bytes(text.as_bytes())
    }

    /// Prints results for programs on standard output: each record is one line.
    pub(crate) fn print_records(&mut self, text: &str) -> io::Result<()> {
        self.write_bytes(terminal_safe(text).as_bytes())
    }

    /// Prints a result on standard output, with unbroken lines if `is_for_programs`.
    pub(crate) fn print_as(&mut self, text: &str, is_for_programs: bool) -> io::Result<()> {
        if is_for_programs { self.print_records(text) } else { self.print(text) }
    }

    /// Prints a diff. Programs that apply it need its lines unchanged. Control characters are written by their numbers: XML allows none
    /// in a model, and the output of a pipe may reach a terminal.
    pub(crate) fn print_diff(&mut self, text: &str) -> io::Result<()> {
        if io::stdout().is_terminal() {
            return self.print_records(text);
        }
        let steers = |letter: char| letter.is_control() && !matches!(letter, '\n' | '\t' | '\r');
        let mut out = String::with_capacity(text.len());
        for letter in text.chars() {
            if steers(letter) { out.extend(letter.escape_unicode()) } else { out.push(letter) }
        }
        self.write_bytes(out.as_bytes())
    }

    /// Prints results with colours; files and pipes get them without colours.
    pub(crate) fn print_painted(&mut self, text: &str) -> io::Result<()> {
        if self.gone || self.is_quiet {
            return Ok(());
        }
        let text = harmless_but_colours(text);
        let mut out = anstream::stdout().lock();
        let written = out.write_all(fitted(&text, self.out).as_bytes()).and_then(|()| out.flush());
        self.gone = written.as_ref().is_err_and(|error| error.kind() == ErrorKind::BrokenPipe);
        without_closed_pipe(written)
    }

    /// Writes the unchanged bytes of a model or another file to standard output.
    pub(crate) fn write_bytes(&mut self, bytes: &[u8]) -> io::Result<()> {
        if self.gone {
            return Ok(());
        }
        let mut out = io::stdout().lock();
        let written = out.write_all(bytes).and_then(|()| out.flush());
        // What follows a gap is of no use: it is left out, and the failure is reported once.
        self.gone = written.is_err();
        without_closed_pipe(written)
    }

    /// Columns of standard output; `None` if lines are not broken, as in files and pipes.
    pub(crate) fn columns(&self) -> Option<usize> {
        self.out
    }

    /// Columns of standard error; `None` if lines are not broken.
    pub(crate) fn columns_of_errors(&self) -> Option<usize> {
        self.err
    }

    /// Prints text that is not a result on standard error.
    pub(crate) fn print_to_stderr(&mut self, text: &str) -> io::Result<()> {
        if self.is_quiet { Ok(()) } else { self.print_to_stderr_unbroken(&fitted(text, self.err)) }
    }

    /// Prints text that is not a result on standard error, with unbroken lines.
    pub(crate) fn print_to_stderr_unbroken(&mut self, text: &str) -> io::Result<()> {
        without_closed_pipe(io::stderr().lock().write_all(terminal_safe(text).as_bytes()))
    }

    /// Prints a failure on standard error. If standard error is closed, does nothing.
    pub(crate) fn error(&mut self, text: &str) {
        let _ = io::stderr().lock().write_all(fitted(&terminal_safe(text), self.err).as_bytes());
    }

    /// Prints a failure in one sentence on standard error.
    pub(crate) fn error_line(&mut self, text: &str) {
        self.error(&format!("error: {}\n", one_line(text.to_owned())));
    }

    /// Prints a remark in one line on standard error.
    pub(crate) fn remark(&mut self, text: &str) -> io::Result<()> {
        self.print_to_stderr(&format!("remark: {}\n", one_line(text.to_owned())))
    }
}

/// The result of writing; a reader that has gone away is no failure.
pub(crate) fn without_closed_pipe(written: io::Result<()>) -> io::Result<()> {
    match written {
        Err(error) if error.kind() == ErrorKind::BrokenPipe => Ok(()),
        result => result,
    }
}

/// Columns of a stream. A terminal of unknown width, or of width 0, gets the width of an old terminal.
fn columns(is_terminal: bool, width: Option<Width>) -> Option<usize> {
    let known = width.map(|width| usize::from(width.0)).filter(|&columns| columns > 0);
    is_terminal.then(|| known.unwrap_or(WIDTH))
}

/// The text, broken into lines of at most this number of columns.
fn fitted(text: &str, columns: Option<usize>) -> Cow<'_, str> {
    columns.map_or(Cow::Borrowed(text), |columns| break_long_lines(text, columns).into())
}

/// The text without control characters except those for colours, so that it cannot steer a terminal.
fn harmless_but_colours(text: &str) -> String {
    let mut parts = text.split("\u{1b}[");
    let mut out = terminal_safe(parts.next().unwrap_or_default()).into_owned();
    for part in parts {
        let end = part.find(|c: char| !c.is_ascii_digit() && c != ';');
        let colour = end.filter(|&end| part[end..].starts_with('m')).map(|end| part.split_at(end + 1));
        let (mark, (colour, rest)) = colour.map_or((r"\u{1b}[", ("", part)), |split| ("\u{1b}[", split));
        out.extend([mark, colour, &terminal_safe(rest)]);
    }
    out
}

// How far a run is: on a terminal only, and only with several models.

/// A progress bar: finished models, their rate, the remaining time, and failures.
pub(crate) struct Progress {
    bar: ProgressBar,
    failures: AtomicUsize,
}

impl Progress {
    pub(crate) fn begin(models: usize, quiet: bool) -> Self {
        let hidden = models < 2 || quiet || !io::stderr().is_terminal();
        let bar = if hidden { ProgressBar::hidden() } else { ProgressBar::new(models as u64) };
        let style = ProgressStyle::with_template(
            "{wide_bar} {human_pos}/{human_len} models, {rate}, {eta} left{msg}",
        );
        if let Ok(style) = style {
            let rate = |state: &ProgressState, text: &mut dyn Write| {
                // A terminal that cannot be written to shows no bar at all.
                let _ = write!(text, "{:.0}/s", state.per_sec());
            };
            bar.set_style(style.with_key("rate", rate).progress_chars("##-"));
        }
        Self { bar, failures: AtomicUsize::new(0) }
    }

    pub(crate) fn count_model(&self, failed: bool) {
        if self.bar.is_hidden() {
            return;
        }
        if failed {
            let failures = self.failures.fetch_add(1, Ordering::Relaxed) + 1;
            self.bar.set_message(format!(", {failures} failed"));
        }
        self.bar.inc(1);
    }

    /// Hides the progress bar while `write` writes to the terminal.
    pub(crate) fn suspended<T>(&self, write: impl FnOnce() -> T) -> T {
        if self.bar.is_hidden() { write() } else { self.bar.suspend(write) }
    }

    pub(crate) fn end(&self) {
        self.bar.finish_and_clear();
    }
}

// A window that closes too soon: Windows takes it away, with all it shows, when a program that Explorer started ends.

/// If a model was dropped on the program's icon, waits for Enter, so that the user has time to read.
#[cfg(windows)]
pub(crate) fn keep_open(terminal: &mut Terminal) {
    use std::io::{IsTerminal, stdin, stdout};
    // Asking for the parent costs some milliseconds; elsewhere there is no need to.
    if !stdout().is_terminal() || !stdin().is_terminal() {
        return;
    }
    if parent_of(std::process::id()).is_some_and(|name| name.eq_ignore_ascii_case("explorer.exe")) {
        terminal.error("\npress Enter to close this window");
        // Whatever comes, the window may go.
        let _ = stdin().read_line(&mut String::new());
    }
}

#[cfg(not(windows))]
pub(crate) fn keep_open(_terminal: &mut Terminal) {}

/// File name of the program that started the process with the number `process`.
#[cfg(windows)]
fn parent_of(process: u32) -> Option<String> {
    use winsafe::{HPROCESSLIST, co::TH32CS};
    let mut list = HPROCESSLIST::CreateToolhelp32Snapshot(TH32CS::SNAPPROCESS, None).ok()?;
    let mut parents = std::collections::HashMap::new();
    for entry in list.iter_processes() {
        let entry = entry.ok()?;
        parents.insert(entry.th32ProcessID, (entry.th32ParentProcessID, entry.szExeFile()));
    }
    let (parent, _) = parents.get(&process)?;
    Some(parents.get(parent)?.1.clone())
}

#[cfg(test)]
mod tests {
    use super::harmless_but_colours;

    #[test]
    fn colours_are_all_that_reaches_a_terminal() {
        let painted = "\u{1b}[1m\u{1b}[33m0.35 !\u{1b}[0m\nnext\n";
        assert_eq!(harmless_but_colours(painted), painted);
        let hostile = "a\u{1b}[2J\u{1b}]0;t\u{7}\u{1b}[31mred\u{9b}2J\u{1b}[";
        assert_eq!(
            harmless_but_colours(hostile),
            "a\\u{1b}[2J\\u{1b}]0;t\\u{7}\u{1b}[31mred\\u{9b}2J\\u{1b}["
        );
    }
}

#[cfg(all(test, windows))]
mod tests_of_windows {
    #[test]
    fn the_parent_of_a_child_is_this_program() {
        let mut child = std::process::Command::new("cmd")
            .args(["/c", "pause"])
            .stdin(std::process::Stdio::piped())
            .stdout(std::process::Stdio::null())
            .spawn()
            .unwrap();
        let parent = super::parent_of(child.id());
        child.kill().unwrap();
        child.wait().unwrap();
        let this = std::env::current_exe().unwrap();
        assert_eq!(parent.as_deref(), this.file_name().and_then(|name| name.to_str()));
    }
}
