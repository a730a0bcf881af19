#!/usr/bin/env bash
# The libraries compile for a browser (wasm32), where there is no disk, no terminal and no clock.
set -euo pipefail
cd "$(dirname "$0")/.."

# Default features: contact-plots makes its PNG pictures there, too. What the page itself uses is compiled by web/build.mjs.
exec dev/cargo_wasm.sh check \
    --package contact-scaling --package contact-plots --package osim-model --package osim-requests --package osim-patch \
    --package osim-inspect --package osim-motion --package osim-planning --package osim-view
