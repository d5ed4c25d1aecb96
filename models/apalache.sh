#!/bin/sh
# Apalache is in no package registry: it is looked for in APALACHE_HOME, then on PATH.
# usage: models/apalache.sh typecheck | check
set -eu
cd "$(dirname "$0")/.."

apalache="${APALACHE_HOME:+$APALACHE_HOME/bin/}apalache-mc"
if ! command -v "$apalache" >/dev/null 2>&1; then
    echo "not run: apalache-mc was not found (release 0.62.1, Java 21 or newer; see README.md)" >&2
    exit 3
fi
flatten() { .venv/bin/python -m evidence.tla.flatten "$@"; }
out=$(mktemp -d)
mkdir "$out/flat"
trap 'rm -rf "$out"' EXIT

case "$1" in
typecheck)
    # Between them these extend every module of spec/.
    for module in Explain Inductive Liveness LifeCycle CounterLock Conservation; do
        echo "typecheck $module and what it extends"
        flatten "$module" spec/*/ >"$out/flat/$module.tla"
        "$apalache" typecheck --out-dir="$out" "$out/flat/$module.tla" >"$out/log" 2>&1 || { grep -v "^# " "$out/log"; exit 1; }
    done
    ;;
check)
    # A bounded check: no counterexample of up to this many steps, not a proof.
    names=$(sed -n 's/^ *\(.*\) <- \(.*\)/\1,\2/p' models/APAirt.cfg | paste -s -d , -)
    flatten --only "APInit,APNext,StackAndAirtInv,$names" APAirt models spec/*/ \
        >"$out/flat/APAirt.tla"
    "$apalache" check --out-dir="$out" --config=models/APAirt.cfg --length=5 \
        --inv=StackAndAirtInv "$out/flat/APAirt.tla"
    ;;
*)
    echo "usage: models/apalache.sh typecheck | check" >&2
    exit 2
    ;;
esac
