#pragma once
// Draws scenes given as text into floats, also as pictures that count how often each pixel was covered.

#include <glibra/render.h>
#include <gtest/gtest.h>

#include <array>
#include <cstdint>
#include <functional>
#include <map>
#include <numbers>
#include <string>
#include <vector>

#include "geometry/mesh.h"
#include "gpu/context/context.h"
#include "scene/scene.h"

namespace glibra::stress {

/// The only context of the test program.
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
    /// The number of pixels for which `wanted` is true.
    [[nodiscard]] std::size_t count(const std::function<bool(const std::array<float, 3>&)>& wanted) const;
    /// The number of components that are NaN or infinite.
    [[nodiscard]] std::size_t nonFinite() const;
    /// Sum of a component over all pixels.
    [[nodiscard]] double sum(int component) const;
};

/// Draws the scene with the eye where the scene puts it. If there is no picture, the test fails with the
/// messages, and the result is empty (width 0).
FloatPicture draw(const std::string& scene, const Files& files = {}, RenderOptions options = {});
/// The same, but returns the messages instead of failing.
Result<FloatPicture> tryDraw(const std::string& scene, const Files& files = {}, RenderOptions options = {});

inline constexpr double kDegree = std::numbers::pi / 180;

/// The eye looks along -z.
inline const std::string kFrontView = "LookAt 0 0 5 0 0 0 0 1 0\nBackground 0\n";
/// A view in which eye space equals model space and the quad fills the window.
inline const std::string kFlatView =
    "Background 0\nOrtho -1 1 -1 1\nLookAt 0 0 5 0 0 0 0 1 0\nVertex v.vert\nFragment f.frag\n";

/// "Vertex v.vert / Fragment f.frag / Program P", and the two files: the vertex stage multiplies by the
/// matrices and passes on vMC and vEC (model and eye coordinates), vN (uNormalMatrix * aNormal) and vST; the
/// fragment stage writes the expression.
extern const char* const kProgram;
Files shaded(const std::string& rgb, const std::string& declarations = "");

/// A fragment stage that adds `rgb` exactly to the colour of the pixel. Alpha is 2^-60, so that blending
/// multiplies the old colour by 1, and the new colour is 2^60 times as large. Depth is constant, so that no
/// fragment hides another.
std::string addingFragment(const std::string& rgb, const std::string& declarations = "");

/// The text of a shader of the library. The path does not contain `shaders/`.
std::string shipped(const std::string& path);
/// The text with every `from` replaced. The test fails if `from` does not occur.
std::string replaced(std::string text, const std::string& from, const std::string& to);

/// A pseudo-random number in -1..1 for each index.
double spread(std::uint32_t index);

/// A text that is parsed to the same double.
std::string number(double value);

/// All messages in one text.
std::string text(const Diagnostics& diagnostics);
bool has(const Diagnostics& diagnostics, const std::string& id);

/// The scene of a text, without drawing. Files that the text names are searched in `folder`.
scene::Scene interpreted(const std::string& text, const std::string& folder = "/nowhere");
/// The mesh of the only shape of a scene's text.
geometry::Mesh meshOf(const std::string& text);

}  // namespace glibra::stress
