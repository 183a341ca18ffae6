#!/bin/sh
# Whether a run that is killed at random moments, killed again while it resumes, and then left alone,
# makes the bytes of an undisturbed run, loses no finished shard, and leaves nothing behind; and whether
# merge and augment, which write one file in one go, clear away what a killed one left, and end on a signal
# with a word and without a trace.
#
#   kill_test.sh PROGRAM SOURCE_TREE
#
# SPECULA_KILLS  how many runs are killed (default 5; 100 take some minutes)
set -u
program=$(readlink -f "$1")
export SPECULA_HOME="$2"
runs=${SPECULA_KILLS:-5}
folder=$(mktemp -d /tmp/specula-kill.XXXXXX)
trap 'rm -rf "$folder"' EXIT
cd "$folder" || exit 1
fail() {
    echo "FAILED in run $run: $*"
    ls -l . run run/run.h5.parts 2>/dev/null
    exit 1
}
run=0

# Small frames of small plates: ten shards in about a second.
cat >small.toml <<'END'
title = "small"
seed = 5
worlds = 10
radar = "iwrl6432boost"
nominal_height_mm = 450
[recordings]
samples = 2
sessions = 16
frames = 16
[geometry]
height_mm = { uniform = [400, 500], sampling = "quasi" }
[sample]
size_mm = [30, 30]
[[class]]
name = "iron"
material = "iron"
thickness_mm = 3
[[class]]
name = "wood"
material = "wood"
thickness_mm = { normal = [18, 1] }
[session]
gain_db = { normal = [0, 0.3] }
[frame]
displacement_um = { normal = [0, 35] }
END

milliseconds() { echo $(($(date +%s%N) / 1000000)); }
# A whole number below $1.
random() { echo $(($(od -An -N4 -tu4 /dev/urandom) % $1)); }
sleep_ms() { sleep "$(printf '%d.%03d' $(($1 / 1000)) $(($1 % 1000)))"; }

generate() { "$program" generate small.toml -o "$1" >log 2>&1; }

begin=$(milliseconds)
generate one/one.h5 || { cat log; exit 1; }
length=$(($(milliseconds) - begin))
expected=$(sha256sum <one/one.h5)
echo "an undisturbed run takes $length ms: ${expected%% *}"

# Nothing of the surroundings reaches the data.
LC_ALL=de_DE.UTF-8 TZ=Asia/Tokyo MALLOC_PERTURB_=165 "$program" generate small.toml -o two/two.h5 \
    --threads 1 >log 2>&1 || fail "in other surroundings: $(cat log)"
[ "$(sha256sum <two/two.h5)" = "$expected" ] || fail "other surroundings give other bytes"

# The shards that are finished now: every one, read before it can go.
finished() { ls run/run.h5.parts 2>/dev/null | grep -c '^shard-[0-9]*\.h5$'; }

# attempt SIGNAL: starts a run, sends the signal after a random time, tells how it ended.
attempt() {
    "$program" generate small.toml -o run/run.h5 >log 2>&1 &
    pid=$!
    sleep_ms "$(random "$length")"
    kill -"$1" $pid 2>/dev/null
    sent=$(milliseconds)
    wait $pid 2>/dev/null
    status=$?
    ending=$(($(milliseconds) - sent))
}

killed=0 in_resume=0 clean=0
while [ $run -lt "$runs" ]; do
    run=$((run + 1))
    rm -rf run
    again=$(random 2)
    attempt KILL
    if [ $status -ge 128 ]; then killed=$((killed + 1)); fi
    if [ "$again" = 1 ]; then
        before=$(finished)
        attempt KILL
        if [ $status -ge 128 ]; then in_resume=$((in_resume + 1)); fi
        [ -e run/run.h5 ] || [ "$(finished)" -ge "$before" ] || fail "finished shards are gone"
    fi
    # Ctrl-C and a polite kill, too: a clean end within two seconds.
    if [ ! -e run/run.h5 ] && [ $((run % 5)) = 0 ]; then
        case $((run % 10)) in 0) signal=INT expected_status=130 ;; *) signal=TERM expected_status=143 ;; esac
        attempt $signal
        # A file under its final name is whole: the signal came while it was being described.
        if [ $status -ne 0 ] && [ ! -e run/run.h5 ] && ! { [ $status -gt 128 ] && ! [ -s log ]; }; then
            [ $status = $expected_status ] || fail "SIG$signal ends with status $status: $(cat log)"
            grep -q 'run the same command again to resume' log || fail "no word of resuming: $(cat log)"
            [ $ending -le 2000 ] || fail "SIG$signal took $ending ms"
            clean=$((clean + 1))
        fi
    fi
    if [ ! -e run/run.h5 ]; then
        ls run/run.h5.parts 2>/dev/null | grep '^shard-[0-9]*\.h5$' | while read -r shard; do
            stat -c '%n %i %Y' "run/run.h5.parts/$shard"
        done >before
        kept=$(wc -l <before)
        generate run/run.h5 || fail "resuming ends with $?: $(cat log)"
        # Told before anything is simulated; nothing is told where all were finished.
        if [ "$kept" -gt 0 ] && grep -q 'frames in' log; then
            grep -q "($kept are finished)" log || fail "$kept shards were finished, but: $(cat log)"
        fi
    else
        generate run/run.h5 || fail "a finished file: $(cat log)"
    fi
    [ "$(sha256sum <run/run.h5)" = "$expected" ] || fail "other bytes than the undisturbed run's"
    left=$(ls -A run | grep -vx -e run.h5 -e run.DATASHEET.md -e run.croissant.json)
    [ -z "$left" ] || fail "left over: $left"
done
echo "$runs runs: $killed killed, $in_resume killed again while resuming, $clean stopped by signals;" \
    "all came to the same bytes, no finished shard lost, nothing left over"

# Until the one file is being written, or is there.
await_draft() {
    until ls once/out.h5.draft-* >/dev/null 2>&1 || [ -e once/out.h5 ] || ! kill -0 $pid 2>/dev/null; do
        sleep 0.01
    done
}
for share in 0 1; do
    "$program" generate small.toml -o two/parts.h5 --shard $share/2 >log 2>&1 || fail "share $share: $(cat log)"
done
for command in merge augment; do
    case $command in
    merge) set -- merge two/parts.h5.parts -o once/out.h5 ;;
    augment) set -- augment one/one.h5 -o once/out.h5 --copies 2 --step noise=1 ;;
    esac
    rm -rf once && mkdir once
    begin=$(milliseconds)
    "$program" "$@" >log 2>&1 || fail "$command: $(cat log)"
    length=$(($(milliseconds) - begin))
    expected=$(sha256sum <once/out.h5)
    cut=0 heeded=0
    for signal in KILL TERM KILL INT KILL TERM; do
        rm -rf once && mkdir once
        "$program" "$@" >log 2>&1 &
        pid=$!
        case $signal in KILL) sleep_ms "$(random "$length")" ;; *) await_draft ;; esac
        kill -$signal $pid 2>/dev/null
        wait $pid 2>/dev/null
        status=$?
        [ ! -e once/out.h5 ] || continue # finished, and being described
        cut=$((cut + 1))
        if [ $signal != KILL ]; then
            case $signal in INT) wanted=130 ;; *) wanted=143 ;; esac
            [ $status = $wanted ] || fail "$command: SIG$signal ends with status $status: $(cat log)"
            grep -q 'stopped; nothing was written' log || fail "$command: no word of it: $(cat log)"
            [ -z "$(ls -A once)" ] || fail "$command: SIG$signal leaves $(ls -A once)"
            heeded=$((heeded + 1))
        fi
        "$program" "$@" >log 2>&1 || fail "$command after SIG$signal: $(cat log)"
        [ "$(sha256sum <once/out.h5)" = "$expected" ] || fail "$command: other bytes after SIG$signal"
        left=$(ls -A once | grep -vx -e out.h5 -e out.DATASHEET.md -e out.croissant.json)
        [ -z "$left" ] || fail "$command after SIG$signal: left over: $left"
    done
    # A merge this small may be over before the signal comes; an augmentation is not, three times.
    [ $command = merge ] || [ $heeded -gt 0 ] || fail "augment heeds no signal"
    echo "$command: 6 runs, $cut of them cut short; the next one made the same bytes and left nothing over"
done
