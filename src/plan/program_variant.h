#pragma once
// Which GL program a draw needs, before any is compiled.

#include <compare>
#include <optional>
#include <variant>
#include <vector>

#include "base/program_resources.h"
#include "glsl/types/builtins.h"
#include "glsl/types/translated_program.h"
#include "scene/objects.h"
#include "scene/scene.h"

namespace glibra::plan {

// A linked program as the plan sees it: plain values, without GL.

using base::ActiveInput;
using base::ActiveUniform;
using base::BaseType;
using base::UniformBlock;
using base::ValueType;
using UniformIndex = scene::Index<ActiveUniform>;

/// What a program reads, with the translator's facts about its stages. The names of uniforms are the user's.
struct ProgramInterface : base::ActiveResources {
    glsl::TranslatedProgram facts;  ///< stages' sources may be empty; diagnostics of translating and linking
    bool usable = false;            ///< it linked; otherwise `facts.diagnostics` says why
    bool isBuiltin = false;         ///< glibra's own flat-colour program
};

/// The same Program statement may need several GL programs: flat or smooth colours, one or several colour
/// targets, its own vertex stage or a supplied one.
struct ProgramVariant {
    scene::ProgramIndex program{};  ///< none: the built-in program
    bool flatColors = false;
    int colorTargets = 1;
    bool isFullScreen = false;                ///< a vertex stage that covers the whole target may be supplied
    bool inPieces = false;                    ///< a compute program that runs in several dispatches
    bool isFill = false;                      ///< Program::isLeftOutByFill: these stages are left out
    bool suppliesFragment = false;            ///< a fragment stage is missing and needed
    std::vector<glsl::Constant> constants{};  ///< those of the Program statement
    friend auto operator<=>(const ProgramVariant&, const ProgramVariant&) = default;
};

/// The variant of a program that differs in nothing but its constants.
ProgramVariant plainVariant(const scene::Scene& scene, scene::ProgramIndex program);

/// The program that draws it in this pass: its own, or the built-in program if its own lacks a stage.
ProgramVariant variantOf(const scene::Scene& scene, const scene::Draw& draw, const scene::Pass& pass);

/// True if the program has a fragment stage and no other. It gets a vertex stage: one that covers the whole
/// target where a draw covers it (scene::ClipSpace::hasStage) or has no vertex data, otherwise that of the
/// fixed pipeline.
bool isWithoutVertexStage(const scene::Program& program, bool isFill = false);

/// True if the built-in program is used: the draw has no program, or the program has no vertex stage and
/// cannot get one (language, 2.2).
bool usesBuiltin(const scene::Scene& scene, const scene::Draw& draw);

// ---- What its uniforms read

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

}  // namespace glibra::plan
