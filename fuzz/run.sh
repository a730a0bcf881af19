#!/bin/bash
# Runs fuzz targets on all processors from kept seeds, the fixtures, and prints the runs and the coverage of each. Ends with 1 at the first
# panic, at an input that takes more than 20 s, and at a broken promise; the input is then in fuzz/artifacts. Needs a C++ compiler, and
# neither a nightly toolchain nor cargo-fuzz.
#
#     fuzz/run.sh [SECONDS [TARGET...]]     for so many seconds each: 600 if no number is given
set -euo pipefail
cd "$(dirname "$0")"
seconds=${1:-600}
shift || true
triple=$(rustc -vV | sed -n 's/^host: //p')
# What cargo-fuzz passes to the compiler. With a target of its own, build scripts are compiled without these.
export RUSTFLAGS="--cfg fuzzing -Cpasses=sancov-module -Cllvm-args=-sanitizer-coverage-level=4 \
    -Cllvm-args=-sanitizer-coverage-inline-8bit-counters -Cllvm-args=-sanitizer-coverage-pc-table \
    -Cllvm-args=-sanitizer-coverage-trace-compares -Cdebug-assertions -Ccodegen-units=1"
cargo build --release --locked --target "$triple" --target-dir ../target/fuzz
./seed.sh
targets=("$@")
if [ ${#targets[@]} = 0 ]; then
    for target in fuzz_targets/*.rs; do targets+=("$(basename "$target" .rs)"); done
fi
for target in "${targets[@]}"; do
    mkdir -p "artifacts/$target"
    log=../target/fuzz/$target.log status=0
    "../target/fuzz/$triple/release/$target" "corpus/$target" -fork="$(nproc)" -max_total_time="$seconds" -timeout=20 -max_len=32768 \
        -rss_limit_mb=4096 -ignore_timeouts=0 -ignore_ooms=0 -dict=osim.dict -artifact_prefix="artifacts/$target/" >"$log" 2>&1 || status=$?
    if [ "$status" != 0 ]; then
        tail -n 60 "$log"
        printf 'error: %s found something: see fuzz/artifacts/%s\n' "$target" "$target"
        exit 1
    fi
    # Such as `#4096: cov: 2107 ft: 9381 corp: 513 exec/s 409 oom/timeout/crash: 0/0/0`.
    grep -a '^#[0-9]*: cov:' "$log" | tail -n 1 | sed "s/^#\\([0-9]*\\): cov: \\([0-9]*\\).*/$target: \\1 runs, \\2 branches covered/"
done
