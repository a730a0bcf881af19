//! Colours for verdicts that are readable without them. They reach terminals only: see `Terminal::print_painted`.

use anstyle::{AnsiColor, Style};
use osim_patch::Severity;

/// Stands behind a figure that is outside its limit.
pub(crate) const OUTSIDE: char = '!';

const OUTSIDE_STYLE: Style = AnsiColor::Yellow.on_default().bold();

/// A table with every figure that has an [`OUTSIDE`] mark in colour.
pub(crate) fn painted(text: &str) -> String {
    let mut out = String::with_capacity(text.len());
    let mut rest = text;
    while let Some((before, after)) = rest.split_once(" !") {
        // The figure begins behind the blanks that part the columns.
        let (skipped, figure) = before.rsplit_once("  ").unwrap_or(("", before));
        let gap = if skipped.len() + figure.len() < before.len() { "  " } else { "" };
        out.push_str(&format!("{skipped}{gap}{OUTSIDE_STYLE}{figure} {OUTSIDE}{OUTSIDE_STYLE:#}"));
        rest = after;
    }
    out.push_str(rest);
    out
}

/// The word for `severity`, in its colour.
pub(crate) fn severity(severity: Severity) -> String {
    let style = match severity {
        Severity::Error => AnsiColor::Red.on_default().bold(),
        Severity::Warn => OUTSIDE_STYLE,
        Severity::Info => Style::new(),
    };
    format!("{style}{}{style:#}", severity.as_str())
}

#[cfg(test)]
mod tests {
    use super::painted;

    #[test]
    fn only_what_is_outside_is_painted() {
        let style = anstyle::AnsiColor::Yellow.on_default().bold();
        let text = "x/R   <= 0.16  0.12    0.35 !\nnext  1\n";
        let expected = format!("x/R   <= 0.16  0.12    {style}0.35 !{style:#}\nnext  1\n");
        assert_eq!(painted(text), expected);
    }
}
