#!/bin/sh
# The web server against clients that mean it harm; long form: SPECULA_SERVE_REQUESTS=10000.
# usage: hostile_clients_test.sh SPECULA SOURCE CACHE_FOLDER
command -v python3 >/dev/null || { echo "skipped: needs python3"; exit 77; }
SPECULA_HOME=$2 exec python3 "$2/tests/tools/serve/hostile_clients.py" "$1" "$3"
