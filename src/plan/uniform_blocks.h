#pragma once
// The bytes of uniform blocks, laid out as the linked program reports (GL 4.6, 7.6.2.2).

#include <cstddef>
#include <span>
#include <vector>

#include "plan/uniforms.h"

namespace glibra::plan {

/// Writes components (column by column, element by element, from element `firstElement` on) of a block member
/// into the bytes of its block. Numbers are rounded to the member's type once; what lies beyond the member or
/// the block is left.
void writeMember(const ActiveUniform& member, int firstElement, std::span<const double> values,
                 std::span<std::byte> block);

/// A whole block: zeros, and over them the literals among `bindings` that belong to it. Supplied values stay
/// 0.
std::vector<std::byte> blockContent(const ProgramInterface& interface, int block,
                                    std::span<const UniformBinding> bindings);

}  // namespace glibra::plan
