//! The end of a page that a verb writes.

use osim_library::page::ReportPage;

use crate::exit::Exit;
use crate::session::Session;

/// Ends the page, if there is one; what cannot be written is reported.
pub(super) fn end_page(page: Option<ReportPage>, session: &mut Session) -> Exit {
    match page.map_or(Ok(()), ReportPage::finish) {
        Ok(()) => Exit::Done,
        Err(fault) => {
            let why = session.refused(&fault);
            session.terminal.error_line(&format!("the report: {why:#}"));
            Exit::Failed
        }
    }
}
