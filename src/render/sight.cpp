#include "render/sight.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace glibra::render {
namespace {

/// Relative error of a clip coordinate: some ten roundings of 2^-24, and ten times as much for safety.
constexpr double kRounding = 1e-5;
/// Below this drivers may take numbers for 0, above the other products may leave the range of floats.
constexpr double kTiny = 1e-30;
constexpr double kHuge = 1e30;
/// Pixels by which drivers move vertices (1/256 is usual) and err in the viewport's transform.
constexpr double kSnapping = 1.0 / 16;

/// A clip coordinate, or a sum of them, as a function of the vertex, and how far off the driver's may be.
struct Form {
    glm::dvec4 factors{0.0};
    double error = 0;
};
Form operator*(double factor, const Form& form) {
    return {factor * form.factors, std::abs(factor) * form.error};
}
Form operator+(const Form& a, const Form& b) {
    return {a.factors + b.factors, a.error + b.error};
}
Form operator-(const Form& a, const Form& b) {
    return a + -1.0 * b;
}

double largest(const Bounds& bounds, const Form& form) {
    double sum = form.error;
    for (int i = 0; i < 4; ++i)
        sum += std::max(form.factors[i] * bounds.low[i], form.factors[i] * bounds.high[i]);
    return sum;
}
double smallest(const Bounds& bounds, const Form& form) {
    return -largest(bounds, -1.0 * form);
}

glm::dmat4 absolute(const glm::dmat4& matrix) {
    glm::dmat4 result;
    for (int column = 0; column < 4; ++column)
        for (int row = 0; row < 4; ++row) result[column][row] = std::abs(matrix[column][row]);
    return result;
}

struct Clip {
    Form x, y, z, w;
};

Clip clipOf(const Bounds& bounds, const Lens& lens) {
    const glm::dmat4 matrix = lens.projection * lens.modelView;
    const glm::dmat4 sizes = absolute(lens.projection) * absolute(lens.modelView);
    const glm::dvec4 most = glm::max(glm::abs(bounds.low), glm::abs(bounds.high));
    const auto form = [&](int row) {
        Form result{{}, kTiny};
        for (int column = 0; column < 4; ++column) {
            result.factors[column] = matrix[column][row];
            result.error += kRounding * sizes[column][row] * most[column];
        }
        return result;
    };
    Clip clip{form(0), form(1), form(2), form(3)};
    // The tile as the translated program scales and moves it.
    const auto part = [&](const Form& coordinate, double whole, double first, double size) {
        return (whole / size) * coordinate + ((whole - 2 * first - size) / size) * clip.w;
    };
    clip.x = part(clip.x, lens.width, lens.tile.x, lens.tile.width);
    clip.y = part(clip.y, lens.height, lens.tile.y, lens.tile.height);
    return clip;
}

/// True if no sample lies in the interval that the coordinate's pixels span. `w` is positive.
bool missesCentres(const Bounds& bounds, const Form& coordinate, const Form& w, int pixels) {
    const double nearest = smallest(bounds, w);
    double low = std::numeric_limits<double>::infinity();
    double high = -low;
    for (unsigned corner = 0; corner < 16; ++corner) {
        glm::dvec4 vertex;
        for (unsigned i = 0; i < 4; ++i)
            vertex[static_cast<int>(i)] =
                (corner >> i & 1U) != 0 ? bounds.high[static_cast<int>(i)] : bounds.low[static_cast<int>(i)];
        const double ratio = glm::dot(coordinate.factors, vertex) / glm::dot(w.factors, vertex);
        const double error = (coordinate.error + std::abs(ratio) * w.error) / nearest;
        low = std::min(low, ratio - error);
        high = std::max(high, ratio + error);
    }
    const double first = (low + 1) / 2 * pixels - kSnapping - .5;
    const double last = (high + 1) / 2 * pixels + kSnapping - .5;
    return std::isfinite(first) && std::isfinite(last) && std::floor(last) < std::ceil(first);
}

template <std::size_t Components>
Bounds boundsOf(const std::vector<float>& values) {
    constexpr float kMost = std::numeric_limits<float>::infinity();
    std::array<float, 4> low{kMost, kMost, kMost, kMost};
    std::array<float, 4> high{-kMost, -kMost, -kMost, -kMost};
    std::array<float, Components> zero{};  // turns NaN where a value is no finite number
    for (std::size_t i = 0; i + Components <= values.size(); i += Components)
        for (std::size_t k = 0; k < Components; ++k) {
            const float value = values[i + k];
            low[k] = value < low[k] ? value : low[k];
            high[k] = value > high[k] ? value : high[k];
            zero[k] += value * 0;
        }
    if constexpr (Components == 3) low[3] = high[3] = 1;
    Bounds bounds;
    for (std::size_t k = 0; k < 4; ++k) {
        bounds.low[static_cast<int>(k)] = static_cast<double>(low[k]);
        bounds.high[static_cast<int>(k)] = static_cast<double>(high[k]);
    }
    bounds.isKnown = std::none_of(zero.begin(), zero.end(), [](float each) { return std::isnan(each); });
    return bounds;
}

}  // namespace

Bounds boundsOf(const geometry::Mesh& mesh) {
    const geometry::Attribute* position = mesh.attribute(geometry::kPosition);
    if (position == nullptr || position->values.empty()) return {};
    switch (position->components) {
        case 3:
            return boundsOf<3>(position->values);
        case 4:
            return boundsOf<4>(position->values);
        default:
            return {};
    }
}

Bounds placed(const Bounds& bounds, glsl::Placement placement) {
    Bounds result = bounds;
    if (placement == glsl::Placement::point) result.low.w = result.high.w = 1;
    if (placement == glsl::Placement::unknown) result.isKnown = false;
    return result;
}

Lens lensOf(const scene::Draw& draw, geometry::Topology topology, const ViewMatrices& view,
            const Screen& screen, const gpu::Capabilities& driver) {
    using geometry::Topology;
    Lens lens;
    lens.modelView = view.modelView(draw);
    lens.projection = view.projection(draw.projection, static_cast<double>(screen.width) / screen.height);
    lens.width = screen.width;
    lens.height = screen.height;
    lens.tile = screen.tile;
    lens.filled = topology == Topology::triangles || topology == Topology::trianglesAdjacency;
    lens.oneSample = screen.samples <= 1 && !screen.mayShift;
    if (topology == Topology::points)
        lens.reach = (draw.raster.pointSizeFromShader ? driver.maxPointSize : draw.raster.pointSize) / 2 + 1;
    else if (!lens.filled)
        lens.reach = draw.raster.lineWidth / 2 + 1;
    if (screen.mayShift) lens.reach += 1;
    return lens;
}

Sight sightOf(const Bounds& bounds, const Lens& lens) {
    if (!bounds.isKnown) return Sight::possible;
    const Clip clip = clipOf(bounds, lens);
    for (const Form& each : {clip.x, clip.y, clip.z, clip.w})
        if (!(each.error < kRounding * kHuge)) return Sight::possible;
    const auto isBeyond = [&](const Form& coordinate, int pixels) {
        // Drivers differ in whether they clip wide lines and points at their middle.
        const double widened = 1 + 2 * lens.reach / pixels;
        return largest(bounds, clip.w - coordinate) < 0 && largest(bounds, widened * clip.w - coordinate) < 0;
    };
    if (largest(bounds, clip.w + clip.z) < 0) return Sight::nearer;
    if (largest(bounds, clip.w - clip.z) < 0) return Sight::farther;
    if (isBeyond(-1.0 * clip.x, lens.tile.width)) return Sight::left;
    if (isBeyond(clip.x, lens.tile.width)) return Sight::right;
    if (isBeyond(-1.0 * clip.y, lens.tile.height)) return Sight::below;
    if (isBeyond(clip.y, lens.tile.height)) return Sight::above;
    if (lens.filled && lens.oneSample && smallest(bounds, clip.w) > 0 &&
        (missesCentres(bounds, clip.x, clip.w, lens.tile.width) ||
         missesCentres(bounds, clip.y, clip.w, lens.tile.height)))
        return Sight::betweenPixels;
    return Sight::possible;
}

std::string_view describe(Sight sight) {
    switch (sight) {
        case Sight::left:
            return "it is left of what is shown";
        case Sight::right:
            return "it is right of what is shown";
        case Sight::below:
            return "it is below what is shown";
        case Sight::above:
            return "it is above what is shown";
        case Sight::nearer:
            return "it is behind the eye or before the near plane";
        case Sight::farther:
            return "it is beyond the far plane";
        case Sight::betweenPixels:
            return "it is too small to cover the centre of a pixel";
        case Sight::possible:
            break;
    }
    return "";
}

}  // namespace glibra::render
