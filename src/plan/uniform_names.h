#pragma once
// Finds the active uniforms that a tag names, and the names that the runtime supplies (language, 5.3 and 6).

#include <glibra/diagnostic.h>

#include <functional>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "glsl/types/builtins.h"
#include "glsl/types/translated_program.h"
#include "plan/program_variant.h"
#include "plan/type_table.h"

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
/// for a name that the user chose. `knowsNames`: well-known names count
/// (scene::Scene::suppliesNames).
std::optional<std::string_view> attributeOfInput(const ActiveInput& input, bool knowsNames);

/// True for the names of uniforms and vertex inputs that the runtime supplies (language, 6), with or without
/// gl_.
bool isSuppliedName(std::string_view name);

/// True for names that exist only in translated sources. Messages never show them.
bool isInternalName(std::string_view name);

/// True for the name of a block, of its instance, of its last member, or of an atomic counter.
bool namesMemory(const glsl::MemoryFacts& memory, std::string_view name);
/// Adds the names of the blocks, their instances and the counters.
void addMemory(const glsl::MemoryFacts& memory, std::vector<std::string>& to);

/// The nearest of these names; empty if none is near.
std::string nearestUniform(std::string_view tag, std::span<const std::string> names);

/// Returns "; did you mean 'uShrink'?" for such a name; empty for an empty one.
std::string hintOf(std::string_view name);

/// Returns hintOf() the nearest of these names, or nothing if none is near.
std::string suggestionFor(std::string_view tag, std::span<const std::string> names);

/// The name under which a source declares the uniform: `light` for `light[2].color`.
std::string_view rootName(std::string_view name);

// Finds the member of a structure or uniform block that a tag with points and subscripts names, as far as the
// text of the shaders declares it (language, 5.3).

/// What the text of the shaders says about a tag.
struct MemberSearch {
    bool isDeclared = false;   ///< the tag names a number, a vector, a matrix or an array of them
    std::string hint{};        ///< if it does not: what would be right, beginning with "; "; may be empty
    std::string suggestion{};  ///< the name that the hint proposes; may be empty
    int elements = 0;          ///< of an array that is declared with so many; else 0
};

/// Follows the parts of a tag as `lights[2].inner.position`. Nothing if it begins with no uniform variable of
/// a structure type, and with neither the name nor the instance of a uniform block.
std::optional<MemberSearch> searchMember(const glsl::MemoryFacts& memory, std::string_view tag);

/// What a uniform variable of a structure type holds, named as OpenGL names active uniforms:
/// "lights[1].position". An array of a basic type is one value.
struct MemberValue {
    std::string name;
    std::string_view type;
    bool isArray = false;
};

/// Calls `visit` for the values of the variable `root` in the order in which they are declared, until it
/// returns false. False, without a call, if `root` is no such variable, or if the text does not show how many
/// elements an array of structures has.
bool visitMembers(const glsl::MemoryFacts& memory, std::string_view root,
                  const std::function<bool(const MemberValue&)>& visit);

// Messages about tags that set no uniform and uniforms that no tag sets.

/// The messages of one program.
class UniformMessages {
  public:
    /// `scene`: the scene if it supplies names, else null. Messages are appended to `to`. The references must
    /// outlive this.
    UniformMessages(const scene::Program& program, const ProgramInterface& interface,
                    const UniformNames& names, const scene::Scene* scene, Diagnostics& to)
        : program_(program), interface_(interface), names_(names), scene_(scene), to_(to) {}

    /// glib-W25: glibra supplies the uniform.
    void supplied(const GivenValue& given);

    /// The tag names no active uniform: supplied but unused (glib-W25), declared but unused (glib-W24), the
    /// misspelt key `resembles` of Dispatch (glib-E16), or unknown (glib-W23).
    void unknown(const GivenValue& given, std::string_view resembles = {});

    /// True for a tag that names an element or member that is declared in an array or structure of which
    /// the program reads some other part. Drivers differ in which of these they call active.
    [[nodiscard]] bool isUnreadPart(std::string_view tag) const;

    /// glib-W37: the uniforms have no value. Many members of a variable or block are reported as one.
    void unset(std::span<const ActiveUniform> uniforms);

  private:
    void warn(const char* id, std::string text, const Place& place, std::string_view subject = {},
              std::string suggestion = {});
    [[nodiscard]] bool isDeclared(std::string_view name) const;
    const std::vector<std::string>& knownNames();
    /// For a uniform that a Set names, but of another scope.
    [[nodiscard]] std::string scopeHint(const std::string& name) const;
    [[nodiscard]] std::string hintOfNames(const ActiveUniform& target) const;

    const scene::Program& program_;
    const ProgramInterface& interface_;
    const UniformNames& names_;
    const scene::Scene* scene_;
    Diagnostics& to_;
    std::vector<std::string> knownNames_;
};

/// glib-E27 for a word as the value of a tag, which names nothing of the scene.
Diagnostic unknownWord(const scene::Scene& scene, std::string_view word, const Place& place);

}  // namespace glibra::plan
