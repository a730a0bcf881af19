# Steps of checks, for .ci/run and dev/thorough, which source this file: each prints its command, keeps what it printed, and is timed.
# At the end, however it ends, the seconds of every step are printed. Steps are in parts, functions `part_NAME`, which can run on machines
# of their own; without words all run.
#
#     parts NAME... -- "$@"     the parts that there are, and the words of the call; runs those that are wanted, or `all_parts` where there
#                               is such a function and no word, then looks at what was skipped
#     step NAME COMMAND...      now
#     needs NAME COMMAND...     a step that several parts need, once
#     beside NAME COMMAND...    while others run, where COMMAND may be a function of steps; nothing of it is shown until
#     ready NAME                waits for it, and shows it
#     gently COMMAND...         takes only what others leave of the processor, which is for `beside`
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."

LOGS=target/logs-$(basename "$0")
rm -rf "$LOGS"
mkdir -p "$LOGS"
touch "$LOGS/seconds"
# Those beside that nothing has waited for yet: their number by name.
declare -A running=()

at_the_end() {
    local name
    for name in "${!running[@]}"; do kill -- "-${running[$name]}" 2>/dev/null || true; done
    printf '\nseconds  step\n'
    cat "$LOGS/seconds"
    printf '%7d  all\n' "$SECONDS"
}
trap at_the_end EXIT

# ended NAME STATUS SECONDS [WORD]
ended() {
    printf '%7d  %s\n' "$3" "$1${4:-}" >>"$LOGS/seconds"
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

needs() { [ -f "$LOGS/$1.log" ] || step "$@"; }

beside() {
    local lane=$1 since=$SECONDS
    shift
    printf '\n== %s: beside what follows\n' "$*"
    # In a process group of its own, which is ended as a whole.
    set -m
    (
        trap 'printf "%d %d\n" "$?" $((SECONDS - since)) >"$LOGS/$lane.ended"' EXIT
        "$@" >"$LOGS/$lane.log" 2>&1 </dev/null
    ) &
    running[$lane]=$!
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

gently() {
    renice -n 10 -p "$BASHPID" >/dev/null
    "$@"
}

parts() {
    local known="" part
    while [ "$1" != -- ]; do known+=" $1"; shift; done
    shift
    for part in "$@"; do
        case "$known " in *" $part "*) ;; *) printf 'no part %s; there are:%s\n' "$part" "$known" >&2; exit 2 ;; esac
    done
    if [ $# = 0 ] && declare -F all_parts >/dev/null; then
        all_parts
    else
        # shellcheck disable=SC2086
        for part in ${*:-$known}; do "part_$part"; done
    fi
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
if [ -z "${OSIM_CASES:-}" ] && [ -d ../shared/cases ]; then
    OSIM_CASES=$(cd ../shared/cases && pwd)
    export OSIM_CASES
fi
ORACLE="target/oracle-venv/bin/python"
PYTHON="target/python-venv/bin/python"
PYTEST="-m pytest -q -rs --no-fold-skipped"
