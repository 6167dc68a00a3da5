#!/usr/bin/env bash
# fuzz/campaign/kill-and-resume.sh [CASES [KILLS [SEED [OPTION...]]]]: runs one campaign three times, with one worker, with two, and
# killed at KILLS random moments and resumed each time, and compares the run directories byte for byte (times.jsonl and
# lock aside). OPTIONs go to `asts campaign`, such as --claim ID. ASTS names the program, RUNS a folder for the three directories. Exit code 0: equal; 1: not.
set -euo pipefail
program=${ASTS:-build/release/asts}
cases=${1:-20000}
kills=${2:-20}
seed=${3:-1}
runs=${RUNS:-$(mktemp -d)}
options=("${@:4}")
RANDOM=$seed

campaign() { # FOLDER OPTION...
  local folder=$1 status=0
  shift
  "$program" campaign --cases "$cases" --seed "$seed" --out "$runs/$folder" "${options[@]}" "$@" >"$runs/$folder.txt" 2>"$runs/$folder.err" || status=$?
  ((status <= 1 || status == 3)) || { cat "$runs/$folder.err" >&2; exit 2; }
}

started=$SECONDS
campaign two --jobs 2
length=$((SECONDS - started))
echo "two workers: $length s"

# Killed after a random part of what an even share would be, so that kills are spread over the run.
killed=0
while ((killed < kills)); do
  milliseconds=$((length * 1000 / (kills + 1) * (30 + RANDOM % 101) / 100 + 1))
  "$program" campaign --cases "$cases" --seed "$seed" --out "$runs/killed" "${options[@]}" --jobs 2 --resume >"$runs/killed.txt" 2>"$runs/killed.err" &
  process=$!
  sleep "$((milliseconds / 1000)).$(printf %03d $((milliseconds % 1000)))"
  kill -KILL "$process" || true
  wait "$process" 2>"$runs/killed.wait" || true
  killed=$((killed + 1))
  echo "killed $killed times: $(wc -l <"$runs/killed/units.jsonl") units recorded"
done
campaign killed --jobs 2 --resume

started=$SECONDS
campaign one --jobs 1
echo "one worker: $((SECONDS - started)) s"

equal=0
for folder in one killed; do
  if diff -r -q --exclude=times.jsonl --exclude=lock "$runs/two" "$runs/$folder" && cmp "$runs/two.txt" "$runs/$folder.txt"; then
    echo "$folder: the same bytes in $(find "$runs/two" -type f ! -name times.jsonl ! -name lock | wc -l) files, and printed"
  else
    equal=1
  fi
done
exit "$equal"
