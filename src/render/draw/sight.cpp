#include "render/draw/sight.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace glibra::render {
namespace {

/// The relative error of a clip coordinate: about ten roundings of 2^-24, times ten for safety.
constexpr double kRounding = 1e-5;
/// Drivers may flush numbers below kTiny to 0. Products of numbers above kHuge may leave the range of floats.
constexpr double kTiny = 1e-30;
constexpr double kHuge = 1e30;
/// Allowance in pixels for vertex snapping (1/256 is usual) and errors of the viewport transform.
constexpr double kSnapping = 1.0 / 16;

/// A clip coordinate, or a sum of them, as a linear function of the vertex, with the driver's largest error.
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

double largest(const VertexBox& bounds, const Form& form) {
    double sum = form.error;
    for (int i = 0; i < 4; ++i)
        sum += std::max(form.factors[i] * bounds.low[i], form.factors[i] * bounds.high[i]);
    return sum;
}
double smallest(const VertexBox& bounds, const Form& form) {
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

Clip clipOf(const VertexBox& bounds, const DrawView& drawView) {
    const glm::dmat4 matrix = drawView.projection * drawView.modelView;
    const glm::dmat4 sizes = absolute(drawView.projection) * absolute(drawView.modelView);
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
    // Map the tile to clip space as the translated program does.
    const auto part = [&](const Form& coordinate, double whole, double first, double size) {
        return (whole / size) * coordinate + ((whole - 2 * first - size) / size) * clip.w;
    };
    clip.x = part(clip.x, drawView.width, drawView.tile.x, drawView.tile.width);
    clip.y = part(clip.y, drawView.height, drawView.tile.y, drawView.tile.height);
    return clip;
}

/// True if no pixel centre lies in the interval that the coordinate spans. `w` is positive.
bool missesCentres(const VertexBox& bounds, const Form& coordinate, const Form& w, int pixels) {
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

}  // namespace

bool isPlacedByMatrices(const scene::Draw& draw) {
    return !draw.raster->depthClamp && draw.raster->polygon == base::PolygonMode::fill &&
           draw.raster->viewport == base::FractionRectangle{} && !draw.attributes;
}

VertexBox placed(const VertexBox& bounds, glsl::Placement placement) {
    VertexBox result = bounds;
    if (placement == glsl::Placement::point) result.low.w = result.high.w = 1;
    if (placement == glsl::Placement::unknown) result.isKnown = false;
    return result;
}

DrawView drawViewOf(const scene::Draw& draw, geometry::Topology topology, const ViewMatrices& view,
                    const Screen& screen, const gpu::Capabilities& driver) {
    using geometry::Topology;
    DrawView drawView;
    drawView.modelView = view.modelView(draw);
    drawView.projection =
        view.projection(*draw.projection, static_cast<double>(screen.width) / screen.height);
    drawView.width = screen.width;
    drawView.height = screen.height;
    drawView.tile = screen.tile;
    drawView.depthClamp = draw.raster->depthClamp;
    drawView.filled = topology == Topology::triangles || topology == Topology::trianglesAdjacency;
    drawView.oneSample = screen.samples <= 1 && !screen.mayShift;
    if (topology == Topology::points)
        drawView.reach =
            (draw.raster->pointSizeFromShader ? driver.maxPointSize : draw.raster->pointSize) / 2 + 1;
    else if (!drawView.filled)
        drawView.reach = draw.raster->lineWidth / 2 + 1;
    if (screen.mayShift) drawView.reach += 1;
    return drawView;
}

Sight sightOf(const VertexBox& bounds, const DrawView& drawView) {
    if (!bounds.isKnown) return Sight::possible;
    const Clip clip = clipOf(bounds, drawView);
    for (const Form& each : {clip.x, clip.y, clip.z, clip.w})
        if (!(each.error < kRounding * kHuge)) return Sight::possible;
    const auto isBeyond = [&](const Form& coordinate, int pixels) {
        // Drivers differ: some clip wide lines and points at their centre.
        const double widened = 1 + 2 * drawView.reach / pixels;
        return largest(bounds, clip.w - coordinate) < 0 && largest(bounds, widened * clip.w - coordinate) < 0;
    };
    if (!drawView.depthClamp && largest(bounds, clip.w + clip.z) < 0) return Sight::nearer;
    if (!drawView.depthClamp && largest(bounds, clip.w - clip.z) < 0) return Sight::farther;
    if (isBeyond(-1.0 * clip.x, drawView.tile.width)) return Sight::left;
    if (isBeyond(clip.x, drawView.tile.width)) return Sight::right;
    if (isBeyond(-1.0 * clip.y, drawView.tile.height)) return Sight::below;
    if (isBeyond(clip.y, drawView.tile.height)) return Sight::above;
    if (drawView.filled && drawView.oneSample && smallest(bounds, clip.w) > 0 &&
        (missesCentres(bounds, clip.x, clip.w, drawView.tile.width) ||
         missesCentres(bounds, clip.y, clip.w, drawView.tile.height)))
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
            return "it is behind the eye or in front of the near plane";
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
