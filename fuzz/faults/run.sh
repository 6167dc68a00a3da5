#!/usr/bin/env bash
# fuzz/faults/run.sh [--work DIR] [--jobs N] [--search SECONDS] [--fresh] [NAME...]
#
# Applies each fault (NN-NAME.patch, or those named) to a copy of the working tree in DIR, builds it, and writes down in
# table.md which test caught it first, and which search. What an earlier run found out in DIR is kept; --fresh forgets it.
set -euo pipefail

faults=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
root=$(cd "$faults/../.." && pwd)
work=$root/build/faults jobs=1 search_seconds=12 fresh=no names=()
while (($#)); do
  case $1 in
    --work) work=$2; shift ;;
    --jobs) jobs=$2; shift ;;
    --search) search_seconds=$2; shift ;;
    --fresh) fresh=yes ;;
    -*) sed -n '2,5s/^# \{0,1\}//p' "${BASH_SOURCE[0]}" >&2; exit 2 ;;
    *) names+=("$1") ;;
  esac
  shift
done
mkdir -p "$work/tree" "$work/results" "$work/logs"
# Compilers of an interrupted run hold the lock until they have ended: what they write is older than what is copied now.
exec 9>"$work/lock"
flock 9
tree=$(cd -P "$work/tree" && pwd)
build=$tree/build/release
programs=(exact threads mesh refine spline zones gen properties minimize cli reports reference fuzz)

# The copy gets a new time stamp only where it differs, so that as little as possible is built.
copy_tree() {
  local file
  (cd "$root" && git ls-files --cached --others --exclude-standard) >"$work/files.new"
  [[ -f $work/files ]] && comm -23 <(sort "$work/files") <(sort "$work/files.new") | (cd "$tree" && xargs -r -d '\n' rm -f)
  mv "$work/files.new" "$work/files"
  while read -r file; do
    [[ -f $root/$file ]] || continue
    cmp -s "$root/$file" "$tree/$file" && continue
    mkdir -p "$(dirname "$tree/$file")"
    cp --no-preserve=timestamps "$root/$file" "$tree/$file"
  done <"$work/files"
}

configure() {
  [[ -f $build/build.ninja ]] && return
  local linker=()
  command -v mold >/dev/null && linker=(-DCMAKE_EXE_LINKER_FLAGS=-fuse-ld=mold)
  (cd "$tree" && CCACHE_BASEDIR=$tree cmake --preset release "${linker[@]}" >"$work/logs/configure")
}

build_targets() { CCACHE_BASEDIR=$tree cmake --build "$build" -j "$jobs" --target "$@" >>"$log.build" 2>&1; }

elapsed() { awk -v begin="$1" -v end="$(date +%s.%N)" 'BEGIN { printf "%.1f", end - begin }'; }

# --- tests -----------------------------------------------------------------------------------------------------------

has_program() { [[ -f "$build/tests/test_$1[1]_include.cmake" ]]; }

# CPU seconds: five times what the unchanged program took, and half a minute.
limit_of() { awk '{ printf "%d", 5 * $1 + 30 }' "$work/results/seconds.$1" 2>/dev/null || echo 1200; }

# Tests that took more than a second come last.
slow_tests() { sed -n 's/^\[       OK \] \([^ ,]*\).* (\([0-9]\{4,\}\) ms)$/\1/p' "$work/logs/unchanged.$1" 2>/dev/null | paste -sd:; }

# Faults.* demands that all patches apply, which they do not to a file that has one.
# run_tests PROGRAM FILTER: sets `found` to the first test that fails.
run_tests() {
  local status=0
  (cd "$tree" && ulimit -t "$(limit_of "$1")" &&
    timeout $((10 * $(limit_of "$1"))) "$build/tests/test_$1" --gtest_filter="$2" --gtest_fail_fast) >"$log.$1" 2>&1 || status=$?
  ((status == 0)) && return 1
  found=$(sed -n 's/^\[  FAILED  \] \([^ ,]*\).*/\1/p' "$log.$1" | head -n 1)
  [[ -n $found ]] || found=$(sed -n 's/^\[ RUN      \] \([^ ]*\).*/\1/p' "$log.$1" | tail -n 1)
  if ((status == 124 || status == 152)); then
    found+=" (timeout)"  # 152: SIGXCPU
  elif ((status > 128)); then
    found+=" (crash)"
  fi
  return 0
}

# near_tests FOLDER FILE: the test suites of the mirrored folder in files that include the changed file's header.
near_tests() {
  { grep -l "\"${2%.cpp}.hpp\"" "$tree/tests/$1"/*_test.cpp || true; } | xargs -r -d '\n' cat |
    sed -n 's/^\(TEST\|TEST_P\|RC_GTEST_PROP\)(\([A-Za-z0-9_]*\),.*/\2.*:*\/\2.*/p' | sort -u | paste -sd:
}

# first_test FOLDER FILE: first the tests nearest to the changed file, then the mirrored program, then the others, their
# slow tests last. Sets test and test_seconds.
first_test() {
  local program pass passes=("$1 near" "$1 quick" "$1 slow") begin spent=0 tests near found
  test=- test_seconds=-
  for pass in quick slow; do
    for program in "${programs[@]}"; do [[ $program == "$1" ]] || passes+=("$program $pass"); done
  done
  for pass in "${passes[@]}"; do
    program=${pass% *} tests=$(slow_tests "${pass% *}")
    has_program "$program" || continue
    build_targets "test_$program" || { test="does not compile"; return; }
    case $pass in
      *near) near=$(near_tests "$1" "$2") tests=${near:+"$near-$tests"} ;;
      *quick) tests="-Faults.*:$tests" ;;
      *slow) tests=${tests:+"$tests-Faults.*"} ;;
    esac
    [[ -n $tests ]] || continue
    begin=$(date +%s.%N)
    if run_tests "$program" "$tests"; then test="$program: $found"; fi
    spent=$(awk -v a="$spent" -v b="$(elapsed "$begin")" 'BEGIN { printf "%.1f", a + b }')
    [[ $test == - ]] || { test_seconds=$spent; return; }
  done
}

# --- search ----------------------------------------------------------------------------------------------------------

# The cases that are known: nothing fails, what is violated is confirmed by the literal code, collections are as recorded.
search_known() {
  local case cases=0 status
  while read -r case; do
    cases=$((cases + 1)) status=0
    timeout 60 "$build/asts" check --format json "$case" >"$work/checked.jsonl" 2>>"$log.search" || status=$?
    if ((status > 1)); then search="check" after="$cases cases"; return 0; fi
    if ((status == 1)) && ! timeout 60 "$build/asts" validate "$work/checked.jsonl" >>"$log.search" 2>&1; then
      search="check, validate" after="$cases cases"
      return 0
    fi
  done < <(find "$tree/tests/cases" -name '*.case' | sort)
  for case in collection findings; do
    timeout 300 "$build/asts" replay "$tree/reports/$case" >>"$log.search" 2>&1 && continue
    search="replay" after="reports/$case"
    return 0
  done
  return 1
}

search_random() {
  local status=0
  timeout $((search_seconds + 60)) "$build/fuzz/faults/search_for_faults" 1 "$search_seconds" >"$log.random" 2>&1 || status=$?
  ((status == 0)) && return 1
  search=$(sed -n 's/^caught: //p' "$log.random" | cut -c 1-60 | tr '|' '/')
  ((status == 124)) && search=timeout
  ((status > 128)) && search=crash
  after="$(grep -c '^mesh' "$log.random") meshes"
  return 0
}

first_search() {
  search=- after=-
  build_targets asts search_for_faults || { search="does not compile"; return; }
  search_known || search_random || true
}

# --- one fault -------------------------------------------------------------------------------------------------------

# The mirrored test program of a file.
folder_of() {
  local folder=${1#lib/}
  echo "${folder%%/*}"
}

try_fault() {
  local patch=$1 name file
  name=$(basename "$patch" .patch)
  log=$work/logs/$name
  rm -f "$log".*
  file=$(sed -n 's/^+++ b\///p' "$patch")
  cp "$tree/$file" "$work/original"
  (cd "$tree" && patch -p1 -F0 -s --no-backup-if-mismatch) <"$patch"
  first_test "$(folder_of "$file")" "$file"
  first_search
  cp "$work/original" "$tree/$file"
  if [[ $test$search == *"does not compile"* ]]; then
    echo "$name does not compile: see $log.build" >&2
    return
  fi
  printf '%s|%s|%s|%s|%s|%s|%s\n' "$name" "$(head -n 1 "$patch" | sed 's/: .*//')" "$file" "$test" "$test_seconds" \
    "$search" "$after" >"$work/results/$name.new"
  cksum <"$patch" >"$work/results/$name.patch"
  mv "$work/results/$name.new" "$work/results/$name"
  cat "$work/results/$name"
}

is_known() {
  local name
  name=$(basename "$1" .patch)
  [[ -f $work/results/$name ]] && [[ $(cat "$work/results/$name.patch") == $(cksum <"$1") ]]
}

# Without a fault nothing may be caught; and how long each test program takes.
try_unchanged() {
  [[ -f $work/results/unchanged ]] && return
  local program begin found
  log=$work/logs/unchanged
  rm -f "$log".*
  for program in "${programs[@]}"; do
    has_program "$program" || continue
    build_targets "test_$program"
    begin=$(date +%s.%N)
    if run_tests "$program" '*'; then echo "the unchanged $program fails: $found" >&2; exit 1; fi
    elapsed "$begin" >"$work/results/seconds.$program"
  done
  first_search
  [[ $search == - ]] || { echo "the search finds something in the unchanged code: $search" >&2; exit 1; }
  touch "$work/results/unchanged"
}

# --- table -----------------------------------------------------------------------------------------------------------

write_table() {
  local patch name caught=0 all=0 row class file test seconds search after
  {
    echo "# Planted faults and what caught them"
    echo
    echo "Made by \`fuzz/faults/run.sh\`; [README.md](README.md) says how to read it."
    echo
    echo "| fault | class | file | first test | seconds | search | after |"
    echo "|---|---|---|---|---|---|---|"
    for patch in "$faults"/*.patch; do
      name=$(basename "$patch" .patch)
      is_known "$patch" || continue
      IFS='|' read -r row class file test seconds search after <"$work/results/$name"
      echo "| $row | $class | $file | $test | $seconds | $search | $after |"
      all=$((all + 1))
      [[ $test$search == -- ]] || caught=$((caught + 1))
    done
    echo
    echo "$caught of $all caught"
  } >"$work/table.md"
  cp "$work/table.md" "$faults/table.md"
}

[[ $fresh == no ]] || rm -f "$work"/results/*
copy_tree
configure
try_unchanged
for patch in "$faults"/*.patch; do
  name=$(basename "$patch" .patch)
  if ((${#names[@]})); then
    [[ " ${names[*]} " == *" $name "* || " ${names[*]} " == *" ${name%%-*} "* || " ${names[*]} " == *" ${name#*-} "* ]] || continue
    rm -f "$work/results/$name"
  fi
  is_known "$patch" || try_fault "$patch"
  write_table
done
tail -n 1 "$faults/table.md"
