// Reading by content, with and without the OpenImageIO module.

#include "image/read.h"

#include <gtest/gtest.h>
#include <pthread.h>

#include "image/compare/compare.h"
#include "image/file.h"
#include "image/foreign_headers.h"
#include "image/format.h"
#include "image/write.h"
#include "support.h"

namespace glibra::image {
namespace {

namespace fs = std::filesystem;
using testing::idsOf;

const Place kReadPlace{"scene.glib", 5, 1};

TEST(PictureFormat, IsRecognisedByTheFirstBytes) {
    using testing::bytesOf;
    const struct {
        Format format;
        std::vector<std::byte> bytes;
    } cases[] = {
        {Format::jpeg, bytesOf({0xff, 0xd8, 0xff, 0xe0})},
        {Format::tiff, bytesOf({'I', 'I', 42, 0})},
        {Format::tiff, bytesOf({'M', 'M', 0, 42})},
        {Format::openExr, bytesOf({0x76, 0x2f, 0x31, 0x01})},
        {Format::gif, bytesOf({'G', 'I', 'F', '8', '9', 'a'})},
        {Format::webp, bytesOf({'R', 'I', 'F', 'F', 1, 2, 3, 4, 'W', 'E', 'B', 'P'})},
        {Format::pnm, bytesOf({'P', '6', '\n', '1'})},
        {Format::pfm, bytesOf({'P', 'F', '\n', '1'})},
        {Format::pfm, bytesOf({'P', 'f', '\n', '1'})},
        {Format::unknown, bytesOf({'P', '6', 'x'})},
        {Format::unknown, bytesOf({'B', 'M', 'x', 'y'})},
        {Format::unknown, bytesOf({'R', 'I', 'F', 'F', 1, 2, 3, 4, 'W', 'A', 'V', 'E'})},
        {Format::unknown, {}},
    };
    for (const auto& each : cases) EXPECT_EQ(formatOf(each.bytes), each.format);
}

TEST(PictureFormat, RawTexturesOfAllowedSizesAreNeverMistakenForPictures) {
    for (std::uint32_t s = 1; s <= 16384; s += s < 300 ? 1 : 61)
        for (const std::uint32_t t : {1U, 2U, 16U, 64U, 256U, 4096U, 16384U}) {
            std::vector<std::byte> file;
            for (const std::uint32_t word : {s, t, 64U}) testing::putLittle(file, word, 4);
            file.resize(100000);
            ASSERT_EQ(formatOf(file), Format::unknown) << s << " " << t;
        }
}

TEST(PictureFormat, SuffixesAreReadInAnyCase) {
    EXPECT_EQ(formatOfSuffix("a/b.PNG"), Format::png);
    EXPECT_EQ(formatOfSuffix("b.Jpeg"), Format::jpeg);
    EXPECT_EQ(formatOfSuffix("noise3d.064.tex"), Format::rawTexture);
    EXPECT_EQ(formatOfSuffix("b.jpx"), Format::unknown);
    EXPECT_EQ(formatOfSuffix("b."), Format::unknown);
    EXPECT_EQ(formatOfSuffix("png"), Format::unknown);
    EXPECT_EQ(formatOfSuffix("a.b c"), Format::unknown);
}

class ReadImage : public testing::InFolder {};

TEST_F(ReadImage, PngNeedsNoModule) {
    const Image image = testing::noisyImage(9, 4, 3, Component::u8);
    const auto read = readImage(put("a.png", encodePng(image)), kReadPlace, testing::withoutModule());
    ASSERT_TRUE(read);
    EXPECT_TRUE(read.diagnostics.empty());
    EXPECT_TRUE(compare(image, *read).identical);
}

TEST_F(ReadImage, AWrongSuffixIsAWarning) {
    const auto read =
        readImage(put("posx.bmp", encodePng(testing::noisyImage(2, 2, 3, Component::u8))), kReadPlace);
    ASSERT_TRUE(read);
    ASSERT_EQ(idsOf(read.diagnostics), "file-W03");
    EXPECT_EQ(read.diagnostics[0].text, "'posx.bmp' is a PNG picture");
    EXPECT_EQ(read.diagnostics[0].severity, Severity::warning);
    EXPECT_EQ(read.diagnostics[0].place, kReadPlace);
    EXPECT_TRUE(readImage(put("picture", encodePng(testing::noisyImage(2, 2, 3, Component::u8))))
                    .diagnostics.empty());
}

/// A directory that says 1 x 1, and nothing else.
std::vector<std::byte> smallestTiff() {
    return testing::bytesOf({'I', 'I', 42, 0, 8, 0, 0, 0, 2, 0, 0, 1, 3, 0, 1, 0, 0, 0, 1,
                             0,   0,   0,  1, 1, 3, 0, 1, 0, 0, 0, 1, 0, 0, 0, 0, 0, 0, 0});
}

TEST_F(ReadImage, WithoutTheModuleTheFormatIsNamed) {
    const auto read = readImage(put("wood.bmp", smallestTiff()), kReadPlace, testing::withoutModule());
    ASSERT_EQ(idsOf(read.diagnostics), "file-E03");
    EXPECT_EQ(read.diagnostics[0].text,
              "'wood.bmp' is a TIFF picture, but the image module that reads it is not installed");
    EXPECT_EQ(read.diagnostics[0].place, kReadPlace);
}

TEST_F(ReadImage, AModuleThatCannotBeLoadedIsNamedWithTheReason) {
    const auto module = put("glibra_openimageio.so", testing::bytesOf({'n', 'o'}));
    ReadOptions options;
    options.moduleFolders = {folder / "empty", folder};
    const auto read = readImage(put("a.tif", smallestTiff()), kReadPlace, options);
    ASSERT_EQ(idsOf(read.diagnostics), "file-E03");
    EXPECT_EQ(read.diagnostics[0].text.find(
                  "'a.tif' is a TIFF picture, but the image module that reads it cannot be "
                  "loaded: " +
                  module.string() + ": "),
              0U)
        << read.diagnostics[0].text;
}

TEST_F(ReadImage, TextIsNotAPicture) {
    const auto read = readImage(put("a.png", testing::bytesOf({'h', 'e', 'l', 'l', 'o'})), kReadPlace);
    ASSERT_EQ(idsOf(read.diagnostics), "file-E03");
    EXPECT_EQ(read.diagnostics[0].text, "'a.png' is neither a picture nor a raw texture");
}

TEST_F(ReadImage, LimitsAreTheCallers) {
    const auto path = put("a.png", encodePng(testing::noisyImage(20, 10, 4, Component::u8)));
    ReadOptions options = testing::withoutModule();
    options.limits.side = 19;
    EXPECT_EQ(idsOf(readImage(path, kReadPlace, options).diagnostics), "file-E09");
    options.limits.side = 20;
    options.limits.texelBytes = 799;
    EXPECT_EQ(idsOf(readImage(path, kReadPlace, options).diagnostics), "file-E09");
    options.limits.texelBytes = 800;
    EXPECT_TRUE(readImage(path, kReadPlace, options));
    options.limits.fileBytes = 20;
    EXPECT_EQ(idsOf(readImage(path, kReadPlace, options).diagnostics), "file-E09");
}

/// Formats that the module writes and reads, and the allowed error of a value.
struct ByModule {
    const char* suffix;
    Component type;  ///< as written
    Component readType;
    int components;
    double largest;
};
class ReadByModule : public testing::InFolder, public ::testing::WithParamInterface<ByModule> {};

TEST_P(ReadByModule, KeepsThePixels) {
    GLIBRA_NEED_MODULE();
    const auto& [suffix, type, readType, components, largest] = GetParam();
    const Image image =
        largest == 0 ? testing::noisyImage(37, 23, components, type) : testing::smoothImage(37, 23);
    const fs::path path = folder / (std::string("a") + suffix);
    const auto problems = writeImage(image, path, {{}, testing::moduleFolders()});
    ASSERT_TRUE(problems.empty()) << problems[0].text;
    EXPECT_EQ(fileCount(), 1U);
    const auto read = readImage(path, kReadPlace, testing::withModule());
    ASSERT_TRUE(read) << read.diagnostics[0].text;
    EXPECT_TRUE(read.diagnostics.empty());
    EXPECT_EQ(read->components, 4);
    EXPECT_EQ(read->type, readType);
    EXPECT_LE(compare(image, *read).largest, largest);
}

INSTANTIATE_TEST_SUITE_P(Formats, ReadByModule,
                         ::testing::Values(ByModule{".jpg", Component::u8, Component::u8, 3, .04},
                                           ByModule{".bmp", Component::u8, Component::u8, 3, 0},
                                           ByModule{".tif", Component::u8, Component::u8, 4, 0},
                                           ByModule{".tif", Component::u16, Component::u16, 4, 0},
                                           ByModule{".tif", Component::f32, Component::f32, 4, 0},
                                           ByModule{".tif", Component::u8, Component::u8, 1, 0},
                                           ByModule{".exr", Component::f32, Component::f32, 4, 0},
                                           ByModule{".exr", Component::f32, Component::f32, 3, 0},
                                           ByModule{".exr", Component::f32, Component::f32, 2, 0},
                                           ByModule{".hdr", Component::u8, Component::f32, 3, .01},
                                           ByModule{".tga", Component::u8, Component::u8, 4, 0},
                                           ByModule{".tga", Component::u8, Component::u8, 2, 0},
                                           ByModule{".ppm", Component::u8, Component::u8, 3, 0},
                                           ByModule{".pfm", Component::f32, Component::f32, 3, 0},
                                           ByModule{".pfm", Component::f32, Component::f32, 1, 0},
                                           ByModule{".sgi", Component::u8, Component::u8, 4, 0},
                                           ByModule{".webp", Component::u8, Component::u8, 4, 0}));

TEST_P(ReadByModule, ACutFileGivesOneMessage) {
    GLIBRA_NEED_MODULE();
    const std::string suffix = GetParam().suffix;
    const fs::path path = folder / ("a" + suffix);
    ASSERT_TRUE(
        writeImage(testing::noisyImage(60, 50, 3, GetParam().type), path, {{}, testing::moduleFolders()})
            .empty());
    const auto whole = readFile(path, {"a", {}});
    ASSERT_TRUE(whole);
    for (const std::size_t percent : {10U, 50U, 90U}) {
        put("b" + suffix, std::span(*whole).first(whole->size() * percent / 100));
        const auto read = readImage(folder / ("b" + suffix), kReadPlace, testing::withModule());
        EXPECT_FALSE(read) << percent;
        EXPECT_EQ(idsOf(read.diagnostics), "file-E04") << percent;
    }
}

/// OpenImageIO leaves a thread behind that may hold a lock when the next process is forked.
TEST_F(ReadImage, TheModuleWritesAndReadsInProcessesOfTheirOwn) {
    GLIBRA_NEED_MODULE();
    static int forks = 0;
    ASSERT_EQ(pthread_atfork(nullptr, [] { ++forks; }, nullptr), 0);
    ASSERT_TRUE(
        writeImage(testing::smoothImage(40, 30), folder / "a.tif", {{}, testing::moduleFolders()}).empty());
    EXPECT_EQ(forks, 1);
    EXPECT_TRUE(readImage(folder / "a.tif", kReadPlace, testing::withModule()));
    EXPECT_EQ(forks, 2);
    const auto problems =
        writeImage(testing::smoothImage(70000, 1), folder / "a.tga", {{}, testing::moduleFolders()});
    ASSERT_EQ(idsOf(problems), "file-E10") << "the reason of a failure comes back";
    EXPECT_NE(problems[0].text.find("65535"), std::string::npos) << problems[0].text;
    EXPECT_EQ(forks, 3);
}

TEST_F(ReadImage, AJpegNamedBmpIsReadAsJpeg) {
    GLIBRA_NEED_MODULE();
    const Image image = testing::smoothImage(40, 30);
    ASSERT_TRUE(writeImage(image, folder / "posx.jpg", {{}, testing::moduleFolders()}).empty());
    fs::rename(folder / "posx.jpg", folder / "posx.bmp");
    const auto read = readImage(folder / "posx.bmp", kReadPlace, testing::withModule());
    ASSERT_TRUE(read);
    ASSERT_EQ(idsOf(read.diagnostics), "file-W03");
    EXPECT_EQ(read.diagnostics[0].text, "'posx.bmp' is a JPEG picture");
    EXPECT_LT(compare(image, *read).largest, .04);
}

TEST_F(ReadImage, LimitsHoldBeforeTheModuleReads) {
    GLIBRA_NEED_MODULE();
    ASSERT_TRUE(
        writeImage(testing::smoothImage(40, 30), folder / "a.tif", {{}, testing::moduleFolders()}).empty());
    ReadOptions options = testing::withModule();
    options.limits.side = 39;
    EXPECT_EQ(idsOf(readImage(folder / "a.tif", kReadPlace, options).diagnostics), "file-E09");
}

/// A JPEG with an additional segment after the start of the image.
std::vector<std::byte> withSegment(std::span<const std::byte> jpeg, int marker, const std::string& content) {
    std::vector<std::byte> file(jpeg.begin(), jpeg.begin() + 2);
    const auto length = static_cast<int>(content.size() + 2);
    for (const int each : {0xff, marker, length >> 8, length & 255})
        file.push_back(static_cast<std::byte>(each));
    for (const char each : content) file.push_back(static_cast<std::byte>(each));
    file.insert(file.end(), jpeg.begin() + 2, jpeg.end());
    return file;
}

TEST(JpegSegments, OnlyMetadataAreRemoved) {
    const auto plain = testing::bytesOf({0xff, 0xd8, 0xff, 0xe0, 0, 4,    1,    2, 0xff, 0xff, 0xee, 0, 3, 9,
                                         0xff, 0xdb, 0,    3,    7, 0xff, 0xda, 0, 2,    0xff, 0xe1, 0, 2});
    EXPECT_EQ(withoutMetadata(plain), plain);
    for (const int marker : {0xe1, 0xe2, 0xed, 0xef, 0xfe})
        EXPECT_EQ(withoutMetadata(withSegment(plain, marker, "Exif and more")), plain) << marker;
    EXPECT_EQ(withoutMetadata(withSegment(withSegment(plain, 0xe1, "a"), 0xfe, "b")), plain);
    EXPECT_NE(withoutMetadata(withSegment(plain, 0xee, "Adobe")), plain);
}

TEST(JpegSegments, DamageIsPassedOnAsItIs) {
    for (const auto& file :
         {testing::bytesOf({0xff, 0xd8}), testing::bytesOf({0xff, 0xd8, 0xff, 0xe1, 0, 1, 5}),
          testing::bytesOf({0xff, 0xd8, 0xff, 0xe1, 0xff, 0xff, 5}),
          testing::bytesOf({0xff, 0xd8, 1, 2, 3, 4, 5}),
          testing::bytesOf({0xff, 0xd8, 0xff, 0xff, 0xff, 0xff})})
        EXPECT_EQ(withoutMetadata(file), file);
}

TEST(JpegSegments, TheEndOfTheImageIsFoundAfterThePixels) {
    // A table, a scan with a stuffed ff and a restart marker, another scan, the end. An end marker inside a
    // segment does not count.
    const auto whole =
        testing::bytesOf({0xff, 0xd8, 0xff, 0xdb, 0, 4,    0xff, 0xd9, 0xff, 0xda, 0,    2,    1,   0xff,
                          0,    2,    0xff, 0xd3, 3, 0xff, 0xda, 0,    2,    4,    0xff, 0xff, 0xd9});
    EXPECT_TRUE(hasEndOfImage(whole));
    for (std::size_t length = 0; length < whole.size(); ++length)
        EXPECT_FALSE(hasEndOfImage(std::span(whole).first(length))) << length;
}

TEST_F(ReadImage, ExifNeitherRotatesAPictureNorStopsTheProgram) {
    GLIBRA_NEED_MODULE();
    const Image image = testing::smoothImage(24, 16);
    ASSERT_TRUE(writeImage(image, folder / "a.jpg", {{}, testing::moduleFolders()}).empty());
    const auto jpeg = readFile(folder / "a.jpg", {"a.jpg", {}});
    ASSERT_TRUE(jpeg);
    // Orientation 6 (rotated by 90 degrees), then the same with a count that is negative as a 32-bit number.
    std::string exif("Exif\0\0II*\0\x08\0\0\0\x01\0\x12\x01\x03\0\x01\0\0\0\x06\0\0\0\0\0\0\0", 32);
    for (const int highByteOfCount : {0, 0xdd}) {
        exif[23] = static_cast<char>(highByteOfCount);
        const auto read =
            readImage(put("b.jpg", withSegment(*jpeg, 0xe1, exif)), kReadPlace, testing::withModule());
        ASSERT_TRUE(read);
        EXPECT_EQ(read->width, 24);
        EXPECT_LT(compare(image, *read).largest, .04);
        EXPECT_EQ(idsOf(read.diagnostics), highByteOfCount == 0 ? "file-W15" : "");
    }
}

}  // namespace
}  // namespace glibra::image
