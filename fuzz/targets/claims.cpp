#include <fmt/format.h>

#include "fuzz/targets/targets.hpp"
#include "fuzz/validation/literal_case.hpp"
#include "lib/exact/errors.hpp"
#include "lib/gen/case_bytes.hpp"
#include "lib/mesh/case_file.hpp"
#include "properties/case_meshes.hpp"
#include "properties/ledger/trials.hpp"
#include "reports/witness_json.hpp"
#include "tests/reference/claim_witness.hpp"

namespace asts::fuzz {

namespace {

/// Up to so many elements the literal code is asked about a witness.
constexpr std::int64_t kMostLiteral = 100;

/// What a violation says against the program, if anything.
Fault fault_of(const Claim& claim, const TrialSubject& subject, const Verdict& verdict) {
  const nlohmann::json witness = nlohmann::json::parse(witness_json(verdict.witness.value()).dump());
  if (!claim.refuted) return fmt::format("{} is violated: {}", claim.id, witness.dump());
  if (subject.elements > kMostLiteral) return std::nullopt;
  reference::ClaimSubject by_hand = literal::subject(subject.whole);
  const reference::Validation validation = reference::validate_claim_witness(by_hand, claim.id, witness);
  if (validation.valid) return std::nullopt;
  return fmt::format("{}: the witness {} is not valid: {}", claim.id, witness.dump(), validation.report);
}

/// All claims, tried on what a case ends with; the first fault stays.
class ClaimTrials {
 public:
  explicit ClaimTrials(const Case& content)
      : content_(content), subject_(0, content, "bytes"), trials_(claims(), options()) {}

  Fault run() {
    try {
      try_all();
    } catch (const ResourceError&) {
      // nobody's fault
    }
    return std::move(fault_);
  }

 private:
  static std::vector<const Claim*> claims() {
    std::vector<const Claim*> result;
    for (const Claim& claim : all_claims()) result.push_back(&claim);
    return result;
  }

  Trials::Options options() {
    Trials::Options options;
    options.violated = [this](std::size_t place, const TrialSubject* subject, const Verdict& verdict) {
      if (!fault_) fault_ = fault_of(*trials_.claims()[place], *subject, verdict);
    };
    return options;
  }

  void try_all() {
    subject_.step = content_.steps.size();
    with_last_mesh(content_, [this](MeshUnderTest& mesh) {
      subject_.looks_at(mesh, fingerprint_of(mesh.mesh()));
      trials_.on_mesh(subject_, mesh);
    });
    if (Trials::is_sequence(content_)) trials_.on_sequence(subject_);
  }

  const Case& content_;
  TrialSubject subject_;
  Trials trials_;
  Fault fault_;
};

}  // namespace

Fault claims_fault(Bytes bytes) {
  const Case content = case_of_bytes(bytes);
  try {
    const Fault fault = ClaimTrials(content).run();
    if (!fault) return fault;
    return *fault + "\n" + write_case(content);
  } catch (const std::exception& error) {
    return std::string("an exception that is not documented: ") + error.what() + "\n" + write_case(content);
  }
}

}  // namespace asts::fuzz
