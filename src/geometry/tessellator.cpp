#include "geometry/tessellator.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <ranges>
#include <span>

namespace glibra::geometry {
namespace {

using base::TessellationLayout;
using Domain = TessellationLayout::Domain;
using Spacing = TessellationLayout::Spacing;
using Coordinates = std::array<float, 3>;

constexpr std::int64_t kOne = 1 << 16;  // of a coordinate
constexpr std::int64_t kThird = 0x5555, kTwoThirds = 0xAAAA;
constexpr float kLargest = 64;
/// What keeps the inner vertices of odd spacing apart from the edges.
constexpr float kLeastStep = 1.F / kOne;

std::int64_t toFixed(float value) {
    return std::lrint(value * static_cast<float>(kOne));
}

/// The parts that a level divides an edge into. An edge is symmetric: each half has `steps` whole parts, and
/// an odd number of parts has one more in the middle.
class Division {
  public:
    /// `level` is in the range of the spacing, and a whole number for equal spacing.
    Division(float level, bool isOdd) : isOdd_(isOdd) {
        std::int64_t half = (toFixed(level) + 1) / 2;
        if (isOdd || half == kOne / 2) half += kOne / 2;
        const std::int64_t floor = half / kOne, ceiling = (half + kOne - 1) / kOne;
        fraction_ = half % kOne;
        halfPoints_ = static_cast<int>(ceiling);
        if (floor == ceiling)
            split_ = halfPoints_ + 1;
        else
            split_ =
                isOdd && floor == 1 ? 0 : newPointAfter(static_cast<unsigned>(isOdd ? floor - 1 : floor));
        const std::int64_t odd = isOdd ? 1 : 0;
        stepBelow_ = inverse(2 * floor - odd);
        stepAbove_ = inverse(2 * ceiling - odd);
    }

    [[nodiscard]] bool isOdd() const { return isOdd_; }
    [[nodiscard]] int points() const { return 2 * halfPoints_ + (isOdd_ ? 0 : 1); }
    [[nodiscard]] int steps() const { return isOdd_ ? halfPoints_ - 1 : halfPoints_; }

    /// Where point `i` stands, 0 to kOne.
    [[nodiscard]] std::int64_t place(int i) const {
        const bool isMirrored = i >= halfPoints_;
        if (isMirrored) i = 2 * halfPoints_ - i - (isOdd_ ? 1 : 0);
        if (i == halfPoints_) return kOne / 2;
        const std::int64_t below = (i > split_ ? i - 1 : i) * stepBelow_, above = i * stepAbove_;
        const std::int64_t place = (below * (kOne - fraction_) + above * fraction_ + kOne / 2) / kOne;
        return isMirrored ? kOne - place : place;
    }

    /// Where the steps of a half begin on an edge with all 32 of them, by which the steps of two edges are
    /// merged.
    [[nodiscard]] std::vector<int> beginnings() const {
        std::vector<int> places{0, kSlots};
        for (unsigned floor = 1; places.size() <= static_cast<std::size_t>(steps()); ++floor) {
            const auto at = places.begin() + newPointAfter(floor);
            places.insert(at, (*at + *(at - 1)) / 2);
        }
        places.resize(static_cast<std::size_t>(steps()));
        return places;
    }

  private:
    static constexpr int kSlots = 32;

    /// Where a half with `floor` steps gets its next point.
    static int newPointAfter(unsigned floor) {
        return static_cast<int>(((floor & ~std::bit_floor(floor)) << 1U) + 1);
    }
    static std::int64_t inverse(std::int64_t parts) {
        return toFixed(1.F / static_cast<float>(std::max<std::int64_t>(1, parts)));
    }

    bool isOdd_;
    std::int64_t fraction_ = 0, stepBelow_ = 0, stepAbove_ = 0;
    int halfPoints_ = 0, split_ = 0;
};

/// Takes the levels of a layout.
class DividedPatch {
  public:
    explicit DividedPatch(const TessellationLayout& layout) : layout_(layout) {}

    std::vector<Coordinates> take() { return std::move(made_); }

    void quads(const std::array<float, 6>& levels) {
        const std::span outer(levels.data(), 4);
        const std::array inner{innerLevel(outer, levels[4], levels[5]),
                               innerLevel(outer, levels[5], levels[4])};
        if (isWhole(outer, inner)) {
            const Coordinates a = at(0, 0), b = at(kOne, 0), c = at(kOne, kOne), d = at(0, kOne);
            if (layout_.asPoints) return points({d, a, b, c});
            triangle(a, b, d);
            return triangle(b, c, d);
        }
        const Division u = innerDivision(inner[0]), v = innerDivision(inner[1]);
        const auto ring = [&](int depth) {
            const int lastU = u.points() - 1 - depth, lastV = v.points() - 1 - depth;
            std::vector<std::vector<Coordinates>> edges(4);
            for (int i = depth; i <= lastV; ++i) {
                edges[0].push_back(at(u.place(depth), v.place(lastV + depth - i)));
                edges[2].push_back(at(u.place(lastU), v.place(i)));
            }
            for (int i = depth; i <= lastU; ++i) {
                edges[1].push_back(at(u.place(i), v.place(depth)));
                edges[3].push_back(at(u.place(lastU + depth - i), v.place(lastV)));
            }
            return edges;
        };
        std::vector<std::vector<Coordinates>> outside(4);
        std::vector<Division> divisions;
        for (int edge = 0; edge < 4; ++edge) {
            const Division& own =
                divisions.emplace_back(outerDivision(outer[static_cast<std::size_t>(edge)]));
            for (int i = 0; i < own.points(); ++i) {
                const std::int64_t place = own.place(i), back = own.place(own.points() - 1 - i);
                outside[static_cast<std::size_t>(edge)].push_back(edge == 0   ? at(0, back)
                                                                  : edge == 1 ? at(place, 0)
                                                                  : edge == 2 ? at(kOne, place)
                                                                              : at(back, kOne));
            }
        }
        const int depth = std::min(u.points(), v.points());
        rings(std::move(outside), divisions, {&v, &u, &v, &u}, (depth + 1) / 2, ring);
        if (depth % 2 == 0 && !layout_.asPoints) centreOfQuads(ring(depth / 2 - 1));
    }

    void triangles(const std::array<float, 6>& levels) {
        const std::span outer(levels.data(), 3);
        const float inner = innerLevel(outer, levels[4], levels[4]);
        if (isWhole(outer, {inner, inner})) {
            const Coordinates a = at(0, kOne, 0), b = at(0, 0, kOne), c = at(kOne, 0, 0);
            if (layout_.asPoints) return points({a, b, c});
            return triangle(a, b, c);
        }
        const Division own = innerDivision(inner);
        const auto corner = [](int edge, std::int64_t distance, std::int64_t along) {
            const std::int64_t rest = kOne - distance - along;
            return edge == 0   ? at(distance, along, rest)
                   : edge == 1 ? at(along, distance, rest)
                               : at(along, rest, distance);
        };
        const auto ring = [&](int depth) {
            std::vector<std::vector<Coordinates>> edges(3);
            const int last = own.points() - 1 - depth;
            const std::int64_t distance = (own.place(depth) * kTwoThirds + kOne / 2) / kOne;
            for (int edge = 0; edge < 3; ++edge)
                for (int i = depth; i <= last; ++i) {
                    const std::int64_t along =
                        own.place(edge == 1 ? i : last + depth - i) - (distance + 1) / 2;
                    edges[static_cast<std::size_t>(edge)].push_back(
                        2 * depth == own.points() - 1 ? at(kThird, kThird, kOne - 2 * kThird)
                                                      : corner(edge, distance, along));
                }
            for (std::size_t edge = 0; edge < 3; ++edge) edges[edge].back() = edges[(edge + 1) % 3].front();
            return edges;
        };
        std::vector<std::vector<Coordinates>> outside(3);
        std::vector<Division> divisions;
        for (int edge = 0; edge < 3; ++edge) {
            const Division& each =
                divisions.emplace_back(outerDivision(outer[static_cast<std::size_t>(edge)]));
            for (int i = 0; i < each.points(); ++i)
                outside[static_cast<std::size_t>(edge)].push_back(
                    corner(edge, 0, each.place(edge == 1 ? i : each.points() - 1 - i)));
        }
        rings(std::move(outside), divisions, {&own, &own, &own}, (own.points() + 1) / 2, ring);
        if (own.points() % 2 == 0 && !layout_.asPoints) {
            const std::vector<std::vector<Coordinates>> last = ring(own.points() / 2 - 1);
            triangle(last[0][0], last[1][0], last[2][0]);
        }
    }

    void isolines(const std::array<float, 6>& levels) {
        const float lines = std::ceil(std::clamp(levels[0], 1.F, kLargest));
        const Division across(lines, std::fmod(lines, 2.F) == 1);
        const Division along = outerDivision(levels[1]);
        for (int line = 0; line < static_cast<int>(lines); ++line)
            for (int i = 0; i < along.points(); ++i) {
                const Coordinates here = at(along.place(i), across.place(line));
                if (layout_.asPoints)
                    made_.push_back(here);
                else if (i + 1 < along.points())
                    made_.insert(made_.end(), {here, at(along.place(i + 1), across.place(line))});
            }
    }

  private:
    static Coordinates at(std::int64_t u, std::int64_t v, std::int64_t w = 0) {
        constexpr auto kScale = 1.F / static_cast<float>(kOne);
        return {static_cast<float>(u) * kScale, static_cast<float>(v) * kScale,
                static_cast<float>(w) * kScale};
    }

    [[nodiscard]] float rounded(float level) const {
        switch (layout_.spacing) {
            case Spacing::equal:
                return std::ceil(std::clamp(level, 1.F, kLargest));
            case Spacing::fractionalEven:
                return std::clamp(level, 2.F, kLargest);
            default:
                return std::clamp(level, 1.F, kLargest - 1);
        }
    }

    [[nodiscard]] float innerLevel(std::span<const float> outer, float level, float other) const {
        constexpr float kMore = 1 + kLeastStep / 2;
        const bool isDivided = level > kMore || other > kMore ||
                               std::ranges::any_of(outer, [](float each) { return each > kMore; });
        // A level that is no number counts as the least.
        const float known = level > 1 ? level : 1;
        return rounded(
            layout_.spacing == Spacing::fractionalOdd && isDivided ? std::max(known, 1 + kLeastStep) : known);
    }

    [[nodiscard]] bool isOdd(float level) const {
        return layout_.spacing == Spacing::fractionalOdd ||
               (layout_.spacing == Spacing::equal && std::fmod(level, 2.F) == 1);
    }
    [[nodiscard]] Division outerDivision(float level) const {
        const float own = rounded(level);
        return {own, isOdd(own)};
    }
    /// One part inside is drawn as two, since the edges have more.
    [[nodiscard]] Division innerDivision(float level) const {
        return {level, isOdd(level) && !(layout_.spacing == Spacing::equal && level == 1)};
    }
    [[nodiscard]] bool isWhole(std::span<const float> outer, std::array<float, 2> inner) const {
        return layout_.spacing != Spacing::fractionalEven && inner[0] == 1 && inner[1] == 1 &&
               std::ranges::all_of(outer, [&](float each) { return rounded(each) == 1; });
    }

    void points(std::initializer_list<Coordinates> all) { made_.insert(made_.end(), all); }
    void triangle(const Coordinates& a, const Coordinates& b, const Coordinates& c) {
        made_.insert(made_.end(), {a, layout_.isClockwise ? c : b, layout_.isClockwise ? b : c});
    }

    /// Joins the outer ring with the first one inside, and each with the next.
    template <class Ring>
    void rings(std::vector<std::vector<Coordinates>> outside, const std::vector<Division>& divisions,
               const std::vector<const Division*>& inner, int count, const Ring& ring) {
        if (layout_.asPoints) addPoints(outside);
        for (int depth = 1; depth < count; ++depth) {
            std::vector<std::vector<Coordinates>> inside = ring(depth);
            if (layout_.asPoints)
                addPoints(inside);
            else
                for (std::size_t edge = 0; edge < outside.size(); ++edge)
                    if (depth == 1)
                        merge(outside[edge], divisions[edge], inside[edge], *inner[edge]);
                    else
                        join(outside[edge], inside[edge]);
            outside = std::move(inside);
        }
    }

    void addPoints(const std::vector<std::vector<Coordinates>>& ring) {
        const std::vector<Coordinates>& longer = ring[0].size() > ring[1].size() ? ring[0] : ring[1];
        if (ring[0].size() == 1 || ring[1].size() == 1)  // a line or a point
            made_.insert(made_.end(), longer.begin(), longer.end());
        else
            for (const std::vector<Coordinates>& edge : ring)
                made_.insert(made_.end(), edge.begin(), edge.end() - 1);
    }

    /// Triangles between an edge and the first one inside, whose levels differ: the parts of both are merged
    /// by where they begin, in the second half the other way round.
    void merge(const std::vector<Coordinates>& outside, const Division& outer,
               const std::vector<Coordinates>& inside, const Division& inner) {
        std::size_t o = 0, i = 0;
        const auto outerPart = [&](bool isMiddle = false) {
            if (isMiddle)
                triangle(inside[i], outside[o], outside[o + 1]);
            else
                triangle(outside[o], outside[o + 1], inside[i]);
            ++o;
        };
        const auto innerPart = [&] {
            triangle(inside[i], outside[o], inside[i + 1]);
            ++i;
        };
        const std::vector<int> outerPlaces = outer.beginnings(), innerPlaces = inner.beginnings();
        std::vector<bool> isOuter;
        auto next = innerPlaces.empty() ? innerPlaces.end() : innerPlaces.begin() + 1;  // one ring further in
        for (const int place : outerPlaces) {
            for (; next != innerPlaces.end() && *next <= place; ++next) isOuter.push_back(false);
            isOuter.push_back(true);
        }
        isOuter.insert(isOuter.end(), static_cast<std::size_t>(innerPlaces.end() - next), false);
        for (const bool each : isOuter) each ? outerPart() : innerPart();
        if (inner.isOdd()) innerPart();
        if (outer.isOdd()) outerPart(true);
        for (const bool each : std::views::reverse(isOuter)) each ? outerPart() : innerPart();
    }

    /// Triangles between two rings inside. The diagonals lean towards the middle.
    void join(const std::vector<Coordinates>& outside, const std::vector<Coordinates>& inside) {
        const std::size_t quads = inside.size() - 1;
        triangle(outside[0], outside[1], inside[0]);
        for (std::size_t i = 1; i <= quads; ++i)
            if (i <= (quads + 1) / 2) {
                triangle(outside[i], inside[i], inside[i - 1]);
                triangle(outside[i], outside[i + 1], inside[i]);
            } else {
                triangle(inside[i - 1], outside[i], outside[i + 1]);
                triangle(inside[i - 1], outside[i + 1], inside[i]);
            }
        triangle(outside[quads + 1], outside[quads + 2], inside[quads]);
    }

    /// The row of quads inside of the last ring.
    void centreOfQuads(const std::vector<std::vector<Coordinates>>& ring) {
        const std::size_t across = ring[1].size(), down = ring[0].size();
        if (across > down)
            for (std::size_t i = 0; i + 1 < across; ++i) {
                const Coordinates &above = ring[3][across - 1 - i], &next = ring[3][across - 2 - i];
                triangle(above, ring[1][i], ring[1][i + 1]);
                triangle(above, ring[1][i + 1], next);
            }
        else
            for (std::size_t i = 0; i + 1 < down; ++i) {
                const Coordinates &left = ring[0][i], &leftNext = ring[0][i + 1];
                const Coordinates &right = ring[2][down - 1 - i], &rightNext = ring[2][down - 2 - i];
                if (2 * (i + 1) == down) {
                    triangle(left, rightNext, right);
                    triangle(left, leftNext, rightNext);
                } else {
                    if (down % 2 == 0)
                        triangle(left, leftNext, right);
                    else
                        triangle(right, left, leftNext);
                    triangle(right, leftNext, rightNext);
                }
            }
    }

    const TessellationLayout& layout_;
    std::vector<Coordinates> made_;
};

}  // namespace

std::vector<std::array<float, 3>> tessellate(const base::TessellationLayout& layout,
                                             const std::array<float, 6>& levels) {
    const int used = layout.domain == Domain::quads ? 4 : layout.domain == Domain::triangles ? 3 : 2;
    if (!std::all_of(levels.begin(), levels.begin() + used, [](float each) { return each > 0; })) return {};
    DividedPatch patch(layout);
    switch (layout.domain) {
        case Domain::quads:
            patch.quads(levels);
            break;
        case Domain::triangles:
            patch.triangles(levels);
            break;
        case Domain::isolines:
            patch.isolines(levels);
            break;
    }
    return patch.take();
}

}  // namespace glibra::geometry
