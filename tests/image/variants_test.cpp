// Every variant of the formats that are read here against the pixels that it holds, and against Pillow and
// ImageMagick: equal pixels or a message.

#include <gtest/gtest.h>
#include <sys/wait.h>

#include <cmath>
#include <cstdlib>
#include <map>

#include "image/compare/compare.h"
#include "image/image.h"
#include "image/read.h"
#include "support.h"
#include "variant_maker.h"

namespace glibra::image {
namespace {

using testing::componentAt;
using testing::Variant;

/// Half a step of the type, which rounding may take, and for floats their own rounding.
double stepOf(const Image& image, double value) {
    return image.type == Component::u8    ? .501 / 255
           : image.type == Component::u16 ? .501 / 65535
                                          : 1e-6 * std::abs(value) + 1e-12;
}

void expectHolds(const Variant& variant) {
    const auto read = decodeImage(variant.file, variant.name, {}, testing::withoutModule());
    ASSERT_TRUE(read) << variant.name << ": " << read.diagnostics[0].text;
    ASSERT_EQ(read->width, variant.width) << variant.name;
    ASSERT_EQ(read->height, variant.height) << variant.name;
    for (std::size_t i = 0; i < variant.pixels.size(); ++i)
        for (std::size_t c = 0; c < 4; ++c) {
            const double expected = variant.pixels[i].at(c);
            ASSERT_NEAR(componentAt(*read, 4 * i + c), expected, stepOf(*read, expected))
                << variant.name << ", pixel " << i % static_cast<std::size_t>(variant.width) << " "
                << i / static_cast<std::size_t>(variant.width) << ", component " << c;
        }
}

using Maker = std::vector<Variant> (*)();
class Variants : public ::testing::TestWithParam<Maker> {};

TEST_P(Variants, HoldTheirPixels) {
    for (const Variant& each : GetParam()()) expectHolds(each);
}

TEST_P(Variants, AreErrorsAtEveryLengthThatIsTooShort) {
    std::map<std::string, int> seen;
    for (const Variant& each : GetParam()()) {
        if (seen[each.name.substr(0, 5)]++ % 7 != 0) continue;
        for (std::size_t length = 0; length < each.file.size(); length += 1 + length / 40) {
            const auto read =
                decodeImage(std::span(each.file).first(length), each.name, {}, testing::withoutModule());
            // What follows the last number of plain PNM may be missing; nothing else.
            if (read) {
                EXPECT_GE(length + 20, each.file.size()) << each.name;
            } else {
                EXPECT_EQ(read.diagnostics.size(), 1U) << each.name << " " << length;
            }
        }
    }
}

TEST_P(Variants, WithAnyByteChangedGiveAPictureOrOneMessage) {
    std::map<std::string, int> seen;
    ReadOptions options = testing::withoutModule();
    options.limits = {.fileBytes = 1U << 20, .texelBytes = 1U << 22, .side = 2048, .side3D = 16};
    for (const Variant& each : GetParam()()) {
        if (seen[each.name.substr(0, 5)]++ % 9 != 0) continue;
        for (std::size_t at = 0; at < std::min<std::size_t>(each.file.size(), 160); ++at)
            for (const int value : {0, 1, 127, 128, 255}) {
                std::vector<std::byte> file = each.file;
                file[at] = static_cast<std::byte>(value);
                const auto read = decodeImage(file, each.name, {}, options);
                EXPECT_TRUE(read.value.has_value() != hasError(read.diagnostics)) << each.name << " " << at;
            }
    }
}

INSTANTIATE_TEST_SUITE_P(Formats, Variants,
                         ::testing::Values(testing::targaVariants, testing::pnmVariants, testing::hdrVariants,
                                           testing::ddsVariants));

class SecondDecoder : public testing::InFolder {
  protected:
    /// 0, or the exit status of the decoder.
    [[nodiscard]] int decodeAll() const {
        int status = 77;
        for (const char* python : {"/usr/bin/python3", "python3"}) {
            const std::string command = std::string(python) +
                                        " '" GLIBRA_SOURCE_DIR "/tests/image/second_decoder.py' '" +
                                        folder.string() + "'";
            const int ended = std::system(command.c_str());  // NOLINT(cert-env33-c): a test
            status = WIFEXITED(ended) ? WEXITSTATUS(ended) : 1;
            if (status != 77) break;
        }
        return status;
    }
};

/// False for variants that both decoders leave out or read wrong; their pixels are checked above.
bool isKnownElsewhere(const std::string& name) {
    const bool isWideTarga =
        name.starts_with("tga-1-16") || name.starts_with("tga-2-15") || name.starts_with("tga-3-16");
    const bool isOpaqueScreen =
        name.starts_with("gif") && name.find('o') != std::string::npos && name.find('t') == std::string::npos;
    const bool isOddDds = name.starts_with("dds") && name.find("gba8") == std::string::npos &&
                          name.find("gra8") == std::string::npos && name.find("gr8") == std::string::npos;
    return !isWideTarga && !isOpaqueScreen && !isOddDds;
}

/// True for variants that ImageMagick 7 and Pillow 11 (Debian 13) read otherwise than their predecessors:
/// palettes with alpha, and 16 bits with a bit of alpha. Their pixels are checked above, too.
bool isReadOtherwise(const std::string& name) {
    return name.starts_with("tga-1-8-15") || name.starts_with("tga-1-8-16") ||
           name.starts_with("tga-1-8-32") || name.starts_with("tga-2-16");
}

/// Colours of transparent pixels, which the decoders of GIF give differently, count as black. So do those of
/// an alpha of 1, which others round down to 0.
Image withoutHidden(Image image) {
    for (std::size_t at = 0; at + 4 <= image.data.size(); at += 4)
        if (image.data[at + 3] <= std::byte{1})
            std::fill_n(image.data.begin() + static_cast<std::ptrdiff_t>(at), 3, std::byte{0});
    return image;
}

TEST_F(SecondDecoder, SeesTheSamePixelsOrThereIsAMessage) {
    GLIBRA_NEED_MODULE();
    for (const Maker make :
         {testing::targaVariants, testing::pnmVariants, testing::gifVariants, testing::ddsVariants}) {
        int number = 0;
        for (const Variant& each : make())
            if (number++ % 8 == 0 && isKnownElsewhere(each.name)) put(each.name, each.file);
    }
    for (const auto& [name, file] : testing::blockFiles())
        if (!testing::isSignedBlocks(name)) put(name, file);  // others show -1 as 0 and 0 as a half
    const int status = decodeAll();
    if (status == 77) GTEST_SKIP() << "needs python3-pil and imagemagick";
    ASSERT_EQ(status, 0);
    struct Seen {
        int decoders = 0, equal = 0;
        std::string last;  ///< what the last decoder saw otherwise
    };
    std::map<std::filesystem::path, Seen> seen;
    for (const auto& entry : std::filesystem::directory_iterator(folder)) {
        const std::filesystem::path decoder = entry.path().extension();
        if (decoder != ".pillow" && decoder != ".magick") continue;
        const std::filesystem::path file = entry.path().parent_path() / entry.path().stem();
        Seen& each = seen[file.filename()];
        ++each.decoders;
        const auto theirs = readImage(entry.path(), {}, testing::withoutModule());
        ASSERT_TRUE(theirs) << entry.path();
        const auto ours = readImage(file, {}, testing::withModule());
        if (!ours) {
            each.last = ours.diagnostics[0].text;
            continue;
        }
        const Comparison found = compare(withoutHidden(withType(*theirs, Component::u8)),
                                         withoutHidden(withType(*ours, Component::u8)));
        // Some decoders cut where others round; YCbCr is rounded twice.
        const bool isYcc = file.filename().string().find("ycc") != std::string::npos;
        if (found.sameSize && found.largest * 255 <= (isYcc ? 2.01 : 1.01))
            ++each.equal;
        else
            each.last = decoder.string() + " differs by " + std::to_string(found.largest * 255) + " at " +
                        std::to_string(found.x) + " " + std::to_string(found.y);
    }
    std::map<std::string, int> equal;
    for (const auto& [name, each] : seen) {
        const bool isMessage = each.last.starts_with("'");
        EXPECT_TRUE(each.equal > 0 || isMessage || isReadOtherwise(name.string()))
            << name << ": " << each.last;
        if (isMessage || each.equal == 0) std::printf("%s: %s\n", name.c_str(), each.last.c_str());
        equal[name.extension().string()] += each.equal > 0 ? 1 : 0;
    }
    for (const char* suffix :
         {".tga", ".pnm", ".gif", ".dds", ".sgi", ".tif", ".webp", ".bmp", ".ico", ".jpg", ".psd"})
        EXPECT_GE(equal[suffix], 3) << suffix << ": the second decoder read too few";
}

}  // namespace
}  // namespace glibra::image
