#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "lib/refine/replay.hpp"
#include "properties/claims/claim.hpp"
#include "properties/properties.hpp"

namespace asts {

/// What `asts check` says about one mesh.
struct CheckRecord {
  std::string case_name;
  std::int64_t step = 0;
  struct Figures {
    std::int64_t elements = 0;
    std::int64_t new_elements = 0;
    std::optional<std::int32_t> max_level;
    std::int64_t active_nodes = 0;
  };
  std::optional<Figures> mesh;  ///< none for a sequence whose mesh is too large to be made for this
  struct Entry {
    const Property* property;
    Verdict verdict;
  };
  std::vector<Entry> entries;
  struct ClaimEntry {
    const Claim* claim;
    Trial trial;
  };
  std::vector<ClaimEntry> claims;
  std::string mesh_case;  ///< the case up to this mesh; empty when nothing is violated or it is too long to repeat
};

/// The record as one line of JSON, with a line end.
std::string check_json(const CheckRecord& record);

/// The record for a person: one line a mesh, and below it what does not hold.
std::string check_text(const CheckRecord& record);

/// What `asts refine` says about one step.
struct RefineRecord {
  StepCounts counts;
  std::int64_t elements = 0;
  std::int64_t new_elements = 0;
};

std::string refine_json(const RefineRecord& record);
std::string refine_text_header();
std::string refine_text(const RefineRecord& record);

}  // namespace asts
