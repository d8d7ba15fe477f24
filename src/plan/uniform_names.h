#pragma once
// Finds the active uniforms that a tag names, and the names that the runtime supplies (language, 5.3 and 6).

#include <functional>
#include <map>
#include <optional>
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

/// Finds uniforms by tag. It keeps copies of the names, so it may outlive the interface.
class UniformNames {
  public:
    explicit UniformNames(const ProgramInterface& interface);

    /// The uniform of exactly that name; otherwise the members of uniform blocks named `member`,
    /// `Block.member` or `instance.member`, as `lights[2].color`; otherwise, if the tag ends in a valid
    /// subscript, the array. Normally one or none.
    [[nodiscard]] std::vector<NamedUniform> find(std::string_view tag) const;

    /// True if there is a uniform of exactly that name.
    [[nodiscard]] bool hasUniform(std::string_view name) const { return exact_.contains(name); }

  private:
    [[nodiscard]] const std::vector<UniformIndex>* indices(std::string_view name) const;

    std::map<std::string, std::vector<UniformIndex>, std::less<>> exact_;
    std::map<std::string, std::vector<UniformIndex>, std::less<>> members_;
    scene::List<int, ActiveUniform> arraySizes_;  ///< 0: no array
};

/// True for gl_TextureMatrix and its variants, which are arrays.
bool isTextureMatrix(glsl::Builtin value);

/// The table row that supplies this uniform; null unless name and GLSL type are those of a built-in.
const glsl::BuiltinUniform* suppliedBy(const ActiveUniform& uniform);

/// The mesh attribute that a vertex input of that name reads; empty for an input that is constant. Nothing
/// for a name that the user chose. Well-known names count in modern scenes.
std::optional<std::string_view> attributeOfInput(const ActiveInput& input, bool isModern);

/// True for the names of uniforms and vertex inputs that the runtime supplies (language, 6), with or without
/// gl_.
bool isSuppliedName(std::string_view name);

/// True for names that exist only in translated sources. Messages never show them.
bool isInternalName(std::string_view name);

/// True for the name of a block, of its instance, of its last member, or of an atomic counter.
bool namesMemory(const glsl::MemoryFacts& memory, std::string_view name);

/// The nearest of these names; empty if none is near.
std::string nearestUniform(std::string_view tag, std::span<const std::string> names);

/// Returns "; did you mean 'uShrink'?" for such a name; empty for an empty one.
std::string hintOf(std::string_view name);

/// Returns hintOf() the nearest of these names, or nothing if none is near.
std::string suggestionFor(std::string_view tag, std::span<const std::string> names);

/// The name under which a source declares the uniform: `light` for `light[2].color`.
std::string_view rootName(std::string_view name);

}  // namespace glibra::plan
