#!/bin/sh
# Whether a disk that is or becomes full, or cannot be written at all, is told in one line with path and
# reason, leaves every finished shard whole, and whether the run resumes to the same bytes.
#
#   full_disk_test.sh PROGRAM SOURCE_TREE
#
# Skipped (77) where no file system can be mounted.
set -u
program=$(readlink -f "$1")
export SPECULA_HOME="$2"
folder=$(mktemp -d /tmp/specula-full.XXXXXX)
disk=$folder/disk
mkdir "$disk"
cleanup() {
    umount "$disk" 2>/dev/null
    rm -rf "$folder"
}
trap cleanup EXIT
mount -t tmpfs -o size=50m specula "$disk" 2>/dev/null || { echo "skipped: cannot mount a tmpfs"; exit 77; }
fail() {
    echo "FAILED: $*"
    cat "$folder/log"
    ls -l "$disk" "$disk"/*.parts 2>/dev/null
    exit 1
}
# Ten shards of small plates.
cat >"$folder/small.toml" <<'END'
title = "small"
seed = 5
worlds = 10
radar = "iwrl6432boost"
nominal_height_mm = 450
[recordings]
samples = 2
sessions = 16
frames = 60
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
generate() { "$program" generate "$folder/small.toml" -o "$1" >"$folder/log" 2>&1; }

generate "$folder/one/one.h5" || fail "the undisturbed run"
size=$(stat -c %s "$folder/one/one.h5")
echo "the whole file: $size bytes"

# Too small from the beginning: refused before anything is simulated.
dd if=/dev/zero of="$disk/filler" bs=1M count=30 2>/dev/null
for out in a.h5 new/folders/a.h5 new/folder/; do
    generate "$disk/$out" && fail "no refusal"
    grep -q 'needs about .* and has .* free' "$folder/log" || fail "not refused for its size"
    [ "$(ls "$disk")" = filler ] || fail "the refusal left something: $(find "$disk")"
done
rm "$disk/filler"

# Filled by somebody else on the way, at several stages.
for after in 1 3 6; do
    generate "$disk/a.h5" &
    pid=$!
    for _ in $(seq 600); do
        [ "$(ls "$disk"/a.h5.parts 2>/dev/null | grep -c '^shard-[0-9]*\.h5$')" -ge $after ] && break
        sleep 0.01
    done
    dd if=/dev/zero of="$disk/filler" bs=64k 2>/dev/null
    wait $pid
    status=$?
    if [ $status = 0 ]; then
        echo "after $after shards: the run was too fast for the filler"
    else
        [ $status = 1 ] || fail "status $status"
        grep -q "$disk/a.h5.*No space left on device" "$folder/log" || fail "no path and reason"
        [ "$(grep -c error "$folder/log")" = 1 ] || fail "not one line"
        (cd "$disk/a.h5.parts" && sha256sum --quiet -c manifest.sha256) || fail "a shard is damaged"
        kept=$(ls "$disk/a.h5.parts" | grep -c '^shard-[0-9]*\.h5$')
        echo "full after $after shards: $(grep error "$folder/log"); $kept kept"
    fi
    rm -f "$disk/filler"
    generate "$disk/a.h5" || fail "resuming"
    cmp "$disk/a.h5" "$folder/one/one.h5" || fail "other bytes after a full disk"
    rm "$disk/a.h5" "$disk/a.DATASHEET.md" "$disk/a.croissant.json"
    [ -z "$(ls "$disk")" ] || fail "left over: $(ls "$disk")"
done

# No file may grow beyond a limit (a quota): shards fit, the whole file does not.
(ulimit -f $((size / 1024 / 2)) && generate "$disk/a.h5")
[ $? = 1 ] || fail "a limited file: status $?"
grep -q 'a.h5.*File too large' "$folder/log" || fail "the limit is not named"
generate "$disk/a.h5" && cmp "$disk/a.h5" "$folder/one/one.h5" || fail "resuming after a limit"

mount -o remount,ro "$disk" 2>/dev/null
generate "$disk/b.h5" && fail "a read-only disk"
grep -q "$disk/b.h5.*Read-only file system" "$folder/log" || fail "read-only is not named"
echo "read-only: $(cat "$folder/log")"
echo "full, limited and read-only disks: told in one line, resumed to the same bytes"
