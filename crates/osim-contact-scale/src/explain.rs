//! `explain`: what a warning code means and what to do about it.

use anyhow::{Result, bail};
use osim_patch::WarningCode;

use crate::report::table;
use crate::terminal::Terminal;

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
    terminal.print(&format!(
        "{}\n\nWhat:  {}\nWhy:   {}\nDo:    {}\n",
        found.as_str(),
        found.what().trim(),
        found.why(),
        found.remedy()
    ))?;
    Ok(())
}
