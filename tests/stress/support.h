#pragma once
// Scenes given as text, drawn into floats, and pictures that count how often each pixel was covered.

#include <glibra/render.h>
#include <gtest/gtest.h>

#include <array>
#include <cstdint>
#include <functional>
#include <map>
#include <string>
#include <vector>

#include "geometry/mesh.h"
#include "gpu/context.h"
#include "scene/scene.h"

namespace glibra::stress {

/// The one context of the program.
gpu::Context& context();

/// Shader and model files beside the scene, by name.
using Files = std::map<std::string, std::string>;

/// Red, green, blue of every pixel as floats, top row first.
struct FloatPicture {
    int width = 0, height = 0;
    std::vector<float> values;
    Diagnostics diagnostics;

    [[nodiscard]] std::array<float, 3> at(int x, int y) const {
        const std::size_t i =
            3 * (static_cast<std::size_t>(y) * static_cast<std::size_t>(width) + static_cast<std::size_t>(x));
        return {values[i], values[i + 1], values[i + 2]};
    }
    /// Number of pixels of which `wanted` is true.
    [[nodiscard]] std::size_t count(const std::function<bool(const std::array<float, 3>&)>& wanted) const;
    /// Components that are NaN or infinite.
    [[nodiscard]] std::size_t nonFinite() const;
    /// Sum of a component over all pixels.
    [[nodiscard]] double sum(int component) const;
};

/// Draws the scene with the eye where the scene puts it; the test fails with the messages if there is no
/// picture (the result is then empty: width 0).
FloatPicture draw(const std::string& scene, const Files& files = {}, RenderOptions options = {});
/// The same, with the messages instead of a failure.
Result<FloatPicture> tryDraw(const std::string& scene, const Files& files = {}, RenderOptions options = {});

/// "Vertex v.vert / Fragment f.frag / Program P", and the two files: the vertex stage multiplies by the
/// matrices and hands on vMC and vEC (model and eye coordinates), vN (uNormalMatrix * aNormal) and vST; the
/// fragment stage writes the expression.
extern const char* const kProgram;
Files shaded(const std::string& rgb, const std::string& declarations = "");

/// A fragment stage that adds `rgb` to what is there, exactly: alpha is 2^-60, so that blending multiplies
/// by 1 what is there, and the colour is 2^60 times as large. Depth is a constant, so that nothing hides
/// anything.
std::string addingFragment(const std::string& rgb, const std::string& declarations = "");

/// A shader of the library, `shaders/` left out of its path.
std::string shipped(const std::string& path);
/// The text with every `from` replaced; the test fails if there is none.
std::string replaced(std::string text, const std::string& from, const std::string& to);

/// Numbers in -1..1, a function of their index.
double spread(std::uint32_t index);

/// Text of a number that reads back as the same double.
std::string number(double value);

/// All messages in one text.
std::string text(const Diagnostics& diagnostics);
bool has(const Diagnostics& diagnostics, const std::string& id);

/// The scene of a text, without drawing; the files its text names are looked for in `folder`.
scene::Scene interpreted(const std::string& text, const std::string& folder = "/nowhere");
/// The mesh of the only shape of a scene's text.
geometry::Mesh meshOf(const std::string& text);

}  // namespace glibra::stress
