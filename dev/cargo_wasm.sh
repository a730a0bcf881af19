#!/usr/bin/env bash
# Runs cargo for a browser (wasm32), where there is no disk, no terminal and no clock: dev/cargo_wasm.sh COMMAND OPTIONS...
#
# Rust's own library is built along, from its sources, so that nothing of panics is in a module: nobody could read their texts there,
# and they are a fifth of it. The sources come from `rustup component add rust-src`; where that cannot be had, from Debian's compiler, by
# `dev/install.sh wasm`.
set -euo pipefail
cd "$(dirname "$0")/.."

TARGET=wasm32-unknown-unknown
DEBIAN=/usr/bin/rustc
command=${1:?the command of cargo}
shift
# Not among what another compiler built.
OPTIONS=(--locked --target "$TARGET" --target-dir "${CARGO_TARGET_DIR:-target}/wasm" -Zbuild-std=std,panic_abort)

has_sources() { [ -d "$("$1" --print sysroot)/lib/rustlib/src/rust/library" ]; }

if has_sources rustc; then
    compiler=rustc
elif [ -x "$DEBIAN" ] && has_sources "$DEBIAN"; then
    compiler=$DEBIAN
    OPTIONS+=(--config "target.$TARGET.linker=\"wasm-ld-19\"")
else
    echo "error: no sources of Rust's library: rustup component add rust-src, or dev/install.sh wasm" >&2
    exit 1
fi
if [ "$command" = build ]; then
    # Names of folders are in a module, too, and differ from machine to machine.
    sysroot=$("$compiler" --print sysroot)
    flags="\"--remap-path-prefix=$sysroot/lib/rustlib/src=rust\", \"--remap-path-prefix=${CARGO_HOME:-$HOME/.cargo}=cargo\", \"--remap-path-prefix=$PWD=.\""
    OPTIONS+=(-Zpanic-immediate-abort --config 'profile.web.panic="immediate-abort"' --config "target.$TARGET.rustflags=[$flags, \"-Zlocation-detail=none\"]")
fi
"$compiler" --version
# RUSTC_BOOTSTRAP: a released compiler builds its own library only when told so.
printf '+ cargo %s\n' "$command ${OPTIONS[*]} $*"
# Flags of the environment would take the place of those above.
exec env -u RUSTFLAGS -u CARGO_ENCODED_RUSTFLAGS RUSTC="$compiler" RUSTC_BOOTSTRAP=1 cargo "$command" "${OPTIONS[@]}" "$@"
