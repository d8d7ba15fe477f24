#include "geometry/shapes/clouds.h"

#include <cassert>
#include <utility>

#include "geometry/mix.h"
#include "geometry/shapes/surface.h"

namespace glibra::geometry {
namespace {

double gridPlace(int i, int n) {
    return n == 1 ? 0 : -1 + 2 * static_cast<double>(i) / (n - 1);
}

/// Calls displace(point, q) for every grid point, where q is its number, and adds the point that it returns.
template <class Displace>
Mesh cloud(int nx, int ny, int nz, Displace displace) {
    assert(nx >= 1 && ny >= 1 && nz >= 1);
    Surface surface(Topology::points, 3, cloudCounts(nx, ny, nz));
    for (int k = 0; k < nz; ++k)
        for (int j = 0; j < ny; ++j)
            for (int i = 0; i < nx; ++i) {
                const std::uint32_t q = surface.size();
                const glm::dvec3 place =
                    displace(glm::dvec3{gridPlace(i, nx), gridPlace(j, ny), gridPlace(k, nz)}, q);
                surface.add({.position = place, .texCoord = (place + 1.0) / 2.0});
                surface.point(q);
            }
    return std::move(surface).finish();
}

double reflected(double place) {
    if (place > 1) return 2 - place;
    if (place < -1) return -2 - place;
    return place;
}

}  // namespace

Mesh pointCloud(int nx, int ny, int nz) {
    return cloud(nx, ny, nz, [](const glm::dvec3& place, std::uint32_t) { return place; });
}

Mesh jitterCloud(int nx, int ny, int nz, std::uint32_t seed) {
    const auto cell = [](int n) { return n == 1 ? 2. : 2. / (n - 1); };
    const glm::dvec3 size{cell(nx), cell(ny), cell(nz)};
    return cloud(nx, ny, nz, [&](glm::dvec3 place, std::uint32_t q) {
        const std::uint32_t base = mix(q + 0x9e3779b9U * (seed + 1));
        for (std::uint32_t axis = 0; axis < 3; ++axis) {
            const double u = static_cast<double>(mix(base + axis) >> 8) / 0x1p24;
            const auto a = static_cast<int>(axis);
            place[a] = reflected(place[a] + (u - .5) * size[a]);
        }
        return place;
    });
}

namespace {

constexpr ShapeArgument kPointsAlongX = countArgument("nx", 10, 1),
                        kPointsAlongY = countArgument("ny", 10, 1),
                        kPointsAlongZ = countArgument("nz", 10, 1);
constexpr ShapeArgument kPointArguments[] = {kPointsAlongX, kPointsAlongY, kPointsAlongZ};
constexpr ShapeArgument kJitterArguments[] = {
    kPointsAlongX,
    kPointsAlongY,
    kPointsAlongZ,
    {.name = "seed", .kind = ArgumentKind::seed, .byDefault = 0, .least = -0x1p31, .most = 0x1p32 - 1}};

Counts countsOf(Numbers n) {
    return cloudCounts(countAt(n, 0), countAt(n, 1), countAt(n, 2));
}

}  // namespace

constexpr PrimitiveSpec kPointCloudRow{
    .names = {"PointCloud"},
    .arguments = kPointArguments,
    .summary = "regular grid of points",
    .topology = Topology::points,
    .counts = countsOf,
    .make = [](Numbers n) { return pointCloud(countAt(n, 0), countAt(n, 1), countAt(n, 2)); }};

constexpr PrimitiveSpec kJitterCloudRow{
    .names = {"JitterCloud"},
    .arguments = kJitterArguments,
    .summary = "grid of displaced points",
    .topology = Topology::points,
    .counts = countsOf,
    .make = [](Numbers n) {
        const auto seed = static_cast<std::uint32_t>(static_cast<std::int64_t>(n[3]));
        return jitterCloud(countAt(n, 0), countAt(n, 1), countAt(n, 2), seed);
    }};

}  // namespace glibra::geometry
