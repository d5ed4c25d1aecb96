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
out=$(mktemp -d)
trap 'rm -rf "$out"' EXIT

case "$1" in
typecheck)
    # Between them these extend every module of spec/.
    for module in spec/Explain.tla spec/PropertiesIrt.tla; do
        echo "typecheck $module"
        "$apalache" typecheck --out-dir="$out" "$module" >"$out/log" 2>&1 || { cat "$out/log"; exit 1; }
    done
    ;;
check)
    # A bounded check: no counterexample of up to this many steps, not a proof.
    # Apalache looks for modules beside the one it checks.
    mkdir "$out/all"
    cp spec/*.tla models/MCBase.tla models/APAirt.tla models/APAirt.cfg "$out/all"
    "$apalache" check --out-dir="$out" --config="$out/all/APAirt.cfg" --length=4 \
        --inv=StackAndAirtInv "$out/all/APAirt.tla"
    ;;
*)
    echo "usage: models/apalache.sh typecheck | check" >&2
    exit 2
    ;;
esac
