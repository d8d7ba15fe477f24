#pragma once
// What the text of a program says of an active uniform, and which values fit it.

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "plan/type_table.h"
#include "plan/uniform_names.h"

namespace glibra::plan {

/// The elements that its declaration gives an array, also one in a structure; 0 for other uniforms.
int declaredElements(const ProgramInterface& interface, const ActiveUniform& uniform);
bool hasInitializer(const ProgramInterface& interface, const ActiveUniform& uniform);
/// The functions that a subroutine uniform counts; null for other uniforms.
const std::vector<std::string>* functionsOf(const ProgramInterface& interface, const ActiveUniform& uniform);

/// The values for a mat3 of which a modern scene gives all components of a mat4: its upper left part. Nothing
/// if that is not so.
std::optional<std::array<double, 9>> upperLeft(const GivenValue& given, const ActiveUniform& target,
                                               bool oneElement);
/// True for a whole matrix as the value of a scalar or vector.
bool isMatrixInstead(const GivenValue& given, const ActiveUniform& target, const NamedUniform& named);

/// The value of a well-known name, for messages.
std::string_view describeValue(glsl::Builtin value);

}  // namespace glibra::plan
