#pragma once

#include "properties/claims/admissible_steps.hpp"

namespace asts {

/// Theorem 5.3's conclusion for any mesh: the perturbed regions do not meet (Definition 5.2).
/// Met: the pairs of axes whose regions are both not empty.
Trial regions_apart(MeshUnderTest& mesh);

/// The statements of the proof of Theorem 5.3, each for one gathered step, whether or not its subdivision is
/// admissible. x, y, z are role(0), role(1), role(2) of the step.

/// R^_y = R_y, R^_z = R_z, and R^_x(q) = R_x(q) for all q that are no xi, compared as sets of points.
/// Met: 1 if there are new active nodes and a perturbed region that is not empty.
Judgement judge_kept_regions(const SubdivisionStep& step);

/// For each xi, Sigma meets neither R^_y nor R^_z. Met: the xi with Sigma and one of the two regions not empty.
Judgement judge_sigma_unperturbed(const SubdivisionStep& step);

/// For each xi, N^_x(xi) = N_x(xi) u (N^_A \ N_A) and N^_A \ N^_x(xi) = N_A \ N^_x(xi) = N_A \ N_x(xi). The second line
/// says the same of the complements, since N_A and the new nodes partition N^_A: one comparison node by node.
/// Met: the xi with N^_x(xi) other than N_x(xi).
Judgement judge_new_node_split(const SubdivisionStep& step);

/// The repaired form, with P = {v in N_A : (v_2, v_3) in [y, y+y~] x [z, z+z~]}:
///   N^_x(xi) = N_x(xi) u (N^_A \ N_A) u P and N^_A \ N^_x(xi) = N_A \ (N_x(xi) u P),
/// and what the proof needs of it: the supports of P \ N_x(xi) add nothing to Sigma, and R^_x(xi) lies in
/// R_x(xi) u Sigma. Met as above.
///
/// The split: the x-orthogonal skeleton grows by the faces {xi} x [y, y+y~] x [z, z+z~], so that v in N^_A has
/// (xi, v_2, v_3) in it exactly if it was in the old one or (v_2, v_3) is in the closed rectangle. All new nodes are
/// vertices of these faces; the old nodes are those of N_x(xi), those of P and the others.
///
/// Sigma: let v in P \ N_x(xi) have a support that reaches the slice, and let an inner element K'' of the refinement
/// tree with level(K) + 1 touch the line through v along y within (p_2+1)/2 sizes of K. Every element that meets U(K'')
/// has level(K) + 1 or more, so K does not meet U(K''). It is separated from it neither along z, where both touch v_3,
/// nor along y, where U(K'') reaches p_2+1 sizes of K; so it is along x, and X(v_2, v_3) has p_1+1 entries between v
/// and K: too many for v to reach xi. Hence no element finer than level(K) + 1 touches that line, and none in U(K) is
/// coarser than K: along y, and likewise along z, v has the index vector of (xi, v_2, v_3), and (v_2, v_3) is a corner
/// of the rectangle. (xi, v_2, v_3) is an active node, and a new one, since v is not in N_x(xi).
///
/// The inclusion: a node outside P keeps its index vectors, the other nodes' supports do not grow; so the supports of
/// N_x(xi) and of the nodes outside N^_x(xi), which are outside N_x(xi), have nothing in common on the slice but
/// R_x(xi), and those of the other nodes of N^_x(xi) lie in Sigma.
Judgement judge_new_node_split_repaired(const SubdivisionStep& step);

/// For each xi, Sigma lies in {xi} x [nu +- eps (p_2 + 2)] x [tau +- eps (p_3 + 2)], and every w in N^_A whose support
/// meets Sigma has (w_1, w_2) in [xi +- eps (p_1 + 1)] x [nu +- eps (2 p_2 + 3)]; eps is half of K's size, along each
/// axis its own (all three are m^(-level/3)/2 if level = 0 mod 3, as printed).
/// Met: the pairs of a xi and a node w whose support meets Sigma.
Judgement judge_sigma_extent(const SubdivisionStep& step);

}  // namespace asts
