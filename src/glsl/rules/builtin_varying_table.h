#pragma once
// The built-in varyings that core GLSL lacks (language, 7.6), one row each.

#include <array>
#include <cstddef>
#include <string>
#include <string_view>

namespace glibra::glsl::varyings {

enum Varying : std::size_t {
    frontColor,
    backColor,
    frontSecondary,
    backSecondary,
    texCoord,
    fog,
    kVaryingCount
};

inline constexpr std::array<Varying, kVaryingCount> kVaryings{frontColor,    backColor, frontSecondary,
                                                              backSecondary, texCoord,  fog};

struct Row {
    std::string_view name;  ///< without gl_
    std::string_view type;
    std::string_view unwritten;  ///< the value that a reader gets if no stage writes it
    bool color;
};
inline constexpr std::array<Row, kVaryingCount> kRows = {
    {{"FrontColor", "vec4", "glibra_CurrentColor", true},
     {"BackColor", "vec4", "glibra_CurrentColor", true},
     {"FrontSecondaryColor", "vec4", "vec4(0., 0., 0., 1.)", true},
     {"BackSecondaryColor", "vec4", "vec4(0., 0., 0., 1.)", true},
     {"TexCoord", "vec4", "vec4(0., 0., 0., 1.)", false},
     {"FogFragCoord", "float", "0.", false}}};
inline constexpr int kMostTexCoords = 32;

/// The user's name of the varying.
inline std::string user(Varying which) {
    return "gl_" + std::string(kRows[which].name);
}
/// Its name in translated shaders.
inline std::string own(Varying which) {
    return "glibra_" + std::string(kRows[which].name);
}

/// The varying that a word names; kVaryingCount for other words. Sets `input` for names that end with In.
inline Varying varyingOf(std::string_view word, bool& input) {
    input = false;
    if (!word.starts_with("gl_")) return kVaryingCount;
    const std::string_view name = word.substr(3);
    for (std::size_t i = 0; i < kVaryingCount; ++i) {
        if (name == kRows[i].name) return static_cast<Varying>(i);
        if (name.ends_with("In") && name.substr(0, name.size() - 2) == kRows[i].name) {
            input = true;
            return static_cast<Varying>(i);
        }
    }
    return kVaryingCount;
}

}  // namespace glibra::glsl::varyings
