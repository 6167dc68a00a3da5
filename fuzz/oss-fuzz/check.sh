#!/bin/bash
# Runs build.sh as OSS-Fuzz would, with the compiler and the engine that are here, and starts each fuzzer in $OUT on
# the seeds of its zip file. Works in build/oss-fuzz.
set -euo pipefail
root=$(cd "$(dirname "$0")/../.." && pwd)
work=$root/build/oss-fuzz
mkdir -p "$work/src" "$work/out" "$work/work"
ln -sfn "$root" "$work/src/asts"
export SRC=$work/src OUT=$work/out WORK=$work/work CC=clang-16 CXX=clang++-16 LIB_FUZZING_ENGINE=-fsanitize=fuzzer
export CFLAGS="-O1 -fno-omit-frame-pointer -gline-tables-only -fsanitize=address -fsanitize-address-use-after-scope -fsanitize=fuzzer-no-link"
export CXXFLAGS="$CFLAGS"
bash -eu "$root/fuzz/oss-fuzz/build.sh"
for fuzzer in "$OUT"/fuzz_*[a-z]; do
  [[ -x $fuzzer && ! -d $fuzzer ]] || continue
  name=$(basename "$fuzzer")
  if ldd "$fuzzer" | grep -E 'lib(gmp|mpfr|flint|flint-arb|fmt|pugixml)\.so' | grep -vF "$OUT/lib/"; then
    echo "$name: a library is not in \$OUT/lib" >&2
    exit 1
  fi
  seeds=$work/seeds/$name
  rm -rf "$seeds" && mkdir -p "$seeds"
  (cd "$seeds" && unzip -q "$OUT/${name}_seed_corpus.zip")
  "$fuzzer" -runs=200 "$seeds" >"$work/$name.log" 2>&1 || { tail -20 "$work/$name.log" >&2; exit 1; }
  echo "$name: started, $(grep -c . <(ls "$seeds")) seeds, $(tail -1 "$work/$name.log")"
done
