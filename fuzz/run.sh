#!/bin/sh
# Runs one fuzz target, from the checked-in corpus and the stored findings. fuzz/README.md explains.
#
#   fuzz/run.sh TARGET [OPTION...]          libFuzzer with ASan and UBSan; options such as -runs=10000, -max_total_time=60
#   fuzz/run.sh --afl TARGET [OPTION...]    AFL++; options such as -V 60
#   fuzz/run.sh --minimize TARGET           takes what a run found into the checked-in corpus, and of that what it needs
#
# TARGET is claims, differential, case_reader or witness_reader.
set -eu
cd "$(dirname "$0")/.."

mode=libfuzzer
case "${1:-}" in
  --afl) mode=afl; shift ;;
  --minimize) mode=minimize; shift ;;
esac
target=${1:?usage: fuzz/run.sh [--afl|--minimize] TARGET [OPTION...]}
shift

build=build/fuzz
if [ "$mode" = afl ]; then build=build/afl; fi
case "$target" in
  claims) limits="-max_len=300 -timeout=60 -entropic_scale_per_exec_time=1"; dictionary= ;;
  differential) limits="-max_len=120 -timeout=60 -entropic_scale_per_exec_time=1"; dictionary= ;;
  case_reader) limits="-max_len=250 -timeout=20"; dictionary=fuzz/dictionaries/case.dict ;;
  witness_reader) limits="-max_len=4000 -timeout=60"; dictionary=fuzz/dictionaries/record.dict ;;
  *) echo "fuzz/run.sh: no target $target" >&2; exit 2 ;;
esac

cmake --preset "$(basename $build)" > /dev/null
cmake --build $build --target "fuzz_$target" seed_corpora
corpus=$build/corpus/$target
mkdir -p "$corpus" $build/artifacts $build/afl
# Names say what the bytes are, so that what is there already is not there twice.
$build/fuzz/targets/seed_corpora $build/seeds tests/cases/*/*.case reports/collection/*.case reports/findings/*.case
fuzzer=$build/fuzz/targets/fuzz_$target

# Allocations are many and small: their stacks would cost more than the target. A crash is replayed with them. Not for
# AFL++, which is built without sanitizers and wants options of its own.
if [ "$mode" != afl ]; then
  export ASAN_OPTIONS="${ASAN_OPTIONS:-malloc_context_size=0:quarantine_size_mb=1:detect_stack_use_after_return=0}"
fi

case $mode in
  libfuzzer)
    exec $fuzzer $limits ${dictionary:+-dict=$dictionary} -rss_limit_mb=2048 -print_final_stats=1 \
      -artifact_prefix=$build/artifacts/"$target"- "$@" "$corpus" fuzz/corpora/"$target" $build/seeds/"$target" ;;
  minimize)
    mkdir -p $build/minimized/"$target"
    rm -f $build/minimized/"$target"/*
    $fuzzer -merge=1 $limits $build/minimized/"$target" $build/seeds/"$target" fuzz/corpora/"$target" "$corpus"
    rm -f fuzz/corpora/"$target"/*
    $build/fuzz/targets/seed_corpora --adopt fuzz/corpora/"$target" $build/seeds/"$target" $build/minimized/"$target" ;;
  afl)
    cp -n fuzz/corpora/"$target"/* $build/seeds/"$target"/
    export AFL_SKIP_CPUFREQ=1 AFL_I_DONT_CARE_ABOUT_MISSING_CRASHES=1
    exec afl-fuzz -i $build/seeds/"$target" -o $build/afl/"$target" ${dictionary:+-x $dictionary} -t 5000 "$@" -- $fuzzer ;;
esac
