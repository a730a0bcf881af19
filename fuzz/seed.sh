#!/bin/sh
# Copies the fixtures up to 32 KB into fuzz/corpus/<target>, as seeds; removes nothing.
set -eu
cd "$(dirname "$0")"
for target in fuzz_targets/*.rs; do
    corpus=corpus/$(basename "$target" .rs)
    mkdir -p "$corpus"
    find ../fixtures -type f \( -name '*.osim' -o -name '*.xml' -o -name '*.vtp' -o -name '*.stl' -o -name '*.obj' \) -size -33k | while read -r file; do
        name=$(echo "${file#../fixtures/}" | tr / _)
        cp "$file" "$corpus/$name"
    done
    echo "$corpus: $(find "$corpus" -type f | wc -l) inputs"
done
