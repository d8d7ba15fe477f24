#pragma once
// `--set NAME=VALUE` over a whole scene, and names that have no effect.

#include <glibra/diagnostic.h>
#include <glibra/result.h>

#include <cstddef>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "scene/scene.h"

namespace glibra::plan {

struct FramePlan;

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

/// Returns glib-W23 for each override that no program used, or notAChoice() for a word. `names` are the names
/// of existing uniforms, for the suggestion. `used` has one element per override.
Diagnostics unusedOverrides(std::span<const Override> overrides, const std::vector<bool>& used,
                            std::span<const std::string> names);

/// glib-W15 for a value of a variable of the scene with another number of components than the variable has;
/// the variable keeps its value.
Diagnostic misfit(std::string_view name, std::span<const double> values, std::size_t components);

// ---- Names without effect
// What only all plans of a scene show together: names of --set and Set that no program has (language, 12.1),
// and textures that nothing writes (12.4).

/// glib-W23 for `--set` names that no program of the plans has, and glib-W24 for those that are declared but
/// not active. `plans` are those of the scene's frame and of its Once and Step blocks, made with the same
/// overrides. For a program that none of them asked for, or that did not link, only the pairs are known, so a
/// name among them is accepted. Also draw-W11 for textures that are read and never written, and glib-W23 for
/// names of Set that look misspelt: no program has them, one has a name that is near, and all programs of the
/// scene are known.
Diagnostics reportNames(const scene::Scene& scene, std::span<const FramePlan* const> plans,
                        std::span<const Override> overrides);

}  // namespace glibra::plan
