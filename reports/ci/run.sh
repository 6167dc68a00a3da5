#!/usr/bin/env bash
# run.sh CASES OUT
# Decides the properties on a project's own meshes, then runs a campaign on random ones. README.md beside this file.
#   CASES  a folder of .case files, those in folders below it too
#   OUT    what is kept: own/ (minimized cases that violate), campaign/ (the run directory, resumed when it is there)
# From the environment:
#   ASTS                   the program; built from the folder that this script is part of when it is not set
#   ASTS_PROPERTIES        what must hold on the project's meshes; all five when it is not set
#   ASTS_CLAIMS            claims that must hold on them, beside the properties
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

# worse CODE: the exit code is the gravest: 1 before 2 before 3 before 0.
worse() {
  case "$status,$1" in
    *,0 | 1,*) ;;
    *,1 | 0,* | 3,2) status=$1 ;;
  esac
}

build() {
  (cd "$root" && ./build.sh install && cmake --workflow --preset verify) >&2 || fail "ASTS cannot be built" 3
}

# minimize FILE OPTION ID: prints and keeps the smallest case that violates in the same way.
minimize() {
  local kept
  kept="$out/own/$(basename "$1" .case)-$3.case"
  echo "==== $1 violates $3; the smallest case that does so in the same way:"
  if "$asts" minimize "$1" "$2" "$3" --budget 2000 >"$kept" 2>"$kept.log"; then
    cat "$kept"
  else
    cat "$kept.log" "$1"
    cp "$1" "$kept"
  fi
  rm -f "$kept.log"
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

decide_own() {
  local file id count=0
  mkdir -p "$out/own"
  while IFS= read -r -d '' file; do
    count=$((count + 1))
    for id in $properties; do decide "$file" --property "$id"; done
    for id in $claims; do decide "$file" --claim "$id"; done
  done < <(find "$cases" -name '*.case' -type f -print0 | sort -z)
  ((count > 0)) || fail "$cases: no .case file" 2
  echo "==== $count cases of the project"
}

# The files of the findings that nobody expects; of all where only claims that were named are violated.
telling_findings() {
  sed -n 's/^UNEXPECTED .*: \(findings\/.*\.case\)$/\1/p' "$out/campaign/statistics.txt" 2>/dev/null | grep . ||
    (cd "$out/campaign" && find findings -name '*.case' -type f | sort)
}

show_findings() {
  local file
  telling_findings | while IFS= read -r file; do
    echo "==== $file"
    cat "$out/campaign/$file"
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
