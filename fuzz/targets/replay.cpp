// replay_TARGET [--print] FILE|FOLDER...: runs the target on files, without a fuzzer. Exit code 1 when one of them
// shows a fault, 2 when one cannot be read. With --print it writes what each file's bytes mean: the case, or the text.

#include <cstdio>
#include <string_view>

#include "fuzz/targets/corpus.hpp"
#include "lib/gen/case_bytes.hpp"
#include "lib/mesh/case_file.hpp"

namespace {

void print(const asts::fuzz::Target& target, const asts::fuzz::CorpusFile& file) {
  const std::string text = target.limits != nullptr ? asts::write_case(asts::case_of_bytes(file.bytes, *target.limits))
                                                    : std::string(file.bytes.begin(), file.bytes.end());
  std::printf("# %s\n%s", file.path.c_str(), text.c_str());
}

/// The number of files with a fault.
int replay(const asts::fuzz::Target& target, const std::vector<asts::fuzz::CorpusFile>& files) {
  int faults = 0;
  for (const asts::fuzz::CorpusFile& file : files) {
    const asts::fuzz::Fault fault = asts::fuzz::checked_fault(target, file.bytes);
    if (!fault) continue;
    ++faults;
    std::printf("%s: %s\n", file.path.c_str(), fault->c_str());
  }
  std::printf("%zu files, %d with a fault\n", files.size(), faults);
  return faults;
}

}  // namespace

int main(int argc, char** argv) {
  const asts::fuzz::Target& target = *asts::fuzz::find_target(ASTS_FUZZ_TARGET);
  std::vector<std::string> arguments(argv + 1, argv + argc);
  const bool prints = !arguments.empty() && arguments.front() == "--print";
  if (prints) arguments.erase(arguments.begin());
  try {
    const std::vector<asts::fuzz::CorpusFile> files = asts::fuzz::read_corpus(arguments);
    if (!prints) return replay(target, files) == 0 ? 0 : 1;
    for (const asts::fuzz::CorpusFile& file : files) print(target, file);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "%s\n", error.what());
    return 2;
  }
}
