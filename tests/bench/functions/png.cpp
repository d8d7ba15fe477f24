// PNG files of 1024 x 1024 pixels, against libpng with its defaults. "bytes" is the size of the file.

#include <benchmark/benchmark.h>
#include <png.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <vector>

#include "functions/libpng_writer.h"
#include "image/image.h"
#include "image/png/png_reader.h"
#include "image/png/png_writer.h"
#include "noise/noise.h"

namespace {

using namespace glibra;

constexpr int kSide = 1024;

image::Image emptyPicture() {
    image::Image picture{kSide, kSide, 3, image::Component::u8, {}};
    picture.data.resize(picture.rowBytes() * kSide);
    return picture;
}

void put(image::Image& picture, int x, int y, double red, double green, double blue) {
    std::byte* to = picture.data.data() + picture.rowBytes() * static_cast<std::size_t>(y) +
                    3 * static_cast<std::size_t>(x);
    for (const double each : {red, green, blue}) *to++ = static_cast<std::byte>(std::lround(255 * each));
}

/// A lit sphere in front of a plain background, as in most exercises.
const image::Image& sphere() {
    static const image::Image made = [] {
        image::Image picture = emptyPicture();
        for (int y = 0; y < kSide; ++y)
            for (int x = 0; x < kSide; ++x) {
                const double u = (x - 511.5) / 400, v = (y - 511.5) / 400, z = 1 - u * u - v * v;
                const double light = z < 0 ? 0 : .2 + .8 * std::max(0., .5 * std::sqrt(z) - .4 * v + .3 * u);
                if (z < 0)
                    put(picture, x, y, .07, .1, .13);
                else
                    put(picture, x, y, light, .5 * light, 0);
            }
        return picture;
    }();
    return made;
}

/// Noise in four octaves, coloured: detail in every pixel.
const image::Image& marble() {
    static const image::Image made = [] {
        image::Image picture = emptyPicture();
        const auto texels = noise::noise2Texels(kSide);
        for (int y = 0; y < kSide; ++y)
            for (int x = 0; x < kSide; ++x) {
                const std::uint8_t* from =
                    &texels[4 * (static_cast<std::size_t>(y) * kSide + static_cast<std::size_t>(x))];
                const double sum = (from[0] + from[1] + from[2] + from[3] - 510) / 255.;
                const double vein = .5 + .5 * std::sin(12. * x / kSide + 6 * sum);
                put(picture, x, y, vein, .2 + .6 * vein, .9 - .5 * vein);
            }
        return picture;
    }();
    return made;
}

void readRow(png_structp png, png_bytep to, std::size_t size) {
    auto* from = static_cast<const std::byte**>(png_get_io_ptr(png));
    std::memcpy(to, *from, size);
    *from += size;
}

std::vector<std::uint8_t> readByLibpng(const std::vector<std::byte>& file) {
    const std::byte* from = file.data();
    png_structp png = png_create_read_struct(PNG_LIBPNG_VER_STRING, nullptr, nullptr, nullptr);
    png_infop info = png_create_info_struct(png);
    png_set_read_fn(png, &from, readRow);
    png_read_info(png, info);
    png_set_add_alpha(png, 255, PNG_FILLER_AFTER);
    png_read_update_info(png, info);
    const std::size_t rowBytes = png_get_rowbytes(png, info);
    std::vector<std::uint8_t> pixels(rowBytes * kSide);
    for (std::size_t y = 0; y < kSide; ++y) png_read_row(png, &pixels[y * rowBytes], nullptr);
    png_read_end(png, nullptr);
    png_destroy_read_struct(&png, &info, nullptr);
    return pixels;
}

void encode(benchmark::State& state, const image::Image& (*picture)()) {
    const image::Image& from = picture();
    std::size_t bytes = 0;
    for (auto _ : state) bytes = image::encodePng(from).size();
    state.counters["bytes"] = static_cast<double>(bytes);
}

void encodeLibpng(benchmark::State& state, const image::Image& (*picture)()) {
    const image::Image& from = picture();
    std::size_t bytes = 0;
    for (auto _ : state) bytes = bench::writeByLibpng(from).size();
    state.counters["bytes"] = static_cast<double>(bytes);
}

void decode(benchmark::State& state, const image::Image& (*picture)()) {
    const std::vector<std::byte> file = image::encodePng(picture());
    for (auto _ : state) benchmark::DoNotOptimize(image::decodePng(file, {"picture.png", {}}));
}

void decodeLibpng(benchmark::State& state, const image::Image& (*picture)()) {
    const std::vector<std::byte> file = image::encodePng(picture());
    for (auto _ : state) benchmark::DoNotOptimize(readByLibpng(file));
}

/// The writer starts its own threads, so the time of the whole process is measured.
void wholeProcess(benchmark::internal::Benchmark* function) {
    function->Unit(benchmark::kMillisecond)->MeasureProcessCPUTime()->UseRealTime();
}

BENCHMARK_CAPTURE(encode, sphere, sphere)->Apply(wholeProcess);
BENCHMARK_CAPTURE(encodeLibpng, sphere, sphere)->Apply(wholeProcess);
BENCHMARK_CAPTURE(encode, marble, marble)->Apply(wholeProcess);
BENCHMARK_CAPTURE(encodeLibpng, marble, marble)->Apply(wholeProcess);
BENCHMARK_CAPTURE(decode, marble, marble)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(decodeLibpng, marble, marble)->Unit(benchmark::kMillisecond);

}  // namespace
