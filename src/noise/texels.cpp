// Texels of the noise textures. The sum over the corners of a cell is separable, and the rows of lattice
// points of one octave differ only by a rotation. So each octave has as many different rows as cells, and
// they are interpolated along x once for the whole texture. For each row of the lattice, a slice combines
// two of them along z; each row of texels combines two of those along y. This is done in floats; the few
// texels that floats cannot decide are computed in double. A slice depends only on its index, so the bytes
// are the same for any number of threads.

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <vector>

#include "base/parallel.h"
#include "noise/noise.h"
#include "noise/tables.h"
#include "noise/texel_rows.h"
#include "noise/weights.h"

namespace glibra::noise {
namespace {

// Computes one component of one texel in double precision: the reference for every faster method.

std::uint8_t exactByte(const tables::Octave2& table, const AxisPlace& x, const AxisPlace& y);

/// The gradients at one end of a cell along x, interpolated along y and z: a slope along x, and a level.
struct LineEnd {
    double slope, level;
};

double along(const Weights& w, double nearSlope, double farSlope) {
    return nearSlope * w.g0 + farSlope * w.g1;
}

double between(const Weights& w, double nearLevel, double farLevel) {
    return nearLevel * w.n0 + farLevel * w.n1;
}

std::uint8_t byteOf(const LineEnd& near, const LineEnd& far, const Weights& w) {
    const double noise = along(w, near.slope, far.slope) + between(w, near.level, far.level);
    return static_cast<std::uint8_t>(255 * std::clamp(0.5 + noise, 0., 1.));
}

/// floor(255 * value) of an octave at a texel's places along x, y and z.
std::uint8_t exactByte(const tables::Octave3& table, const AxisPlace& x, const AxisPlace& y,
                       const AxisPlace& z) {
    const auto cells = static_cast<std::size_t>(table.cells);
    const auto gradient = [&](std::size_t i, std::size_t j, std::size_t k) -> const std::array<double, 3>& {
        return table.gradients[(i + table.p[(j % cells + table.q[k % cells]) % cells]) % cells];
    };
    const auto mergedAlongZ = [&](std::size_t i, std::size_t j) -> std::array<double, 3> {
        const auto& near = gradient(i, j, z.cell);
        const auto& far = gradient(i, j, z.cell + 1);
        return {between(z.at, near[0], far[0]), between(z.at, near[1], far[1]), along(z.at, near[2], far[2])};
    };
    const auto lineEnd = [&](std::size_t i) -> LineEnd {
        const auto near = mergedAlongZ(i, y.cell);
        const auto far = mergedAlongZ(i, y.cell + 1);
        return {between(y.at, near[0], far[0]),
                along(y.at, near[1], far[1]) + between(y.at, near[2], far[2])};
    };
    return byteOf(lineEnd(x.cell), lineEnd(x.cell + 1), x.at);
}

std::uint8_t exactByte(const tables::Octave2& table, const AxisPlace& x, const AxisPlace& y) {
    const auto cells = static_cast<std::size_t>(table.cells);
    const auto lineEnd = [&](std::size_t i) -> LineEnd {
        const auto& near = table.gradients[(i + table.p[y.cell]) % cells];
        const auto& far = table.gradients[(i + table.p[(y.cell + 1) % cells]) % cells];
        return {between(y.at, near[0], far[0]), along(y.at, near[1], far[1])};
    };
    return byteOf(lineEnd(x.cell), lineEnd(x.cell + 1), x.at);
}

/// Several rows of n floats each.
class Rows {
  public:
    Rows(std::size_t rows, std::size_t n) : n_(n), values_(rows * n) {}
    [[nodiscard]] float* operator[](std::size_t row) { return values_.data() + row * n_; }
    [[nodiscard]] const float* operator[](std::size_t row) const { return values_.data() + row * n_; }

  private:
    std::size_t n_;
    std::vector<float> values_;
};

RowWeights inFloats(const Weights& w) {
    return {static_cast<float>(w.n0), static_cast<float>(w.n1), static_cast<float>(w.g0),
            static_cast<float>(w.g1)};
}

/// One octave of a texture with n texels per side, interpolated along x, in units. Row r comes from lattice
/// points whose gradients are rotated by r; the slopes along x are already part of the values.
template <class Table>
struct OctaveRows {
    static constexpr std::size_t kAxes = std::tuple_size_v<typename decltype(Table::gradients)::value_type>;

    const Table& table;
    std::vector<AxisPlace> places;
    std::vector<Rows> gradients;  ///< along x, y and, in 3D, z

    OctaveRows(const Table& from, int n) : table(from), places(axisPlaces(n, from.cells)) {
        const std::size_t rows = cells();
        gradients.assign(kAxes, Rows(rows, places.size()));
        for (std::size_t row = 0; row < rows; ++row)
            for (std::size_t i = 0; i < places.size(); ++i) {
                const Weights& w = places[i].at;
                const auto& near = table.gradients[(places[i].cell + row) % rows];
                const auto& far = table.gradients[(places[i].cell + 1 + row) % rows];
                gradients[0][row][i] = static_cast<float>(kUnitsPerValue * (near[0] * w.g0 + far[0] * w.g1));
                for (std::size_t axis = 1; axis < kAxes; ++axis)
                    gradients[axis][row][i] =
                        static_cast<float>(kUnitsPerValue * (near[axis] * w.n0 + far[axis] * w.n1));
            }
    }

    [[nodiscard]] std::size_t cells() const { return static_cast<std::size_t>(table.cells); }
};

template <class Table>
std::vector<OctaveRows<Table>> octaveRows(const std::array<Table, kOctaves>& tables, int n) {
    std::vector<OctaveRows<Table>> rows;
    rows.reserve(kOctaves);
    for (const Table& table : tables) rows.emplace_back(table, n);
    return rows;
}

/// Writes a row of `n` RGBA texels. `exact(octave, i)` gives a component of texel i.
template <class Exact>
void writeRow(const std::array<OctaveRow, kOctaves>& octaves, std::size_t n, std::uint8_t* row,
              const Exact& exact) {
    TexelBlock block;
    for (std::size_t begin = 0; begin < n; begin += kBlock) {
        const std::size_t count = std::min(kBlock, n - begin);
        const bool inDoubt = combineOctaves(octaves, begin, count, block);
        std::memcpy(row + 4 * begin, block.texels.data(), 4 * count);
        if (!inDoubt) continue;
        for (std::size_t i = 0; i < count; ++i)
            if (block.doubts[i] == 0)
                for (std::size_t octave = 0; octave < octaves.size(); ++octave)
                    row[4 * (begin + i) + octave] = exact(octave, begin + i);
    }
}

/// The source of a slice of one octave: the level and the slope along y for each row of the lattice.
struct SliceField {
    Rows levels, slopes;
};

void mergeAlongZ(const OctaveRows<tables::Octave3>& octave, const AxisPlace& place, SliceField& field) {
    const std::size_t cells = octave.cells(), n = octave.places.size();
    const auto& table = octave.table;
    const std::size_t near = table.q[place.cell], far = table.q[(place.cell + 1) % cells];
    const RowWeights weights = inFloats(place.at);
    for (std::size_t j = 0; j < cells; ++j) {
        const std::size_t nearRow = table.p[(j + near) % cells], farRow = table.p[(j + far) % cells];
        const auto pair = [&](std::size_t axis) -> std::array<const float*, 2> {
            return {octave.gradients[axis][nearRow], octave.gradients[axis][farRow]};
        };
        mergeRows({pair(0), pair(2), weights}, n, field.levels[j]);
        mergeLevels({pair(1), {}, weights}, n, field.slopes[j]);
    }
}

/// Calls row(octaves, rows, j, k) for every row of texels of a 3D texture.
template <class Row>
void forEachRow3(int n, int threads, const Row& row) {
    const auto size = static_cast<std::size_t>(n);
    const auto octaves = octaveRows(tables::kOctaves3, n);
    base::forEachIndex(size, threads, [&](std::size_t k) {
        std::vector<SliceField> fields;
        for (const auto& octave : octaves) {
            fields.push_back({Rows(octave.cells(), size), Rows(octave.cells(), size)});
            mergeAlongZ(octave, octave.places[k], fields.back());
        }
        for (std::size_t j = 0; j < size; ++j) {
            std::array<OctaveRow, kOctaves> rows;
            for (std::size_t octave = 0; octave < rows.size(); ++octave) {
                const AxisPlace& place = octaves[octave].places[j];
                const SliceField& field = fields[octave];
                const std::size_t next = (place.cell + 1) % octaves[octave].cells();
                rows[octave] = {{field.levels[place.cell], field.levels[next]},
                                {field.slopes[place.cell], field.slopes[next]},
                                inFloats(place.at)};
            }
            row(octaves, rows, j, k);
        }
    });
}

/// Calls row(octaves, rows, j) for every row of texels of a 2D texture.
template <class Row>
void forEachRow2(int n, int threads, const Row& row) {
    const auto octaves = octaveRows(tables::kOctaves2, n);
    base::forEachIndex(static_cast<std::size_t>(n), threads, [&](std::size_t j) {
        std::array<OctaveRow, kOctaves> rows;
        for (std::size_t octave = 0; octave < rows.size(); ++octave) {
            const auto& from = octaves[octave];
            const AxisPlace& place = from.places[j];
            const std::size_t near = from.table.p[place.cell],
                              far = from.table.p[(place.cell + 1) % from.cells()];
            rows[octave] = {{from.gradients[0][near], from.gradients[0][far]},
                            {from.gradients[1][near], from.gradients[1][far]},
                            inFloats(place.at)};
        }
        row(octaves, rows, j);
    });
}

/// Writes a row of `n` RGBA texels of 16 bits. The error of the floats is at most 1/30 of a step.
void writeShorts(const std::array<OctaveRow, kOctaves>& octaves, std::size_t n, std::vector<float>& sum,
                 std::uint16_t* row) {
    constexpr double kStepsPerUnit = 65535 / kUnitsPerValue;
    constexpr auto kScale = static_cast<float>(kStepsPerUnit);
    constexpr auto kMiddle =
        static_cast<float>(65535 / 2. - 257 / 2. + .5);  // .5: truncation becomes rounding
    sum.resize(n);
    for (std::size_t octave = 0; octave < octaves.size(); ++octave) {
        mergeRows(octaves[octave], n, sum.data());
        for (std::size_t i = 0; i < n; ++i)
            row[4 * i + octave] = static_cast<std::uint16_t>(static_cast<int>(kMiddle + kScale * sum[i]));
    }
}

/// The numbers of the texture of size n, four per texel; 0 if n is out of range.
std::size_t numbersOf3(int n) {
    const auto size = static_cast<std::size_t>(n);
    return n < 1 || n > kLargestSize3 ? 0 : 4 * size * size * size;
}
std::size_t numbersOf2(int n) {
    const auto size = static_cast<std::size_t>(n);
    return n < 1 || n > kLargestSize2 ? 0 : 4 * size * size;
}

}  // namespace

bool writeNoise3(int n, std::span<std::uint8_t> texels, int threads) {
    if (texels.empty() || texels.size() != numbersOf3(n)) return false;
    const auto size = static_cast<std::size_t>(n);
    forEachRow3(n, threads, [&](const auto& octaves, const auto& rows, std::size_t j, std::size_t k) {
        writeRow(rows, size, texels.data() + 4 * size * (j + size * k),
                 [&](std::size_t octave, std::size_t i) {
                     const auto& places = octaves[octave].places;
                     return exactByte(octaves[octave].table, places[i], places[j], places[k]);
                 });
    });
    return true;
}

bool writeNoise2(int n, std::span<std::uint8_t> texels, int threads) {
    if (texels.empty() || texels.size() != numbersOf2(n)) return false;
    const auto size = static_cast<std::size_t>(n);
    forEachRow2(n, threads, [&](const auto& octaves, const auto& rows, std::size_t j) {
        writeRow(rows, size, texels.data() + 4 * size * j, [&](std::size_t octave, std::size_t i) {
            const auto& places = octaves[octave].places;
            return exactByte(octaves[octave].table, places[i], places[j]);
        });
    });
    return true;
}

TexelBytes noise3Texels(int n, int threads) {
    TexelBytes texels(numbersOf3(n));
    writeNoise3(n, texels, threads);
    return texels;
}

TexelBytes noise2Texels(int n, int threads) {
    TexelBytes texels(numbersOf2(n));
    writeNoise2(n, texels, threads);
    return texels;
}

TexelShorts noise3Shorts(int n, int threads) {
    TexelShorts texels(numbersOf3(n));
    if (texels.empty()) return texels;
    const auto size = static_cast<std::size_t>(n);
    forEachRow3(n, threads, [&](const auto&, const auto& rows, std::size_t j, std::size_t k) {
        thread_local std::vector<float> sum;
        writeShorts(rows, size, sum, texels.data() + 4 * size * (j + size * k));
    });
    return texels;
}

TexelShorts noise2Shorts(int n, int threads) {
    TexelShorts texels(numbersOf2(n));
    if (texels.empty()) return texels;
    const auto size = static_cast<std::size_t>(n);
    forEachRow2(n, threads, [&](const auto&, const auto& rows, std::size_t j) {
        thread_local std::vector<float> sum;
        writeShorts(rows, size, sum, texels.data() + 4 * size * j);
    });
    return texels;
}

}  // namespace glibra::noise
