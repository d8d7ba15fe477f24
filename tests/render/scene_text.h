#pragma once
// Scenes given as text in a test: written to a folder of their own, rendered, and the folder removed.

#include <glibra/render.h>
#include <gtest/gtest.h>

#include <array>
#include <cstdint>
#include <map>
#include <string>

namespace glibra::test {

/// Renders with one context that all tests of the program share; fails the test with the diagnostics if there
/// is no picture.
Picture picture(const std::string& scene, const std::map<std::string, std::string>& files = {},
                const RenderOptions& options = {});

/// The same, with the diagnostics instead of a failure.
Result<Picture> tryPicture(const std::string& scene, const std::map<std::string, std::string>& files = {},
                           const RenderOptions& options = {});

/// Red, green, blue of the pixel, counted from the top left; bytes.
inline std::array<int, 3> pixel(const Picture& picture, int x, int y) {
    const std::size_t at = (static_cast<std::size_t>(y) * static_cast<std::size_t>(picture.width) +
                            static_cast<std::size_t>(x)) *
                           static_cast<std::size_t>(picture.components);
    return {std::to_integer<int>(picture.data[at]), std::to_integer<int>(picture.data[at + 1]),
            std::to_integer<int>(picture.data[at + 2])};
}

/// Number of pixels whose red, green and blue are all equal to the given ones.
int countPixels(const Picture& picture, std::array<int, 3> color);

/// True if the diagnostics hold one with that id.
bool has(const Diagnostics& diagnostics, const std::string& id);

/// All messages in one text, for failure output.
std::string text(const Diagnostics& diagnostics);

}  // namespace glibra::test
