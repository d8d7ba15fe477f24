#include "geometry/obj/shapefile.h"

#include <fmt/format.h>

#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <optional>
#include <utility>

#include "base/text.h"
#include "geometry/obj/obj_model.h"

namespace glibra::geometry {
namespace {

constexpr std::size_t kHeaderLength = 100, kRecordHeaderLength = 8, kBoxLength = 32, kRangeLength = 16;

/// The shape type is kind + 10 with z, or kind + 20 with measures only.
enum ShapeKind : std::uint32_t {
    kNull = 0,
    kPoint = 1,
    kPolyline = 3,
    kPolygon = 5,
    kMultipoint = 8,
    kMultipatch = 31
};

struct ShapeType {
    std::uint32_t kind = kNull;
    bool hasZ = false;
    [[nodiscard]] bool isPoints() const { return kind == kPoint || kind == kMultipoint; }
};

std::optional<ShapeType> shapeType(std::uint32_t code) {
    if (code == kNull || code == kMultipatch) return ShapeType{code, false};
    const ShapeType type{code % 10, code / 10 == 1};
    const bool isKnown =
        type.kind == kPoint || type.kind == kPolyline || type.kind == kPolygon || type.kind == kMultipoint;
    if (!isKnown || code >= 30) return std::nullopt;
    return type;
}

/// The bytes of a file or of one record. Callers check with `holds` before they read.
class Bytes {
  public:
    explicit Bytes(std::span<const std::byte> bytes) : bytes_(bytes) {}
    [[nodiscard]] bool holds(std::uint64_t at, std::uint64_t length) const {
        return at <= bytes_.size() && length <= bytes_.size() - at;
    }
    [[nodiscard]] Bytes part(std::size_t at, std::size_t length) const {
        return Bytes(bytes_.subspan(at, length));
    }
    [[nodiscard]] std::uint32_t big(std::size_t at) const {
        return byte(at) << 24 | byte(at + 1) << 16 | byte(at + 2) << 8 | byte(at + 3);
    }
    [[nodiscard]] std::uint32_t little(std::size_t at) const {
        return byte(at + 3) << 24 | byte(at + 2) << 16 | byte(at + 1) << 8 | byte(at);
    }
    [[nodiscard]] double real(std::size_t at) const {
        return std::bit_cast<double>(std::uint64_t{little(at + 4)} << 32 | little(at));
    }

  private:
    [[nodiscard]] std::uint32_t byte(std::size_t at) const {
        return std::to_integer<std::uint32_t>(bytes_[at]);
    }
    std::span<const std::byte> bytes_;
};

using Point = std::array<float, 3>;

class ShapeReader {
  public:
    explicit ShapeReader(std::span<const std::byte> bytes) : file_(bytes) {}

    /// Describes what is wrong with the file; empty if nothing is.
    std::string read();
    [[nodiscard]] Mesh mesh() &&;
    [[nodiscard]] std::size_t multipatches() const { return multipatches_; }
    [[nodiscard]] bool passesLimit() const {
        return hasTooManyPoints_ || indices_.size() / (isPoints_.value_or(false) ? 1 : 2) > kMostTriangles;
    }

  private:
    std::string readRecord(const Bytes& record);
    std::string readSinglePoint(const Bytes& record, const ShapeType& type);
    std::string readPoints(const Bytes& record, const ShapeType& type);
    bool addPoint(double x, double y, double z);
    void addSegment(std::uint32_t from, std::uint32_t to) { indices_.insert(indices_.end(), {from, to}); }

    Bytes file_;
    std::optional<bool> isPoints_;  // set by the first shape; all others must be of the same kind
    std::vector<Point> points_;
    std::vector<std::uint32_t> indices_;
    std::size_t multipatches_ = 0;
    bool hasTooManyPoints_ = false;
};

std::string ShapeReader::read() {
    if (!file_.holds(0, kHeaderLength) || file_.big(0) != 9994) return "is not a shapefile";
    const std::uint64_t length = 2 * std::uint64_t{file_.big(24)};
    if (length < kHeaderLength || !file_.holds(0, length))
        return fmt::format("its header gives the length as {} bytes", base::groupedText(length));
    std::uint64_t at = kHeaderLength;
    for (std::uint64_t number = 1; at < length; ++number) {
        if (at + kRecordHeaderLength + 4 > length) return fmt::format("the data end in record {}", number);
        const std::uint64_t content = 2 * std::uint64_t{file_.big(static_cast<std::size_t>(at) + 4)};
        if (content < 4 || content > length - at - kRecordHeaderLength)
            return fmt::format("record {} gives its length as {} bytes", number, base::groupedText(content));
        const std::string fault = readRecord(file_.part(static_cast<std::size_t>(at + kRecordHeaderLength),
                                                        static_cast<std::size_t>(content)));
        if (!fault.empty()) return fmt::format("record {} {}", number, fault);
        if (passesLimit()) return {};
        at += kRecordHeaderLength + content;
    }
    return {};
}

std::string ShapeReader::readRecord(const Bytes& record) {
    const std::uint32_t code = record.little(0);
    const std::optional<ShapeType> type = shapeType(code);
    if (!type) return fmt::format("has the unknown shape type {}", code);
    if (type->kind == kNull) return {};
    if (type->kind == kMultipatch) {
        ++multipatches_;
        return {};
    }
    if (isPoints_.value_or(type->isPoints()) != type->isPoints()) return "mixes points and lines";
    isPoints_ = type->isPoints();
    return type->kind == kPoint ? readSinglePoint(record, *type) : readPoints(record, *type);
}

std::string ShapeReader::readSinglePoint(const Bytes& record, const ShapeType& type) {
    if (!record.holds(4, type.hasZ ? 24 : 16)) return "is too short";
    if (!addPoint(record.real(4), record.real(12), type.hasZ ? record.real(20) : 0))
        return "has a coordinate that is not a number";
    return {};
}

/// Multipoints: box, number of points, points. Polylines and polygons: box, number of parts, number of
/// points, first point of each part, points. With z: its range and values follow.
std::string ShapeReader::readPoints(const Bytes& record, const ShapeType& type) {
    const std::size_t countsAt = 4 + kBoxLength;
    const bool hasParts = !type.isPoints();
    if (!record.holds(countsAt, hasParts ? 8 : 4)) return "is too short";
    const std::uint64_t parts = hasParts ? record.little(countsAt) : 0;
    const std::uint64_t count = record.little(countsAt + (hasParts ? 4 : 0));
    const std::uint64_t partsAt = countsAt + (hasParts ? 8 : 4);
    const std::uint64_t pointsAt = partsAt + 4 * parts;
    const std::uint64_t zAt = pointsAt + 16 * count + kRangeLength;
    if (!record.holds(pointsAt, 16 * count) || (type.hasZ && !record.holds(zAt, 8 * count)))
        return fmt::format("is too short for its {} points", base::groupedText(count));

    // Each segment adds two points.
    hasTooManyPoints_ = points_.size() + count > 2 * kMostTriangles;
    if (hasTooManyPoints_) return {};
    const auto first = static_cast<std::uint32_t>(points_.size());
    for (std::uint64_t i = 0; i < count; ++i) {
        const auto at = static_cast<std::size_t>(pointsAt + 16 * i);
        const double z = type.hasZ ? record.real(static_cast<std::size_t>(zAt + 8 * i)) : 0;
        if (!addPoint(record.real(at), record.real(at + 8), z))
            return "has a coordinate that is not a number";
    }
    const auto partStart = [&](std::uint64_t part) {
        return part == parts ? count : record.little(static_cast<std::size_t>(partsAt + 4 * part));
    };
    for (std::uint64_t part = 0; part < parts; ++part) {
        const std::uint64_t begin = partStart(part), end = partStart(part + 1);
        if (begin > end || end > count) return fmt::format("has a part that begins at point {}", end);
        const std::uint32_t a = first + static_cast<std::uint32_t>(begin),
                            b = first + static_cast<std::uint32_t>(end);
        for (std::uint32_t i = a; i + 1 < b; ++i) addSegment(i, i + 1);
        if (type.kind == kPolygon && b > a + 1 && points_[b - 1] != points_[a]) addSegment(b - 1, a);
    }
    return {};
}

/// Returns false if a coordinate is not finite as a float.
bool ShapeReader::addPoint(double x, double y, double z) {
    constexpr double kLargest = std::numeric_limits<float>::max();
    for (const double coordinate : {x, y, z})
        if (!(std::abs(coordinate) <= kLargest)) return false;
    if (isPoints_.value_or(false)) indices_.push_back(static_cast<std::uint32_t>(points_.size()));
    points_.push_back({static_cast<float>(x), static_cast<float>(y), static_cast<float>(z)});
    return true;
}

Mesh ShapeReader::mesh() && {
    Mesh mesh;
    mesh.topology = isPoints_.value_or(false) ? Topology::points : Topology::lines;
    Attribute position{std::string(kPosition), 3, {}}, normal{std::string(kNormal), 3, {}},
        tangent{std::string(kTangent), 3, {}};
    for (Attribute* each : {&position, &normal, &tangent}) each->values.reserve(3 * points_.size());
    for (const Point& point : points_) {
        position.values.insert(position.values.end(), point.begin(), point.end());
        normal.values.insert(normal.values.end(), {0, 0, 1});
        tangent.values.insert(tangent.values.end(), {0, 1, 0});
    }
    mesh.attributes = {std::move(position), std::move(normal), std::move(tangent)};
    mesh.indices = std::move(indices_);
    if (mesh.topology == Topology::points) mesh.pointCount = mesh.indices.size();
    return mesh;
}

}  // namespace

Result<Mesh> parseShp(std::span<const std::byte> bytes, std::string path) {
    const Place place{path, 1, 1};
    const auto failure = [&](std::string id, std::string_view what) {
        return diagnose(std::move(id), fmt::format("'{}': {}", fileName(path), what), place);
    };
    if (bytes.size() > kLargestModelFile)
        return failure("file-E09", fmt::format("{}, the limit is {}", base::readableBytes(bytes.size()),
                                               base::readableBytes(kLargestModelFile)));
    ShapeReader reader(bytes);
    if (const std::string fault = reader.read(); !fault.empty()) return failure("file-E04", fault);
    if (reader.passesLimit())
        return failure("file-E09",
                       fmt::format("more than {} segments or points", base::groupedText(kMostTriangles)));
    Diagnostics remarks;
    if (const std::size_t skipped = reader.multipatches(); skipped > 0)
        remarks.push_back(
            diagnose("file-W11", base::countedInGroups(skipped, "multipatch shape") + " skipped", place));
    return {std::move(reader).mesh(), std::move(remarks)};
}

}  // namespace glibra::geometry
