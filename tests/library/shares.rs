//! `--shard` divides a run into shares for several computers; `--jobs` sets the number of threads.

use std::collections::BTreeSet;

use crate::model_folder::{files_below, folder_with_models, model_bytes};
use crate::support::TestDir;

/// Names of the files below `out/` that the share `index` of `count` writes.
fn outputs_of_share(dir: &TestDir, index: usize, count: usize) -> BTreeSet<String> {
    let run = dir
        .run(&format!("lib --target-mass 500 -d out --shard {index}/{count} --summary {index}.csv"))
        .succeeded();
    let outputs = run.changed.iter().filter_map(|name| name.strip_prefix("out/"));
    outputs.map(str::to_owned).collect()
}

#[test]
fn shares_of_a_run_are_disjoint_and_complete() {
    for count in [1, 3, 7] {
        let dir = folder_with_models(30);
        let shares: Vec<_> = (1..=count).map(|index| outputs_of_share(&dir, index, count)).collect();
        let all: BTreeSet<_> = files_below(&dir.files(), "lib/").into_keys().collect();
        assert_eq!(shares.iter().map(BTreeSet::len).sum::<usize>(), all.len(), "no model twice");
        assert_eq!(shares.iter().flatten().cloned().collect::<BTreeSet<_>>(), all);
        let smallest = shares.iter().map(BTreeSet::len).min().unwrap();
        assert!(smallest > 0, "30 models in {count} shares leave none empty");
    }
}

#[test]
fn a_model_stays_in_its_share_if_models_are_added() {
    let (few, many_jobs) = (folder_with_models(20), folder_with_models(40));
    many_jobs.write("lib/a_new_one.osim", model_bytes(77));
    for index in 1..=4 {
        let (few, many_jobs) = (outputs_of_share(&few, index, 4), outputs_of_share(&many_jobs, index, 4));
        assert!(few.is_subset(&many_jobs), "{index}");
    }
}

#[test]
fn an_invalid_share_is_refused() {
    let dir = folder_with_models(1);
    for wrong in ["0/4", "5/4", "1", "1/0", "one/two"] {
        dir.run(&format!("lib --target-mass 500 -d out --shard {wrong}")).usage_error().wrote_nothing();
    }
}

/// A folder in which some models fail or have no contacts.
fn folder_with_failing_models() -> TestDir {
    let dir = folder_with_models(30);
    dir.write("lib/even/broken.osim", "<OpenSimDocument>");
    dir.write("lib/odd/none.osim", crate::support::fixture("bad/no_contacts.osim"));
    dir
}

#[test]
fn the_number_of_jobs_does_not_change_the_result() {
    for format in ["table", "lines", "json"] {
        let run = |jobs: usize| {
            let dir = folder_with_failing_models();
            let call =
                format!("lib --target-mass 500 -d out --format {format} --summary s.csv --jobs {jobs}");
            let run = dir.run(&call).failed();
            (run.stdout, run.stderr, dir.files())
        };
        let one_job = run(1);
        assert!(one_job.0.len() > 1000);
        for jobs in [2, 8] {
            let many_jobs = run(jobs);
            assert!(one_job.0 == many_jobs.0, "{format}, {jobs} jobs: standard output differs");
            assert_eq!(one_job.1, many_jobs.1, "{format}, {jobs} jobs");
            assert!(one_job.2 == many_jobs.2, "{format}, {jobs} jobs: a file differs");
        }
    }
}
