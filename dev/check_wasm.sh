#!/usr/bin/env bash
# The libraries compile for a browser (wasm32), where there is no disk, no terminal and no clock.
set -euo pipefail
cd "$(dirname "$0")/.."

# Default features: contact-plots makes its PNG pictures there, too.
exec dev/cargo_wasm.sh check \
    --package contact-scaling --package contact-plots --package osim-frames --package osim-wording --package osim-xml --package osim-model \
    --package osim-feet --package osim-patch --package osim-inspect --package osim-values --package osim-options --package osim-remarks \
    --package osim-requests --package osim-states --package osim-figures --package osim-report
