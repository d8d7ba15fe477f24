#include "suite/report/report_files.h"

#include <gtest/gtest.h>
#include <libdeflate.h>

#include <algorithm>
#include <cstring>
#include <nlohmann/json.hpp>
#include <random>

#include "folder.h"
#include "image/write.h"
#include "results_maker.h"
#include "suite/report/report_pictures.h"

namespace glibra::suite {
namespace {

namespace fs = std::filesystem;

image::Image noise(int width, int height, int components, image::Component type) {
    image::Image picture{width, height, components, type, {}};
    picture.data.resize(picture.rowBytes() * static_cast<std::size_t>(height));
    std::mt19937 random(7);
    for (std::byte& each : picture.data) each = static_cast<std::byte>(random());
    return picture;
}

/// Unpacks the text of packedPixels as the script of the page does, written independently of the writer.
std::vector<std::byte> unpacked(const std::string& json, std::size_t size) {
    const auto parsed = nlohmann::json::parse(json);
    std::vector<std::byte> compressed;
    unsigned group = 0;
    int bits = 0;
    const std::string digits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    for (const char digit : parsed.at("data").get<std::string>()) {
        if (digit == '=') break;
        group = group << 6U | static_cast<unsigned>(digits.find(digit));
        bits += 6;
        if (bits >= 8)
            compressed.push_back(static_cast<std::byte>(group >> static_cast<unsigned>(bits -= 8)));
    }
    std::vector<std::byte> bytes(size);
    libdeflate_decompressor* decompressor = libdeflate_alloc_decompressor();
    EXPECT_EQ(libdeflate_zlib_decompress(decompressor, compressed.data(), compressed.size(), bytes.data(),
                                         size, nullptr),
              LIBDEFLATE_SUCCESS);
    libdeflate_free_decompressor(decompressor);
    const std::size_t row = size / parsed.at("height").get<std::size_t>();
    for (std::size_t i = row; i < size; ++i)
        bytes[i] =
            static_cast<std::byte>(std::to_integer<int>(bytes[i]) + std::to_integer<int>(bytes[i - row]));
    return bytes;
}

TEST(PackedPixels, ComeBackBitForBit) {
    for (const auto type : {image::Component::u8, image::Component::u16, image::Component::f32})
        for (const int components : {3, 4})
            for (const auto& [width, height] : {std::pair{1, 1}, {5, 3}, {2, 7}, {64, 1}}) {
                const image::Image picture = noise(width, height, components, type);
                EXPECT_EQ(unpacked(packedPixels(picture), picture.data.size()), picture.data);
            }
}

TEST(PackedPixels, LeaveOutAnOpaqueAlpha) {
    image::Image picture = noise(4, 4, 4, image::Component::u8);
    for (std::size_t i = 3; i < picture.data.size(); i += 4) picture.data[i] = std::byte{255};
    EXPECT_EQ(nlohmann::json::parse(packedPixels(picture)).at("components"), 3);
    picture.data[3] = std::byte{254};
    EXPECT_EQ(nlohmann::json::parse(packedPixels(picture)).at("components"), 4);
}

class HtmlReport : public testing::Test {
  protected:
    HtmlReport() {
        picture("a.png");
        picture("b.png");
    }
    void picture(const std::string& name) {
        EXPECT_TRUE(
            image::writeImage(noise(8, 6, 3, image::Component::u8), folder / "results" / name).empty());
    }
    Diagnostics write(std::vector<ShotResult> shots) {
        RunResult run;
        run.shots = std::move(shots);
        return writeHtmlReport(run, folder / "results", folder / "report");
    }
    static ShotResult failed() {
        ShotResult shot;
        shot.suite = "s";
        shot.shot = "a";
        shot.verdict = Verdict::failed;
        shot.expected = "a.png";
        shot.got = "b.png";
        return shot;
    }
    /// The JSON data in the page.
    nlohmann::json data() const {
        const std::string page = textOf(folder / "report/index.html");
        const std::string begin = "<script type=\"application/json\" id=\"data\">";
        const std::size_t from = page.find(begin) + begin.size();
        return nlohmann::json::parse(page.substr(from, page.find("</script>", from) - from));
    }
    std::vector<std::string> files(const std::string& name) const {
        std::vector<std::string> names;
        for (const auto& each : fs::directory_iterator(folder / "report" / name))
            names.push_back(each.path().filename().string());
        std::ranges::sort(names);
        return names;
    }

    struct WithResults : Folder {
        WithResults() { fs::create_directories(*this / "results"); }
    } folder;
};

TEST_F(HtmlReport, HasTheWarningsOfPasses) {
    ShotResult shot = failed();
    shot.verdict = Verdict::passed;
    shot.diagnostics = {diagnose("draw-N01", "no LookAt"), diagnose("glib-W23", "no uniform 'uKe'")};
    EXPECT_TRUE(write({shot}).empty());
    const nlohmann::json told = data().at("shots").at(0).at("diagnostics");
    ASSERT_EQ(told.size(), 1U);
    EXPECT_EQ(told.at(0).at(1), "glib-W23");
}

TEST_F(HtmlReport, ReplacesAnEarlierReportAndLeavesOtherFilesAlone) {
    ASSERT_TRUE(write({failed(), failed(), failed()}).empty());
    writeText(folder / "report/pictures/holiday.png", "mine");
    writeText(folder / "report/pictures/2024.png", "mine");
    ASSERT_TRUE(write({failed()}).empty());
    const std::vector<std::string> pictures = files("pictures");
    ASSERT_EQ(pictures.size(), 4U);
    EXPECT_EQ(pictures[2], "2024.png");
    EXPECT_EQ(pictures[3], "holiday.png");
    EXPECT_EQ(files("pixels").size(), 1U);
}

TEST_F(HtmlReport, LeavesTheOldPageWholeUntilTheNewOneIsThere) {
    ASSERT_TRUE(write({failed()}).empty());
    const nlohmann::json old = data().at("shots").at(0);
    std::map<std::string, std::string> shown;
    for (const char* key : {"expected", "got", "pixels"})
        shown[old.at(key)] = textOf(folder / "report" / old.at(key).get<std::string>());
    fs::copy_file(folder / "results/a.png", folder / "results/b.png", fs::copy_options::overwrite_existing);
    fs::remove(folder / "report/index.html");
    fs::create_directories(folder / "report/index.html/in the way");
    ASSERT_FALSE(write({failed()}).empty());
    for (const auto& [file, content] : shown) EXPECT_EQ(textOf(folder / "report" / file), content) << file;
}

TEST_F(HtmlReport, CopiesPicturesAsTheyAre) {
    ASSERT_TRUE(write({failed()}).empty());
    const std::string got = data().at("shots").at(0).at("got");
    EXPECT_EQ(textOf(folder / "report" / got), textOf(folder / "results/b.png"));
}

TEST_F(HtmlReport, KeepsOnePictureOfAPassByEqualBytes) {
    ShotResult pass = failed();
    pass.verdict = Verdict::passed;
    pass.exact = true;
    ASSERT_TRUE(write({pass}).empty());
    ASSERT_EQ(files("pictures").size(), 1U);
    EXPECT_TRUE(files("pixels").empty());
    EXPECT_EQ(data().at("shots").at(0).at("expected"), "pictures/" + files("pictures").front());
}

TEST_F(HtmlReport, ReportsAMissingPictureAndAFileThatIsNotAPicture) {
    ShotResult absent = failed(), damaged = failed();
    absent.got = "gone.png";
    damaged.got = "text.png";
    writeText(folder / "results/text.png", "no picture");
    const Diagnostics problems = write({absent, damaged});
    ASSERT_EQ(problems.size(), 2U);
    EXPECT_EQ(problems[0].id, "result-W02");
    EXPECT_NE(problems[0].text.find("'s/a': cannot find 'gone.png'"), std::string::npos) << problems[0].text;
    EXPECT_FALSE(hasError(problems));
    EXPECT_EQ(data().at("shots").at(0).at("remarks").size(), 1U);
    EXPECT_FALSE(data().at("shots").at(1).contains("got"));
}

TEST_F(HtmlReport, FourHundredMissingPicturesAreNotFourHundredMessages) {
    ShotResult absent = failed();
    absent.got = "gone.png";
    EXPECT_LE(write(std::vector(400, absent)).size(), 20U);
}

TEST_F(HtmlReport, AFolderThatCannotBeMadeIsOneError) {
    writeText(folder / "report", "a file");
    const Diagnostics problems = write({failed(), failed()});
    ASSERT_EQ(problems.size(), 1U);
    EXPECT_EQ(problems[0].id, "file-E10");
}

TEST_F(HtmlReport, APageIsNotReplacedWhenItsFilesCannotBeWritten) {
    ASSERT_TRUE(write({failed(), failed()}).empty());
    const std::string page = textOf(folder / "report/index.html");
    fs::remove_all(folder / "report/pixels");
    writeText(folder / "report/pixels", "a file in the way");
    EXPECT_TRUE(hasError(write({failed()})));
    EXPECT_EQ(textOf(folder / "report/index.html"), page);
    EXPECT_EQ(files("pictures").size(), 4U);
}

TEST_F(HtmlReport, HoldsEachSceneOnce) {
    writeText(folder / "results/scene.glib", "Sphere 1\n\xff\n");
    ShotResult shot = failed();
    shot.script = "scene.glib";
    shot.diagnostics.push_back(diagnose("glib-W01", "x", {"scene.glib", 1, 1}));
    ASSERT_TRUE(write({shot, shot, shot}).empty());
    ASSERT_EQ(data().at("sources").size(), 1U);
    EXPECT_EQ(data().at("sources").at(0).at("text"), "Sphere 1\n\xef\xbf\xbd\n");
    EXPECT_EQ(data().at("shots").at(2).at("sources"), std::vector{0});
}

TEST_F(HtmlReport, NoTextOfAResultIsMarkup) {
    ResultsMaker maker(8);
    std::vector<ShotResult> shots(200);
    for (ShotResult& each : shots) each = maker.shot();
    for (ShotResult& each : shots) {
        each.reason += "</script></noscript><!--<script>{{data}}{{style}}";
        each.shot += "<img src=x>\"'";
    }
    EXPECT_FALSE(hasError(write(shots)));
    const std::string page = textOf(folder / "report/index.html");
    const auto count = [&](const std::string& part) {
        int found = 0;
        for (std::size_t at = page.find(part); at != std::string::npos; at = page.find(part, at + 1)) ++found;
        return found;
    };
    EXPECT_EQ(count("</script"), 2);
    EXPECT_EQ(count("<script"), 2);
    EXPECT_EQ(count("</noscript"), 1);
    EXPECT_EQ(count("<!--"), 0);
    EXPECT_EQ(count("<img src=x"), 0);
    EXPECT_EQ(count("<style>"), 1);
    EXPECT_EQ(data().at("shots").size(), 200U);
}

TEST_F(HtmlReport, APictureThatBrowsersDoNotKnowIsMadeAPng) {
    const Diagnostics problems =
        image::writeImage(noise(4, 4, 3, image::Component::f32), folder / "results/float.exr");
    if (!problems.empty()) GTEST_SKIP() << problems.front().text;
    ShotResult shot = failed();
    shot.got = "float.exr";
    const Diagnostics told = write({shot});
    ASSERT_TRUE(told.empty()) << told.front().text;
    const nlohmann::json shown = data().at("shots").at(0);
    EXPECT_EQ(textOf(folder / "report" / shown.at("got").get<std::string>()).substr(1, 3), "PNG");
    EXPECT_NE(textOf(folder / "report" / shown.at("pixels").get<std::string>()).find("\"type\":\"f32\""),
              std::string::npos);
}

}  // namespace
}  // namespace glibra::suite
