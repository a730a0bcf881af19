#!/bin/bash -eu
# Runs in the image of the Dockerfile beside it: each target with its seeds and its dictionary goes to $OUT.
cd "$SRC/osim-contact-scale"
cargo fuzz build -O --debug-assertions
fuzz/seed.sh
for target in fuzz/fuzz_targets/*.rs; do
    name=$(basename "$target" .rs)
    cp "fuzz/target/x86_64-unknown-linux-gnu/release/$name" "$OUT/"
    cp fuzz/osim.dict "$OUT/$name.dict"
    printf '[libfuzzer]\ntimeout = 20\nmax_len = 32768\n' >"$OUT/$name.options"
    (cd "fuzz/corpus/$name" && zip -q -r "$OUT/${name}_seed_corpus.zip" .)
done
