#!/bin/sh
# Copies the fixtures up to 32 KB into fuzz/corpus/<target>, as seeds; removes nothing. The target `files` gets what is not a model.
set -eu
cd "$(dirname "$0")"
for target in fuzz_targets/*.rs; do
    target=$(basename "$target" .rs)
    corpus=corpus/$target
    mkdir -p "$corpus"
    case $target in
    files) kinds='mot sto csv xlsx json plates.xml' ;;
    mesh) kinds='vtp stl obj' ;;
    *) kinds='osim xml' ;;
    esac
    for kind in $kinds; do
        find ../fixtures seeds -type f -name "*$kind" | while read -r file; do
            name=$(printf '%s' "$file" | sed 's,^\.\./fixtures/,,' | tr / _)
            # The beginning of a recording is one, too.
            case $kind in
            mot | sto) head -n 60 "$file" >"$corpus/$name" ;;
            *) [ "$(wc -c <"$file")" -gt 32768 ] || cp "$file" "$corpus/$name" ;;
            esac
        done
    done
    echo "$corpus: $(find "$corpus" -type f | wc -l) inputs"
done
