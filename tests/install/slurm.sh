#!/bin/sh
# usage: slurm.sh SOURCE_DIR PROGRAM   tools/slurm-array on a real Slurm: one node, on this machine, with a controller,
# a daemon and munge of its own. Skipped (77) by name where one of them is missing or may not run.
set -eu
source=$1
GLIBRA=$2
export GLIBRA
for each in slurmctld slurmd sbatch scancel sinfo munged; do
    command -v $each >/dev/null || { echo "skipped: $each is missing (slurm-wlm and munge)"; exit 77; }
done
[ "$(id -u)" = 0 ] || { echo "skipped: slurmd needs root"; exit 77; }

place=$(mktemp -d /tmp/glibra-slurm-XXXXXX)
started=
finish() {
    for each in $started; do kill "$each" 2>/dev/null || true; done
    rm -rf "$place"
}
trap finish EXIT
fail() {
    echo "FAILED: $*"
    tail -n 20 "$place"/*.log 2>/dev/null || true
    exit 1
}
# start NAME COMMAND...
start() {
    name=$1
    shift
    "$@" >"$place/$name.log" 2>&1 &
    started="$! $started"
}
# until COMMAND...: waits up to a minute.
until_true() {
    tries=300
    while ! "$@" >/dev/null 2>&1; do
        tries=$((tries - 1))
        [ "$tries" -gt 0 ] || return 1
        sleep .2
    done
}

chmod 755 "$place"
mkdir -p "$place/munge" "$place/state" "$place/spool"
dd if=/dev/urandom of="$place/munge/key" bs=1024 count=1 2>/dev/null
chmod 700 "$place/munge"
chmod 600 "$place/munge/key"
start munge munged --foreground --force --key-file="$place/munge/key" --socket="$place/munge.socket" \
    --pid-file="$place/munge/pid" --seed-file="$place/munge/seed" --log-file="$place/munge/log"
until_true test -S "$place/munge.socket" || fail "munged does not start"

host=$(hostname -s)
cat >"$place/slurm.conf" <<END
ClusterName=glibra
SlurmctldHost=$host(127.0.0.1)
SlurmctldPort=$((20000 + $$ % 10000))
SlurmdPort=$((30000 + $$ % 10000))
SlurmUser=root
AuthType=auth/munge
AuthInfo=socket=$place/munge.socket
CredType=cred/munge
StateSaveLocation=$place/state
SlurmdSpoolDir=$place/spool
SlurmctldPidFile=$place/slurmctld.pid
SlurmdPidFile=$place/slurmd.pid
SlurmctldLogFile=$place/slurmctld.log
SlurmdLogFile=$place/slurmd.log
ProctrackType=proctrack/pgid
TaskPlugin=task/none
SwitchType=switch/none
MpiDefault=none
SelectType=select/cons_tres
SelectTypeParameters=CR_CPU
SchedulerParameters=sched_interval=1
ReturnToService=2
JobRequeue=1
NodeName=$host NodeAddr=127.0.0.1 CPUs=$(nproc) State=UNKNOWN
PartitionName=all Nodes=$host Default=YES MaxTime=INFINITE State=UP OverSubscribe=FORCE:4
END
SLURM_CONF=$place/slurm.conf
export SLURM_CONF
start controller slurmctld -D
start node slurmd -D -N "$host"
is_idle() { sinfo -h -o %T | grep -q idle; }
until_true is_idle || fail "the node does not become idle: $(sinfo -h -o '%T %E' 2>&1)"

# Eight shots. GLIBRA is replaced by a program that waits where a part is to be cancelled or started again.
mkdir "$place/scenes"
cp "$source/scenes/expectations/sphere.glib" "$source/scenes/expectations/plain.vert" \
   "$source/scenes/expectations/plain.frag" "$place/scenes"
cat >"$place/scenes/s.toml" <<'END'
[[shot]]
script = "sphere.glib"
size = [32, 32]
sweep = { "uColor" = [[1, 0, 0], [0, 1, 0], [0, 0, 1], [1, 1, 0], [0, 1, 1], [1, 0, 1], [1, 0.5, 0], [0, 0.5, 1]] }
END
cd "$place/scenes"
"$GLIBRA" test s.toml --update >"$place/update.log" 2>&1 || fail "the goldens cannot be made"

# All parts, and a picture that differs.
array() { "$source/tools/slurm-array" -n 4 -o "$place/out" "$@" >"$place/array.log" 2>&1; }
array s.toml || fail "a run without differences ends with $?"
grep -q '8 passed' "$place/array.log" || fail "not all shots have passed"
for part in 1 2 3 4; do [ -s "$place/out/$part/results.jsonl" ] || fail "part $part has no results"; done
[ -s "$place/out/report/index.html" ] && [ -s "$place/out/junit.xml" ] || fail "no report"
cp plain.frag good.frag
sed -i 's/vLight \* uColor/.5 * vLight * uColor/' plain.frag
status=0
array s.toml || status=$?
[ "$status" = 1 ] || fail "a picture that differs gives the status $status"
cp good.frag plain.frag

# A part that is cancelled is missing: status 3, and it is named. The program of that part waits until then.
cat >"$place/slow" <<END
#!/bin/sh
if [ "\${SLURM_ARRAY_TASK_ID-}" = "\$(cat '$place/slow.part' 2>/dev/null)" ] && [ "\$1" = test ] &&
   [ "\${SLURM_RESTART_COUNT:-0}" = 0 ]; then
    touch '$place/waits'
    sleep 120
fi
exec '$GLIBRA' "\$@"
END
chmod +x "$place/slow"
real=$GLIBRA
GLIBRA=$place/slow
echo 2 >"$place/slow.part"
"$source/tools/slurm-array" -n 4 -o "$place/out" s.toml >"$place/array.log" 2>&1 &
array=$!
until_true test -e "$place/waits" || fail "part 2 does not begin"
job=$(squeue -h -o '%F' | head -n 1)
scancel "${job}_2"
status=0
wait "$array" || status=$?
[ "$status" = 3 ] || fail "a part that was cancelled gives the status $status"
grep -q 'part 2 has no results' "$place/array.log" || fail "the part that was cancelled is not named"
grep -q '2/4' "$place/array.log" || fail "the report does not say which part is missing"

# -r continues with what is left.
GLIBRA=$real
"$source/tools/slurm-array" -n 4 -o "$place/out" -r s.toml >"$place/array.log" 2>&1 || fail "-r ends with $?"
grep -q '8 passed' "$place/array.log" || fail "-r does not complete the run"

# A part that Slurm starts again continues where it was.
rm -f "$place/waits"
GLIBRA=$place/slow
echo 3 >"$place/slow.part"
"$source/tools/slurm-array" -n 4 -o "$place/out" -s --requeue s.toml >"$place/array.log" 2>&1 &
array=$!
until_true test -e "$place/waits" || fail "part 3 does not begin"
job=$(squeue -h -o '%F' | head -n 1)
scontrol requeue "${job}_3" || fail "the part is not started again"
until_true scontrol release "${job}_3" || true
status=0
wait "$array" || status=$?
[ "$status" = 0 ] || fail "a part that was started again gives the status $status"
grep -q '8 passed' "$place/array.log" || fail "a part that was started again has no results"
echo "all parts, a difference, a cancelled part, -r and a part that was started again are right"
