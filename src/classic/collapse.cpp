// Common vertices become one. Space is divided into cells with sides of twice the tolerance: what is near to
// a vertex is in its own cell or, along each axis, in the neighbour on the nearer side, so that at most eight
// cells are searched. Values other than the place have to be equal, and are part of the hash.

#include <array>
#include <cmath>
#include <cstring>
#include <numeric>
#include <unordered_map>
#include <utility>

#include "base/hash.h"

#include "classic/vertex_lists.h"

namespace glibra::classic {
namespace {

/// Equal numbers have equal bits.
std::uint64_t bitsOf(double value) {
    value += 0.0;  // -0 is 0
    std::uint64_t bits = 0;
    std::memcpy(&bits, &value, sizeof bits);
    return bits;
}

class Collapse {
  public:
    Collapse(const VertexLists& from, float tolerance)
        : from_(from), tolerance_(tolerance > 0 ? static_cast<double>(tolerance) : 0) {
        heads_.reserve(from.count());
    }

    Collapsed run() {
        Collapsed result;
        result.columns = from_.columns();
        result.vertexOf.reserve(from_.count());
        for (std::size_t i = 0; i < from_.count(); ++i) {
            const std::uint64_t others = hashOfOthers(i);
            std::uint32_t vertex = find(i, others);
            if (vertex == kNone) vertex = keep(i, others);
            result.vertexOf.push_back(vertex);
        }
        result.count = kept_.size();
        for (VertexColumn& column : result.columns) {
            const auto width = static_cast<std::size_t>(column.components);
            std::vector<float> values;
            values.reserve(kept_.size() * width);
            for (const Kept& each : kept_)
                for (std::size_t c = 0; c < width; ++c)
                    values.push_back(column.values[each.given * width + c]);
            column.values = std::move(values);
        }
        return result;
    }

  private:
    static constexpr std::uint32_t kNone = 0xffffffffU;
    struct Kept {
        std::size_t given = 0;
        std::uint32_t next = kNone;  ///< of the same hash
    };

    [[nodiscard]] double coordinate(std::size_t vertex, std::size_t axis) const {
        const VertexColumn& place = from_.columns().front();
        return static_cast<double>(place.values[vertex * static_cast<std::size_t>(place.components) + axis]);
    }

    /// Of all values but x, y and z.
    [[nodiscard]] std::uint64_t hashOfOthers(std::size_t vertex) const {
        std::uint64_t hash = 1;
        std::size_t skipped = 3;
        for (const VertexColumn& column : from_.columns()) {
            const auto width = static_cast<std::size_t>(column.components);
            for (std::size_t c = skipped; c < width; ++c)
                hash = base::combined(hash, bitsOf(static_cast<double>(column.values[vertex * width + c])));
            skipped = 0;
        }
        return hash;
    }

    /// False for what is the same as nothing, and would make long lists of one hash.
    [[nodiscard]] bool isOrdinary(std::size_t vertex) const {
        for (std::size_t axis = 0; axis < 3; ++axis)
            if (!std::isfinite(coordinate(vertex, axis))) return false;
        for (const VertexColumn& column : from_.columns()) {
            const auto width = static_cast<std::size_t>(column.components);
            for (std::size_t c = 0; c < width; ++c)
                if (std::isnan(column.values[vertex * width + c])) return false;
        }
        return true;
    }

    [[nodiscard]] bool isSame(std::size_t a, std::size_t b) const {
        for (std::size_t axis = 0; axis < 3; ++axis)
            if (!(std::abs(coordinate(a, axis) - coordinate(b, axis)) <= tolerance_)) return false;
        std::size_t skipped = 3;
        for (const VertexColumn& column : from_.columns()) {
            const auto width = static_cast<std::size_t>(column.components);
            for (std::size_t c = skipped; c < width; ++c)
                if (!(column.values[a * width + c] == column.values[b * width + c])) return false;
            skipped = 0;
        }
        return true;
    }

    [[nodiscard]] double cell(double value) const {
        return tolerance_ > 0 ? std::floor(value / (2 * tolerance_)) : value;
    }

    [[nodiscard]] std::uint64_t hashAt(std::uint64_t others, const std::array<double, 3>& cells) const {
        for (const double each : cells) others = base::combined(others, bitsOf(each));
        return others;
    }

    /// The first kept vertex that is the same, in the order in which they were given.
    [[nodiscard]] std::uint32_t find(std::size_t vertex, std::uint64_t others) const {
        // Rounding may put the two ends two cells apart.
        std::array<std::array<double, 3>, 3> sides{};
        std::array<std::size_t, 3> count{1, 1, 1};
        for (std::size_t axis = 0; axis < 3; ++axis) {
            const double value = coordinate(vertex, axis);
            const double least = cell(value - tolerance_);
            const double most = cell(value + tolerance_);
            sides[axis] = {least, most, least + 1};
            if (most != least) count[axis] = most - least > 1 ? 3 : 2;
        }
        std::uint32_t best = kNone;
        for (std::size_t x = 0; x < count[0]; ++x)
            for (std::size_t y = 0; y < count[1]; ++y)
                for (std::size_t z = 0; z < count[2]; ++z) {
                    const auto head = heads_.find(hashAt(others, {sides[0][x], sides[1][y], sides[2][z]}));
                    if (head == heads_.end()) continue;
                    for (std::uint32_t each = head->second; each != kNone; each = kept_[each].next)
                        if (each < best && isSame(kept_[each].given, vertex)) best = each;
                }
        return best;
    }

    std::uint32_t keep(std::size_t vertex, std::uint64_t others) {
        const auto number = static_cast<std::uint32_t>(kept_.size());
        kept_.push_back({vertex, kNone});
        if (!isOrdinary(vertex)) return number;
        std::array<double, 3> cells{};
        for (std::size_t axis = 0; axis < 3; ++axis) cells[axis] = cell(coordinate(vertex, axis));
        const auto [head, isNew] = heads_.try_emplace(hashAt(others, cells), number);
        if (!isNew) kept_.back().next = std::exchange(head->second, number);
        return number;
    }

    const VertexLists& from_;
    double tolerance_;
    std::vector<Kept> kept_;
    std::unordered_map<std::uint64_t, std::uint32_t> heads_;  ///< the last kept vertex of a hash
};

}  // namespace

Collapsed collapse(const VertexLists& from, float tolerance) {
    return Collapse(from, tolerance).run();
}

Collapsed uncollapsed(const VertexLists& from) {
    Collapsed same;
    same.columns = from.columns();
    same.count = from.count();
    same.vertexOf.resize(same.count);
    std::iota(same.vertexOf.begin(), same.vertexOf.end(), 0U);
    return same;
}

}  // namespace glibra::classic
