#!/usr/bin/env bash
# The sweep of docs/farm.md as a Slurm job array, on a controller and a node that this script starts here and stops again.
# One task is killed in mid-sweep and rescheduled; the set must be complete and identical to the unsharded one.
# usage: slurm_one_node.sh PROGRAM SOURCE_FOLDER     status 77: skipped
set -euo pipefail

snell=$(realpath "$1") source=$(realpath "$2")
. "$source/tests/farm/common.sh"
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

ready "$work"
block slurm >job.sh

# What the tasks find as snell. The first run of task 2 stops in the middle of its work: it lacks two of its pictures.
mkdir bin
cat >bin/snell <<WRAPPER
#!/bin/bash
if [ "\$SLURM_ARRAY_TASK_ID" != 2 ] || [ -e $work/started ]; then exec $snell "\$@"; fi
$snell "\$@" --json $work/first.json
grep -o '"file": "[^"]*"' $work/first.json | cut -d'"' -f4 | tail -n 2 | xargs rm
touch $work/started
sleep 600
WRAPPER
chmod +x bin/snell
export PATH="$work/bin:$PATH"
began=$(date +%s%N)
job=$(sbatch --parsable job.sh)
for _ in $(seq 60); do
  [ -e started ] && break
  sleep .5
done
[ -e started ] || fail "task 2 did not start"
[ "$(grep -c '"index"' first.json)" -gt 2 ] || fail "task 2 had nothing to lose"
scontrol requeue "${job}_2" || fail "task 2 can't be rescheduled"
# Slurm waits two minutes before it starts a task again, if nobody says otherwise.
for _ in $(seq 20); do
  [ "$(squeue -h -o %t -j "${job}_2" 2>/dev/null)" != PD ] || { scontrol update jobid="${job}_2" StartTime=now && break; }
  sleep .5
done
for _ in $(seq 120); do
  [ -z "$(squeue -h -j "$job" 2>/dev/null)" ] && break
  sleep 1
done
[ -z "$(squeue -h -j "$job" 2>/dev/null)" ] || fail "the job does not end"
echo "job array of 8 tasks, one killed and rescheduled: $(seconds) s"
grep -qi requeuing slurmctld.log || fail "no task was rescheduled"
export PATH="${PATH#"$work/bin:"}"
same
