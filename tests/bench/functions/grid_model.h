#pragma once
// A model file of any size: a wavy sheet of quads with texture coordinates and normals.

#include <fmt/format.h>

#include <cmath>
#include <iterator>
#include <string>

namespace glibra::bench {

/// OBJ text with side * side vertices and (side - 1)^2 faces; a side of 640 gives 70 MB.
inline std::string gridModel(int side) {
    std::string text = "# a wavy sheet\n";
    const auto at = [&](int i) { return 2. * i / (side - 1) - 1; };
    const auto height = [](double x, double y) { return .2 * std::sin(9 * x) * std::cos(7 * y); };
    for (int j = 0; j < side; ++j)
        for (int i = 0; i < side; ++i) {
            const double x = at(i), y = at(j), dx = 1.8 * std::cos(9 * x) * std::cos(7 * y),
                         dy = -1.4 * std::sin(9 * x) * std::sin(7 * y), length = std::hypot(dx, dy, 1.);
            fmt::format_to(std::back_inserter(text),
                           "v {:.6f} {:.6f} {:.6f}\nvt {:.6f} {:.6f}\nvn {:.6f} {:.6f} {:.6f}\n", x, y,
                           height(x, y), (x + 1) / 2, (y + 1) / 2, -dx / length, -dy / length, 1 / length);
        }
    for (int j = 0; j + 1 < side; ++j)
        for (int i = 0; i + 1 < side; ++i) {
            const int a = j * side + i + 1, b = a + 1, c = b + side, d = a + side;
            fmt::format_to(std::back_inserter(text), "f {0}/{0}/{0} {1}/{1}/{1} {2}/{2}/{2} {3}/{3}/{3}\n", a,
                           b, c, d);
        }
    return text;
}

}  // namespace glibra::bench
