//! `explain`: what a warning code means and what to do about it.

use anyhow::{Result, bail};
use osim_patch::WarningCode;

use crate::report::table;
use crate::terminal::Terminal;

/// Columns of an old terminal.
const WIDTH: usize = 80;

/// Explains one code, or lists all of them.
///
/// # Errors
/// An unknown code.
pub(crate) fn run(code: Option<&str>, terminal: &mut Terminal) -> Result<()> {
    let Some(code) = code else {
        let mut table = table(&["code", "what it is"]);
        for code in WarningCode::ALL {
            table.add_row(vec![code.as_str(), code.what().trim()]);
        }
        terminal.print(&format!("{}\n", table.trim_fmt()))?;
        return Ok(());
    };
    let Some(found) = WarningCode::ALL.iter().find(|known| known.as_str() == code) else {
        bail!("'{code}' is no warning code: `osim-contact-scale explain` lists them");
    };
    let parts = [("What: ", found.what().trim()), ("Why:  ", found.why()), ("Do:   ", found.remedy())];
    let mut text = format!("{}\n\n", found.as_str());
    for (label, body) in parts {
        let body = format!("{}.", body.trim_end_matches('.'));
        let options = textwrap::Options::new(WIDTH).initial_indent(label).subsequent_indent("      ");
        text.push_str(&textwrap::fill(&body, options));
        text.push('\n');
    }
    terminal.print(&text)?;
    Ok(())
}
