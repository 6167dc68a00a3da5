#pragma once

#include <cstddef>
#include <functional>

#include "lib/mesh/case.hpp"
#include "properties/mesh_under_test.hpp"

namespace asts {

/// Calls visit(step, mesh) for the mesh after each step of a case, from step 0 on, the initial mesh; for an explicit
/// mesh once, with step 0. The mesh is gone after the call.
/// Cost: that of the replay and of building every mesh. Throws InputError when the case cannot be replayed, or its
/// boxes do not tile the domain.
void for_each_mesh(const Case& test_case, const std::function<void(std::size_t step, MeshUnderTest& mesh)>& visit);

/// The same for the last mesh alone; no other one is built.
void with_last_mesh(const Case& test_case, const std::function<void(MeshUnderTest& mesh)>& visit);

}  // namespace asts
