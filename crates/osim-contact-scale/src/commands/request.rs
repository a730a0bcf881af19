//! `request`: a verb with its options, as JSON.

use std::path::Path;

use anyhow::{Context, Result, bail};
use osim_library::Disk;
use osim_model::files::Files;
use osim_requests::Request;

use crate::args::RequestArgs;
use crate::session::Session;
use crate::words::{self, Language};

/// The name of standard input.
const STDIN: &str = "-";

/// Reads a request from a file or standard input. From now on the session names options as the caller does: as fields of
/// requests, or as arguments of the function that made the request.
///
/// # Errors
/// The file cannot be read, or holds no request that makes sense.
pub(super) fn read(args: &RequestArgs, session: &mut Session) -> Result<Request> {
    session.words = words::of_request(args.words);
    session.terminal.never_break();
    let is_stdin = args.file == Path::new(STDIN);
    let shown = if is_stdin { "standard input".into() } else { args.file.to_string_lossy().into_owned() };
    let bytes = Disk.read(&args.file).with_context(|| shown.clone())?;
    let request = Request::from_json(&bytes).map_err(|fault| session.usage(&fault));
    // Who called a function knows of no file.
    let request = if args.words == Language::Matlab { request? } else { request.with_context(|| shown)? };
    if is_stdin && let Some(field) = request.field_that_reads(&args.file) {
        bail!("`{field}` is standard input, where the request itself was: put the request into a file");
    }
    Ok(request)
}
