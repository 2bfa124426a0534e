#!/usr/bin/env bash
# A sweep of 32 pictures as a Slurm job array, on a controller and a node that this script starts here and stops again.
# One task is killed in mid-sweep and rescheduled; the set must be complete and identical to the unsharded one.
# usage: slurm_one_node.sh PROGRAM SOURCE_FOLDER     status 77: skipped
set -euo pipefail

snell=$(realpath "$1") source=$(realpath "$2")
skip() { echo "SKIP: $*"; exit 77; }
fail() {
  echo "FAILED: $*"
  tail -n 20 "$work"/*.log "$work"/slurm-*.out 2>/dev/null || true
  exit 1
}
for tool in slurmctld slurmd sbatch munged munge; do
  command -v "$tool" >/dev/null || skip "$tool is not installed (Debian: slurm-wlm, munge)"
done
[ "$(id -u)" = 0 ] || skip "Slurm's daemons are started as root here"
pgrep -x slurmctld >/dev/null && skip "another slurmctld runs on this machine"

work=$(mktemp -d "${TMPDIR:-/tmp}/snell-slurm-XXXXXX")
host=$(hostname -s)
# Only processes that this script started are ever ended.
end() { [ -f "$1" ] && kill "$(cat "$1")" 2>/dev/null && rm -f "$1"; true; }
stop() {
  end "$work/slurmd.pid"
  end "$work/slurmctld.pid"
  end "$work/munged.pid"
  sleep 1
  rm -rf "$work"
}
trap stop EXIT
chmod 755 "$work"

# munge, with a key and a socket of its own.
mkdir "$work/munge"
head -c 1024 /dev/urandom >"$work/munge/key"
chown -R munge "$work/munge"
chmod 711 "$work/munge"
chmod 400 "$work/munge/key"
su -s /bin/sh munge -c "munged --force --key-file='$work/munge/key' --socket='$work/munge/socket' \
  --pid-file='$work/munge/pid' --log-file='$work/munge/log' --seed-file='$work/munge/seed'" 2>/dev/null
cp "$work/munge/pid" "$work/munged.pid"
munge -n --socket="$work/munge/socket" | unmunge --socket="$work/munge/socket" >/dev/null || fail "munge does not work"

ports=$((20000 + RANDOM % 20000))
cat >"$work/slurm.conf" <<CONF
ClusterName=snell
SlurmctldHost=$host(127.0.0.1)
SlurmctldPort=$ports
SlurmdPort=$((ports + 1))
SlurmUser=root
AuthType=auth/munge
AuthInfo=socket=$work/munge/socket
StateSaveLocation=$work/state
SlurmdSpoolDir=$work/spool
SlurmctldPidFile=$work/slurmctld.pid
SlurmdPidFile=$work/slurmd.pid
SlurmctldLogFile=$work/slurmctld.log
SlurmdLogFile=$work/slurmd.log
ProctrackType=proctrack/linuxproc
TaskPlugin=task/none
SelectType=select/cons_tres
SchedulerParameters=sched_interval=1
ReturnToService=2
MpiDefault=none
KillWait=2
NodeName=$host NodeAddr=127.0.0.1 CPUs=2 State=UNKNOWN
PartitionName=p Nodes=$host Default=YES MaxTime=INFINITE State=UP
CONF
mkdir "$work/state" "$work/spool"
export SLURM_CONF="$work/slurm.conf"
slurmctld -f "$SLURM_CONF"
sleep 2
slurmd -f "$SLURM_CONF"
for _ in $(seq 30); do
  [ "$(sinfo -h -o %t 2>/dev/null)" = idle ] && break
  sleep 1
done
[ "$(sinfo -h -o %t)" = idle ] || fail "the node does not become idle"

cd "$work"
scene="$source/scenes/refraction-room/refraction-room.glib"
sweep=("$snell" sweep "$scene" --over uIndex=1.1:2.5:16 --over uMix=0,1 --size 128x128)
mkdir whole out
began=$(date +%s.%N)
"${sweep[@]}" -o 'whole/{uIndex}_{uMix}.png'
echo "unsharded: $(echo "$(date +%s.%N) $began" | awk '{printf "%.1f", $1 - $2}') s"

# As in docs/farm.md; the first run of task 2 waits in the middle of its work, so that there is something to kill.
cat >job.sh <<JOB
#!/bin/bash
#SBATCH --job-name=sweep --array=0-7 --ntasks=1 --requeue --open-mode=append
sweep() {
  ${sweep[*]} -o 'out/{uIndex}_{uMix}.png' --shard \$SLURM_ARRAY_TASK_ID/\$SLURM_ARRAY_TASK_COUNT --skip-existing "\$@"
}
if [ \$SLURM_ARRAY_TASK_ID = 2 ] && [ ! -e started ]; then
  sweep --time 0 && find out -newer started.2 -name '*.png' | head -n 2 | xargs -r rm
  touch started
  sleep 600
fi
sweep
JOB
touch started.2
began=$(date +%s.%N)
job=$(sbatch --parsable job.sh)
for _ in $(seq 60); do
  [ -e started ] && break
  sleep .5
done
[ -e started ] || fail "task 2 did not start"
scontrol requeue "${job}_2" || fail "task 2 can't be rescheduled"
for _ in $(seq 120); do
  [ -z "$(squeue -h -j "$job" 2>/dev/null)" ] && break
  sleep 1
done
[ -z "$(squeue -h -j "$job" 2>/dev/null)" ] || fail "the job does not end"
echo "job array of 8 tasks, one killed and rescheduled: $(echo "$(date +%s.%N) $began" | awk '{printf "%.1f", $1 - $2}') s"
grep -q -i "requeue" slurmctld.log || fail "no task was rescheduled"

[ "$(ls out | wc -l)" = 32 ] || fail "there are $(ls out | wc -l) pictures, not 32"
[ "$(ls -A out | grep -c part)" = 0 ] || fail "unfinished pictures are left"
diff -r whole out || fail "the pictures are not those of the unsharded sweep"
# Everything is there: gathering draws nothing.
"${sweep[@]}" -o 'out/{uIndex}_{uMix}.png' --skip-existing --sheet sheet.png --json all.json
[ "$(grep -c '"skipped": true' all.json)" = 32 ] || fail "gathering drew pictures again"
echo "32 pictures, identical to the unsharded sweep"
