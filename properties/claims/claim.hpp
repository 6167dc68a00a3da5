#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "lib/mesh/case.hpp"
#include "properties/mesh_under_test.hpp"
#include "properties/verdict.hpp"

namespace asts {

/// What the paper calls the statement.
enum class ClaimKind {
  example,
  algorithm,
  definition,
  remark,
  theorem,
  lemma,
  proposition,
  corollary,
  equation,
  figure,
  experiment,
  conjecture,
};

/// "example", ..., "conjecture".
const char* kind_name(ClaimKind kind);

/// What came out when a claim was tried once.
struct Trial {
  Verdict verdict;
  /// How often its hypothesis was met in a way that is not trivial; what is counted is the claim's `met_means`. A
  /// verdict `holds` with met == 0 says nothing.
  std::int64_t met = 0;
};

/// How far a claim that is no statement about one mesh is followed: within a test, or as far as is reasonable.
enum class Extent { short_run, long_run };

/// A statement of the paper, or a repaired form of one that is false as printed. Tested literally: closed and open
/// sets, index ranges and quantifiers as printed.
///
/// At least one of the three functions is there. Each decides the claim for one subject and throws BudgetExhausted
/// where a budget of the subject runs out.
struct Claim {
  const char* id;         ///< as in the ledger of claims; a repaired form is called ID-repaired
  const char* source;     ///< the paper's number
  const char* statement;  ///< in the paper's notation
  ClaimKind kind;
  /// The classes of meshes that it is stated for: a (admissible refinements), r (any meshes that subdivisions make),
  /// e (explicit boxes). Empty for statements that no mesh occurs in.
  const char* meshes;
  const char* met_means;  ///< what Trial::met counts, in words: "pairs of ... that ..."
  bool refuted = false;   ///< false as printed: reports/findings/ID.md says why, ID.case is a counterexample

  /// For one mesh. A mesh outside the hypothesis gives not-applicable with the reason.
  Trial (*on_mesh)(MeshUnderTest& mesh) = nullptr;
  /// For a whole sequence of steps. REQUIRES: no explicit mesh.
  Trial (*on_sequence)(const Case& sequence) = nullptr;
  /// For everything that no mesh is needed for, within bounds that the claim's file states.
  Trial (*alone)(Extent extent) = nullptr;

  /// Random meshes for this claim have at most so many elements, and it is tried on every `stride`-th of them: set by
  /// what one trial costs.
  std::int64_t max_elements = 250;
  int stride = 1;

  /// Whether `on_mesh` gives a mesh and its reflections along the axes the same outcome and the same `met`, so that one
  /// of them can be tried for all. Not so where random sets are tried, or where counting ends with the first violation.
  bool reflects = false;
  /// Whether `on_mesh` depends on nothing but the active nodes and their index vectors, so that it need not be tried
  /// again after a subdivision that leaves them as they are.
  bool of_splines = false;
};

/// All claims in the order of the ledger, a repaired form behind its original.
const std::vector<Claim>& all_claims();

/// The ids of the statements of the paper that can be tested, in its order: what all_claims() must have.
std::span<const std::string_view> ledger_ids();

/// nullptr if there is none.
const Claim* find_claim(std::string_view id);

/// Decides a claim for a mesh, a sequence, or alone; turns BudgetExhausted into `undecided`, and a claim that is not
/// about such a subject into `not-applicable`.
Trial try_on_mesh(const Claim& claim, MeshUnderTest& mesh);
Trial try_on_sequence(const Claim& claim, const Case& sequence);
Trial try_alone(const Claim& claim, Extent extent);

/// The families, each in files of its own.
std::span<const Claim> refinement_claims();    ///< Sections 2, 3, the outlook
std::span<const Claim> equation_claims();      ///< Appendix A: sizes, distances, radii
std::span<const Claim> complexity_claims();    ///< Section 7
std::span<const Claim> skeleton_claims();      ///< Sections 4, 5: index sets, perturbed regions, figures
std::span<const Claim> theorem_5_3_claims();   ///< Theorem 5.3 and the steps of its proof
std::span<const Claim> suitability_claims();   ///< Section 6: analysis-suitable, dual-compatible, dual basis
std::span<const Claim> functional_claims();    ///< Proposition 6.1
std::span<const Claim> independence_claims();  ///< Corollary 6.8

}  // namespace asts
