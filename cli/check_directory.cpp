#include "cli/check_directory.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "cli/output_file.hpp"
#include "fuzz/campaign/sealed_lines.hpp"
#include "lib/exact/errors.hpp"
#include "lib/mesh/case_file.hpp"
#include "lib/mesh/case_prefix.hpp"
#include "reports/check_reading.hpp"
#include "reports/witness_reading.hpp"

namespace asts::cli {

namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

constexpr int kFormat = 1;  ///< of the folder
constexpr const char* kRun = "check.json";
constexpr const char* kRecords = "records.jsonl";
constexpr const char* kCases = "cases";

bool is_plain(char c) {
  const bool letter = ('a' <= c && c <= 'z') || ('A' <= c && c <= 'Z');
  return letter || ('0' <= c && c <= '9') || c == '.' || c == '_' || c == '-';
}

/// The names of files begin with their number.
std::string file_begin(std::size_t place) { return fmt::format("{}/{}-", kCases, place + 1); }

/// A name for a file that needs no quotes anywhere: "cases/2-as-implies-dc.case".
std::string file_of(std::size_t place, const std::string& name) {
  std::string stem = name == "-" ? "stdin" : fs::path(name).stem().string();
  std::replace_if(
      stem.begin(), stem.end(), [](char c) { return !is_plain(c); }, '_');
  constexpr std::size_t kLongest = 100;
  return file_begin(place) + stem.substr(0, kLongest) + ".case";
}

/// Whether a file is called as the one of a case.
bool is_file_of(std::size_t place, const std::string& file) {
  const std::string begin = file_begin(place);
  return file.starts_with(begin) && file.ends_with(".case") &&
         std::all_of(file.begin() + static_cast<std::ptrdiff_t>(begin.size()), file.end(), is_plain);
}

void make_empty_folder(const std::string& folder) {
  std::error_code error;
  fs::create_directories(folder, error);
  if (error || !fs::is_directory(folder)) throw InputError(folder + ": cannot be made a folder");
  const bool empty = fs::is_empty(folder, error);
  if (error) throw InputError(folder + ": cannot be read");
  if (!empty) throw InputError(folder + ": is not empty");
  fs::create_directory(fs::path(folder) / kCases, error);
  if (error) throw InputError(folder + ": cannot be written to");
}

std::string run_json(const CheckRun& run, const std::vector<Input>& inputs) {
  Json json{{"check", kFormat},      {"version", run.version},      {"final", run.final_only},
            {"budget", run.budget},  {"properties", Json::array()}, {"claims", Json::array()},
            {"cases", Json::array()}};
  for (const Property* property : run.properties) json["properties"].push_back(property->id);
  for (const Claim* claim : run.claims) json["claims"].push_back(claim->id);
  for (std::size_t i = 0; i < inputs.size(); ++i) {
    json["cases"].push_back({{"name", inputs[i].name}, {"file", file_of(i, inputs[i].name)}});
  }
  return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

CheckRun run_from(const Json& json, const std::string& folder) {
  require(count_in(json, "check") == kFormat, "a check of another form");
  CheckRun run;
  run.version = text_in(json, "version");
  run.final_only = json.at("final").get<bool>();
  run.budget = static_cast<std::uint64_t>(count_in(json, "budget"));
  for (const Json& id : json.at("properties")) {
    run.properties.push_back(find_property(id.get<std::string>()));
    if (run.properties.back() == nullptr) throw InputError("no property is called '" + id.get<std::string>() + "'");
  }
  for (const Json& id : json.at("claims")) {
    run.claims.push_back(find_claim(id.get<std::string>()));
    if (run.claims.back() == nullptr) throw InputError("no claim is called '" + id.get<std::string>() + "'");
  }
  for (const Json& one : json.at("cases")) {
    const std::string name = text_in(one, "name");
    const std::string file = text_in(one, "file");
    if (!is_file_of(run.cases.size(), file)) throw InputError("'" + file + "' is not the file of the case");
    run.cases.push_back({name, file, read_input(folder + "/" + file).content});
  }
  return run;
}

CheckRun read_run(const std::string& folder) {
  const std::string path = folder + "/" + kRun;
  const Json json = json_of_file(path);
  try {
    return run_from(json, folder);
  } catch (const Json::exception& error) {
    const std::string reason = error.what();
    throw InputError(path + ": " + reason.substr(reason.find("] ") + 2));
  } catch (const CaseFileError&) {
    throw;  // names its own place
  } catch (const InputError& error) {
    throw InputError(path + ": " + error.what());
  }
}

/// A record must be that of the mesh that comes next, with a verdict on everything that was asked for.
void require_next(const CheckRun& run, const CheckRun::CheckedCase& checked, std::int64_t step,
                  const CheckRecord& record) {
  if (record.case_name != checked.name || record.step != step) {
    throw InputError(fmt::format("is no record of {}, step {}, which comes next", checked.name, step));
  }
  const bool properties =
      std::equal(record.entries.begin(), record.entries.end(), run.properties.begin(), run.properties.end(),
                 [](const auto& a, const auto* b) { return a.property == b; });
  const bool claims = std::equal(record.claims.begin(), record.claims.end(), run.claims.begin(), run.claims.end(),
                                 [](const auto& a, const auto* b) { return a.claim == b; });
  require(properties && claims, "has not the verdicts that were asked for");
  const bool same = record.mesh_case.empty() ||
                    record.mesh_case == write_case(case_prefix(checked.content, static_cast<std::size_t>(step)));
  require(same, "its mesh is not that of the case");
}

/// Lines of a file with their numbers; the last one must have its line end.
class Lines {
 public:
  explicit Lines(std::string path) : path_(std::move(path)), text_(content_of_file(path_)) {}

  bool done() const { return begin_ == text_.size(); }
  std::string_view next() {
    ++number_;
    const std::size_t end = text_.find('\n', begin_);
    if (end == std::string::npos) throw InputError("the record is cut off");
    const std::string_view line = std::string_view(text_).substr(begin_, end - begin_);
    begin_ = end + 1;
    return line;
  }
  std::string place() const { return fmt::format("{}:{}: ", path_, number_); }

 private:
  std::string path_;
  std::string text_;
  std::size_t begin_ = 0;
  std::size_t number_ = 0;
};

void read_records(Lines& lines, CheckRun& run) {
  for (std::size_t i = 0; i < run.cases.size(); ++i) {
    for (const std::int64_t step : checked_steps(run.cases[i].content, run.final_only)) {
      if (lines.done()) return;
      CheckRecord record = check_record_from_json(lines.next());
      require_next(run, run.cases[i], step, record);
      run.meshes.push_back({i, std::move(record)});
    }
  }
  if (!lines.done()) {
    lines.next();
    throw InputError("there are more records than meshes");
  }
}

}  // namespace

CheckDirectory::CheckDirectory(const std::string& folder, const CheckRun& run, const std::vector<Input>& inputs)
    : path_(folder + "/" + kRecords) {
  make_empty_folder(folder);
  for (std::size_t i = 0; i < inputs.size(); ++i) {
    OutputFile(folder + "/" + file_of(i, inputs[i].name)).finish(write_case(inputs[i].content));
  }
  OutputFile(folder + "/" + kRun).finish(run_json(run, inputs));
  records_.open(path_, std::ios::binary);
  if (!records_) throw InputError(path_ + ": cannot be written");
}

void CheckDirectory::add(const std::string& line) {
  records_ << line << std::flush;
  if (!records_) throw ResourceError(path_ + ": could not be written to its end");
}

bool has_check(const std::string& folder) { return fs::exists(folder + "/" + kRun); }

CheckRun read_check_directory(const std::string& folder) {
  CheckRun run = read_run(folder);
  Lines lines(folder + "/" + kRecords);
  try {
    read_records(lines, run);
  } catch (const InputError& error) {
    throw InputError(lines.place() + error.what());
  }
  return run;
}

}  // namespace asts::cli
