#include "tests/reference/skeleton_kinds.hpp"

namespace asts::reference {

namespace {

constexpr const char* entry_missing = "the global index set along the axis through the point lacks the entry";
constexpr const char* in_no_region =
    "the node or edge hangs on the element along the axis and has a point in no perturbed region";
constexpr const char* not_in_own_region =
    "the node or edge hangs on the element along the axis and has a point of the active region outside the perturbed "
    "region of that axis";
constexpr const char* only_extensions =
    "a horizontal and a vertical T-junction extension meet, but no two perturbed regions do";
constexpr const char* only_regions =
    "two perturbed regions meet in the point, but no horizontal T-junction extension meets a vertical one";
constexpr const char* not_drawn =
    "the definitions do not give what is drawn: the mesh is not admissible, or only the figure or only the mesh has "
    "the "
    "place (y,z) of the drawn squares in the set";

constexpr ClaimKind kinds[] = {
    {"frame-in-index-sets", "entry-missing", entry_missing, check_frame_entry},
    {"frame-in-index-sets-repaired", "entry-missing", entry_missing, check_frame_entry_repaired},
    {"index-vectors-exist", "no-unique-index-vector",
     "not exactly one choice of p+2 consecutive entries along the axis has the active node in the middle",
     check_index_vector},
    {"uniform-unperturbed", "perturbed", "the point is in the perturbed region of the axis, though the mesh is uniform",
     check_perturbed_uniform_mesh},
    {"perturbed-cover-hanging", "hanging-node-not-covered", in_no_region, check_hanging_node},
    {"perturbed-cover-hanging", "hanging-edge-not-covered", in_no_region, check_hanging_edge},
    {"perturbed-cover-hanging-repaired", "hanging-node-not-covered", not_in_own_region, check_hanging_node_repaired},
    {"perturbed-cover-hanging-repaired", "hanging-edge-not-covered", not_in_own_region, check_hanging_edge_repaired},
    {"planar-equals-classical", "only-extensions-meet", only_extensions, check_only_extensions_meet},
    {"planar-equals-classical", "only-regions-meet", only_regions, check_only_regions_meet},
    {"planar-equals-classical-repaired", "only-extensions-meet", only_extensions, check_only_extensions_meet_repaired},
    {"planar-equals-classical-repaired", "only-regions-meet", only_regions, check_only_regions_meet_repaired},
    {"figure-slices", "drawn-otherwise",
     "the point belongs to the part as it is drawn or as the definitions have it, but not to both", check_slice_figure},
    {"figure-slices", "caption-disagrees", "the mesh is not what the caption calls it", check_caption},
    {"figure-proof-levels", "drawn-otherwise", not_drawn, check_proof_figure},
    {"figure-proof-levels", "no-degree-fits",
     "no odd degrees p2, p3 fit; for each item those among the tried ones for which it is as drawn", check_no_degree},
    {"figure-proof-levels-repaired", "drawn-otherwise", not_drawn, check_proof_figure_repaired},
};

}  // namespace

std::span<const ClaimKind> skeleton_kinds() { return kinds; }

}  // namespace asts::reference
