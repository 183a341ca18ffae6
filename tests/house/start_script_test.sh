#!/bin/sh
# start_script_test.sh SCRIPT: the start script, tried on a tiny project of its own.
#
# The project lies at a path with spaces; dpkg-query, apt-get and sudo are pretended, cmake and ninja
# are real. Exit status 77 means that one of those is not here.

script=$1
command -v cmake >/dev/null && command -v ninja >/dev/null || exit 77
unset SPECULA_BUILD_DIR SPECULA_NO_APT SPECULA_HOME

folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
project="$folder/a clone"
fakes=$folder/fakes
failures=0

check() { # check WHAT COMMAND...
    what=$1
    shift
    if "$@"; then
        printf 'ok      %s\n' "$what"
    else
        printf 'FAILED  %s\n' "$what"
        sed 's/^/        /' "$folder/out" "$folder/err"
        failures=$((failures + 1))
    fi
}
start() { # start ARGUMENT...: runs the script; leaves $status and the files out and err
    PATH=$fakes:$PATH "$project/specula" "$@" >"$folder/out" 2>"$folder/err"
    status=$?
}
says() { grep -Fq -- "$2" "$folder/$1"; }
is_silent() { [ ! -s "$folder/err" ]; }
pretend() { # pretend PROGRAM <its text
    { echo '#!/bin/sh' && cat; } >"$fakes/$1"
    chmod +x "$fakes/$1"
}

mkdir -p "$project" "$fakes"
cp "$script" "$project/specula"
cat >"$project/CMakeLists.txt" <<'END'
cmake_minimum_required(VERSION 3.22)
project(pretended C)
option(SPECULA_TESTS "" ON)
add_executable(specula main.c)
if(SPECULA_TESTS)
    enable_testing()
    add_executable(specula_tests EXCLUDE_FROM_ALL main.c)
    add_test(NAME slab COMMAND specula_tests)
    add_test(NAME stack COMMAND specula_tests)
endif()
END
cat >"$project/main.c" <<'END'
#include <stdio.h>
#include <stdlib.h>
int main(int count, char **words) {
    printf("home=%s\n", getenv("SPECULA_HOME"));
    for (int i = 1; i < count; i++) printf("[%s]\n", words[i]);
    return count == 4 ? 7 : 0;
}
END

# --- packages are missing ---
pretend dpkg-query <<'END'
echo "installed:g++"
exit 1
END
pretend apt-get <<END
echo "\$DEBIAN_FRONTEND apt-get \$*" >>"$folder/apt"
exit 100
END
pretend sudo <<'END'
exec "$@"
END

SPECULA_NO_APT=1
export SPECULA_NO_APT
start list
check "without leave to install, it stops" [ "$status" -eq 1 ]
check "and shows the command" says err "apt-get install --no-install-recommends cmake ninja-build"
check "without what is installed or only tests need" [ "$(grep -Ec 'g\+\+|catch2' "$folder/err")" -eq 0 ]
check "and leaves nothing behind" [ ! -e "$project/build" ]
start test
check "tests need Catch2 too" says err " catch2"
unset SPECULA_NO_APT

start list
check "it tells how many packages it installs" says err "installing 17 packages"
check "apt-get is asked for them, without questions" \
    grep -q "^noninteractive apt-get install -y --no-install-recommends .*cmake" "$folder/apt"
check "when apt-get fails, so does it" [ "$status" -eq 1 ]
check "and names the log" says err "$project/build/specula.log"

# --- all packages are there ---
pretend dpkg-query <<'END'
for package; do echo "installed:$package"; done
END
rm -rf "$project/build" "$folder/apt"

PATH=$fakes:$PATH "$project/specula" first >"$folder/first" 2>&1 &
start second
wait
check "two at once: the one is built for" says first "[first]"
check "and the other" says out "[second]"
check "but only one of them configures" \
    [ "$(cat "$folder/first" "$folder/err" | grep -c configuring)" -eq 1 ]

start "two words" '*'
check "arguments arrive as they were" says out "[two words]"
check "without expansion" says out "[*]"
check "the program learns where its data are" says out "home=$project"
check "nothing changed: nothing said" is_silent
check "nothing was installed" [ ! -e "$folder/apt" ]
start 1 2 3
check "the program's exit status is kept" [ "$status" -eq 7 ]
start
check "without arguments it shows the help" says out "[--help]"

ln -s "$project/specula" "$folder/a link"
(cd / && PATH=$fakes:$PATH "$folder/a link" far >"$folder/out" 2>"$folder/err")
check "it works from elsewhere, by a link" says out "home=$project"

(cd "$folder" && SPECULA_BUILD_DIR="built elsewhere" PATH=$fakes:$PATH "$project/specula" \
    >"$folder/out" 2>"$folder/err")
check "SPECULA_BUILD_DIR says where to build" [ -x "$folder/built elsewhere/specula" ]

start test -R slab
check "tests run, filtered as ctest does" says out "100% tests passed, 0 tests failed out of 1"
start test --help
check "the help on tests is short and builds nothing" says out "./specula test -R slab"

mv "$project" "$folder/moved" && project=$folder/moved
start here
check "a clone may be moved with its build folder" says out "home=$project"

echo 'int broken(' >>"$project/main.c"
start list
check "when the build fails, so does it" [ "$status" -eq 1 ]
check "and shows what the compiler said" says err "int broken("
check "and names the log" says err "$project/build/specula.log"

[ "$failures" -eq 0 ]
