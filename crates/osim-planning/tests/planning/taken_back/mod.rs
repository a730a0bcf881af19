//! `remove` after `add` gives the first file back, byte for byte: every model that we have, in every form of text, by every way of
//! adding, and also with other numbers in between.

pub mod documents;
mod forms;
mod ways;

use std::collections::BTreeMap;
use std::path::Path;
use std::sync::atomic::{AtomicUsize, Ordering};

use osim_model::files::InMemory;
use osim_model::{FileId, Model};
use osim_planning::prepare;
use osim_requests::Request;
use serde_json::{Value, json};

use documents::{Desk, Document, all_files, models};
use forms::{bytes, forms, letters};
use ways::{TABLE, Way, between, ways};

/// Numbers of things that were tried, and of those that held.
#[derive(Default)]
struct Counts {
    back: usize,
    /// Ways that do not fit the model, by the code of the answer.
    refused: BTreeMap<String, usize>,
    failures: Vec<String>,
}

/// The name of requests that are applied one after the other, and the requests.
type Steps = (&'static str, Vec<Value>);

/// The bytes that a request makes of `bytes`, and why there are none.
fn step(desk: &mut Desk<'_>, name: &str, bytes: &[u8], request: &Value) -> Result<Vec<u8>, (String, String)> {
    desk.own.insert(name.into(), bytes.to_vec());
    let other = |error: String| ("other".to_owned(), error);
    let request =
        Request::from_json(request.to_string().as_bytes()).map_err(|fault| other(format!("{fault:?}")))?;
    let change = prepare(request, &*desk).map_err(|fault| other(format!("{fault:?}")))?;
    let failed = |failure: osim_model::files::Failure| (failure.code.to_owned(), failure.message.to_string());
    let opened = change.open(Path::new(name), &*desk).map_err(failed)?;
    let plan = change.plan(&opened, &*desk).map_err(failed)?;
    plan.patched(&opened.model, FileId::MAIN).map_err(|fault| (fault.code().to_owned(), fault.to_string()))
}

/// Tries one way, and what is done in between.
fn try_one(
    desk: &mut Desk<'_>,
    what: &str,
    first: &Document,
    way: &Way,
    steps: &[Value],
    counts: &mut Counts,
) {
    desk.own.insert(TABLE.into(), way.table.clone().into_bytes());
    let name = &first.name;
    let mut now = match step(desk, name, &first.bytes, &way.request) {
        Ok(added) => added,
        Err((code, why)) => {
            let why = if std::env::var_os("TAKEN_BACK_REASONS").is_some() {
                format!("{code}: {why}")
            } else {
                code
            };
            *counts.refused.entry(format!("{}: {why}", way.name)).or_default() += 1;
            return;
        }
    };
    for request in steps {
        // What makes no sense for these contacts, such as their own class, changes nothing.
        if let Ok(next) = step(desk, name, &now, request) {
            now = next;
        }
    }
    if now == first.bytes {
        // A part was all of it.
        counts.back += 1;
        return;
    }
    match step(desk, name, &now, &json!({"verb": "remove", "models": [name]})) {
        Ok(back) if back == first.bytes => counts.back += 1,
        Ok(back) => counts.failures.push(format!("{what}: differs: {}", difference(&first.bytes, &back))),
        Err((code, why)) => counts.failures.push(format!("{what}: refused: {code}: {why}")),
    }
}

/// The bytes around the first one that differs.
fn difference(expected: &[u8], seen: &[u8]) -> String {
    let at = expected.iter().zip(seen).take_while(|(one, other)| one == other).count();
    let around = |bytes: &[u8]| {
        let part = bytes.get(at.saturating_sub(30)..(at + 60).min(bytes.len())).unwrap_or_default();
        format!("{:?}", String::from_utf8_lossy(part))
    };
    format!("expected {}, seen {}", around(expected), around(seen))
}

/// The model itself, or without the contacts that it has.
fn without_contacts(desk: &mut Desk<'_>, document: &Document) -> Option<Document> {
    let name = &document.name;
    let select = json!({"verb": "remove", "models": [name], "select": ["*"]});
    let bytes = match step(desk, name, &document.bytes, &select) {
        Ok(bytes) => bytes,
        Err((code, _)) if code == "no-contacts" || code == "refused" => document.bytes.clone(),
        Err(_) => return None,
    };
    Some(Document { name: name.clone(), bytes })
}

/// The share of forms that each model is tried in, where it is small and where it is large. Forms, ways and steps come by turns, so that
/// every form comes with every kind of each.
#[derive(Clone, Copy)]
struct Share {
    small: usize,
    large: usize,
}

/// A share of the forms, because all of them would take most of an hour.
const FEW: Share = Share { small: 13, large: 61 };
const MANY: Share = Share { small: 1, large: 7 };

fn try_all(files: &InMemory, documents: &[Document], share: Share, next: &AtomicUsize) -> Counts {
    let mut counts = Counts::default();
    let forms = forms();
    let mut desk = Desk { files, own: BTreeMap::new() };
    loop {
        let at = next.fetch_add(1, Ordering::Relaxed);
        let Some(document) = documents.get(at) else { return counts };
        desk.own.clear();
        let own = [Some(document.clone()), without_contacts(&mut desk, document)];
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
                let ways = ways(&first.name, &model);
                let Some((way, steps)) = chosen(&ways, &first.name, turn) else { continue };
                let what = format!("{} [{form}] {}, {}", first.name, way.name, steps.0);
                try_one(&mut desk, &what, &first, way, &steps.1, &mut counts);
            }
        }
    }
}

/// The way of adding, and what is done in between, whose turn it is.
fn chosen<'w>(ways: &'w [Way], name: &str, turn: usize) -> Option<(&'w Way, Steps)> {
    let number = (turn * 5).checked_rem(ways.len())?;
    let way = ways.get(number)?;
    let mut steps = between(name, way);
    Some((way, steps.swap_remove((turn + 3 * number) % steps.len())))
}

/// Numbers of things tried with all models.
fn try_share(share: Share) -> Counts {
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

    fn told(&self) -> String {
        let refused: String = self.refused.iter().map(|(why, count)| format!("\n  {count}: {why}")).collect();
        format!("{} times the first file is back; ways that do not fit:{refused}", self.back)
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
fn what_was_added_is_taken_back() {
    let counts = try_share(FEW);
    println!("{}", counts.told());
    counts.check();
}

/// Contacts are added to models in all forms and taken back.
#[test]
#[ignore = "slow: dev/thorough runs it"]
fn what_was_added_is_taken_back_in_every_form() {
    let counts = try_share(MANY);
    println!("{}", counts.told());
    counts.check();
}
