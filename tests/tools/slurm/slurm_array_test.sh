#!/bin/sh
# Whether an array of eight Slurm jobs, one of which is killed and requeued, makes the dataset that one
# process makes: starts munged, slurmctld and slurmd on this machine, in a folder of its own.
#
#   slurm_array_test.sh PROGRAM SOURCE_TREE
#
# Skipped (77) unless SPECULA_SLURM_TEST=1, without root, or without Debian's slurm-wlm and munge.
set -u
program=$(readlink -f "$1")
tree=$(readlink -f "$2")
skip() { echo "skipped: $*"; exit 77; }
[ "${SPECULA_SLURM_TEST:-0}" = 1 ] || skip "takes about a minute; SPECULA_SLURM_TEST=1 runs it"
[ "$(id -u)" = 0 ] || skip "the daemons are started as root"
for each in munged mungekey slurmctld slurmd sbatch; do
    command -v $each >/dev/null || skip "$each is missing (Debian: slurm-wlm, munge)"
done

folder=$(mktemp -d /tmp/specula-slurm.XXXXXX)
chmod 755 "$folder"
mkdir "$folder/state" "$folder/spool" "$folder/log" "$folder/munge"
export SLURM_CONF=$folder/slurm.conf
pids=
stop_all() {
    for pid in $pids; do kill "$pid" 2>/dev/null; done
    wait 2>/dev/null
    [ -n "${KEEP:-}" ] || rm -rf "$folder"
}
trap stop_all EXIT
fail() {
    echo "FAILED: $*"
    tail -n 20 "$folder"/log/* "$folder"/specula-*.log 2>/dev/null
    exit 1
}

# --- a cluster of one node ------------------------------------------------------------------------
host=$(hostname -s)
mungekey --create --keyfile "$folder/munge/key" || fail "mungekey"
chmod 700 "$folder/munge"
munged --foreground --force --key-file "$folder/munge/key" --socket "$folder/munge/socket" \
    --pid-file "$folder/munge/pid" --log-file "$folder/log/munged" --seed-file "$folder/munge/seed" &
pids="$pids $!"
cat >"$folder/slurm.conf" <<END
ClusterName=specula
SlurmctldHost=$host(127.0.0.1)
SlurmctldPort=26817
SlurmdPort=26818
SlurmUser=root
SlurmdUser=root
AuthType=auth/munge
AuthInfo=socket=$folder/munge/socket
CredType=cred/munge
StateSaveLocation=$folder/state
SlurmdSpoolDir=$folder/spool
SlurmctldPidFile=$folder/slurmctld.pid
SlurmdPidFile=$folder/slurmd.pid
SlurmctldLogFile=$folder/log/slurmctld
SlurmdLogFile=$folder/log/slurmd
ProctrackType=proctrack/linuxproc
TaskPlugin=task/none
JobAcctGatherType=jobacct_gather/none
AccountingStorageType=accounting_storage/none
MpiDefault=none
ReturnToService=2
SchedulerType=sched/builtin
SelectType=select/cons_tres
SelectTypeParameters=CR_Core
JobRequeue=1
NodeName=$host NodeAddr=127.0.0.1 CPUs=$(nproc)
PartitionName=all Nodes=$host Default=YES MaxTime=INFINITE State=UP OverSubscribe=FORCE:8
END
printf 'CgroupPlugin=cgroup/v1\nCgroupMountpoint=%s\n' "$folder/cgroup" >"$folder/cgroup.conf"
mkdir "$folder/cgroup"
sleep 1
slurmctld -D -f "$SLURM_CONF" >/dev/null 2>&1 &
pids="$pids $!"
slurmd -D -f "$SLURM_CONF" -N "$host" >/dev/null 2>&1 &
pids="$pids $!"
for _ in 1 2 3 4 5 6 7 8 9 10 11 12 13 14 15 16 17 18 19 20; do
    sinfo -h -o %t 2>/dev/null | grep -q idle && break
    sleep 1
done
sinfo -h -o %t 2>/dev/null | grep -q idle || fail "the node does not register: $(sinfo 2>&1)"
echo "slurmctld, slurmd and munged run: $(sinfo -h -o '%N %t %c CPUs')"

# --- the dataset, by one process and by an array --------------------------------------------------
cd "$folder" || exit 1
export SPECULA="$program" SPECULA_HOME="$tree"
worlds=${SPECULA_SLURM_WORLDS:-48}
"$program" generate tilt_and_height -o one/one.h5 --worlds "$worlds" --store adc >one.log 2>&1 ||
    fail "the single process: $(cat one.log)"
job=$(sbatch --parsable --cpus-per-task=1 --mem=0 "$tree/tools/slurm/generate.sbatch" \
    tilt_and_height "$folder/array.h5" --worlds "$worlds" --store adc) || fail "sbatch"
echo "submitted array $job: $(squeue -h -r -o %i | wc -l) tasks"

# Kill the first task that is at work, once it has begun, and give it back to the queue.
killed=
for _ in $(seq 200); do
    task=$(squeue -h -r -t RUNNING -o %i | head -n 1)
    if [ -n "$task" ] && ls array.h5.parts/manifest-* >/dev/null 2>&1; then
        scontrol requeue "$task" && killed=$task && break
    fi
    sleep 0.1
done
[ -n "$killed" ] || fail "no task was ever running"
echo "killed and requeued task $killed"
for _ in $(seq 300); do
    [ -n "$(squeue -h)" ] || break
    # A requeued job is held back for a while; it need not be.
    squeue -h -r -t PENDING -o %i | while read -r task; do
        scontrol update JobId="$task" StartTime=now >/dev/null 2>&1
    done
    sleep 1
done
[ -z "$(squeue -h)" ] || fail "the array does not end: $(squeue)"
grep -h "Share\|frames in" specula-*.log

"$program" merge array.h5.parts -o array.h5 || fail "merge"
sha256sum one/one.h5 array.h5
cmp one/one.h5 array.h5 || fail "the array's dataset is another one"
echo "eight tasks, one of them killed and requeued, made the same bytes as one process"
