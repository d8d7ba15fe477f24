#pragma once
// Shared by several tests of this room: pictures with known pixels, a temporary folder, the place of the
// module.

#include <gtest/gtest.h>

#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <span>
#include <string>
#include <vector>

#include "../support/new_folder.h"
#include "image/image.h"
#include "image/read.h"

namespace glibra::image::testing {

/// A counter-based hash: the same noise on every machine.
inline std::uint32_t hash(std::uint32_t x) {
    x = x * 0x9e3779b9U + 0x85ebca6bU;
    x ^= x >> 16;
    x *= 0x7feb352dU;
    x ^= x >> 15;
    x *= 0x846ca68bU;
    return x ^ (x >> 16);
}

/// Noise over the whole range of the type; floats from -2 to 2.
inline Image noisyImage(int width, int height, int components, Component type, std::uint32_t seed = 0) {
    Image image{width, height, components, type, {}};
    image.data.resize(image.rowBytes() * static_cast<std::size_t>(height));
    if (type == Component::f32) {
        for (std::size_t at = 0; at < image.data.size(); at += 4) {
            const float value =
                static_cast<float>(hash(seed + static_cast<std::uint32_t>(at)) >> 8) / 4194304.F - 2.F;
            std::memcpy(image.data.data() + at, &value, 4);
        }
    } else {
        for (std::size_t at = 0; at < image.data.size(); ++at)
            image.data[at] = static_cast<std::byte>(hash(seed + static_cast<std::uint32_t>(at)) >> 24);
    }
    return image;
}

/// A smooth RGB picture, which lossy formats preserve well.
inline Image smoothImage(int width, int height) {
    Image image{width, height, 3, Component::u8, {}};
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x)
            for (const int value : {255 * x / width, 255 * y / height, 128 + 60 * (x + y) / (width + height)})
                image.data.push_back(static_cast<std::byte>(value));
    return image;
}

/// A grey picture; `value` gives each pixel.
template <class Value>
Image greyImage(Value value, int width, int height) {
    Image image{width, height, 1, Component::u8, {}};
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x)
            image.data.push_back(static_cast<std::byte>(static_cast<int>(value(x, y))));
    return image;
}

inline Image floatImage(int width, int height, int components, const std::vector<float>& values) {
    Image image{width, height, components, Component::f32, std::vector<std::byte>(4 * values.size())};
    std::memcpy(image.data.data(), values.data(), image.data.size());
    return image;
}

/// The first components of a pixel as numbers.
inline std::vector<int> pixelAt(const Image& image, int x, int y) {
    std::vector<int> values;
    const auto row = image.row(y);
    for (int c = 0; c < image.components; ++c) {
        const auto index = static_cast<std::size_t>(x) * static_cast<std::size_t>(image.components) +
                           static_cast<std::size_t>(c);
        if (image.type == Component::u8) {
            values.push_back(std::to_integer<int>(row[index]));
        } else {
            std::uint16_t value = 0;
            std::memcpy(&value, row.data() + 2 * index, 2);
            values.push_back(value);
        }
    }
    return values;
}

/// A component of all pixels as a number: bytes and 16 bits stand for 0..1.
inline double componentAt(const Image& image, std::size_t index) {
    if (image.type == Component::u8) return std::to_integer<int>(image.data[index]) / 255.;
    if (image.type == Component::u16) {
        std::uint16_t value = 0;
        std::memcpy(&value, image.data.data() + 2 * index, 2);
        return value / 65535.;
    }
    float value = 0;
    std::memcpy(&value, image.data.data() + 4 * index, 4);
    return static_cast<double>(value);
}

using Rgba = std::vector<int>;

/// The module that was built; GLIBRA_TEST_MODULE_DIR names a packaged one to test instead.
inline std::vector<std::filesystem::path> moduleFolders() {
    const char* elsewhere = std::getenv("GLIBRA_TEST_MODULE_DIR");
    return {elsewhere != nullptr ? elsewhere : GLIBRA_BINARY_DIR};
}
inline bool hasModule() {
    return std::filesystem::exists(moduleFolders()[0] / "glibra_openimageio.so");
}

/// Skips a test that needs the module, which a build without OpenImageIO does not have.
#define GLIBRA_NEED_MODULE() \
    if (!testing::hasModule()) GTEST_SKIP() << "the OpenImageIO module was not built"

inline ReadOptions withModule() {
    ReadOptions options;
    options.moduleFolders = moduleFolders();
    return options;
}
inline ReadOptions withoutModule() {
    ReadOptions options;
    options.moduleFolders.clear();
    return options;
}

/// An independent decoder: OpenImageIO's.
inline Result<Image> decodeElsewhere(Format format, std::span<const std::byte> file) {
    return readByModule(format, file, {}, {"elsewhere", {}}, withModule());
}

/// A new empty folder for every test.
class InFolder : public ::testing::Test {
  protected:
    void SetUp() override { folder = test::newFolder("image"); }
    void TearDown() override { std::filesystem::remove_all(folder); }

    std::filesystem::path put(const std::string& name, std::span<const std::byte> bytes) const {
        std::ofstream file(folder / name, std::ios::binary);
        file.write(reinterpret_cast<const char*>(bytes.data()), static_cast<std::streamsize>(bytes.size()));
        return folder / name;
    }
    [[nodiscard]] std::size_t fileCount() const {
        std::size_t count = 0;
        for ([[maybe_unused]] const auto& each : std::filesystem::directory_iterator(folder)) ++count;
        return count;
    }

    std::filesystem::path folder;
};

/// The ids, joined by blanks.
inline std::string idsOf(const Diagnostics& diagnostics) {
    std::string ids;
    for (const Diagnostic& each : diagnostics) ids += (ids.empty() ? "" : " ") + each.id;
    return ids;
}

inline void putLittle(std::vector<std::byte>& to, std::uint32_t value, int bytes) {
    for (int i = 0; i < bytes; ++i) to.push_back(static_cast<std::byte>(value >> (8 * i)));
}
inline void putBig(std::vector<std::byte>& to, std::uint32_t value, int bytes) {
    for (int i = bytes; i-- > 0;) to.push_back(static_cast<std::byte>(value >> (8 * i)));
}

inline std::vector<std::byte> bytesOf(const std::vector<int>& values) {
    std::vector<std::byte> bytes;
    bytes.reserve(values.size());
    for (const int value : values) bytes.push_back(static_cast<std::byte>(value));
    return bytes;
}

}  // namespace glibra::image::testing
