//! How far a run is: on a terminal only, and only with several models.

use std::fmt::Write;
use std::io::IsTerminal;
use std::sync::atomic::{AtomicUsize, Ordering};

use indicatif::{ProgressBar, ProgressState, ProgressStyle};

/// Models done, their rate, the time that remains, and failures.
pub(crate) struct Progress {
    bar: ProgressBar,
    failures: AtomicUsize,
}

impl Progress {
    pub(crate) fn begin(models: usize, quiet: bool) -> Self {
        let hidden = models < 2 || quiet || !std::io::stderr().is_terminal();
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

    pub(crate) fn done(&self, failed: bool) {
        if self.bar.is_hidden() {
            return;
        }
        if failed {
            let failures = self.failures.fetch_add(1, Ordering::Relaxed) + 1;
            self.bar.set_message(format!(", {failures} failed"));
        }
        self.bar.inc(1);
    }

    /// Lets `write` write to the terminal between two pictures of the bar.
    pub(crate) fn suspended<T>(&self, write: impl FnOnce() -> T) -> T {
        if self.bar.is_hidden() { write() } else { self.bar.suspend(write) }
    }

    pub(crate) fn end(&self) {
        self.bar.finish_and_clear();
    }
}
