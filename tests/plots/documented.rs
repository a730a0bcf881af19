//! The pictures in docs/ are those that the commands beside them draw.

use std::path::Path;

use crate::support::{Bench, root};

/// Calls in `page` that write a figure: the name of the picture and the arguments before it.
fn calls(page: &str) -> Vec<(String, String)> {
    let lines = page.lines().filter_map(|line| line.strip_prefix("$ osim-contact-scale "));
    lines
        .filter_map(|call| call.split_once(" -o "))
        .map(|(call, name)| (name.to_owned(), call.to_owned()))
        .collect()
}

/// Numbers may differ by one drawing unit (1/20 pt): the last bit of a sine is the platform's.
#[track_caller]
fn assert_same_picture(seen: &str, committed: &str, name: &str) {
    let pieces = |text: &str| -> Vec<String> {
        text.split(|c: char| " \"<>,M\n".contains(c))
            .filter(|piece| !piece.is_empty())
            .map(str::to_owned)
            .collect()
    };
    let (seen, committed) = (pieces(seen), pieces(committed));
    assert_eq!(seen.len(), committed.len(), "{name} is not what the command draws");
    for (new, old) in seen.iter().zip(&committed) {
        let close = || Some((new.parse::<f64>().ok()? - old.parse::<f64>().ok()?).abs() <= 1.0);
        assert!(new == old || close() == Some(true), "{name}: {new}, but {old} in docs/plots");
    }
}

/// To draw them anew: `PLOTS=overwrite cargo test --test plots`, then look at them.
#[test]
fn pictures_are_current() {
    let page = std::fs::read_to_string(root().join("docs/plots.md")).unwrap();
    let calls = calls(&page);
    assert!(calls.len() >= 8, "docs/plots.md draws {} figures", calls.len());
    let bench = Bench::new();
    for entry in std::fs::read_dir(root().join("fixtures/table1")).unwrap() {
        let path = entry.unwrap().path();
        let name = format!("fixtures/table1/{}", path.file_name().unwrap().to_string_lossy());
        bench.write(&name, std::fs::read(&path).unwrap());
    }
    let overwrite = std::env::var("PLOTS").is_ok_and(|value| value == "overwrite");
    for (name, call) in calls {
        bench.run(&format!("{call} -o {name}")).done().wrote(&[&name]);
        let seen = bench.text(&name);
        assert!(seen.len() < 200_000, "{name} has {} bytes", seen.len());
        let committed = root().join("docs/plots").join(Path::new(&name));
        if overwrite {
            std::fs::write(&committed, &seen).unwrap();
        }
        let text =
            std::fs::read_to_string(&committed).unwrap_or_else(|error| panic!("docs/plots/{name}: {error}"));
        assert_same_picture(&seen, &text, &name);
        assert!(page.contains(&format!("](plots/{name})")), "docs/plots.md does not show {name}");
    }
}
