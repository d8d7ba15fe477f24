#pragma once
// Modern scenes of squares that have one colour each.

#include <array>

#include "modern_by_hand.h"

namespace glibra::test {

inline constexpr const char* kConstant =
    "uniform vec4 uColor; out vec4 fColor; void main() { fColor = uColor; }";
inline constexpr const char* kRead =
    "uniform sampler2D uMap; out vec4 fColor; void main() { fColor = texture(uMap, vST); }";

using Color = std::array<double, 4>;

/// A scene whose squares have one colour.
struct Squares {
    ModernScene modern;
    scene::ProgramIndex constant, read;

    explicit Squares(int width = 4, int height = 4)
        : modern(width, height),
          constant(modern.shading("Constant", kConstant)),
          read(modern.shading("Read", kRead)) {}

    scene::Draw& square(const Color& color, double z = 0, double size = 1) {
        scene::Draw& drawn = modern.square(constant, z, size);
        modern.set(drawn, {{"uColor", {color[0], color[1], color[2], color[3]}}});
        return drawn;
    }
    void show(const scene::TextureView& view) {
        modern.window();
        modern.set(modern.square(read), {}, {{"uMap", view}});
    }
};

inline constexpr Color kRed{1, 0, 0, 1}, kGreen{0, 1, 0, 1};
inline constexpr base::FractionRectangle kLeft{0, 0, .5, 1};

}  // namespace glibra::test
