#!/usr/bin/env bash
# ./build.sh install   install the missing packages of packages.txt (Debian 12; as root or through sudo)
# ./build.sh verify    install, build the release, run it on the paper's own examples
# ./build.sh test      install, build with warnings as errors, run all tests
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
  build/release/asts check tests/cases/paper/*.case
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
  *)
    sed -n '2,4s/^# //p' "$0" >&2
    exit 2
    ;;
esac
