// Texels of the noise textures. The sum over the corners of a cell is separable: per slice the two ends along
// z are merged into one gradient field of the plane, per row the two ends along y into one of the line, and
// what is left a texel and octave is four products. Every slice depends on nothing but its index, so the
// bytes are the same for any number of threads.

#include <algorithm>
#include <array>
#include <atomic>
#include <cstddef>
#include <system_error>
#include <thread>

#include "noise/noise.h"
#include "noise/tables.h"
#include "noise/weights.h"

namespace glibra::noise {
namespace {

constexpr std::size_t kMostCells = 32;
using Line =
    std::array<double, kMostCells + 1>;  // one more: the far end of the last cell is the first point again
using Plane = std::array<Line, kMostCells>;

/// The cell of each texel index along an axis and the weights at its place in it, for one octave.
struct AxisWeights {
    std::vector<std::size_t> cell;
    std::vector<Weights> at;

    AxisWeights(int n, int cells) {
        for (int i = 0; i < n; ++i) {
            cell.push_back(static_cast<std::size_t>(i * cells / n));
            at.push_back(weightsAt(static_cast<double>(i * cells % n) / n));
        }
    }
};

/// The terms of one octave that depend on a row: value = 1/2 + slope[I]*g0 + slope[I+1]*g1 + level[I]*n0 +
/// level[I+1]*n1.
struct RowTerms {
    Line slope, level;
};

std::uint8_t byteOf(double value) {
    return static_cast<std::uint8_t>(255 * std::clamp(value, 0., 1.));
}

/// Writes component `octave` of one row of RGBA texels.
void writeRow(const RowTerms& terms, const AxisWeights& along, std::size_t octave, std::uint8_t* row) {
    const std::size_t n = along.cell.size();
    for (std::size_t i = 0; i < n; ++i) {
        const std::size_t cell = along.cell[i];
        const Weights& w = along.at[i];
        const double noise = (terms.slope[cell] * w.g0 + terms.slope[cell + 1] * w.g1) +
                             (terms.level[cell] * w.n0 + terms.level[cell + 1] * w.n1);
        row[4 * i + octave] = byteOf(0.5 + noise);
    }
}

/// The gradient field of one plane z = constant: along x and y as slopes, along z already as a level.
struct PlaneField {
    Plane x, y, level;
};

void mergeAlongZ(const tables::Octave3& table, std::size_t nearK, const Weights& w, PlaneField& field) {
    const auto cells = static_cast<std::size_t>(table.cells);
    const std::size_t nearShift = table.q[nearK];
    const std::size_t farShift = table.q[(nearK + 1) % cells];
    for (std::size_t j = 0; j < cells; ++j) {
        const std::size_t nearRow = table.p[(j + nearShift) % cells];
        const std::size_t farRow = table.p[(j + farShift) % cells];
        for (std::size_t i = 0; i <= cells; ++i) {
            const auto& near = table.gradients[(i + nearRow) % cells];
            const auto& far = table.gradients[(i + farRow) % cells];
            field.x[j][i] = near[0] * w.n0 + far[0] * w.n1;
            field.y[j][i] = near[1] * w.n0 + far[1] * w.n1;
            field.level[j][i] = near[2] * w.g0 + far[2] * w.g1;
        }
    }
}

void mergeAlongY(const PlaneField& field, std::size_t nearJ, std::size_t cells, const Weights& w,
                 RowTerms& terms) {
    const std::size_t farJ = (nearJ + 1) % cells;
    for (std::size_t i = 0; i <= cells; ++i) {
        terms.slope[i] = field.x[nearJ][i] * w.n0 + field.x[farJ][i] * w.n1;
        terms.level[i] = (field.y[nearJ][i] * w.g0 + field.y[farJ][i] * w.g1) +
                         (field.level[nearJ][i] * w.n0 + field.level[farJ][i] * w.n1);
    }
}

void mergeAlongY(const tables::Octave2& table, std::size_t nearJ, const Weights& w, RowTerms& terms) {
    const auto cells = static_cast<std::size_t>(table.cells);
    const std::size_t nearRow = table.p[nearJ];
    const std::size_t farRow = table.p[(nearJ + 1) % cells];
    for (std::size_t i = 0; i <= cells; ++i) {
        const auto& near = table.gradients[(i + nearRow) % cells];
        const auto& far = table.gradients[(i + farRow) % cells];
        terms.slope[i] = near[0] * w.n0 + far[0] * w.n1;
        terms.level[i] = near[1] * w.g0 + far[1] * w.g1;
    }
}

/// Calls work(index) once for every index below `count`, on up to `threads` threads (0: as the machine has).
template <class Work>
void forEachIndex(int count, int threads, const Work& work) {
    std::atomic<int> next{0};
    const auto drain = [&] {
        for (int index = next++; index < count; index = next++) work(index);
    };
    if (threads <= 0) threads = static_cast<int>(std::max(1U, std::thread::hardware_concurrency()));
    std::vector<std::jthread> others;
    try {
        for (int i = 1; i < std::min(threads, count); ++i) others.emplace_back(drain);
    } catch (const std::system_error&) {
        // The machine gives no more threads; those that run do all the work.
    }
    drain();
}

std::vector<AxisWeights> axesOf(int n) {
    std::vector<AxisWeights> axes;
    axes.reserve(kOctaves);
    for (int octave = 0; octave < kOctaves; ++octave) axes.emplace_back(n, cellsOf(octave));
    return axes;
}

}  // namespace

std::vector<std::uint8_t> noise3Texels(int n, int threads) {
    if (n < 1 || n > kLargestSize3) return {};
    const auto size = static_cast<std::size_t>(n);
    std::vector<std::uint8_t> texels(4 * size * size * size);
    const std::vector<AxisWeights> axes = axesOf(n);
    forEachIndex(n, threads, [&](int slice) {
        const auto k = static_cast<std::size_t>(slice);
        PlaneField field;
        RowTerms terms;
        for (std::size_t octave = 0; octave < axes.size(); ++octave) {
            const tables::Octave3& table = tables::kOctaves3[octave];
            const AxisWeights& axis = axes[octave];
            mergeAlongZ(table, axis.cell[k], axis.at[k], field);
            for (std::size_t j = 0; j < size; ++j) {
                mergeAlongY(field, axis.cell[j], static_cast<std::size_t>(table.cells), axis.at[j], terms);
                writeRow(terms, axis, octave, texels.data() + 4 * size * (j + size * k));
            }
        }
    });
    return texels;
}

std::vector<std::uint8_t> noise2Texels(int n, int threads) {
    if (n < 1 || n > kLargestSize2) return {};
    const auto size = static_cast<std::size_t>(n);
    std::vector<std::uint8_t> texels(4 * size * size);
    const std::vector<AxisWeights> axes = axesOf(n);
    forEachIndex(n, threads, [&](int row) {
        const auto j = static_cast<std::size_t>(row);
        RowTerms terms;
        for (std::size_t octave = 0; octave < axes.size(); ++octave) {
            const AxisWeights& axis = axes[octave];
            mergeAlongY(tables::kOctaves2[octave], axis.cell[j], axis.at[j], terms);
            writeRow(terms, axis, octave, texels.data() + 4 * size * j);
        }
    });
    return texels;
}

}  // namespace glibra::noise
