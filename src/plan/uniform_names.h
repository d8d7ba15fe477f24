#pragma once
// Which active uniforms a tag names, and which names the runtime supplies by itself (language, 5.3 and 6).

#include <functional>
#include <map>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "glsl/types/builtins.h"
#include "plan/program_interface.h"

namespace glibra::plan {

/// A uniform that a tag names.
struct NamedUniform {
    UniformIndex uniform{};
    int element = 0;          ///< 0 without a subscript
    bool oneElement = false;  ///< the tag had a subscript: `name[2]`
};

/// Finds uniforms by tag. Refers to nothing: names are copied.
class UniformNames {
  public:
    explicit UniformNames(const ProgramInterface& interface);

    /// The uniform of exactly that name; else the members of uniform blocks that have it as `member` or
    /// `Block.member`; else, with a subscript inside the array, the array. Normally one or none.
    [[nodiscard]] std::vector<NamedUniform> find(std::string_view tag) const;

  private:
    [[nodiscard]] const std::vector<UniformIndex>* indices(std::string_view name) const;

    std::map<std::string, std::vector<UniformIndex>, std::less<>> exact_;
    std::map<std::string, std::vector<UniformIndex>, std::less<>> members_;
    scene::List<int, ActiveUniform> arraySizes_;  ///< 0: no array
};

/// The table row that fills this uniform: its name and its GLSL type are those of a built-in; else null.
const glsl::BuiltinUniform* suppliedBy(const ActiveUniform& uniform);

/// True for every name of section 6 that the runtime supplies: uniforms and vertex inputs, also in gl_
/// spelling.
bool isSuppliedName(std::string_view name);

/// True for names that only translated sources have; messages never show them.
bool isInternalName(std::string_view name);

/// "; did you mean 'uShrink'?" with the nearest of these names of uniforms, or nothing.
std::string suggestionFor(std::string_view tag, std::span<const std::string> names);

/// `light` of `light[2].color`: the name under which a source declares it.
std::string_view rootName(std::string_view name);

}  // namespace glibra::plan
