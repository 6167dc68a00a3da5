#!/usr/bin/env bash
# run.sh CASES OUT
# Decides the properties on a project's own meshes, then runs a campaign on random ones. README.md beside this file.
#   CASES  a folder of .case files, those in folders below it too
#   OUT    what is kept: own/ (minimized cases that violate, of this run alone), campaign/ (the run directory, resumed
#          when it is there)
# From the environment:
#   ASTS                   the program; built from the folder that this script is part of when it is not set
#   ASTS_PROPERTIES        what must hold on the project's meshes; all five when it is not set
#   ASTS_CLAIMS            claims that must hold on them, beside the properties
#   ASTS_BUDGET            how often a property or claim is decided to minimize a case (2000)
#   ASTS_SECONDS           how long the campaign runs (600)
#   ASTS_SEED, ASTS_JOBS   of the campaign (1, all cores)
#   ASTS_CAMPAIGN_OPTIONS  further options of it, for example "--claim patches-nested --timeout 20"
# Exit code: 1 when something is violated or the campaign found what is not expected, with the minimized cases above;
# 2 when the input is wrong; 3 when the campaign is not healthy or something failed; else 0.
set -uo pipefail

root=$(cd "$(dirname "${BASH_SOURCE[0]}")/../.." && pwd)
properties=${ASTS_PROPERTIES-admissible nested-patches analysis-suitable dual-compatible dual-basis}
claims=${ASTS_CLAIMS-}
status=0

fail() {
  echo "run.sh: $1" >&2
  exit "$2"
}

# worse CODE: the exit code is the gravest: 1 before 2 before 3 before 0. Programs that are killed have others: failures.
worse() {
  local code=$1
  ((code <= 3)) || code=3
  case "$status,$code" in
    *,0 | 1,*) ;;
    *,1 | 0,* | 3,2) status=$code ;;
  esac
}

build() {
  (cd "$root" && ./build.sh install && cmake --workflow --preset verify) >&2 || fail "ASTS cannot be built" 3
}

# kept_name FILE ID: where the minimized case of a file goes. Files in different folders, and of different names, get
# different ones.
kept_name() {
  local name=${1#"$cases"}
  name=${name#/}
  name=${name%.case}
  name=${name//%/%25}
  printf '%s/own/%s-%s.case' "$out" "${name//\//%2F}" "$2"
}

# first_violating FILE OPTION ID: the case as far as the first mesh that violates. `asts minimize` looks at the last mesh
# of a case, and what a step breaks a later one may mend. Nothing where that case is too long for `asts check` to print.
first_violating() {
  "$asts" check "$1" "$2" "$3" --format json 2>/dev/null |
    sed -nE '/,"mesh":"asts-case ([^"\\]|\\n)*"\}$/ { s/.*,"mesh":"//; s/\\n"\}$//; s/\\n/\n/g; p; q }'
}

# minimize FILE OPTION ID: prints and keeps the smallest case that violates in the same way, or, where the budget ends
# before that is known, the smallest that was found.
minimize() {
  local kept code=0
  kept=$(kept_name "$1" "$3")
  first_violating "$@" >"$kept.start"
  [[ -s $kept.start ]] || cp "$1" "$kept.start"
  echo "==== $1 violates $3; the smallest case that does so in the same way:"
  "$asts" minimize "$kept.start" "$2" "$3" --budget "${ASTS_BUDGET-2000}" >"$kept" 2>"$kept.log" || code=$?
  case $code in
    0 | 3 | 130) grep -q '^asts-case ' "$kept" ;;
    *) false ;;
  esac || cp "$kept.start" "$kept"
  cat "$kept"
  ((code == 0)) || cat "$kept.log"
  rm -f "$kept.start" "$kept.log"
}

# decide FILE OPTION ID
decide() {
  local said code=0
  said=$("$asts" check "$1" "$2" "$3") || code=$?
  worse "$code"
  ((code == 0)) && return
  printf '%s\n' "$said"
  ((code == 1)) && minimize "$1" "$2" "$3"
}

# What an earlier run kept may be mended by now.
empty_own() {
  mkdir -p "$out/own" || fail "$out/own: cannot be made" 3
  [[ ! $cases -ef $out/own ]] || fail "$cases: is emptied for the minimized cases" 2
  find "$out/own" -maxdepth 1 -type f -name '*.case*' -delete
}

decide_own() {
  local file id count=0
  empty_own
  while IFS= read -r -d '' file; do
    count=$((count + 1))
    for id in $properties; do decide "$file" --property "$id"; done
    for id in $claims; do decide "$file" --claim "$id"; done
  done < <(find "$cases" -name '*.case' -type f -print0 | sort -z)
  ((count > 0)) || fail "$cases: no .case file" 2
  echo "==== $count cases of the project"
}

# The lines that name the findings that nobody expects; of all where only claims that were named are violated.
telling_findings() {
  grep '^UNEXPECTED ' "$out/campaign/statistics.txt" || grep '^[^ ].*: [^ ]*\.case$' "$out/campaign/statistics.txt"
}

# Each ends with the finding's file, unless it has none.
show_findings() {
  local line file
  telling_findings | while IFS= read -r line; do
    echo "==== $line"
    file=$out/campaign/${line##*: }
    if [[ $line == *.case && -f $file ]]; then cat "$file"; fi
  done
}

campaign() {
  local code=0 options
  read -ra options <<<"${ASTS_CAMPAIGN_OPTIONS-}"
  "$asts" campaign --time "${ASTS_SECONDS-600}" --seed "${ASTS_SEED-1}" --jobs "${ASTS_JOBS-$(nproc)}" \
    --out "$out/campaign" --resume "${options[@]}" || code=$?
  ((code == 1)) && show_findings
  ((code == 0)) || echo "==== asts campaign: exit code $code"
  worse "$code"
}

(($# == 2)) || fail "usage: run.sh CASES OUT" 2
cases=$1
out=$2
[[ -d $cases ]] || fail "$cases: no folder" 2
mkdir -p "$out" || fail "$out: cannot be made" 2
asts=${ASTS-$root/build/release/asts}
[[ -n ${ASTS-} ]] || build
decide_own
campaign
exit "$status"
