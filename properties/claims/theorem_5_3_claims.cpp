#include <array>

#include "properties/claims/claim.hpp"
#include "properties/claims/second_patch.hpp"
#include "properties/claims/theorem_5_3_proof.hpp"

namespace asts {

namespace {

/// Theorem 5.3 for one mesh.
Trial admissible_implies_as(MeshUnderTest& mesh) {
  if (!mesh.admissible()) return {Verdict::not_applicable("the mesh is not admissible")};
  return regions_apart(mesh);
}

Trial new_nodes_keep_regions(MeshUnderTest& mesh) { return judge_steps(mesh, judge_kept_regions); }
Trial sigma_unperturbed(MeshUnderTest& mesh) { return judge_steps(mesh, judge_sigma_unperturbed); }
Trial new_node_split(MeshUnderTest& mesh) { return judge_steps(mesh, judge_new_node_split); }
Trial new_node_split_repaired(MeshUnderTest& mesh) { return judge_steps(mesh, judge_new_node_split_repaired); }
Trial sigma_extent(MeshUnderTest& mesh) { return judge_steps(mesh, judge_sigma_extent); }

constexpr std::array kClaims{
    Claim{.id = "admissible-implies-as",
          .source = "Theorem 5.3",
          .statement = "A within AS for all m >= 2: the perturbed regions R_x, R_y, R_z of an admissible mesh do not "
                       "meet; odd degrees p >= 3, the same or different along the axes",
          .kind = ClaimKind::theorem,
          .meshes = "a",
          .met_means = "pairs of axes whose perturbed regions are both not empty",
          .on_mesh = admissible_implies_as,
          .max_elements = 1000,
          .reflects = true},
    Claim{.id = "new-nodes-keep-regions",
          .source = "proof of Theorem 5.3, before the display of N^_x(xi)",
          .statement = "for G in A and AS, level(K) = 0 mod 3 and an admissible G^ = subdiv(G, K): R^_y = R_y, "
                       "R^_z = R_z, and R^_x(q) = R_x(q) for all q that are no xi; for level(K) = 1, 2 mod 3 with the "
                       "axes renamed cyclically",
          .kind = ClaimKind::theorem,
          .meshes = "a",
          .met_means = "subdivisions that make active nodes in a mesh with a perturbed region that is not empty",
          .on_mesh = new_nodes_keep_regions,
          .max_elements = 900,
          .stride = 4,
          .reflects = true},
    Claim{.id = "sigma-unperturbed",
          .source = "proof of Theorem 5.3, after the display of R^_x(xi)",
          .statement = "for G in A and AS, an admissible G^ = subdiv(G, K) and each xi: Sigma = S_x(xi) cut with the "
                       "supports of the new active "
                       "nodes meets neither R^_y nor R^_z",
          .kind = ClaimKind::theorem,
          .meshes = "a",
          .met_means = "pairs (K, xi) with Sigma not empty and R^_y or R^_z not empty",
          .on_mesh = sigma_unperturbed,
          .max_elements = 900,
          .stride = 4,
          .reflects = true},
    Claim{.id = "new-node-split",
          .source = "proof of Theorem 5.3, the display of N^_x(xi)",
          .statement = "for G in A and AS, an admissible G^ = subdiv(G, K) and each xi: N^_x(xi) = N_x(xi) u (N^_A \\ "
                       "N_A) and N^_A \\ N^_x(xi) = "
                       "N_A \\ N^_x(xi) = N_A \\ N_x(xi)",
          .kind = ClaimKind::equation,
          .meshes = "a",
          .met_means = "pairs (K, xi) with N^_x(xi) other than N_x(xi)",
          .refuted = true,
          .on_mesh = new_node_split,
          .max_elements = 900,
          .stride = 4,
          .reflects = true},
    Claim{.id = "new-node-split-repaired",
          .source = "proof of Theorem 5.3, the display of N^_x(xi)",
          .statement = "for G in A and AS, an admissible G^ = subdiv(G, K) and each xi and P = {v in N_A : (v_2, v_3) "
                       "in [y, y+y~] x [z, z+z~]}: "
                       "N^_x(xi) = N_x(xi) u (N^_A \\ N_A) u P and N^_A \\ N^_x(xi) = N_A \\ (N_x(xi) u P); the "
                       "supports of P \\ N_x(xi) add nothing to Sigma, and R^_x(xi) lies in R_x(xi) u Sigma",
          .kind = ClaimKind::equation,
          .meshes = "a",
          .met_means = "pairs (K, xi) with N^_x(xi) other than N_x(xi)",
          .on_mesh = new_node_split_repaired,
          .max_elements = 900,
          .stride = 4,
          .reflects = true},
    Claim{.id = "second-patch-sizes",
          .source = "proof of Theorem 5.3, after the box around Sigma",
          .statement = "for G in A and AS and an admissible G^ = subdiv(G, K): elements of the second-order patch, the "
                       "patches of all elements in the "
                       "patch of K, are of the same or smaller size than K along x and y",
          .kind = ClaimKind::theorem,
          .meshes = "a",
          .met_means = "pairs of K and an element of its second-order patch that is larger than K along z",
          .on_mesh = judge_second_patches,
          .max_elements = 900,
          .reflects = true},
    Claim{.id = "sigma-extent",
          .source = "proof of Theorem 5.3, the boxes for Sigma and (w_1, w_2)",
          .statement = "for G in A and AS and an admissible G^ = subdiv(G, K), with mid(K) = (sigma, nu, tau) and eps "
                       "= m^(-level(K)/3)/2, for each xi: "
                       "Sigma within {xi} x [nu +- eps (p_2 + 2)] x [tau +- eps (p_3 + 2)], and (w_1, w_2) in "
                       "[xi +- eps (p_1 + 1)] x [nu +- eps (2 p_2 + 3)] for every w in N^_A whose support meets Sigma; "
                       "for level(K) = 1, 2 mod 3 eps is half of K's size along each axis",
          .kind = ClaimKind::equation,
          .meshes = "a",
          .met_means = "triples (K, xi, w) such that supp B_w meets Sigma",
          .on_mesh = sigma_extent,
          .max_elements = 900,
          .stride = 4,
          .reflects = true},
};

}  // namespace

std::span<const Claim> theorem_5_3_claims() { return kClaims; }

}  // namespace asts
