#!/usr/bin/env bash
# The libraries compile for a browser (wasm32), where there is no disk, no terminal and no clock.
#
# The target's own library comes from `rustup target add wasm32-unknown-unknown`. Where that cannot be had, another
# compiler and the sources of its library do, which are built along: Debian's, by `dev/install.sh wasm`.
set -euo pipefail
cd "$(dirname "$0")/.."

TARGET=wasm32-unknown-unknown
# Default features: contact-plots makes its PNG pictures there, too.
LIBRARIES=(--package contact-scaling --package contact-plots --package osim-frames --package osim-wording --package osim-xml --package osim-model --package osim-feet --package osim-patch --package osim-inspect
    --package osim-values --package osim-options --package osim-remarks --package osim-requests --package osim-figures --package osim-report)
OPTIONS=(--locked --target "$TARGET")
# Not among what another compiler built.
OPTIONS+=(--target-dir "${CARGO_TARGET_DIR:-target}/wasm")
DEBIAN=/usr/bin/rustc

run() {
    printf '+ %s\n' "$*"
    "$@"
}

if [ -d "$(rustc --print sysroot)/lib/rustlib/$TARGET" ]; then
    run rustc --version
    run cargo check "${OPTIONS[@]}" "${LIBRARIES[@]}"
elif [ -x "$DEBIAN" ] && [ -d "$("$DEBIAN" --print sysroot)/lib/rustlib/src/rust/library" ]; then
    run "$DEBIAN" --version
    # RUSTC_BOOTSTRAP: a released compiler builds its own library only when told so.
    run env RUSTC="$DEBIAN" RUSTC_BOOTSTRAP=1 \
        cargo check -Zbuild-std=std,panic_abort "${OPTIONS[@]}" "${LIBRARIES[@]}"
else
    echo "error: no library for $TARGET: rustup target add $TARGET, or dev/install.sh wasm" >&2
    exit 1
fi
