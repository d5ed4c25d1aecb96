#!/usr/bin/env bash
# Judges $LOGS, runs the kit on $ADAPTER, and writes the results to the folder $RESULTS. What action.yml and a container
# do; each of LOGS and ADAPTER may be empty. Exit code: the higher of the two.
set -uo pipefail
mkdir -p "$RESULTS"
status=0
if [ -n "${LOGS:-}" ]; then
    set -f # s7check knows patterns
    # shellcheck disable=SC2086 # several names
    s7check trace --format sarif --output "$RESULTS/s7check.sarif" $LOGS
    status=$?
    # shellcheck disable=SC2086
    [ "$status" -eq 0 ] || s7check trace $LOGS
    set +f
fi
if [ -n "${ADAPTER:-}" ]; then
    eval "s7check kit run ${KIT_OPTIONS:-} --output \"\$RESULTS/kit.html\" --output \"\$RESULTS/kit.svg\" -- $ADAPTER"
    code=$?
    [ "$code" -le "$status" ] || status=$code
fi
exit "$status"
