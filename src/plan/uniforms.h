#pragma once
// Turns tags and values as written into typed values of active uniforms (language, 5.3 and 6).

#include <glibra/diagnostic.h>

#include <array>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "plan/overrides.h"
#include "plan/program_variant.h"
#include "plan/type_table.h"
#include "plan/uniform_names.h"
#include "scene/scene.h"

namespace glibra::plan {

// What the text of a program says of an active uniform, and which values fit it.

/// The elements that its declaration gives an array, also one in a structure; 0 for other uniforms.
int declaredElements(const ProgramInterface& interface, const ActiveUniform& uniform);
bool hasInitializer(const ProgramInterface& interface, const ActiveUniform& uniform);
/// The functions that a subroutine uniform counts; null for other uniforms.
const std::vector<std::string>* functionsOf(const ProgramInterface& interface, const ActiveUniform& uniform);

/// The values for a mat3 of which a scene that supplies names gives all components of a mat4: its upper left
/// part. Nothing if that is not so.
std::optional<std::array<double, 9>> upperLeft(const GivenValue& given, const ActiveUniform& target,
                                               bool oneElement);
/// True for a whole matrix as the value of a scalar or vector.
bool isMatrixInstead(const GivenValue& given, const ActiveUniform& target, const NamedUniform& named);

/// The value of a well-known name, for messages.
std::string_view describeValue(glsl::Builtin value);

struct UniformResolution {
    std::vector<UniformBinding> values;
    std::vector<SamplerBinding> samplers;
    std::vector<Control> controls;
    Diagnostics diagnostics;
    Diagnostics badBindings;  ///< draw-E09, draw-E10: nothing can be drawn with these textures
    std::vector<scene::ObjectView> refusedImages;  ///< the objects of `badBindings` that images would write
    /// Where the value of a uniform comes from that nothing of the program sets, in words, for --explain:
    /// "'mv_matrix' is the model-view matrix".
    std::vector<std::string> foundByName;
    /// The variables that uniforms read by their names and that change with time.
    std::vector<std::string> timed;
};

/// What a draw or dispatch gives to its program besides the values of the Program statement. Null pointers
/// stand for nothing.
struct DrawValues {
    const scene::Scene* scene = nullptr;     ///< it supplies names: of textures, variables, matrices
    const scene::UniformSet* set = nullptr;  ///< its `values` are among those of the program already
    /// NodeList::namedValues of the list that is planned.
    std::span<const glib::UniformSpec> ownValues{};
    /// Says which uniforms need no value, because a buffer of the scene has it; may be empty.
    std::function<bool(const ActiveUniform&)> isInBuffer{};
};

/// Resolves the pairs of one Program statement against its linked interface. An active uniform that is
/// neither supplied, given nor initialised is reported (glib-W37) and stays 0. `overrides` replace the values
/// of the scene; `usedOverrides` is set to true for each override that names a uniform here. Samplers and
/// images read the texture that `drawn` binds to them, then a texture of their own name, then a unit. Other
/// uniforms that are not set read a variable of their own name, then a value of the table of well-known names
/// (glsl/types/builtins.h).
UniformResolution resolveUniforms(const scene::Program& program, const std::string& scenePath,
                                  const ProgramInterface& interface, std::span<const Override> overrides,
                                  std::vector<bool>& usedOverrides, const DrawValues& drawn = {});

}  // namespace glibra::plan
