//! Colours for verdicts that are readable without them.

use anstyle::{AnsiColor, Style};
use osim_inspect::Sign;
use osim_model::Severity;

/// The mark after a figure that is outside its limit.
pub const OUTSIDE: char = '!';

const OUTSIDE_STYLE: Style = AnsiColor::Yellow.on_default().bold();

/// Whether a text has colours.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
#[non_exhaustive]
pub enum Colour {
    /// None.
    #[default]
    Plain,
    /// Escape sequences, as terminals read them.
    Ansi,
}

/// A table with every figure that has an [`OUTSIDE`] mark in colour.
pub(crate) fn painted(text: &str, colour: Colour) -> String {
    if colour == Colour::Plain {
        return text.to_owned();
    }
    let mut out = String::with_capacity(text.len());
    let mut rest = text;
    while let Some((before, after)) = rest.split_once(" !") {
        // The figure begins after the blanks between the columns.
        let (skipped, figure) = before.rsplit_once("  ").unwrap_or(("", before));
        let gap = if skipped.len() + figure.len() < before.len() { "  " } else { "" };
        out.push_str(&format!("{skipped}{gap}{OUTSIDE_STYLE}{figure} {OUTSIDE}{OUTSIDE_STYLE:#}"));
        rest = after;
    }
    out.push_str(rest);
    out
}

/// The word for `severity`, in its colour.
pub(crate) fn severity(severity: Severity, colour: Colour) -> String {
    let style = match (colour, severity) {
        (Colour::Plain, _) | (_, Severity::Info) => Style::new(),
        (Colour::Ansi, Severity::Error) => AnsiColor::Red.on_default().bold(),
        (Colour::Ansi, Severity::Warn) => OUTSIDE_STYLE,
    };
    format!("{style}{}{style:#}", severity.as_str())
}

/// The word for a verdict's `sign`, in its colour.
pub(crate) fn sign(sign: Sign, colour: Colour) -> String {
    match sign {
        Sign::Info => severity(Severity::Info, colour),
        Sign::Warn => severity(Severity::Warn, colour),
        Sign::Error => severity(Severity::Error, colour),
        Sign::Good | Sign::Unknown => sign.as_str().to_owned(),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn only_what_is_outside_is_painted() {
        let style = AnsiColor::Yellow.on_default().bold();
        let text = "x/R   <= 0.16  0.12    0.35 !\nnext  1\n";
        let expected = format!("x/R   <= 0.16  0.12    {style}0.35 !{style:#}\nnext  1\n");
        assert_eq!(painted(text, Colour::Ansi), expected);
        assert_eq!(painted(text, Colour::Plain), text);
    }
}
