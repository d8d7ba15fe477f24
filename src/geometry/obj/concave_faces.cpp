#include "geometry/obj/concave_faces.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <tuple>
#include <utility>

#include "base/parallel.h"

namespace glibra::geometry {
namespace {

glm::dvec3 wide(const Triple& point) {
    return {point[0], point[1], point[2]};
}

/// The sign of a sum whose terms are exact in double: the sum grows as an expansion of parts that do not
/// overlap, the last of which has its sign (J. Shewchuk, Adaptive precision floating-point arithmetic and
/// fast robust geometric predicates, 1997).
int signOfSum(const std::array<double, 6>& terms) {
    std::array<double, 6> parts{};
    std::size_t count = 0;
    for (const double term : terms) {
        double carried = term;
        for (std::size_t i = 0; i < count; ++i) {
            const double sum = carried + parts[i];
            const double virtualPart = sum - carried;
            parts[i] = (carried - (sum - virtualPart)) + (parts[i] - virtualPart);
            carried = sum;
        }
        parts[count++] = carried;
    }
    while (count > 0 && parts[count - 1] == 0) --count;
    return count == 0 ? 0 : parts[count - 1] > 0 ? 1 : -1;
}

}  // namespace

/// The axis to which a vector is nearest: 0, 1, 2 for x, y, z. Of axes that are about equally near, the last.
static int nearestAxis(const glm::dvec3& vector) {
    // Polygons in a plane at 45 degrees are all seen along the same axis, whatever rounding says.
    constexpr double kClearly = 1.01;
    int axis = 2;
    for (const int other : {1, 0})
        if (std::abs(vector[other]) > kClearly * std::abs(vector[axis])) axis = other;
    return axis;
}

int orientation(PlanePoint a, PlanePoint b, PlanePoint c) {
    const double ax = a.x, ay = a.y, bx = b.x, by = b.y, cx = c.x, cy = c.y;
    const double left = (ax - cx) * (by - cy), right = (ay - cy) * (bx - cx);
    constexpr double kError = 4e-16;  // (3 + 16 e) e with e = 2^-53, in the same paper
    const double error = kError * (std::abs(left) + std::abs(right));
    if (left - right > error) return 1;
    if (right - left > error) return -1;
    // Multiplied out, because products of two floats are exact in double.
    return signOfSum({ax * by, -(ay * bx), bx * cy, -(by * cx), cx * ay, -(cy * ax)});
}

/// The polygon seen along the x, y or z axis: the one to which its area vector is nearest. A polygon without
/// an area vector, as a bow tie, is seen along the axis along which its turns are widest.
static std::vector<PlanePoint> planeOutline(std::span<const Triple> polygon) {
    const std::size_t count = polygon.size();
    glm::dvec3 area(0), turns(0);
    const glm::dvec3 origin = wide(polygon[0]);
    for (std::size_t i = 0; i < count; ++i) {
        const glm::dvec3 a = wide(polygon[i]), b = wide(polygon[(i + 1) % count]);
        area += glm::cross(a - origin, b - origin);
        turns += glm::abs(glm::cross(b - a, wide(polygon[(i + 2) % count]) - b));
    }
    constexpr double kRounding = 1e-6;
    const bool hasArea = glm::length(area) > kRounding * glm::length(turns);
    const int axis = nearestAxis(hasArea ? area : turns);
    const auto x = static_cast<std::size_t>((axis + 1) % 3), y = static_cast<std::size_t>((axis + 2) % 3);
    std::vector<PlanePoint> points;
    points.reserve(count);
    for (const Triple& each : polygon) points.push_back({each[x], each[y]});
    return points;
}

namespace {

/// 1, -1: the outline encloses its area counterclockwise, clockwise; 0 if it has none.
int windingOf(const std::vector<PlanePoint>& points) {
    double area = 0, size = 0;
    for (std::size_t i = 0; i < points.size(); ++i) {
        const PlanePoint a = points[i], b = points[i + 1 == points.size() ? 0 : i + 1];
        const double across = static_cast<double>(a.x) * b.y, back = static_cast<double>(a.y) * b.x;
        area += across - back;
        size += std::abs(across) + std::abs(back);
    }
    if (std::abs(area) > 1e-9 * size) return area > 0 ? 1 : -1;
    // Rounding may decide the sum of a thin outline far from the origin. The turn at an outermost corner is
    // exact.
    const auto before = [](PlanePoint a, PlanePoint b) {
        return std::tuple(a.x, a.y) < std::tuple(b.x, b.y);
    };
    const std::size_t outermost =
        static_cast<std::size_t>(std::ranges::min_element(points, before) - points.begin());
    const std::size_t count = points.size();
    std::size_t next = outermost, previous = outermost;
    for (std::size_t i = 1; i < count && points[next] == points[outermost]; ++i)
        next = (outermost + i) % count;
    for (std::size_t i = 1; i < count && points[previous] == points[outermost]; ++i)
        previous = (outermost + count - i) % count;
    return orientation(points[previous], points[outermost], points[next]);
}

/// One corner of what is left of an outline.
struct RingCorner {
    std::size_t previous = 0, next = 0;
    bool isCut = false;
    bool isConvex = false;  ///< turns left
};

/// An outline that is being cut up. Its corners are numbered counterclockwise from a corner that does not
/// depend on how the polygon is written.
class Remains {
  public:
    Remains(std::vector<PlanePoint> points, std::size_t& work) : points_(std::move(points)), work_(work) {
        const std::size_t count = points_.size();
        corners_.resize(count);
        for (std::size_t i = 0; i < count; ++i)
            corners_[i] = {(i + count - 1) % count, (i + 1) % count, false, false};
        for (std::size_t i = 0; i < count; ++i) corners_[i].isConvex = turnAt(i) > 0;
        for (std::size_t i = 0; i < count; ++i)
            if (!corners_[i].isConvex) reflex_.push_back(i);
        std::ranges::sort(reflex_, [&](std::size_t a, std::size_t b) { return isBefore(a, b); });
        reflexLeft_ = reflex_.size();
    }

    /// Calls `ear(a, b, c)` for each triangle. False if the work is too much.
    template <class Ear>
    bool cut(Ear ear) {
        std::size_t left = points_.size(), at = 0;
        // A corner that is written twice has no place of its own.
        for (std::size_t n = points_.size(); n > 0 && left > 3; --n) {
            if (isTooMuch()) return false;
            const std::size_t next = corners_[at].next;
            if (points_[at] == points_[next]) {
                ear(corners_[at].previous, at, next);
                cutOff(at);
                --left;
            }
            at = next;
        }
        std::size_t last = at;
        int rule = 0;
        while (left > 3) {
            if (isTooMuch()) return false;
            const std::size_t before = corners_[at].previous, after = corners_[at].next;
            if (isEar(at, rule)) {
                ear(before, at, after);
                cutOff(at);
                --left;
                // Every second corner first: the triangles become less narrow.
                at = last = corners_[after].next;
                rule = 0;
                continue;
            }
            at = after;
            // Outlines that touch or cross themselves may have no ear by the stricter rules.
            if (at == last) ++rule;
        }
        ear(corners_[at].previous, at, corners_[at].next);
        return true;
    }

  private:
    [[nodiscard]] bool isTooMuch() const { return work_ > EarCutter::kMostWork; }

    /// The order of reflex_: by x, then by number.
    [[nodiscard]] bool isBefore(std::size_t a, std::size_t b) const {
        return points_[a].x < points_[b].x || (points_[a].x == points_[b].x && a < b);
    }

    [[nodiscard]] int turnAt(std::size_t corner) const {
        const RingCorner& each = corners_[corner];
        return orientation(points_[each.previous], points_[corner], points_[each.next]);
    }

    /// Rules: 0, nothing else touches the triangle; 1, nothing is inside of it; 2, it has no area; 3, it is
    /// convex; 4, any.
    bool isEar(std::size_t at, int rule) {
        ++work_;
        if (rule >= 4) return true;
        if (rule == 2) return turnAt(at) == 0;
        if (!corners_[at].isConvex) return false;
        return rule == 3 || !holdsCorner(at, rule == 0);
    }

    bool holdsCorner(std::size_t at, bool withEdges) {
        constexpr std::size_t kOrientations = 8;  // as much work as comparing boxes
        const PlanePoint a = points_[corners_[at].previous], b = points_[at], c = points_[corners_[at].next];
        const float left = std::min({a.x, b.x, c.x}), right = std::max({a.x, b.x, c.x});
        const float low = std::min({a.y, b.y, c.y}), high = std::max({a.y, b.y, c.y});
        // An outline that enters a triangle has a corner there that turns right, or that lies on a line.
        auto each = std::lower_bound(reflex_.begin(), reflex_.end(), left,
                                     [&](std::size_t i, float x) { return points_[i].x < x; });
        for (; each != reflex_.end() && points_[*each].x <= right; ++each) {
            ++work_;
            const PlanePoint p = points_[*each];
            if (p.y < low || p.y > high || corners_[*each].isCut || corners_[*each].isConvex) continue;
            if (p == a || p == b || p == c) continue;
            work_ += kOrientations;
            const int least = withEdges ? 0 : 1;
            if (orientation(a, b, p) >= least && orientation(b, c, p) >= least &&
                orientation(c, a, p) >= least)
                return true;
        }
        return false;
    }

    void cutOff(std::size_t at) {
        const std::size_t before = corners_[at].previous, after = corners_[at].next;
        if (!corners_[at].isConvex) --reflexLeft_;
        corners_[at].isCut = true;
        corners_[before].next = after;
        corners_[after].previous = before;
        for (const std::size_t each : {before, after}) {
            const bool was = corners_[each].isConvex, is = turnAt(each) > 0;
            corners_[each].isConvex = is;
            if (is && !was) --reflexLeft_;
            // Only outlines that touch or cross themselves lose a convex corner.
            if (was && !is) enter(each);
        }
        if (2 * reflexLeft_ + 16 < reflex_.size())
            std::erase_if(reflex_,
                          [&](std::size_t each) { return corners_[each].isCut || corners_[each].isConvex; });
    }

    void enter(std::size_t corner) {
        ++reflexLeft_;
        const auto place = std::ranges::lower_bound(
            reflex_, corner, [&](std::size_t a, std::size_t b) { return isBefore(a, b); });
        if (place != reflex_.end() && *place == corner) return;  // it is still there
        work_ += reflex_.size() / 64;                            // the others move
        reflex_.insert(place, corner);
    }

    std::vector<PlanePoint> points_;
    std::vector<RingCorner> corners_;
    std::vector<std::size_t> reflex_;  ///< that turn right or lie on a line, in order; some of them no longer
    std::size_t reflexLeft_ = 0;       ///< of these those that still do
    std::size_t& work_;
};

/// The corners of an outline in the order in which they are cut up.
std::vector<std::uint32_t> canonicalOrder(std::span<const Triple> outline, int winding) {
    const std::size_t count = outline.size();
    // Of equal corners, the one whose neighbours are least.
    const auto neighbours = [&](std::size_t i) {
        return std::minmax(outline[(i + 1) % count], outline[(i + count - 1) % count]);
    };
    std::size_t first = 0;
    for (std::size_t i = 1; i < count; ++i)
        if (outline[i] < outline[first] ||
            (outline[i] == outline[first] && neighbours(i) < neighbours(first)))
            first = i;
    const bool isForward =
        winding != 0 ? winding > 0 : outline[(first + 1) % count] < outline[(first + count - 1) % count];
    std::vector<std::uint32_t> order;
    order.reserve(count);
    for (std::size_t i = 0; i < count; ++i)
        order.push_back(
            static_cast<std::uint32_t>(isForward ? (first + i) % count : (first + count - i) % count));
    return order;
}

/// True only for a polygon of four corners whose fan has two triangles of the same orientation beyond all
/// rounding. Most faces with more than three corners are such.
bool isClearQuad(std::span<const Triple> outline) {
    if (outline.size() != 4) return false;
    std::array<glm::dvec3, 3> to;
    for (std::size_t i = 0; i < 3; ++i)
        for (int axis = 0; axis < 3; ++axis)
            to[i][axis] = static_cast<double>(outline[i + 1][static_cast<std::size_t>(axis)]) -
                          outline[0][static_cast<std::size_t>(axis)];
    const glm::dvec3 first = glm::cross(to[0], to[1]), second = glm::cross(to[1], to[2]);
    const int axis = nearestAxis(first + second);
    const double least = 1e-12 * (glm::dot(to[0], to[0]) + glm::dot(to[1], to[1]) + glm::dot(to[2], to[2]));
    return (first[axis] > least && second[axis] > least) || (first[axis] < -least && second[axis] < -least);
}

}  // namespace

bool isFan(std::span<const Triple> outline) {
    if (outline.size() < 4 || isClearQuad(outline)) return true;
    const std::vector<PlanePoint> points = planeOutline(outline);
    const PlanePoint origin = points[0];
    int turn = 0;
    PlanePoint reference = origin;  // the first other corner
    bool isBeyond = false;          // more than half a turn from there
    for (std::size_t i = 1; i < points.size(); ++i) {
        const PlanePoint p = points[i];
        if (reference == origin) {
            reference = p;
            continue;
        }
        const int step = orientation(origin, points[i - 1], p);
        if (step != 0 && turn == 0) turn = step;
        if (step * turn < 0) return false;
        // An edge that passes through the first corner
        if (step == 0) {
            const auto opposite = [](float a, float b, float o) {
                return (a < o && o < b) || (b < o && o < a);
            };
            if (opposite(points[i - 1].x, p.x, origin.x) || opposite(points[i - 1].y, p.y, origin.y))
                return false;
        }
        if (p == origin)  // the outline touches itself there, unless this is the first corner once more
            return std::all_of(points.begin() + static_cast<std::ptrdiff_t>(i), points.end(),
                               [&](PlanePoint each) { return each == origin; });
        const int side = orientation(origin, reference, p) * turn;
        if (isBeyond && side >= 0) return false;
        isBeyond = isBeyond || side < 0;
    }
    return true;
}

bool EarCutter::cut(std::span<const Triple> outline, std::vector<std::uint32_t>& triangles) {
    const std::size_t count = outline.size(), had = triangles.size();
    const std::vector<PlanePoint> points = planeOutline(outline);
    const std::vector<std::uint32_t> order = canonicalOrder(outline, windingOf(points));
    const bool isForward = order[1] == (order[0] + 1) % count;
    std::vector<PlanePoint> ordered;
    ordered.reserve(count);
    for (const std::uint32_t each : order) ordered.push_back(points[each]);
    work_ += count;
    const bool isDone =
        work_ <= kMostWork &&
        Remains(std::move(ordered), work_).cut([&](std::size_t a, std::size_t b, std::size_t c) {
            if (!isForward) std::swap(a, c);
            triangles.insert(triangles.end(), {order[a], order[b], order[c]});
        });
    if (isDone) return true;
    triangles.resize(had);
    for (std::uint32_t i = 1; i + 1 < count; ++i) triangles.insert(triangles.end(), {0, i, i + 1});
    return false;
}

std::size_t splitConcaveFaces(ObjModel& model) {
    const auto takeOutline = [&](std::size_t face, std::vector<Triple>& outline) {
        outline.clear();
        for (std::uint32_t i = model.faceStarts[face]; i < model.faceStarts[face + 1]; ++i)
            outline.push_back(model.positions[model.corners[i].position]);
    };
    // Models of triangles only are the usual ones.
    if (model.corners.size() == 3 * model.faceCount()) return 0;
    constexpr std::size_t kPiece = 16'384;
    std::vector<std::vector<std::uint32_t>> found(model.faceCount() / kPiece + 1);
    base::forEachIndex(
        found.size(), 0, [] { return std::vector<Triple>(); },
        [&](std::size_t piece, std::vector<Triple>& outline) {
            const std::size_t end = std::min(model.faceCount(), (piece + 1) * kPiece);
            for (std::size_t face = piece * kPiece; face < end; ++face) {
                if (model.faceStarts[face + 1] - model.faceStarts[face] <= 3) continue;
                takeOutline(face, outline);
                if (!isFan(outline)) found[piece].push_back(static_cast<std::uint32_t>(face));
            }
        });
    std::size_t uncut = 0;
    EarCutter cutter;
    std::vector<Triple> outline;
    for (const std::vector<std::uint32_t>& piece : found)
        for (const std::uint32_t face : piece) {
            takeOutline(face, outline);
            model.splitFaces.push_back(face);
            if (!cutter.cut(outline, model.splitTriangles)) ++uncut;
        }
    return uncut;
}

}  // namespace glibra::geometry
