#pragma once
// From tags with values as written to typed values of active uniforms (language, 5.3 and 6).

#include <glibra/result.h>

#include <map>
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
};
/// A value that the runtime computes for every draw.
struct Supplied {
    glsl::Builtin value{};
};
/// The value of a uniform is an expression, of which these are the simplest.
using Expression = std::variant<Literal, Supplied>;

struct UniformBinding {
    int uniform = 0;       ///< index into ProgramInterface::uniforms
    int firstElement = 0;  ///< for arrays
    Expression value;
};

/// A sampler or image and the unit of the language that it reads.
struct SamplerBinding {
    int uniform = 0;
    int element = 0;  ///< of an array of samplers
    int unit = 0;     ///< 0..127
};

/// What the interface needs for a slider, a check box or a colour button.
struct Control {
    int uniform = 0;
    glib::UniformForm form = glib::UniformForm::number;
    double minimum = 0, current = 0, maximum = 1;
};

struct UniformResolution {
    std::vector<UniformBinding> values;
    std::vector<SamplerBinding> samplers;
    std::vector<Control> controls;
    Diagnostics diagnostics;
};

/// One `--set NAME=VALUE`: the value as written, numbers separated by commas or blanks, or true/false.
struct Override {
    std::string name;
    glib::UniformForm form = glib::UniformForm::number;
    std::vector<double> values;
    /// Name or scene line of the one Program it is for; empty: all that have the uniform.
    std::string program{};
};
/// Reads "NAME=VALUE"; "uKd=.5", "uColor=1,.5,0", "uOn=true", "uM=[1 0 0 1]". "Dots:uKd=.5" and "12:uKd=.5"
/// are for the program of that name or on that line only.
Result<Override> parseOverride(std::string_view text);
/// True if it is for all programs, or for this one.
bool isFor(const Override& override, const scene::Program& program);

/// Resolves the pairs of one Program statement against its linked interface. Every active uniform that is
/// neither supplied, given nor initialised is reported (glib-W37) and stays 0. `overrides` win over the
/// scene's values; `usedOverrides` gets a true for each one that named a uniform here.
UniformResolution resolveUniforms(const scene::Program& program, const std::string& scenePath,
                                  const ProgramInterface& interface, std::span<const Override> overrides,
                                  std::vector<bool>& usedOverrides);

}  // namespace glibra::plan
