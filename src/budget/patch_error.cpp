#include "budget/patch_error.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <limits>
#include <span>

#include "budget/pixel_scale.h"

namespace glibra::budget {
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

}  // namespace glibra::budget
