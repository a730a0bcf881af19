//! The files that steps write: `human.fixed-1.osim`, `human.fixed-2.osim`.

use std::path::{Path, PathBuf};

use osim_model::files::Files;
use osim_requests::Request;
use osim_requests::options::OutputOptions;

/// What the names of results of steps end in, before their number.
const MARK: &str = ".fixed-";

/// Lets a step write the next file that is not there yet, and says which; `None` of a request that writes none.
pub(super) fn output(request: &mut Request, from: &Path, files: &dyn Files) -> Option<PathBuf> {
    let (stem, done) = numbered(from);
    let name = |number: u32| {
        let mut name = format!("{stem}{MARK}{number}");
        if let Some(extension) = from.extension() {
            name = format!("{name}.{}", extension.to_string_lossy());
        }
        from.with_file_name(name)
    };
    let to = (done + 1..).map(name).find(|name| !files.exists(name))?;
    request.output_mut()?.output = Some(to.clone());
    Some(to)
}

/// Lets a step that is the only one write the file that every change writes, if that is not there yet. A model that is the result
/// of a step stays in its series.
pub(super) fn unnumbered(request: &mut Request, from: &Path, files: &dyn Files) {
    if numbered(from).1 == 0
        && !files.exists(&OutputOptions::beside(from))
        && let Some(output) = request.output_mut()
    {
        output.output = None;
    }
}

/// The name without extension and number, and the number; 0 of a model that no step wrote.
fn numbered(model: &Path) -> (String, u32) {
    let stem = model.file_stem().unwrap_or_default().to_string_lossy().into_owned();
    let number =
        stem.rsplit_once(MARK).and_then(|(stem, number)| Some((stem.to_owned(), number.parse().ok()?)));
    number.unwrap_or((stem, 0))
}

#[cfg(test)]
mod tests {
    use osim_model::files::InMemory;
    use osim_requests::DesignRequest;

    use super::*;

    #[test]
    fn each_step_has_the_next_free_number() {
        let files = InMemory::from_iter([("a/human.fixed-2.osim", "")]);
        for (from, to) in [
            ("a/human.osim", "a/human.fixed-1.osim"),
            ("a/human.fixed-1.osim", "a/human.fixed-3.osim"),
            ("human.scaled.osim", "human.scaled.fixed-1.osim"),
            ("forces.xml", "forces.fixed-1.xml"),
            ("human.fixed-x.osim", "human.fixed-x.fixed-1.osim"),
        ] {
            let mut request = Request::from(DesignRequest::default());
            assert_eq!(output(&mut request, Path::new(from), &files).as_deref(), Some(Path::new(to)));
            assert_eq!(request.output_mut().unwrap().output.as_deref(), Some(Path::new(to)));
        }
    }
}
