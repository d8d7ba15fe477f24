#include "image/cube_map.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <numbers>

#include "image/convert.h"

namespace glibra::image {
namespace {

using Color = std::array<double, 4>;

TexelBlock emptyCube(int side, Component type) {
    TexelBlock cube;
    cube.faces = 6;
    cube.width = cube.height = side;
    cube.type = type;
    const auto texels = static_cast<std::size_t>(side) * static_cast<std::size_t>(side) * 6;
    cube.data.resize(texels * 4 * bytesOf(type));
    return cube;
}

TexelBlock cubeOfCross(const Image& cross) {
    struct Cell {
        int column, row;
    };
    constexpr std::array<Cell, 6> kCells{{{2, 1}, {0, 1}, {1, 0}, {1, 2}, {1, 1}, {3, 1}}};
    const int side = cross.width / 4;
    TexelBlock cube = emptyCube(side, cross.type);
    const std::size_t rowBytes = static_cast<std::size_t>(side) * 4 * bytesOf(cross.type);
    std::byte* to = cube.data.data();
    for (const Cell& cell : kCells)
        for (int y = 0; y < side; ++y, to += rowBytes)
            std::memcpy(
                to, cross.row(cell.row * side + y).data() + static_cast<std::size_t>(cell.column) * rowBytes,
                rowBytes);
    return cube;
}

/// A picture of RGBA floats around the viewer.
class Panorama {
  public:
    explicit Panorama(const Image& floats) : image_(floats) {}

    /// `direction` need not be normalised.
    [[nodiscard]] Color at(const std::array<double, 3>& direction) const {
        const auto [x, y, z] = direction;
        const double length = std::sqrt(x * x + y * y + z * z);
        const double u = .5 + std::atan2(x, -z) / (2 * std::numbers::pi);
        const double v = std::acos(std::clamp(y / length, -1., 1.)) / std::numbers::pi;
        return bilinear(u * image_.width - .5, v * image_.height - .5);
    }

  private:
    [[nodiscard]] Color texel(long x, long y) const {
        const long width = image_.width;
        x = (x % width + width) % width;
        y = std::clamp(y, 0L, static_cast<long>(image_.height) - 1);
        std::array<float, 4> value{};
        std::memcpy(value.data(),
                    image_.row(static_cast<int>(y)).data() + static_cast<std::size_t>(x) * sizeof value,
                    sizeof value);
        return {value[0], value[1], value[2], value[3]};
    }
    [[nodiscard]] Color bilinear(double x, double y) const {
        const double left = std::floor(x), top = std::floor(y);
        Color sum{};
        for (int i = 0; i < 4; ++i) {
            const double weight =
                (i % 2 == 1 ? x - left : 1 - (x - left)) * (i / 2 == 1 ? y - top : 1 - (y - top));
            const Color one = texel(static_cast<long>(left) + i % 2, static_cast<long>(top) + i / 2);
            for (std::size_t c = 0; c < 4; ++c) sum[c] += weight * one[c];
        }
        return sum;
    }
    const Image& image_;
};

TexelBlock cubeOfPanorama(const Image& picture) {
    const Image floats = withType(picture, Component::f32);
    const Panorama panorama(floats);
    const int side = std::max(1, picture.width / 4);
    Image faces{side, side * 6, 4, Component::f32, emptyCube(side, Component::f32).data};
    std::byte* to = faces.data.data();
    for (int face = 0; face < 6; ++face)
        for (int y = 0; y < side; ++y)
            for (int x = 0; x < side; ++x, to += 4 * sizeof(float)) {
                Color mean{};
                for (int i = 0; i < 4; ++i) {
                    const Color one = panorama.at(cubeDirection(face, (x + .25 + .5 * (i % 2)) / side,
                                                                (y + .25 + .5 * (i / 2)) / side));
                    for (std::size_t c = 0; c < 4; ++c) mean[c] += one[c] / 4;
                }
                std::array<float, 4> value{};
                std::transform(mean.begin(), mean.end(), value.begin(),
                               [](double each) { return static_cast<float>(each); });
                std::memcpy(to, value.data(), sizeof value);
            }
    TexelBlock cube = emptyCube(side, picture.type);
    cube.data = withType(faces, picture.type).data;
    return cube;
}

}  // namespace

std::array<double, 3> cubeDirection(int face, double s, double t) {
    const double a = 2 * s - 1, b = 2 * t - 1;
    switch (face) {
        case 0:
            return {1, -b, -a};
        case 1:
            return {-1, -b, a};
        case 2:
            return {a, 1, b};
        case 3:
            return {a, -1, -b};
        case 4:
            return {a, -b, 1};
        default:
            return {-a, -b, -1};
    }
}

Result<TexelBlock> readCubePicture(const base::FileSource& source, const Place& place,
                                   const ReadOptions& options) {
    Result<Image> read = readImage(source, place, options);
    if (!read) return std::move(read.diagnostics);
    const Image picture = withComponents(*read, 4);
    if (picture.width == 2 * picture.height) return {cubeOfPanorama(picture), std::move(read.diagnostics)};
    if (3 * picture.width == 4 * picture.height && picture.width % 4 == 0)
        return {cubeOfCross(picture), std::move(read.diagnostics)};
    read.diagnostics.push_back(diagnose(
        "file-E06",
        fmt::format("CubeMap: '{}' is {} x {}; one picture must be a panorama (2:1) or a cross (4:3)",
                    source.path.filename().string(), picture.width, picture.height),
        place));
    return std::move(read.diagnostics);
}

}  // namespace glibra::image
