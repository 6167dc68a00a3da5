#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "lib/mesh/refinement_tree.hpp"

namespace asts {

/// The element at the origin is marked in each step (Algorithm 2.9): G_n is the mesh after n steps, A_n the closure
/// that step n subdivides. From some step on the meshes repeat themselves near the origin, m times smaller every three
/// steps, so that what all later steps do is known. This is the certificate.
///
/// Let phi(x) = x/m. It maps an element of level k to one of level k + 3. For an integer v below the domain's sides, V
/// is the cube [0,v]^3, a union of elements of every mesh, and G|V the elements of G in V. The certificate (n_0, v):
///   (H) G_(n_0+3)|phi(V) = phi(G_(n_0)|V);
///   (D) for n = n_0 + 1, n_0 + 2, n_0 + 3, every K in A_n has mid(K) + D(level(K)) <= (v,v,v) and level(K) >= 1.
/// Then A_(n+3) = phi(A_n), as levels and as boxes, for every n > n_0.
///
/// Proof. Let H(n) be (H) and D(n+1) be (D) for the step from G_n to G_(n+1), with n >= n_0. Assume both.
/// The element at the origin of G_n lies in V, so phi maps it to that of G_(n+3). By (D) every K in A_(n+1) has
/// U(K) = U in int V: U is cut off by the faces through the origin alone, which phi keeps, so U(phi(K)) = phi(U(K)).
/// An element of G_n that meets U(K) meets int V and hence lies in V; one of G_(n+3) that meets phi(U(K)) meets
/// int phi(V) and, by (H), lies in phi(V). So the patch of phi(K) in G_(n+3) is the image of that of K in G_n, levels
/// grow by 3, and "coarser than K in the patch" is kept: the loop of Algorithm 2.8 in G_(n+3) is the image of that in
/// G_n, so A_(n+4) = phi(A_(n+1)). Subdividing both gives H(n+1), because phi maps children to children (level mod 3 is
/// kept). And D(n+4) holds because mid and D shrink by m towards the origin. With D(n_0+1), D(n_0+2), D(n_0+3) all of
/// H(n), D(n+1) for n >= n_0 follow by induction.
struct SelfSimilarity {
  std::int64_t start = 0;   ///< n_0
  std::int32_t window = 0;  ///< v
  /// |G_n \ G_0| for n = 0, ..., n_0 + 3.
  std::vector<std::int64_t> new_elements;
  /// What step n > n_0 adds to |G_n \ G_0| is growth[(n - n_0 - 1) mod 3]: (m - 1) |A_n|, no level 0 being in A_n.
  PerAxis<std::int64_t> growth{};
};

/// Whether the subtrees of a cube [0,v]^3 of `coarse` and of [0,v/m]^3 of `fine` are the same: (H).
/// REQUIRES: equal settings, 1 <= window <= each side of the domain.
bool is_scaled_copy(const RefinementTree& coarse, const RefinementTree& fine, std::int32_t window);

/// Whether every one of these leaves has level >= 1 and an environment that, not cut off at the domain's upper faces,
/// ends at v or before: (D). REQUIRES: window < each side of the domain, up-to-date ranks.
bool looks_inside(const RefinementTree& tree, const std::vector<std::int32_t>& closure, std::int32_t window);

/// The first certificate: least n_0, then least v. Nothing if there is none with n_0 + 3 <= max_steps.
/// Cost: max_steps refinements and 3 copies of the tree.
std::optional<SelfSimilarity> find_self_similarity(const Setting& setting, std::int64_t max_steps);

/// |G_n \ G_0| for any n, by the certificate where n > n_0 + 3.
Integer new_elements_after(const SelfSimilarity& certificate, std::int64_t steps);

}  // namespace asts
