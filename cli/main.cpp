#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <cstdio>
#include <new>

#include "cli/commands.hpp"
#include "cli/terminal.hpp"
#include "lib/exact/errors.hpp"

namespace asts::cli {

namespace {

/// One line, whatever bytes a file's name has.
std::string without_control_characters(const std::string& text) {
  std::string result;
  for (const char c : text) {
    const auto byte = static_cast<unsigned char>(c);
    result += byte < 0x20 || byte == 0x7F ? fmt::format("\\x{:02X}", byte) : std::string(1, c);
  }
  return result;
}

int complain(int code, const std::string& reason) {
  show_progress({});
  std::fprintf(stderr, "asts: %s\n", without_control_characters(reason).c_str());
  return code;
}

void add_format(CLI::App& command, Format& format) {
  const auto set = [&format](const std::string& name) { format = name == "json" ? Format::json : Format::text; };
  command
      .add_option_function<std::string>("--format", set,
                                        "text for a person (default), json for a program: one object a line")
      ->check(CLI::IsMember({"text", "json"}))
      ->option_text("text|json");
}

void add_setting(CLI::App& command, SettingOptions& setting) {
  command.add_option("--degree", setting.degree, "p, such as 3,3,3")->delimiter(',')->allow_extra_args(false);
  command.add_option("--grading", setting.grading, "m");
  command.add_option("--domain", setting.domain, "unit cubes along each axis, such as 16,16,16")
      ->delimiter(',')
      ->allow_extra_args(false);
}

/// CLI11's own words for a wrong first argument are "a subcommand is required".
std::string reason_of(const CLI::App& app, const CLI::ParseError& error, int argc, char** argv) {
  if (argc < 2) return "no command is given: asts --help lists them";
  const std::string first = argv[1];
  const bool option = !first.empty() && first[0] == '-';
  const auto commands = app.get_subcommands([&](const CLI::App* command) { return command->get_name() == first; });
  if (option || !commands.empty()) return error.what();
  return "unknown command '" + first + "': asts --help lists them";
}

/// All options of all commands; each command remembers what to run.
class CommandLine {
 public:
  CommandLine() {
    app_.require_subcommand(1);
    app_.set_version_flag("--version", "asts " ASTS_VERSION);
    app_.set_help_flag("--help,-h", "show this text");
    add_campaign();
    add_check();
    add_claims();
    add_draw();
    add_enumerate();
    add_export();
    add_ledger();
    add_refine();
    add_generate();
    add_minimize();
    add_replay();
    add_report();
    add_validate();
  }

  int run(int argc, char** argv) {
    try {
      app_.parse(argc, argv);
    } catch (const CLI::ParseError& error) {
      if (error.get_exit_code() == 0) return app_.exit(error);
      return complain(kBadInput, reason_of(app_, error, argc, argv));
    }
    return chosen_();
  }

 private:
  void add_campaign() {
    CLI::App* command = app_.add_subcommand("campaign", "try claims on random cases, for long, and keep what is found");
    command->add_option("--claim", campaign_.claims, "this claim is expected to hold (asts claims); may be given again")
        ->allow_extra_args(false);
    auto* cases =
        command->add_option("--cases", campaign_.cases, "how many random cases")->check(CLI::Range(1L, 1L << 50));
    command->add_option("--time", campaign_.seconds, "instead: as many as fit into so many seconds")
        ->check(CLI::Range(1, 1'000'000'000))
        ->excludes(cases);
    command->add_option("--seed", campaign_.seed, "one seed, one result");
    command->add_option("--jobs", campaign_.jobs, "processes at the same time; the result does not depend on it")
        ->check(CLI::Range(1, 1024));
    command->add_option("--out", campaign_.folder, "the folder that records the campaign");
    command->add_flag("--resume", campaign_.resume, "go on where the folder's records end");
    command->add_option("--timeout", campaign_.timeout, "seconds that a claim may take on one mesh")
        ->check(CLI::Range(1, 1'000'000));
    command->add_option("--memory", campaign_.memory, "MB that a process may take")->check(CLI::Range(64, 1 << 24));
    command->add_option("--replay", campaign_.replayed, "decide the cases of this collection first (asts replay)");
    add_format(*command, campaign_.format);
    command->callback([this] { chosen_ = [this] { return campaign(campaign_); }; });
  }

  void add_check() {
    CLI::App* command = app_.add_subcommand("check", "decide properties of every mesh of a case");
    command->add_option("CASE", check_.cases, "case files, or - for standard input")->required();
    command->add_option("--property", check_.properties, "only this property; may be given again")
        ->allow_extra_args(false);
    command->add_option("--claim", check_.claims, "this claim of the paper (asts claims); may be given again")
        ->allow_extra_args(false);
    command->add_flag("--final", check_.final_only, "only the last mesh of each case");
    command
        ->add_option("--budget", check_.pair_budget, "pairs of supports to look at for a property; beyond: undecided")
        ->check(CLI::PositiveNumber);
    command->add_option("--jobs", check_.jobs, "threads at the same time; the result does not depend on it")
        ->check(CLI::Range(1, 256));
    command->add_option("--out", check_.folder, "record it in this folder, new or empty, for asts report");
    add_format(*command, check_.format);
    command->callback([this] { chosen_ = [this] { return check(check_); }; });
  }

  void add_claims() {
    CLI::App* command = app_.add_subcommand("claims", "list the paper's claims and whether they are refuted");
    add_format(*command, claims_.format);
    command->callback([this] { chosen_ = [this] { return claims(claims_); }; });
  }

  void add_draw() {
    CLI::App* command = app_.add_subcommand("draw", "draw the slices that matter of a case's last mesh as SVG");
    command->add_option("CASE", draw_.case_file, "a case file, or - for standard input")->required();
    command->add_option("--claim", draw_.claim, "decide this claim and draw where it is violated");
    command->add_option("--property", draw_.property, "the same for a property (asts check)");
    command->add_option("--out,-o", draw_.folder, "the folder for the pictures, made if it is not there")->required();
    add_format(*command, draw_.format);
    command->callback([this] { chosen_ = [this] { return draw(draw_); }; });
  }

  void add_enumerate() {
    CLI::App* command = app_.add_subcommand("enumerate", "decide claims for all meshes that few subdivisions make");
    add_setting(*command, enumerate_.setting);
    command->add_option("--max-subdivisions", enumerate_.max_subdivisions, "subdivisions of single elements, at most")
        ->required();
    command->add_option("--claim", enumerate_.claims, "only this claim (asts claims); may be given again")
        ->allow_extra_args(false);
    command->add_option("--property", enumerate_.properties, "this property (asts check); may be given again")
        ->allow_extra_args(false);
    command->add_flag("--admissible", enumerate_.admissible, "only meshes that admissible subdivisions make");
    command->add_flag("--no-symmetry", enumerate_.no_symmetry,
                      "try every mesh, not one for all its reflections: the same result, slower");
    add_format(*command, enumerate_.format);
    command->callback([this] { chosen_ = [this] { return enumerate(enumerate_); }; });
  }

  void add_export() {
    CLI::App* command = app_.add_subcommand("export", "write a case's last mesh as a grid for ParaView (.vtu)");
    command->add_option("CASE", export_.case_file, "a case file, or - for standard input")->required();
    command->add_option("--out,-o", export_.out, "the file to write")->required();
    command
        ->add_option("--node", export_.node, "add the support and the values of this active node's blending function")
        ->option_text("X,Y,Z");
    command->add_option("--claim", export_.claim, "decide this claim and mark what violates it");
    command->add_option("--property", export_.property, "the same for a property (asts check)");
    command->add_flag("--perturbed-regions", export_.perturbed_regions,
                      "mark the elements that meet them; --property analysis-suitable does it too");
    add_format(*command, export_.format);
    command->callback([this] { chosen_ = [this] { return export_mesh(export_); }; });
  }

  void add_ledger() {
    CLI::App* command = app_.add_subcommand("ledger", "try all claims on random cases, and those that need none");
    command->add_option("--claim", ledger_.claims, "only this claim (asts claims); may be given again")
        ->allow_extra_args(false);
    command->add_flag("--long", ledger_.long_run, "many more cases, and everything else as far as is reasonable");
    command->add_option("--seed", ledger_.seed, "one seed, one result");
    command->add_option("--cases", ledger_.cases, "random cases for each claim, instead of the usual number")
        ->check(CLI::NonNegativeNumber);
    command->add_option("--jobs", ledger_.jobs, "processes at the same time; the result does not depend on it")
        ->check(CLI::Range(1, 256));
    command->add_flag("--times", ledger_.times, "say on stderr how long each claim took");
    command->add_option("--render", ledger_.rendered, "run nothing: print the JSON lines of these files as Markdown");
    add_format(*command, ledger_.format);
    command->callback([this] { chosen_ = [this] { return ledger(ledger_); }; });
  }

  void add_refine() {
    CLI::App* command = app_.add_subcommand("refine", "replay a case and count elements step by step");
    command->add_option("CASE", refine_.case_file, "a case file, or - for standard input")->required();
    command->add_option("--write", refine_.write_file, "write the last mesh as `element` lines to this file");
    command->add_option("--jobs", refine_.jobs, "threads; the result does not depend on it")->check(CLI::Range(1, 256));
    add_format(*command, refine_.format);
    command->callback([this] { chosen_ = [this] { return refine(refine_); }; });
  }

  void add_generate() {
    CLI::App* command = app_.add_subcommand("generate", "print a case of a workload: corner, sphere or random");
    command->add_option("WORKLOAD", generate_.workload, "corner, sphere or random")
        ->required()
        ->check(CLI::IsMember({"corner", "sphere", "random"}));
    add_setting(*command, generate_.setting);
    command->add_option("--elements", generate_.elements, "stop at the first mesh with so many elements");
    command->callback([this] { chosen_ = [this] { return generate(generate_); }; });
  }

  void add_minimize() {
    CLI::App* command = app_.add_subcommand("minimize", "make a case that violates a claim as small as possible");
    command->add_option("CASE", minimize_.case_file, "a case file, or - for standard input")->required();
    command->add_option("--claim", minimize_.claim, "the claim that it violates (asts claims)");
    command->add_option("--property", minimize_.property, "or the property (asts check)");
    command->add_option("--out", minimize_.out, "write the smallest case to this file, not to standard output");
    command->add_option("--collect", minimize_.collect,
                        "add the smallest case, and one of each other kind met on the way, to this collection");
    command->add_option("--draw", minimize_.draw, "draw the slices of the smallest mesh that matter into this folder");
    command->add_option("--snippet", minimize_.snippet, "write the smallest case as a C++ program to this file");
    command->add_option("--budget", minimize_.budget, "evaluations of the claim at most; then the smallest so far")
        ->check(CLI::PositiveNumber);
    command->add_flag("--prove", minimize_.prove, "enumerate smaller meshes: is there none that violates?");
    command->add_option("--prove-meshes", minimize_.prove_meshes, "choose a scope of so many meshes at most")
        ->check(CLI::PositiveNumber);
    add_format(*command, minimize_.format);
    command->callback([this] { chosen_ = [this] { return minimize(minimize_); }; });
  }

  void add_replay() {
    CLI::App* command = app_.add_subcommand("replay", "decide every case of a collection again");
    command->add_option("DIR", replay_.folder, "a folder of cases named after what they violate")->required();
    add_format(*command, replay_.format);
    command->callback([this] { chosen_ = [this] { return replay(replay_); }; });
  }

  void add_report() {
    CLI::App* command = app_.add_subcommand("report", "write a run directory as one HTML page");
    command->add_option("DIR", report_.folder, "what asts campaign --out or asts check --out wrote")->required();
    command->add_option("--out,-o", report_.out, "the page")->required();
    command->callback([this] { chosen_ = [this] { return report(report_); }; });
  }

  void add_validate() {
    CLI::App* command = app_.add_subcommand("validate", "decide witnesses again, by separate code");
    command->add_option("FILE", validate_.files, "what `asts check --format json` wrote")->required();
    add_format(*command, validate_.format);
    command->callback([this] { chosen_ = [this] { return validate(validate_); }; });
  }

  CLI::App app_{"Decides statements about three-dimensional analysis-suitable T-splines, exactly.", "asts"};
  CampaignOptions campaign_;
  CheckOptions check_;
  ClaimsOptions claims_;
  DrawOptions draw_;
  EnumerateOptions enumerate_;
  ExportOptions export_;
  LedgerOptions ledger_;
  RefineOptions refine_;
  GenerateOptions generate_;
  MinimizeOptions minimize_;
  ReplayOptions replay_;
  ReportOptions report_;
  ValidateOptions validate_;
  std::function<int()> chosen_;
};

}  // namespace

int run(int argc, char** argv) {
  try {
    watch_interrupts();
    return CommandLine().run(argc, argv);
  } catch (const Interrupted&) {
    show_progress({});
    return kInterrupted;
  } catch (const InputError& error) {
    return complain(kBadInput, error.what());
  } catch (const ResourceError& error) {
    return complain(kFailure, error.what());
  } catch (const std::bad_alloc&) {
    return complain(kFailure, "out of memory");
  } catch (const std::exception& error) {
    return complain(kFailure, std::string("internal error: ") + error.what());
  }
}

}  // namespace asts::cli

int main(int argc, char** argv) { return asts::cli::run(argc, argv); }
