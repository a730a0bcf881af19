#!/usr/bin/env bash
# Makes Arimo-subset.ttf from Arimo-Regular.ttf (Debian: fonts-croscore 20201225-1). Needs fonttools 4.68.
# Usage: make_subset.sh /usr/share/fonts/truetype/croscore/Arimo-Regular.ttf
set -euo pipefail
cd "$(dirname "$0")"
pyftsubset "$1" --output-file=Arimo-subset.ttf --no-hinting --layout-features='ccmp,mark,mkmk,kern' \
    --name-IDs='0,1,2,3,4,5,6,7,13,14' \
    --unicodes="U+0020-007E,U+00A0-017F,U+0300-0304,U+0307,U+0308,U+0391-03C9,U+1E8A,U+1E8B,U+2010-2015,\
U+2018-201D,U+2022,U+2026,U+2032,U+2070-209C,U+2190-2193,U+2212,U+221A,U+221D,U+221E,U+2248,U+2260,U+2264,U+2265"
