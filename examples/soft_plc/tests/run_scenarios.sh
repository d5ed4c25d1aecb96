#!/bin/sh
# Runs every scenario with the program given: exit 0, a header and events; errors give exit 2. The
# second program has the library without the variants of faults/: it writes the same.
set -eu
plc=$1 plain=$2
here=$(dirname "$0")
for scenario in "$here"/../scenarios/*.json; do
    name=$(basename "$scenario")
    case $name in
    real_time.json) mode=--real-time ;;
    *) mode= ;;
    esac
    lines=$("$plc" $mode "$scenario" | grep -c '^{"\(format\|event\)":.*}$')
    [ "$lines" -gt 3 ] || { echo "$name: only $lines lines"; exit 1; }
    echo "$name: $lines lines"
done
for scenario in "$here"/../scenarios/*.json; do
    case $scenario in
    *real_time.json) continue ;;
    esac
    [ "$("$plc" --diag "$scenario" 2>&1 | cksum)" = "$("$plain" --diag "$scenario" 2>&1 | cksum)" ] ||
        { echo "$scenario: another log without the variants"; exit 1; }
done
for seed in 1 2 3 4 5 6 7 8 9; do
    [ "$("$plc" --random $seed --diag --events 5000 | cksum)" = \
        "$("$plain" --random $seed --diag --events 5000 | cksum)" ] ||
        { echo "--random $seed: another log without the variants"; exit 1; }
done
for family in S7-300 S7-400 318; do
    "$plc" --random 5 --cpu $family --diag --events 2000 | grep -q '"diag",.*"id":"16#5380"' ||
        { echo "--random --cpu $family --diag logs no entry 5380"; exit 1; }
done
status=0
echo '{}' | "$plc" - 2>/dev/null || status=$?
[ "$status" -eq 2 ] || { echo "a wrong scenario gives exit $status, not 2"; exit 1; }
status=0
"$plc" --fault none - 2>/dev/null </dev/null || status=$?
[ "$status" -eq 2 ] || { echo "a wrong fault gives exit $status, not 2"; exit 1; }
status=0
"$plc" --choose AMB-34=c --random 1 >/dev/null 2>&1 || status=$?
[ "$status" -eq 2 ] || { echo "a wrong choice gives exit $status, not 2"; exit 1; }
status=0
"$plc" --state "$here"/../scenarios/hold.json >/dev/null 2>&1 || status=$?
[ "$status" -eq 2 ] || { echo "--state with a scenario gives exit $status, not 2"; exit 1; }
status=0
"$plc" --random 1 --events 200000 >/dev/full 2>/dev/null || status=$?
[ "$status" -eq 1 ] || { echo "a full disk gives exit $status, not 1"; exit 1; }
