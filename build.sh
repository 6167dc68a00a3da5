#!/usr/bin/env bash
# ./build.sh install   install the missing packages of packages.txt (Debian 12; as root or through sudo)
# ./build.sh verify    install, build the release, run it on the paper's own examples, try all claims, write reports
# ./build.sh test      install, build with warnings as errors, run all tests
# ./build.sh ledger    build the release, try all claims at length, write the results to reports/ledger
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")"

missing_packages() {
  local package
  sed 's/#.*//' packages.txt | while read -r package; do
    [[ -z $package ]] && continue
    [[ $(dpkg-query -W -f='${db:Status-Status}' "$package" 2>/dev/null) == installed ]] || echo "$package"
  done
}

apt_get() {
  local root=()
  ((EUID == 0)) || root=(sudo)
  "${root[@]}" env DEBIAN_FRONTEND=noninteractive apt-get -y -q "$@"
}

install_packages() {
  local missing
  mapfile -t missing < <(missing_packages)
  ((${#missing[@]})) || return 0
  if ((EUID != 0)) && ! command -v sudo >/dev/null; then
    echo "build.sh: missing packages, and neither root nor sudo to install them: ${missing[*]}" >&2
    return 2
  fi
  # A fresh system has no package lists, an old one stale ones. A broken foreign source must not stop the install.
  apt_get update || echo "build.sh: apt-get update failed; trying with the lists at hand" >&2
  apt_get install --no-install-recommends "${missing[@]}"
}

verify() {
  cmake --workflow --preset verify
  local m
  for m in 2 4 16; do
    build/release/asts refine "tests/cases/paper/example-2.10-m$m.case"
  done
  rm -rf build/verify
  mkdir -p build/verify
  build/release/asts check --out build/verify/paper tests/cases/paper/*.case
  echo
  echo "Trying all claims on 3000 random cases, a minute on two cores ..."
  build/release/asts campaign --cases 3000 --seed 2026 --jobs 2 --out build/verify/claims >build/verify/claims.txt
  local run
  for run in claims paper; do
    build/release/asts report "build/verify/$run" -o "build/verify/$run.html"
  done
  echo "All claims with their findings, to be read in a browser: build/verify/claims.html"
  echo "The paper's examples: build/verify/paper.html"
}

# enumerate_lines DEGREE GRADING DOMAIN SUBDIVISIONS ADMISSIBLE OPTION...: what `asts enumerate` prints, each line with the
# setting in front. A violation is a result, not a failure.
enumerate_lines() {
  local flags=("${@:6}")
  [[ $5 == true ]] && flags+=(--admissible)
  build/release/asts enumerate --degree "$1" --grading "$2" --domain "$3" --max-subdivisions "$4" "${flags[@]}" \
    --format json >build/lines.jsonl || (($? == 1)) || return 3
  sed "s/^{/{\"degree\":[$1],\"grading\":$2,\"domain\":[$3],\"max_subdivisions\":$4,\"admissible\":$5,/" build/lines.jsonl
}

enumerate_all() {
  local inclusions=(--claim as-implies-dc --claim dc-implies-as)
  enumerate_lines 3,3,3 2 4,4,5 3 false "${inclusions[@]}"
  enumerate_lines 3,3,3 2 4,4,5 3 true "${inclusions[@]}"
  enumerate_lines 3,3,3 2 4,4,5 4 false "${inclusions[@]}"
  enumerate_lines 3,3,3 2 5,5,8 2 false "${inclusions[@]}"
  enumerate_lines 3,3,3 2 5,5,8 3 false "${inclusions[@]}"
}

# The exit code is that of `asts ledger`.
ledger() {
  cmake --workflow --preset verify
  local status=0
  build/release/asts ledger --long --jobs "$(nproc)" --format json >build/ledger.jsonl || status=$?
  ((status == 0 || status == 1 || status == 3)) || return "$status"
  enumerate_all >build/enumerate.jsonl
  mkdir -p reports/ledger
  mv build/ledger.jsonl build/enumerate.jsonl reports/ledger/
  build/release/asts ledger --render reports/ledger/ledger.jsonl reports/ledger/enumerate.jsonl >reports/ledger/README.md
  return "$status"
}

case "${1:-}" in
  install) install_packages ;;
  verify)
    install_packages
    verify
    ;;
  test)
    install_packages
    cmake --workflow --preset test
    ;;
  ledger)
    install_packages
    ledger
    ;;
  *)
    sed -n '2,5s/^# //p' "$0" >&2
    exit 2
    ;;
esac
