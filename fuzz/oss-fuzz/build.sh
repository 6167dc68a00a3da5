#!/bin/bash
# The build as OSS-Fuzz and ClusterFuzzLite run it: $SRC/asts is the project, $OUT takes the fuzzers with their seeds,
# dictionaries, options and libraries; $CXX, $CXXFLAGS and $LIB_FUZZING_ENGINE say with which engine and sanitizer.
#
# What runs the fuzzers has no packages of the distribution. Of ours, FLINT, Arb and fmt come without static libraries,
# so all are taken along: shared, in $OUT/lib, where the fuzzers look first (RPATH and not RUNPATH, because that holds
# for the libraries that the libraries need, too). They are not instrumented: what a sanitizer sees of them are their
# allocations. fmt and pugixml are C++ and must be built against the same standard library as the fuzzers; where
# $CXXFLAGS has -stdlib=libc++, they have to be built first, from source.

set -euo pipefail
build=${WORK:-$SRC}/asts-fuzz
cmake -S "$SRC/asts" -B "$build" -G Ninja -DASTS_TESTS=OFF \
  -DCMAKE_C_COMPILER="$CC" -DCMAKE_CXX_COMPILER="$CXX" -DCMAKE_CXX_FLAGS="$CXXFLAGS" \
  -DASTS_FUZZING_ENGINE="$LIB_FUZZING_ENGINE" \
  -DCMAKE_BUILD_RPATH='$ORIGIN/lib' -DCMAKE_EXE_LINKER_FLAGS=-Wl,--disable-new-dtags

targets=(claims differential case_reader witness_reader)
cmake --build "$build" --target "${targets[@]/#/fuzz_}"

mkdir -p "$OUT/lib"
for target in "${targets[@]}"; do
  built=$build/fuzz/targets/fuzz_$target
  cp "$built" "$OUT/"
  # not of the copy: beside that one the libraries may be already
  ldd "$built" | awk '$1 ~ /^lib(gmp|mpfr|flint|flint-arb|arb|fmt|pugixml)\.so/ {print $3}' |
    while read -r library; do cp -L -u "$library" "$OUT/lib/"; done
  (cd "$SRC/asts/fuzz/corpora/$target" && zip -q -r "$OUT/fuzz_${target}_seed_corpus.zip" .)
  cp "$SRC/asts/fuzz/oss-fuzz/fuzz_$target.options" "$OUT/"
done
cp "$SRC/asts/fuzz/dictionaries/case.dict" "$OUT/fuzz_case_reader.dict"
cp "$SRC/asts/fuzz/dictionaries/record.dict" "$OUT/fuzz_witness_reader.dict"
