# Steps of checks, for .ci/run and dev/thorough, which source this file: each prints its command, keeps what it printed, and is timed.
# At the end, however it ends, the seconds of every step are printed. Steps are in parts, functions `part_NAME`, which can run on machines
# of their own; without words all run, in their order.
#
#     parts NAME... -- "$@"     the parts that there are, and the words of the call; runs those that are wanted, then looks at what was skipped
#     step NAME COMMAND...      now
#     beside NAME COMMAND...    while others run; nothing of it is shown until
#     ready NAME                waits for it, and shows it
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."

LOGS=target/logs-$(basename "$0")
rm -rf "$LOGS"
mkdir -p "$LOGS"
took=""
# Those beside that nothing has waited for yet: their number by name.
declare -A running=()

at_the_end() {
    local name
    for name in "${!running[@]}"; do kill -- "-${running[$name]}" 2>/dev/null || true; done
    printf '\n%s\n%s%7d  %s\n' "seconds  step" "$took" "$SECONDS" "all"
}
trap at_the_end EXIT

# ended NAME STATUS SECONDS [WORD]
ended() {
    took+=$(printf '%7d  %s' "$3" "$1${4:-}")$'\n'
    [ "$2" = 0 ] && return
    printf '\nerror: the step %s failed\n' "$1"
    exit "$2"
}

step() {
    local name=$1 begin=$SECONDS status=0
    shift
    printf '\n== %s\n' "$*"
    "$@" 2>&1 | tee "$LOGS/$name.log" || status=$?
    ended "$name" "$status" $((SECONDS - begin))
}

beside() {
    local name=$1
    shift
    printf '\n== %s: beside what follows\n' "$*"
    # In a process group of its own, which is ended as a whole.
    set -m
    (
        begin=$SECONDS status=0
        "$@" >"$LOGS/$name.log" 2>&1 </dev/null || status=$?
        printf '%d %d\n' "$status" $((SECONDS - begin)) >"$LOGS/$name.ended"
    ) &
    running[$name]=$!
    set +m
}

ready() {
    local status=1 seconds=0
    wait "${running[$1]}" || true
    unset "running[$1]"
    printf '\n== %s, which ran beside:\n' "$1"
    cat "$LOGS/$1.log"
    read -r status seconds <"$LOGS/$1.ended" || true
    ended "$1" "$status" "$seconds" " (beside others)"
}

parts() {
    local known="" part
    while [ "$1" != -- ]; do known+=" $1"; shift; done
    shift
    for part in "$@"; do
        case "$known " in *" $part "*) ;; *) printf 'no part %s; there are:%s\n' "$part" "$known" >&2; exit 2 ;; esac
    done
    # shellcheck disable=SC2086
    for part in ${*:-$known}; do "part_$part"; done
    # Nothing is skipped that is not known to be.
    python3 -m doctest dev/skips.py
    step skips python3 dev/skips.py "$LOGS"/*.log
    printf '\nall checks passed\n'
}

# Models by other people stand beside the project; tests that need them say so where they are missing.
if [ -z "${OSIM_CORPUS:-}" ] && [ -d ../shared/corpus ]; then
    OSIM_CORPUS=$(cd ../shared/corpus && pwd)
    export OSIM_CORPUS
fi
ORACLE="target/oracle-venv/bin/python"
PYTHON="target/python-venv/bin/python"
PYTEST="-m pytest -q -rs --no-fold-skipped"
