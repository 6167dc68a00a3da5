#!/usr/bin/env bash
# tests/benchmarks/run.sh [--quick] [--page FILE]
#
# Builds the preset `bench`, measures, and puts the tables between the markers of FILE (reports/performance.md).
# On two idle cores that takes about 20 minutes. With --quick, 2 minutes, for fewer inputs that are measured once; the
# tables are printed instead. Raw figures stay in build/bench/measured.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/../.."

quick=no page=
while (($#)); do
  case $1 in
    --quick) quick=yes ;;
    --page) page=${2:?--page takes a file}; shift ;;
    *) sed -n '2,6s/^# \{0,1\}//p' "${BASH_SOURCE[0]}" >&2; exit 2 ;;
  esac
  shift
done

build=build/bench
measured=$build/measured
programs=$build/tests/benchmarks
asts=$build/asts
repetitions=5 steps=200
properties='admissible|nested-patches|analysis-suitable|dual-compatible|dual-basis|check'
stages="/(read|refine|replay|closure|patches|zones|(plain-)?($properties)|mesh|nodes|bricks|lambda-cold|lambda-warm)(/iterations:[0-9]+)?\$"
growth="^(sphere|corner|random)/p3/m2/(100000|1000000)$stages"
matrix="^(sphere|corner|random)/(p3/m2/10000|p3/m3/.*|p5/.*)$stages"
if [[ $quick == yes ]]; then
  repetitions=1
  matrix="^(sphere|random)/p3/m2/(10000|100000)$stages"
fi

# Open MPI, which p8est needs, does not start as root without being told to.
export OMPI_ALLOW_RUN_AS_ROOT=1 OMPI_ALLOW_RUN_AS_ROOT_CONFIRM=1

say() { echo "run.sh: $*" >&2; }

# benchmarks NAME FILTER OPTION...: Google Benchmark's file NAME.json.
benchmarks() {
  say "$1"
  "$programs/asts_benchmarks" --benchmark_filter="$2" --benchmark_out="$measured/$1.json" --benchmark_out_format=json \
    "${@:3}" >"$measured/$1.txt"
}

# processes NAME ROUNDS COMMANDS...: time_processes's file NAME.jsonl.
processes() {
  say "$1"
  "$programs/time_processes" "${@:2}" >"$measured/$1.jsonl"
}

# On the same input, in turn, so that what the machine does otherwise hits them alike.
measure_beside_p8est() {
  benchmarks beside '^p8est/sphere/1000000/' \
    --benchmark_repetitions=$repetitions --benchmark_enable_random_interleaving=true
}

measure_stages() {
  benchmarks growth "$growth" --benchmark_repetitions=$repetitions --benchmark_min_time=0.05
}

measure_rest() {
  benchmarks matrix "$matrix" --benchmark_min_time=0.05
  benchmarks others '/steps-|^(enumerate|campaign|minimize|reference)/|^p8est/sphere/10{4,5}/' --benchmark_min_time=0.1
}

# whole_case NAME SPHERE: `refine`, `check` and `check --final` of a case, by themselves and with two jobs.
whole_case() {
  local command commands=()
  for command in refine check "check --final"; do
    # shellcheck disable=SC2086 # a command and its option are two words
    commands+=("$command, $1" "$asts" $command "$2" -- "$command --jobs 2, $1" "$asts" $command --jobs 2 "$2" --)
  done
  processes "whole-${1#10^}" $repetitions "${commands[@]:0:${#commands[@]}-1}"
}

# The difference of both is what the added steps cost.
sequence() {
  "$programs/print_steps" sphere 100000 $steps >"$measured/steps.case"
  processes sequence $repetitions "check, 10^5, before" "$asts" check "$measured/sphere-5.case" \
    -- "check, 10^5, $steps steps more" "$asts" check "$measured/steps.case"
}

measure_processes() {
  "$asts" generate sphere --elements 100000 >"$measured/sphere-5.case"
  "$asts" generate sphere --elements 1000000 >"$measured/sphere-6.case"
  whole_case 10^5 "$measured/sphere-5.case"
  whole_case 10^6 "$measured/sphere-6.case"
  if [[ $quick == no ]]; then sequence; fi
}

machine() {
  lscpu | sed -nE 's/^(Model name|CPU\(s\)|L1d cache|L2 cache|L3 cache): +(.*)/- \1: \2/p'
  awk '/^MemTotal/ { printf "- memory: %d GB\n", $2 / 1e6 }' /proc/meminfo
  echo "- compiler: $(c++ --version | head -n 1), preset \`bench\`"
  echo "- commit: $(git describe --always --dirty 2>/dev/null || echo unknown)"
}

tables() {
  machine
  echo
  local files=("$measured"/beside.json)
  [[ -f $measured/growth.json ]] && files+=("$measured"/growth.json)
  "$programs/write_tables" "${files[@]}" "$measured"/matrix.json "$measured"/others.json "$measured"/*.jsonl
}

# Replaces what stands between the markers of the page.
write_page() {
  tables >"$measured/tables.md"
  {
    sed '/^<!-- measured: begin/q' "$page"
    cat "$measured/tables.md"
    sed -n '/^<!-- measured: end/,$p' "$page"
  } >"$measured/page.md"
  cp "$measured/page.md" "$page"
}

[[ $quick == yes || -n $page ]] || page=reports/performance.md
mkdir -p build
cmake --preset bench >"$build-configure.log" || { cat "$build-configure.log" >&2; exit 3; }
cmake --build --preset bench >&2
mkdir -p "$measured"
rm -f "$measured"/*.json "$measured"/*.jsonl
measure_beside_p8est
measure_processes
[[ $quick == yes ]] || measure_stages
measure_rest
if [[ -n $page ]]; then write_page; else tables; fi
