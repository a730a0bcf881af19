//! `--shard` and `--jobs`: the same work, parted.

use std::collections::BTreeSet;

use crate::library::{below, library, model};
use crate::support::Bench;

/// Names below `out/` that share `index` of `count` writes.
fn share(bench: &Bench, index: usize, count: usize) -> BTreeSet<String> {
    let ran = bench
        .run(&format!("lib --target-mass 500 -d out --shard {index}/{count} --summary {index}.csv"))
        .done();
    let outputs = ran.changed.iter().filter_map(|name| name.strip_prefix("out/"));
    outputs.map(str::to_owned).collect()
}

#[test]
fn shares_are_disjoint_and_complete() {
    for count in [1, 3, 7] {
        let bench = library(30);
        let shares: Vec<_> = (1..=count).map(|index| share(&bench, index, count)).collect();
        let all: BTreeSet<_> = below(&bench.files(), "lib/").into_keys().collect();
        assert_eq!(shares.iter().map(BTreeSet::len).sum::<usize>(), all.len(), "no model twice");
        assert_eq!(shares.iter().flatten().cloned().collect::<BTreeSet<_>>(), all);
        let smallest = shares.iter().map(BTreeSet::len).min().unwrap();
        assert!(smallest > 0, "30 models in {count} shares leave none empty");
    }
}

#[test]
fn a_model_stays_in_its_share_when_others_come() {
    let (few, many) = (library(20), library(40));
    many.write("lib/a_new_one.osim", model(77));
    for index in 1..=4 {
        let (few, many) = (share(&few, index, 4), share(&many, index, 4));
        assert!(few.is_subset(&many), "{index}");
    }
}

#[test]
fn a_share_that_is_none_is_refused() {
    let bench = library(1);
    for wrong in ["0/4", "5/4", "1", "1/0", "one/two"] {
        bench.run(&format!("lib --target-mass 500 -d out --shard {wrong}")).usage().wrote_nothing();
    }
}

/// Some models that fail or have no contacts among them.
fn mixed() -> Bench {
    let bench = library(30);
    bench.write("lib/even/broken.osim", "<OpenSimDocument>");
    bench.write("lib/odd/none.osim", crate::support::fixture("bad/no_contacts.osim"));
    bench
}

#[test]
fn the_number_of_jobs_changes_nothing_but_the_time() {
    for format in ["table", "lines", "json"] {
        let run = |jobs: usize| {
            let bench = mixed();
            let call =
                format!("lib --target-mass 500 -d out --format {format} --summary s.csv --jobs {jobs}");
            let ran = bench.run(&call).failed();
            (ran.stdout, ran.stderr, bench.files())
        };
        let alone = run(1);
        assert!(alone.0.len() > 1000);
        for jobs in [2, 8] {
            let many = run(jobs);
            assert!(alone.0 == many.0, "{format}, {jobs} jobs: standard output differs");
            assert_eq!(alone.1, many.1, "{format}, {jobs} jobs");
            assert!(alone.2 == many.2, "{format}, {jobs} jobs: a file differs");
        }
    }
}
