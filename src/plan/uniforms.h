#pragma once
// Turns tags and values as written into typed values of active uniforms (language, 5.3 and 6).

#include <glibra/result.h>

#include <functional>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "glsl/types/builtins.h"
#include "plan/program_interface.h"
#include "scene/scene.h"

namespace glibra::plan {

/// A constant: `values` fill elements firstElement.. of the uniform, column by column, element by element.
struct Literal {
    std::vector<double> values;
    friend bool operator==(const Literal&, const Literal&) = default;
};
/// A value that the runtime computes per draw.
struct Supplied {
    glsl::Builtin value{};
    friend bool operator==(const Supplied&, const Supplied&) = default;
};
/// The value of a uniform.
using Expression = std::variant<Literal, Supplied>;

struct UniformBinding {
    UniformIndex uniform{};
    int firstElement = 0;  ///< for arrays
    Expression value;
    friend bool operator==(const UniformBinding&, const UniformBinding&) = default;
};

/// A texture that a sampler or image reads by its name, or a buffer that it reads as a texture.
struct BoundTexture {
    scene::TextureView view;
    Place place;  ///< of the tag; without a tag, of the Program
    scene::BufferView buffer{};
};

/// A sampler or image and what it reads: a texture with a name, or a unit of the language.
struct SamplerBinding {
    UniformIndex uniform{};
    int element = 0;  ///< of an array of samplers
    int unit = 0;     ///< 0..127
    std::optional<BoundTexture> bound{};
    bool isLost = false;  ///< its tag has an error, which has been reported
};

/// What the window needs for a slider, a check box or a colour button.
struct Control {
    UniformIndex uniform{};
    glib::UniformForm form = glib::UniformForm::number;
    double minimum = 0, current = 0, maximum = 1;
};

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
    const scene::Scene* scene = nullptr;     ///< a modern scene: names of textures, variables, matrices count
    const scene::UniformSet* set = nullptr;  ///< its `values` are among those of the program already
    /// NodeList::namedValues of the list that is planned.
    std::span<const glib::UniformSpec> ownValues{};
    /// Says which uniforms need no value, because a buffer of the scene has it; may be empty.
    std::function<bool(const ActiveUniform&)> isInBuffer{};
};

/// One `--set NAME=VALUE`. The value is numbers separated by commas or blanks, or true or false, or a word of
/// a choice.
struct Override {
    std::string name;
    glib::UniformForm form = glib::UniformForm::number;
    std::vector<double> values;  ///< empty if there is a word
    /// Name or line of the Program that it is for; empty: all programs that have the uniform.
    std::string program{};
    std::string written{};  ///< the value as typed, for messages
    /// A word of the choice `name`, or a function of the subroutine uniform `name`; it has no program.
    std::string word{};
};
/// Reads "NAME=VALUE": "uKd=.5", "uColor=1,.5,0", "uOn=true", "uM=[1 0 0 1]". "Dots:uKd=.5" and "12:uKd=.5"
/// apply only to the program of that name or on that line. "method=unordered" has a word.
Result<Override> parseOverride(std::string_view text);
/// The error for a word whose name is no choice.
Diagnostic notAChoice(std::string_view name, std::string_view word);
/// True if the override applies to this program.
bool isFor(const Override& override, const scene::Program& program);

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
