#!/usr/bin/env bash
# reports/paper/run.sh [--program FILE] [--out DIR]: the paper's figures, their data and the page about them.
# Without options it builds the program and writes beside itself. Needs gnuplot (packages.txt).
set -euo pipefail
here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
root=$(cd "$here/../.." && pwd)
program=
out=$here
while (($#)); do
  case "$1" in
    --program) program=$2 ;;
    --out) out=$2 ;;
    *)
      sed -n '2,3s/^# //p' "$0" >&2
      exit 2
      ;;
  esac
  shift 2
done

if [[ -z $program ]]; then
  (cd "$root" && cmake --preset release && cmake --build --preset release --target paper_figures) >&2
  program=$root/build/release/reports/paper/paper_figures
fi
mkdir -p "$out"
"$program" "$root/tests/cases" "$here/page.md.in" "$out"

# A plot's title and description stand in the first lines of its script; gnuplot writes its own into the picture.
for script in "$here"/figure-*.gp; do
  name=$(basename "$script" .gp)
  title=$(sed -n '1s/^# title: //p' "$script")
  words=$(sed -n '2s/^# desc: //p' "$script")
  gnuplot -e "folder = '$out'" "$script" |
    sed -e "s|<title>Gnuplot</title>|<title>$title</title>|" \
      -e "s|<desc>Produced by GNUPLOT \(.*[0-9]\) *</desc>|<desc>$words Drawn by gnuplot \1.</desc>|" >"$out/$name.svg"
done
