#include "budget/error_models.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>

#include "glib/statement_table.h"

namespace glibra::budget {
namespace {

bool isFinite(const glm::dmat4& matrix) {
    for (int column = 0; column < 4; ++column)
        for (int row = 0; row < 4; ++row)
            if (!std::isfinite(matrix[column][row])) return false;
    return true;
}

/// Returns the corners, in clip space, of the part of the box in front of the near plane z = -w: the box's
/// own corners there, and the points where its edges cross the plane.
std::vector<glm::dvec4> cornersInFront(const glm::dmat4& clipFromModel, const geometry::Extent& extent) {
    std::vector<glm::dvec4> all, front;
    for (unsigned i = 0; i < 8; ++i)
        all.push_back(clipFromModel * glm::dvec4((i & 1U) != 0 ? extent.high.x : extent.low.x,
                                                 (i & 2U) != 0 ? extent.high.y : extent.low.y,
                                                 (i & 4U) != 0 ? extent.high.z : extent.low.z, 1));
    const auto depth = [](const glm::dvec4& point) { return point.z + point.w; };
    for (std::size_t i = 0; i < all.size(); ++i) {
        if (depth(all[i]) >= 0) front.push_back(all[i]);
        for (const std::size_t bit : {1U, 2U, 4U}) {
            const glm::dvec4 &a = all[i], &b = all[i | bit];
            if ((i & bit) == 0 && (depth(a) < 0) != (depth(b) < 0))
                front.push_back(a + (b - a) * (depth(a) / (depth(a) - depth(b))));
        }
    }
    return front;
}

/// Returns the norm of the matrix with these two rows: the root of the larger eigenvalue of the product with
/// its transpose.
double norm(const glm::dvec3& x, const glm::dvec3& y) {
    const double xx = glm::dot(x, x), yy = glm::dot(y, y), xy = glm::dot(x, y);
    return std::sqrt((xx + yy) / 2 + std::hypot((xx - yy) / 2, xy));
}

}  // namespace

std::optional<double> pixelsPerUnit(const glm::dmat4& clipFromModel, const geometry::Extent& extent,
                                    double width, double height) {
    if (!isFinite(clipFromModel)) return std::nullopt;
    const std::vector<glm::dvec4> corners = cornersInFront(clipFromModel, extent);
    if (corners.empty()) return 0;
    const glm::dmat4 rows = glm::transpose(clipFromModel);
    const glm::dvec3 alongX(rows[0]), alongY(rows[1]), alongW(rows[3]);

    double nearest = std::numeric_limits<double>::infinity();
    for (const glm::dvec4& each : corners) nearest = std::min(nearest, each.w);
    const double centreW = glm::dot(alongW, (extent.low + extent.high) * .5) + rows[3].w;
    nearest = std::max(nearest, centreW - extent.radius * glm::length(alongW));
    if (!(nearest > 0)) return std::nullopt;

    glm::dvec2 low(std::numeric_limits<double>::infinity()), high(-low);
    for (const glm::dvec4& each : corners) {
        if (!(each.w > 0)) return std::nullopt;
        low = glm::min(low, glm::dvec2(each) / each.w);
        high = glm::max(high, glm::dvec2(each) / each.w);
    }
    low = glm::max(low, glm::dvec2(-kPictureMargin));
    high = glm::min(high, glm::dvec2(kPictureMargin));
    if (low.x > high.x || low.y > high.y) return 0;

    double largest = 0;
    for (const double x : {low.x, high.x})
        for (const double y : {low.y, high.y})
            largest = std::max(largest,
                               norm(width / 2 * (alongX - x * alongW), height / 2 * (alongY - y * alongW)));
    return largest / nearest;
}

namespace {

/// How far coordinates may miss a primitive: a few roundings of floats.
constexpr double kSlack = 1e-5;

using Weights = std::array<double, 3>;

double cross(const glm::dvec2& a, const glm::dvec2& b) {
    return a.x * b.y - a.y * b.x;
}

/// Returns the weights of the primitive's corners that give `at`; nothing if it is not on the primitive.
std::optional<Weights> weightsOf(const glm::dvec2& at, std::span<const PatchVertex> corners) {
    const glm::dvec2 a(corners[0].coordinate), b(corners[1].coordinate);
    if (corners.size() == 2) {
        const double length = b.x - a.x;
        if (std::abs(at.y - a.y) > kSlack || std::abs(length) < kSlack) return std::nullopt;
        const double share = (at.x - a.x) / length;
        if (share < -kSlack || share > 1 + kSlack) return std::nullopt;
        return Weights{1 - share, share, 0};
    }
    const glm::dvec2 c(corners[2].coordinate);
    const double area = cross(b - a, c - a);
    if (std::abs(area) < kSlack * kSlack) return std::nullopt;
    const Weights weights{cross(b - at, c - at) / area, cross(c - at, a - at) / area,
                          cross(a - at, b - at) / area};
    const bool isInside = std::ranges::all_of(weights, [](double w) { return w > -1e-3; });
    return isInside ? std::optional(weights) : std::nullopt;
}

/// Finds primitives of a patch by coordinates.
class Finder {
  public:
    explicit Finder(const Patch& patch) : patch_(patch) {
        for (std::size_t first = 0; first + patch.corners <= patch.vertices.size(); first += patch.corners) {
            glm::dvec2 low(2), high(-1);
            for (const PatchVertex& each : primitive(first)) {
                low = glm::min(low, glm::dvec2(each.coordinate));
                high = glm::max(high, glm::dvec2(each.coordinate));
            }
            for (std::size_t row = cell(low.y - kSlack); row <= cell(high.y + kSlack); ++row)
                for (std::size_t column = cell(low.x - kSlack); column <= cell(high.x + kSlack); ++column)
                    cells_[row * kCells + column].push_back(first);
        }
    }

    /// Returns gl_Position of the patch at these coordinates.
    [[nodiscard]] std::optional<glm::dvec4> at(const glm::dvec2& coordinate) const {
        for (const std::size_t first : cells_[cell(coordinate.y) * kCells + cell(coordinate.x)]) {
            const auto corners = primitive(first);
            const std::optional<Weights> weights = weightsOf(coordinate, corners);
            if (!weights) continue;
            glm::dvec4 sum(0);
            for (std::size_t i = 0; i < corners.size(); ++i) sum += (*weights)[i] * corners[i].clip;
            return sum;
        }
        return std::nullopt;
    }

  private:
    static constexpr std::size_t kCells = 16;
    static std::size_t cell(double coordinate) {
        return static_cast<std::size_t>(std::clamp(coordinate * kCells, 0., kCells - 1.));
    }
    [[nodiscard]] std::span<const PatchVertex> primitive(std::size_t first) const {
        return std::span(patch_.vertices).subspan(first, patch_.corners);
    }

    const Patch& patch_;
    std::array<std::vector<std::size_t>, kCells * kCells> cells_;
};

}  // namespace

std::optional<double> patchError(const Patch& coarse, const Patch& fine, const glm::dvec2& size) {
    const Finder finder(coarse);
    double largest = 0;
    for (const PatchVertex& vertex : fine.vertices) {
        const std::optional<glm::dvec4> shown = finder.at(vertex.coordinate);
        if (!shown) return std::nullopt;
        if (!(vertex.clip.w > 0) || !(shown->w > 0)) return std::numeric_limits<double>::infinity();
        const glm::dvec2 is = glm::dvec2(vertex.clip) / vertex.clip.w, seems = glm::dvec2(*shown) / shown->w;
        if (glm::max(std::abs(is.x), std::abs(is.y)) > kPictureMargin) continue;
        const double distance = glm::length((seems - is) * size * .5);
        if (!std::isfinite(distance)) return std::numeric_limits<double>::infinity();
        largest = std::max(largest, distance);
    }
    return largest;
}

double edgeError(int samples) {
    return .5 / std::sqrt(samples);
}

int leastSamples(double maxError, int most) {
    int samples = 1;
    while (edgeError(samples) > maxError && 2 * samples <= most) samples *= 2;
    return samples;
}

std::span<const int> noiseSizes(int dimensions) {
    static constexpr std::array kSizes2{32, 64, 96, 128, 192, 256, 384, 512, 768, 1024};
    static constexpr std::array kSizes3{32, 64, 96, 128, 160, 192, 224, 256};
    return dimensions == 3 ? std::span<const int>(kSizes3) : std::span<const int>(kSizes2);
}

double noiseError(int dimensions, NoiseFormat format) {
    const double interpolation = (dimensions == 3 ? 33. : 30.) / format.size / format.size;
    double rounding = dimensions == 3 ? .0017 : .0025;
    if (format.texels == scene::NoiseTexels::shorts) rounding /= 257;
    return std::hypot(interpolation, rounding);
}

double meanNoiseStep(int dimensions) {
    return dimensions == 3 ? .0013 : .00147;
}

NoiseFormat leastNoise(int dimensions, double maxError, const std::function<double(NoiseFormat)>& errorOf) {
    const std::span<const int> sizes = noiseSizes(dimensions);
    for (const int each : sizes)
        for (const scene::NoiseTexels texels : {scene::NoiseTexels::bytes, scene::NoiseTexels::shorts})
            if (errorOf({each, texels}) <= maxError) return {each, texels};
    return {sizes.back(), scene::NoiseTexels::shorts};
}

namespace {

SurfaceModel modelOf(glib::CommandId command) {
    SurfaceModel model{.command = command, .spec = glib::primitiveOf(command)};
    const auto arguments = model.spec->arguments;
    for (std::size_t i = 0; i < arguments.size(); ++i) {
        const geometry::ShapeArgument& each = arguments[i];
        if (each.kind != geometry::ArgumentKind::count) continue;
        assert(model.countsUsed < model.counts.size());
        model.counts[model.countsUsed++] = {i, static_cast<int>(each.least), each.smooth, each.isFixed,
                                            each.name};
    }
    return model;
}

std::vector<SurfaceModel> allModels() {
    std::vector<SurfaceModel> models;
    for (const glib::StatementRow& row : glib::commandTable())
        if (const geometry::PrimitiveSpec* spec = glib::primitiveOf(row.id); spec && spec->deviation)
            models.push_back(modelOf(row.id));
    return models;
}

}  // namespace

const SurfaceModel* surfaceModel(glib::CommandId command) {
    static const std::vector<SurfaceModel> kModels = allModels();
    for (const SurfaceModel& each : kModels)
        if (each.command == command) return &each;
    return nullptr;
}

}  // namespace glibra::budget
