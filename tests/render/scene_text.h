#pragma once
// Renders scenes that a test gives as text: writes them to a temporary folder and removes it afterwards.

#include <glibra/render.h>
#include <gtest/gtest.h>

#include <array>
#include <cstdint>
#include <map>
#include <string>

namespace glibra::test {

/// Renders with a context of its own. Fails the test with the diagnostics if there
/// is no picture.
Picture picture(const std::string& scene, const std::map<std::string, std::string>& files = {},
                const RenderOptions& options = {});

/// The same, but returns the diagnostics instead of failing the test.
Result<Picture> tryPicture(const std::string& scene, const std::map<std::string, std::string>& files = {},
                           const RenderOptions& options = {});

/// The red, green and blue bytes of a pixel, counted from the top left.
inline std::array<int, 3> pixel(const Picture& picture, int x, int y) {
    const std::size_t at = (static_cast<std::size_t>(y) * static_cast<std::size_t>(picture.width) +
                            static_cast<std::size_t>(x)) *
                           static_cast<std::size_t>(picture.components);
    return {std::to_integer<int>(picture.data[at]), std::to_integer<int>(picture.data[at + 1]),
            std::to_integer<int>(picture.data[at + 2])};
}

inline bool isSame(const Picture& a, const Picture& b) {
    return a.width == b.width && a.height == b.height && a.data == b.data;
}

inline constexpr std::array<int, 3> kWhite{255, 255, 255};

/// The number of pixels of that colour.
int countPixels(const Picture& picture, std::array<int, 3> color);

/// True if the diagnostics contain that id.
bool has(const Diagnostics& diagnostics, const std::string& id);

/// All messages as one text, for failure output.
std::string text(const Diagnostics& diagnostics);

}  // namespace glibra::test
