#pragma once

#include <chrono>
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "lib/mesh/fingerprint.hpp"
#include "properties/ledger/record.hpp"
#include "properties/mesh_under_test.hpp"

namespace asts {

/// A case, up to the mesh that is being tried.
struct TrialSubject {
  /// REQUIRES: the case outlives it.
  TrialSubject(std::int64_t case_number, const Case& whole_case, const char* name_of_bias)
      : number(case_number), whole(whole_case), bias(name_of_bias) {}

  std::int64_t number;
  const Case& whole;
  const char* bias;             ///< what the case was drawn to provoke
  const Claim* only = nullptr;  ///< the claim that the case was made for: no other one is tried
  std::size_t step = 0;         ///< how many of its steps make the mesh
  Fingerprint fingerprint{};
  std::int64_t elements = 0;
  LedgerBounds bounds{};
  std::vector<std::string> features{};
  bool features_known = false;

  /// The case that ends with the mesh.
  Case content() const;
  /// Sets what depends on the mesh.
  void looks_at(const MeshUnderTest& mesh, const Fingerprint& mesh_fingerprint);
};

/// Tries claims on meshes and sequences, each on those it is stated for, and counts what comes out.
///
/// A claim gets the meshes of its class (Claim::meshes: admissible ones for "a", those that subdivisions make for "r",
/// all for "e" or when no class is named) with up to Claim::max_elements elements, and of these one in Claim::stride,
/// chosen by the mesh's fingerprint. Sequences go to on_sequence likewise. A case that was made for one claim
/// (TrialSubject::only) is tried on that claim alone, whatever its size and class: the claim itself says when a mesh is
/// outside its hypothesis.
class Trials {
 public:
  struct Options {
    /// The words for a violation; when missing, records keep no smallest one.
    std::string (*describe)(const Verdict&) = nullptr;
    /// Which claims, by place, are tried; empty: all.
    std::function<bool(std::size_t place)> wanted;
    /// Called before each trial.
    std::function<void(std::size_t place)> begins;
    /// Called for each violation. `subject` is null for a claim that is tried alone.
    std::function<void(std::size_t place, const TrialSubject* subject, const Verdict&)> violated;
  };

  Trials(std::vector<const Claim*> claims, Options options);

  /// REQUIRES: subject.looks_at(mesh, ...) was called.
  void on_mesh(TrialSubject& subject, MeshUnderTest& mesh);
  /// REQUIRES: a case of `refine` steps, looked at with its last mesh.
  void on_sequence(TrialSubject& subject);
  void alone(std::size_t place, Extent extent);

  const std::vector<const Claim*>& claims() const { return claims_; }
  /// In the order of the claims.
  const std::vector<LedgerRecord>& records() const { return records_; }
  /// The time that each claim took, in that order: for setting Claim::stride, not for results.
  const std::vector<std::chrono::nanoseconds>& times() const { return times_; }

  /// Whether a case has `refine` steps and no others.
  static bool is_sequence(const Case& content);

 private:
  bool wants(std::size_t place, const TrialSubject& subject) const;
  Trial timed(std::size_t place, const TrialSubject* subject, const std::function<Trial()>& decide);
  void count(std::size_t place, const Trial& trial, TrialSubject* subject, MeshUnderTest* mesh);
  void count_subject(LedgerRecord& one, TrialSubject& subject, MeshUnderTest* mesh) const;
  void count_violation(std::size_t place, const Verdict& verdict, const TrialSubject* subject, LedgerRecord& one) const;

  std::vector<const Claim*> claims_;
  Options options_;
  std::vector<LedgerRecord> records_;
  std::vector<std::chrono::nanoseconds> times_;
};

}  // namespace asts
