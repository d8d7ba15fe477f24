// The size and speed of each level of the PNG writer, against libpng with its defaults, over many pictures.
// Use: png_levels FILE.png...   (glibra render glib/*/*.glib --size 1024x1024 -o DIR makes such pictures)
//
// Sizes and speeds are geometric means over the pictures. Speed is libpng's time divided by ours, the best of
// three: of all processors together, and by the clock. Writer and libpng alternate, picture by picture.
// Before the means comes one row per picture: size and speed by processor time at levels 3 to 6.

#include <fmt/format.h>
#include <png.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <ctime>
#include <filesystem>
#include <string>
#include <vector>

#include "functions/libpng_writer.h"
#include "image/image.h"
#include "image/png/png_writer.h"
#include "image/read.h"

namespace {

using namespace glibra;

struct Cost {
    double processor = 0, wall = 0;  ///< seconds
};

double processorTime() {
    return static_cast<double>(std::clock()) / CLOCKS_PER_SEC;  // POSIX: of all threads
}

/// The least cost of three runs of `encode`, which returns the size of the file.
template <class Encode>
Cost measure(const Encode& encode, std::size_t& bytes) {
    Cost least{1e9, 1e9};
    for (int i = 0; i < 3; ++i) {
        const auto start = std::chrono::steady_clock::now();
        const double processor = processorTime();
        bytes = encode();
        least.processor = std::min(least.processor, processorTime() - processor);
        const std::chrono::duration<double> wall = std::chrono::steady_clock::now() - start;
        least.wall = std::min(least.wall, wall.count());
    }
    return least;
}

/// Sums over the pictures so far.
struct Level {
    double sizes = 0, processor = 0, wall = 0;  ///< sums of logarithms of ratios
    double largest = 0;
    int larger = 0;  ///< pictures that are larger than libpng's
};

constexpr int kMostLevel = 7;
constexpr int kFirstShown = 3, kLastShown = 6;

}  // namespace

int main(int count, char** files) {
    std::vector<Level> levels(kMostLevel + 1);
    int pictures = 0;
    for (int i = 1; i < count; ++i) {
        const auto read = image::readImage(files[i], {files[i], 1, 1});
        if (!read) {
            std::fprintf(stderr, "png_levels: cannot read %s\n", files[i]);
            return 1;
        }
        const image::Image picture = image::withComponents(*read, 3);
        std::size_t theirBytes = 0;
        const Cost theirs = measure([&] { return bench::writeByLibpng(picture).size(); }, theirBytes);
        ++pictures;
        fmt::print("| {} |", std::filesystem::path(files[i]).stem().string());
        for (int level = 0; level <= kMostLevel; ++level) {
            std::size_t bytes = 0;
            const Cost ours = measure(
                [&] { return image::encodePng(picture, {.level = level, .text = {}}).size(); }, bytes);
            Level& sum = levels[static_cast<std::size_t>(level)];
            const double size = static_cast<double>(bytes) / static_cast<double>(theirBytes);
            sum.sizes += std::log(size);
            sum.largest = std::max(sum.largest, size);
            if (size > 1) ++sum.larger;
            if (level >= kFirstShown && level <= kLastShown)
                fmt::print(" {:.3f}, {:.1f} |", size, theirs.processor / ours.processor);
            sum.processor += std::log(theirs.processor / ours.processor);
            sum.wall += std::log(theirs.wall / ours.wall);
        }
        fmt::print("\n");
    }
    if (pictures == 0) {
        std::fprintf(stderr, "use: png_levels FILE.png...\n");
        return 2;
    }
    const auto mean = [&](double sum) { return std::exp(sum / pictures); };
    fmt::print(
        "{} pictures\n| level | size of libpng's (largest) | pictures that are larger | speed by processor "
        "time | by "
        "the clock |\n|---|---|---|---|---|\n",
        pictures);
    for (int level = 0; level <= kMostLevel; ++level) {
        const Level& sum = levels[static_cast<std::size_t>(level)];
        fmt::print("| {} | {:.3f} ({:.2f}) | {} | {:.1f} | {:.1f} |\n", level, mean(sum.sizes), sum.largest,
                   sum.larger, mean(sum.processor), mean(sum.wall));
    }
    return 0;
}
