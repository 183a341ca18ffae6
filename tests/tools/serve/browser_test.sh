#!/bin/sh
# The page in a real browser. Needs chromium, node, and playwright-core:
#   npm install --prefix FOLDER playwright-core     then SPECULA_PLAYWRIGHT=FOLDER
# SPECULA_SHOTS=FOLDER keeps screenshots. usage: browser_test.sh SPECULA SOURCE CACHE_FOLDER
skip() {
    echo "skipped: $1"
    exit 77
}
command -v node >/dev/null || skip "needs nodejs"
command -v chromium >/dev/null || skip "needs chromium"
modules=${SPECULA_PLAYWRIGHT:+$SPECULA_PLAYWRIGHT/node_modules}
[ -d "${modules:-/usr/lib/node_modules}/playwright-core" ] ||
    skip "needs playwright-core: npm install --prefix FOLDER playwright-core, SPECULA_PLAYWRIGHT=FOLDER"
export SPECULA_HOME="$2" SPECULA_MODULES="${modules:-/usr/lib/node_modules}"
exec node "$2/tests/tools/serve/browser_test.mjs" "$1" "$3"
