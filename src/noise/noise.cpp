// The noise functions as language, 9 defines them. The texels below are computed from the same sums in a
// different order.

#include "noise/noise.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstring>
#include <optional>

#include "base/parallel.h"
#include "noise/tables.h"
#include "system/processors.h"

namespace glibra::noise {
namespace {

// How a texel of the noise is made of the values of its lattice.

// The four polynomials of gradient noise (language, 9.2) for t in 0..1: n0 and n1 are the weights of the
// value at the near and the far end of a cell, g0 and g1 those of the slope.

struct Weights {
    double n0, n1, g0, g1;
};

constexpr Weights weightsAt(double t) {
    const double n0 = 1 + t * t * t * (-10 + t * (15 - 6 * t));
    return {n0, 1 - n0, t * (1 + t * t * (-6 + t * (8 - 3 * t))), t * t * t * (-4 + t * (7 - 3 * t))};
}

// The positions of a texture's texels along one axis, in the cells of one octave.

struct AxisPlace {
    std::size_t cell = 0;  ///< 0..cells - 1
    Weights at{};          ///< weights at the texel's place in its cell
};

/// The positions of texels 0..n - 1.
std::vector<AxisPlace> axisPlaces(int n, int cells) {
    std::vector<AxisPlace> places;
    places.reserve(static_cast<std::size_t>(n));
    for (int i = 0; i < n; ++i)
        places.push_back(
            {static_cast<std::size_t>(i * cells / n), weightsAt(static_cast<double>(i * cells % n) / n)});
    return places;
}

/// A coordinate's cell: the lattice points at both ends, and their weights.
struct Axis {
    std::array<std::size_t, 2> point;
    std::array<double, 2> value, slope;
};

std::optional<Axis> axisAt(double coordinate, int cells) {
    if (!std::isfinite(coordinate)) return std::nullopt;
    const double cell = std::floor(coordinate);
    const Weights w = weightsAt(coordinate - cell);
    const double wrapped = cell - std::floor(cell / cells) * cells;  // exact: cells is a power of two
    const auto near = static_cast<std::size_t>(wrapped);
    return Axis{{near, (near + 1) % static_cast<std::size_t>(cells)}, {w.n0, w.n1}, {w.g0, w.g1}};
}

}  // namespace

double noise3(double x, double y, double z, int octave) {
    const tables::Octave3& table = tables::kOctaves3.at(static_cast<std::size_t>(octave));
    const auto cells = static_cast<std::size_t>(table.cells);
    const auto ax = axisAt(x, table.cells);
    const auto ay = axisAt(y, table.cells);
    const auto az = axisAt(z, table.cells);
    if (!ax || !ay || !az) return 0.5;
    double sum = 0;
    for (std::size_t c = 0; c < 2; ++c)
        for (std::size_t b = 0; b < 2; ++b)
            for (std::size_t a = 0; a < 2; ++a) {
                const std::size_t h =
                    (ax->point[a] + table.p[(ay->point[b] + table.q[az->point[c]]) % cells]) % cells;
                const auto& g = table.gradients[h];
                sum += g[0] * ax->slope[a] * ay->value[b] * az->value[c] +
                       g[1] * ax->value[a] * ay->slope[b] * az->value[c] +
                       g[2] * ax->value[a] * ay->value[b] * az->slope[c];
            }
    return 0.5 + sum;
}

double noise2(double x, double y, int octave) {
    const tables::Octave2& table = tables::kOctaves2.at(static_cast<std::size_t>(octave));
    const auto cells = static_cast<std::size_t>(table.cells);
    const auto ax = axisAt(x, table.cells);
    const auto ay = axisAt(y, table.cells);
    if (!ax || !ay) return 0.5;
    double sum = 0;
    for (std::size_t b = 0; b < 2; ++b)
        for (std::size_t a = 0; a < 2; ++a) {
            const auto& g = table.gradients[(ax->point[a] + table.p[ay->point[b]]) % cells];
            sum += g[0] * ax->slope[a] * ay->value[b] + g[1] * ax->value[a] * ay->slope[b];
        }
    return 0.5 + sum;
}

namespace {

constexpr float kOneHalf = static_cast<float>(kUnitsPerValue / 2);

constexpr int byteShift(int octave) {
    return std::endian::native == std::endian::little ? 8 * octave : 24 - 8 * octave;
}

/// Masks the distance of a unit count to the next byte: 0 if a byte boundary is less than a unit away.
inline std::uint32_t distance(std::uint32_t units) {
    constexpr std::uint32_t kFraction = (1U << kFractionBits) - 1;
    return (units + 1) & (kFraction - 1);
}

}  // namespace

GLIBRA_FOR_EACH_PROCESSOR("default", "avx2", "avx512f")
bool combineOctaves(const std::array<OctaveRow, 4>& octaves, std::size_t begin, std::size_t count,
                    TexelBlock& block) {
    const auto unitsAt = [begin](const OctaveRow& row, const RowWeights& w, std::size_t i) {
        const float value = ((row.levels[0] + begin)[i] * w.n0 + (row.levels[1] + begin)[i] * w.n1) +
                            ((row.slopes[0] + begin)[i] * w.g0 + (row.slopes[1] + begin)[i] * w.g1);
        return static_cast<std::uint32_t>(static_cast<std::int32_t>(kOneHalf + value));
    };
    const auto byteAt = [](std::uint32_t units, int octave) {
        return units >> kFractionBits << byteShift(octave);
    };
    const OctaveRow r0 = octaves[0], r1 = octaves[1], r2 = octaves[2], r3 = octaves[3];
    std::uint32_t least = ~0U;
    for (std::size_t i = 0; i < count; ++i) {
        const std::uint32_t u0 = unitsAt(r0, r0.weights, i), u1 = unitsAt(r1, r1.weights, i),
                            u2 = unitsAt(r2, r2.weights, i), u3 = unitsAt(r3, r3.weights, i);
        block.texels[i] = byteAt(u0, 0) | byteAt(u1, 1) | byteAt(u2, 2) | byteAt(u3, 3);
        const std::uint32_t nearest =
            std::min(std::min(distance(u0), distance(u1)), std::min(distance(u2), distance(u3)));
        block.doubts[i] = nearest;
        least = std::min(least, nearest);
    }
    return least == 0;
}

/// sum[i] = n0 * levels[0][i] + n1 * levels[1][i] + g0 * slopes[0][i] + g1 * slopes[1][i], for i below
/// `count`.
GLIBRA_FOR_EACH_PROCESSOR("default", "avx2", "avx512f")
static void mergeRows(const OctaveRow& row, std::size_t count, float* sum) {
    const auto [n0, n1, g0, g1] = row.weights;
    const float *near = row.levels[0], *far = row.levels[1], *nearSlope = row.slopes[0],
                *farSlope = row.slopes[1];
    for (std::size_t i = 0; i < count; ++i)
        sum[i] = (near[i] * n0 + far[i] * n1) + (nearSlope[i] * g0 + farSlope[i] * g1);
}

/// sum[i] = n0 * levels[0][i] + n1 * levels[1][i].
GLIBRA_FOR_EACH_PROCESSOR("default", "avx2", "avx512f")
static void mergeLevels(const OctaveRow& row, std::size_t count, float* sum) {
    const float n0 = row.weights.n0, n1 = row.weights.n1;
    const float *near = row.levels[0], *far = row.levels[1];
    for (std::size_t i = 0; i < count; ++i) sum[i] = near[i] * n0 + far[i] * n1;
}

// Texels of the noise textures. The sum over the corners of a cell is separable, and the rows of lattice
// points of one octave differ only by a rotation. So each octave has as many different rows as cells, and
// they are interpolated along x once for the whole texture. For each row of the lattice, a slice combines
// two of them along z; each row of texels combines two of those along y. This is done in floats; the few
// texels that floats cannot decide are computed in double. A slice depends only on its index, so the bytes
// are the same for any number of threads.

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
