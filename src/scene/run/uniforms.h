#pragma once
// Private to this room: the uniform variables and objects of draws and dispatches (language, 12.1).

#include <glm/mat4x4.hpp>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "scene/run/state.h"

namespace glibra::scene {

/// The uniform variables and objects that tags with expressions, Set and Material give to a draw or dispatch
/// of the program that is made now. `own` are the tags of its own statement, which come before all others.
UniformSetIndex uniformsOf(Interpreter&, ProgramIndex program, std::span<const KeyedValues> own = {});
/// The values of all variables, for uniform variables of the same name.
std::vector<glib::UniformSpec> namedValues(Interpreter&);
/// The same for those that the open Once or Step block sets.
std::vector<glib::UniformSpec> namedValuesOfBlock(Interpreter&);

/// The tag with the values of its subscripts, as `lights[2].color` for `lights[i + 1].color`. Nothing with
/// the reason reported.
std::optional<std::string> keyOfTag(Interpreter&, const KeyedValues& tag);

/// The numbers of matrix * (x, y, z, w). `w` is that of three numbers; four have their own.
std::vector<double> transformed(const glm::dmat4& matrix, const std::vector<double>& numbers, double w);

}  // namespace glibra::scene
