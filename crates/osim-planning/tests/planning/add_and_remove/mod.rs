//! `remove` after `add` gives the first file back, byte for byte: for every model of the project, in every form of text, for every way of
//! adding contacts, and also after other changes in between.

mod add_calls;
pub mod documents;
mod forms;

use std::collections::BTreeMap;
use std::path::Path;
use std::sync::atomic::{AtomicUsize, Ordering};

use osim_model::files::InMemory;
use osim_model::{FileId, Model};
use osim_planning::prepare;
use osim_requests::Request;
use serde_json::{Value, json};

use add_calls::{AddCall, TABLE_OF_PLACES, add_calls, between};
use documents::{ChangedFiles, Document, all_files, models};
use forms::{bytes, forms, letters};

/// Numbers of trials, and of trials in which the first file came back.
#[derive(Default)]
struct Counts {
    back: usize,
    /// Trials in which adding contacts was refused, by the code of the refusal.
    refused: BTreeMap<String, usize>,
    failures: Vec<String>,
}

/// A name, and the requests that are applied one after the other under this name.
type Steps = (&'static str, Vec<Value>);

/// The bytes of the model after a request; or the code and the message of the refusal.
fn step(
    files_with_changes: &mut ChangedFiles<'_>,
    name: &str,
    bytes: &[u8],
    request: &Value,
) -> Result<Vec<u8>, (String, String)> {
    files_with_changes.own.insert(name.into(), bytes.to_vec());
    let other = |error: String| ("other".to_owned(), error);
    let request =
        Request::from_json(request.to_string().as_bytes()).map_err(|fault| other(format!("{fault:?}")))?;
    let change = prepare(request, &*files_with_changes).map_err(|fault| other(format!("{fault:?}")))?;
    let failed = |failure: osim_model::files::Failure| (failure.code.to_owned(), failure.message.to_string());
    let opened = change.open(Path::new(name), &*files_with_changes).map_err(failed)?;
    let plan = change.plan(&opened, &*files_with_changes).map_err(failed)?;
    plan.patched(&opened.model, FileId::MAIN).map_err(|fault| (fault.code().to_owned(), fault.to_string()))
}

/// Adds contacts by one call, applies the requests in between, removes the contacts, and compares the bytes.
fn try_one(
    files_with_changes: &mut ChangedFiles<'_>,
    what: &str,
    first: &Document,
    call: &AddCall,
    steps: &[Value],
    counts: &mut Counts,
) {
    files_with_changes.own.insert(TABLE_OF_PLACES.into(), call.table.clone().into_bytes());
    let name = &first.name;
    let mut now = match step(files_with_changes, name, &first.bytes, &call.request) {
        Ok(added) => added,
        Err((code, why)) => {
            let why = if std::env::var_os("TAKEN_BACK_REASONS").is_some() {
                format!("{code}: {why}")
            } else {
                code
            };
            *counts.refused.entry(format!("{}: {why}", call.name)).or_default() += 1;
            return;
        }
    };
    for request in steps {
        // What makes no sense for these contacts, such as their own class, changes nothing.
        if let Ok(next) = step(files_with_changes, name, &now, request) {
            now = next;
        }
    }
    if now == first.bytes {
        // A part was all of it.
        counts.back += 1;
        return;
    }
    match step(files_with_changes, name, &now, &json!({"verb": "remove", "models": [name]})) {
        Ok(back) if back == first.bytes => counts.back += 1,
        Ok(back) => counts.failures.push(format!("{what}: differs: {}", difference(&first.bytes, &back))),
        Err((code, why)) => counts.failures.push(format!("{what}: refused: {code}: {why}")),
    }
}

/// The bytes around the first byte that differs.
fn difference(expected: &[u8], seen: &[u8]) -> String {
    let at = expected.iter().zip(seen).take_while(|(one, other)| one == other).count();
    let around = |bytes: &[u8]| {
        let part = bytes.get(at.saturating_sub(30)..(at + 60).min(bytes.len())).unwrap_or_default();
        format!("{:?}", String::from_utf8_lossy(part))
    };
    format!("expected {}, seen {}", around(expected), around(seen))
}

/// The model itself if it has no contacts, else the model after its contacts were removed.
fn without_contacts(files_with_changes: &mut ChangedFiles<'_>, document: &Document) -> Option<Document> {
    let name = &document.name;
    let select = json!({"verb": "remove", "models": [name], "select": ["*"]});
    let bytes = match step(files_with_changes, name, &document.bytes, &select) {
        Ok(bytes) => bytes,
        Err((code, _)) if code == "no-contacts" || code == "refused" => document.bytes.clone(),
        Err(_) => return None,
    };
    Some(Document { name: name.clone(), bytes })
}

/// The share of the forms in which each model is tried: one in `small` forms for a small model, one in `large` for a large one. Forms, calls
/// and requests take turns, so that every form occurs with every call and with all requests.
#[derive(Clone, Copy)]
struct FormShare {
    small: usize,
    large: usize,
}

/// A small share of the forms, because all forms would take most of an hour.
const FORMS_TRIED_IN_SHORT: FormShare = FormShare { small: 13, large: 61 };
const FORMS_TRIED_AT_LENGTH: FormShare = FormShare { small: 1, large: 7 };

fn try_all(files: &InMemory, documents: &[Document], share: FormShare, next: &AtomicUsize) -> Counts {
    let mut counts = Counts::default();
    let forms = forms();
    let mut files_with_changes = ChangedFiles { files, own: BTreeMap::new() };
    loop {
        let at = next.fetch_add(1, Ordering::Relaxed);
        let Some(document) = documents.get(at) else { return counts };
        files_with_changes.own.clear();
        let own = [Some(document.clone()), without_contacts(&mut files_with_changes, document)];
        for (which, own) in own.into_iter().flatten().enumerate() {
            let one_in = if own.bytes.len() > 100_000 { share.large } else { share.small };
            for (number, (form, write)) in forms.iter().enumerate() {
                let turn = at * 7 + which * 3 + number;
                if number > 0 && !turn.is_multiple_of(one_in) {
                    continue;
                }
                let Some(text) = write(&letters(&own.bytes)) else { continue };
                let first = Document { name: own.name.clone(), bytes: bytes(&text) };
                let Ok(model) = Model::parse(first.bytes.clone()) else { continue };
                let calls = add_calls(&first.name, &model);
                let Some((call, steps)) = call_of_turn(&calls, &first.name, turn) else { continue };
                let what = format!("{} [{form}] {}, {}", first.name, call.name, steps.0);
                try_one(&mut files_with_changes, &what, &first, call, &steps.1, &mut counts);
            }
        }
    }
}

/// The call that adds contacts and the requests in between, if it is the turn of this form.
fn call_of_turn<'c>(calls: &'c [AddCall], name: &str, turn: usize) -> Option<(&'c AddCall, Steps)> {
    let number = (turn * 5).checked_rem(calls.len())?;
    let call = calls.get(number)?;
    let mut steps = between(name, call);
    Some((call, steps.swap_remove((turn + 3 * number) % steps.len())))
}

/// Tries a share of the forms on all models.
fn try_share(share: FormShare) -> Counts {
    let files = all_files();
    let documents = models(&files);
    let next = AtomicUsize::new(0);
    let threads = std::thread::available_parallelism().map_or(1, usize::from);
    let mut counts = Counts::default();
    std::thread::scope(|scope| {
        let running: Vec<_> =
            (0..threads).map(|_| scope.spawn(|| try_all(&files, &documents, share, &next))).collect();
        for part in running {
            counts.add(part.join().unwrap());
        }
    });
    counts
}

impl Counts {
    fn add(&mut self, other: Self) {
        self.back += other.back;
        self.failures.extend(other.failures);
        for (code, count) in other.refused {
            *self.refused.entry(code).or_default() += count;
        }
    }

    fn summary(&self) -> String {
        let refused: String = self.refused.iter().map(|(why, count)| format!("\n  {count}: {why}")).collect();
        format!("{} times the first file is back; calls that were refused:{refused}", self.back)
    }

    fn check(&self) {
        let Self { back, failures, .. } = self;
        if let Some(path) = std::env::var_os("TAKEN_BACK_FAILURES") {
            std::fs::write(path, failures.join("\n")).unwrap();
        }
        assert!(*back > 1000, "{back}");
        let first = failures[..failures.len().min(20)].join("\n");
        assert!(
            failures.is_empty(),
            "{} of {} fail; the first:\n{first}",
            failures.len(),
            failures.len() + back
        );
    }
}

#[test]
fn remove_takes_back_added_contacts() {
    let counts = try_share(FORMS_TRIED_IN_SHORT);
    println!("{}", counts.summary());
    counts.check();
}

/// Adds contacts to models in all forms, and removes them.
#[test]
#[ignore = "slow: dev/thorough runs it"]
fn added_contacts_are_taken_back_in_every_form() {
    let counts = try_share(FORMS_TRIED_AT_LENGTH);
    println!("{}", counts.summary());
    counts.check();
}
