// glibra compare: figures, heat map, exit status.

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

#include "image/png/png_writer.h"
#include "image/read.h"
#include "image/write.h"
#include "program.h"

namespace glibra::test {
namespace {

class CompareCommand : public testing::Test {
  protected:
    void SetUp() override {
        put("a.png", 100, 0);
        put("same.png", 100, 0, 9);  // equal pixels, different bytes
        put("near.png", 100, 2);
        put("far.png", 100, 60);
    }

    /// Writes 40 x 30 grey pixels with a brighter square.
    void put(const std::string& name, int value, int by, int level = 1) const {
        image::Image picture{40, 30, 3, image::Component::u8, {}};
        for (int y = 0; y < 30; ++y)
            for (int x = 0; x < 40; ++x)
                for (int c = 0; c < 3; ++c)
                    picture.data.push_back(
                        static_cast<std::byte>(value + (x / 8 == 2 && y / 8 == 1 ? by : 0)));
        const auto file = image::encodePng(picture, {.level = level, .text = {}});
        folder.write(name, {reinterpret_cast<const char*>(file.data()), file.size()});
    }

    [[nodiscard]] Finished compare(const std::string& arguments) const {
        return glibra(folder.path(), "compare " + arguments);
    }

    static void expectContains(const std::string& text, std::string_view part) {
        EXPECT_NE(text.find(part), std::string::npos) << part << "\nin\n" << text;
    }

    Folder folder;
};

TEST_F(CompareCommand, EqualPixelsAreIdentical) {
    for (const char* pair : {"a.png a.png", "a.png same.png", "a.png same.png --exact"}) {
        const Finished run = compare(pair);
        EXPECT_EQ(run.status, 0) << pair;
        EXPECT_EQ(run.out, "identical\n") << pair;
        EXPECT_EQ(run.err, "") << pair;
    }
}

TEST_F(CompareCommand, SmallDifferencesPassAndExactRefusesThem) {
    const Finished within = compare("a.png near.png");
    EXPECT_EQ(within.status, 0) << within.out;
    expectContains(within.out, "within tolerance: the largest difference is 2 of 255 at 16, 8");
    EXPECT_EQ(compare("a.png near.png --max 1").status, 1);
    EXPECT_EQ(compare("a.png near.png --bias 0.1").status, 1);
    EXPECT_EQ(compare("a.png near.png --exact").status, 1);
}

TEST_F(CompareCommand, LargeDifferencesFailWithTheirFigures) {
    const Finished run = compare("a.png far.png");
    EXPECT_EQ(run.status, 1);
    expectContains(run.out, "different: 64 pixels differ by more than 3 of 255 (allowed: 0)");
    expectContains(run.out, "60 of 255 at 16, 8");
    EXPECT_EQ(compare("a.png far.png --fraction 1").status, 1) << "they touch";
    EXPECT_EQ(compare("a.png far.png --fraction 1 --cluster 64 --line 7 --bias 3").status, 1);
    EXPECT_EQ(compare("a.png far.png --fraction 1 --cluster 64 --line 8 --bias 3").status, 0);
    EXPECT_EQ(compare("a.png far.png --max 60 --bias 60").status, 0);
    EXPECT_EQ(compare("a.png far.png --flip 0.5").status, 0);
    EXPECT_EQ(compare("a.png far.png --flip 0.0001").status, 1);
    EXPECT_EQ(compare("a.png far.png --structure 0.01").status, 1);
}

TEST_F(CompareCommand, JsonHasTheFigures) {
    const Finished run = compare("a.png far.png --json --all");
    EXPECT_EQ(run.status, 1);
    for (const char* part :
         {"\"same\": false", "\"decidedBy\": \"differences\"", "\"largest\": 60.0", "\"differingPixels\": 64",
          "\"beyond\": 64", "\"flip\": 0.", "\"structure\": 0."})
        expectContains(run.out, part);
    expectContains(compare("a.png a.png --json").out, "\"decidedBy\": \"bytes\"");
}

TEST_F(CompareCommand, HeatMapShowsThePlace) {
    EXPECT_EQ(compare("a.png far.png --heatmap map.png").status, 1);
    EXPECT_EQ(compare("a.png far.png --flip 1 --heatmap flip.png").status, 0);
    EXPECT_EQ(compare("a.png a.png --heatmap none.png").status, 0);
    const auto map = image::readImage(folder / "map.png");
    const auto none = image::readImage(folder / "none.png");
    ASSERT_TRUE(map && none && image::readImage(folder / "flip.png"));
    ASSERT_EQ(map->width, 40);
    EXPECT_EQ(map->row(0)[0], std::byte{0});
    EXPECT_GT(map->row(12)[4 * 20], std::byte{128});
    EXPECT_EQ(none->row(12)[4 * 20], std::byte{0});
    EXPECT_NE(readFile(folder / "map.png"), readFile(folder / "flip.png"));
}

TEST_F(CompareCommand, OtherSizesDiffer) {
    const auto file = image::encodePng({1, 1, 1, image::Component::u8, {std::byte{100}}});
    folder.write("dot.png", {reinterpret_cast<const char*>(file.data()), file.size()});
    const Finished run = compare("a.png dot.png --heatmap map.png");
    EXPECT_EQ(run.status, 1);
    EXPECT_EQ(run.out, "different: the sizes differ: expected 40 x 30, found 1 x 1\n");
    expectContains(run.err, "warning: no heat map");
    EXPECT_FALSE(std::filesystem::exists(folder / "map.png"));
    expectContains(compare("a.png dot.png --json").out, "\"sizes\"");
}

TEST_F(CompareCommand, UnreadableFilesAreStatusThree) {
    folder.write("text.png", "no picture");
    folder.write("cut.png", readFile(folder / "a.png").substr(0, 60));
    for (const char* pair : {"a.png none.png", "none.png a.png", "a.png text.png", "text.png text.png",
                             "cut.png cut.png", "a.png ."}) {
        const Finished run = compare(pair);
        EXPECT_EQ(run.status, 3) << pair;
        EXPECT_EQ(run.out, "") << pair;
        expectContains(run.err, "error: ");
    }
    expectContains(compare("a.png none.png").err, "none.png:1:1: error: cannot find 'none.png' [file-E01]");
    EXPECT_EQ(compare("a.png far.png --heatmap /proc/none/map.png").status, 3);
}

TEST_F(CompareCommand, WrongUsageIsStatusTwo) {
    for (const char* arguments :
         {"", "a.png", "a.png a.png a.png", "a.png a.png --max 256", "a.png a.png --fraction 2",
          "a.png a.png --flip -1", "a.png a.png --nonsense"})
        EXPECT_EQ(compare(arguments).status, 2) << arguments;
}

TEST_F(CompareCommand, FoldersAreComparedPictureByPicture) {
    const std::string a = readFile(folder / "a.png"), far = readFile(folder / "far.png");
    for (const char* each :
         {"one/same.png", "two/same.png", "one/other.png", "one/deep/gone.png", "two/deep/b.png"})
        folder.write(each, a);
    folder.write("two/other.png", far);
    folder.write("one/notes.txt", "no picture");
    const Finished run = compare("one two");
    EXPECT_EQ(run.status, 1);
    expectContains(run.out, "deep/b.png: missing from one\n");
    expectContains(run.out, "deep/gone.png: missing from two\n");
    expectContains(run.out, "other.png: different: ");
    expectContains(run.out, "same.png: identical\n");
    expectContains(run.err, "1 of 4 pictures are the same");
    const Finished json = compare("one two --json --heatmap maps");
    expectContains(json.out, "\"name\": \"same.png\"");
    EXPECT_TRUE(std::filesystem::exists(folder / "maps/other.png"));
    EXPECT_EQ(compare("one one").status, 0);
    std::filesystem::create_directory(folder / "empty");
    EXPECT_EQ(compare("empty empty").status, 3);
}

/// The libraries of the image module take more than that before they read anything.
TEST_F(CompareCommand, LibrariesAreNotPartOfTheLimitOfMemory) {
    const std::vector<std::byte> pixels(40 * 30 * 3, std::byte{9});
    const image::Image small{40, 30, 3, image::Component::u8, pixels};
    ASSERT_TRUE(image::writeImage(small, folder / "a.tif").empty());
    ASSERT_TRUE(image::writeImage(small, folder / "b.png").empty());
    for (const char* limit : {"64M", "80M", "100M"}) {
        const Finished run = compare(std::string("a.tif b.png --memory ") + limit);
        EXPECT_TRUE(run.status == 0 || run.status == 3) << limit << ": " << run.status << run.err;
    }
}

TEST_F(CompareCommand, PicturesAreAsLargeAsThoseThatAreDrawn) {
    const auto strip = [](int side) {
        return image::Image{side, 1, 3, image::Component::u8,
                            std::vector<std::byte>(static_cast<std::size_t>(side) * 3)};
    };
    ASSERT_TRUE(image::writeImage(strip(20'000), folder / "a.png").empty());
    ASSERT_TRUE(image::writeImage(strip(65'537), folder / "b.png").empty());
    EXPECT_EQ(compare("a.png a.png --all").status, 0);
    expectContains(compare("a.png b.png").err, "the limit is 65536 per side");
}

TEST_F(CompareCommand, AFigureThatIsAtItsLimitSaysSo) {
    const auto file = [](int shade) {
        std::vector<std::byte> pixels(64 * 64 * 3, static_cast<std::byte>(shade));
        const auto png = image::encodePng({64, 64, 3, image::Component::u8, std::move(pixels)});
        return std::string(reinterpret_cast<const char*>(png.data()), png.size());
    };
    folder.write("dark.png", file(10));
    folder.write("light.png", file(200));
    expectContains(compare("dark.png light.png").out, "mean of a block     at least 3 of 255 at");
    expectContains(compare("dark.png light.png --json").out, "\"biasCountsUpTo\": 3");
    EXPECT_EQ(compare("dark.png dark.png --heatmap m.png").out.find("at least"), std::string::npos);
}

}  // namespace
}  // namespace glibra::test
