#pragma once
// The values of active uniforms.

#include <optional>
#include <variant>
#include <vector>

#include "glsl/types/builtins.h"
#include "plan/program_variant.h"
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

}  // namespace glibra::plan
