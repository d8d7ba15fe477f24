// FLIP of two pictures of 1024 x 1024 pixels of noise: ours, and the authors' program if its header was given
// to CMake (-DGLIBRA_FLIP_H=.../src/cpp/FLIP.h), alternating in one process. Prints times and their ratio.

#ifdef GLIBRA_FLIP_H
#include GLIBRA_FLIP_H
#endif

#include <algorithm>
#include <chrono>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <functional>
#include <vector>

#include "image/compare/flip.h"

namespace {

using glibra::image::Component;
using glibra::image::Image;

constexpr int kSide = 1024;

std::uint32_t hash(std::uint32_t x) {
    x = (x ^ (x >> 16)) * 0x7feb352dU;
    x = (x ^ (x >> 15)) * 0x846ca68bU;
    return x ^ (x >> 16);
}

Image noise(std::uint32_t seed) {
    Image image{kSide, kSide, 3, Component::u8, {}};
    for (std::uint32_t i = 0; i < 3U * kSide * kSide; ++i)
        image.data.push_back(static_cast<std::byte>(hash(i + seed) >> 24));
    return image;
}

double milliseconds(const std::function<void()>& work) {
    const auto start = std::chrono::steady_clock::now();
    work();
    return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count();
}

void show(const char* name, std::vector<double> values) {
    std::sort(values.begin(), values.end());
    std::printf("  %-7s min %8.3f  median %8.3f  max %8.3f\n", name, values.front(),
                values[values.size() / 2], values.back());
}

#ifdef GLIBRA_FLIP_H
double authors(const Image& a, const Image& b) {
    const auto load = [](const Image& image) {
        FLIP::image<FLIP::color3> to(kSide, kSide);
        for (int y = 0; y < kSide; ++y)
            for (int x = 0; x < kSide; ++x)
                to.set(x, y,
                       FLIP::color3(reinterpret_cast<const unsigned char*>(image.data.data()) +
                                    3 * (static_cast<std::size_t>(y) * kSide + static_cast<std::size_t>(x))));
        return to;
    };
    FLIP::image<FLIP::color3> first = load(a), second = load(b);
    FLIP::image<float> errors(kSide, kSide, 0.F);
    FLIP::Parameters parameters;
    return milliseconds([&] {
        first.sRGBToLinearRGB();
        second.sRGBToLinearRGB();
        FLIP::evaluate(first, second, false, parameters, errors);
    });
}
#endif

}  // namespace

int main(int argc, char** argv) {
    const int runs = argc > 1 ? std::max(std::atoi(argv[1]), 1) : 15;
    const Image a = noise(0), b = noise(12345678);
    std::vector<double> ours, theirs, ratios;
    for (int run = 0; run < runs; ++run) {
#ifdef GLIBRA_FLIP_H
        theirs.push_back(authors(a, b));
#endif
        ours.push_back(milliseconds([&] { glibra::image::flip(a, b); }));
        if (!theirs.empty()) ratios.push_back(theirs.back() / ours.back());
    }
    std::printf("FLIP, milliseconds\n");
    if (!theirs.empty()) show("authors", theirs);
    show("glibra", ours);
    if (!ratios.empty()) show("ratio", ratios);
}
