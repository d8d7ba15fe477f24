// Animations as one file: `glibra render --frames N -o film.mp4`. ffmpeg is a script here that keeps what it
// gets.

#include <gtest/gtest.h>
#include <unistd.h>

#include <cstdlib>
#include <string>
#include <vector>

#include "image/read.h"
#include "program.h"

namespace glibra::test {
namespace {

namespace fs = std::filesystem;

constexpr const char* kFilmScene = R"(WindowSize 20 15
Ortho -1 1 -1 1
Timer 1
Vertex a.vert
Fragment a.frag
Program P uGreen <0. .5 1.>
QuadXY 0. .7
)";

/// The name of the output file is the last argument; "file:" stands before it.
constexpr const char* kFfmpeg = R"(#!/bin/sh
printf '%s\n' "$@" >"$RECORD/arguments"
cat >"$RECORD/pixels"
for last; do :; done
echo "a film" >"${last#file:}"
)";
constexpr const char* kFailing = R"(#!/bin/sh
echo "first line" >&2
echo "Unknown encoder 'libx264'" >&2
exit 1
)";

class Film : public testing::Test {
  protected:
    Film() {
        folder.write("a.glib", kFilmScene);
        folder.write("a.vert",
                     "#version 330\nvoid main() { gl_Position = uModelViewProjectionMatrix * aVertex; }\n");
        folder.write("a.frag",
                     "#version 330\nuniform float uGreen; out vec4 c;\nvoid main() { c = vec4(Timer, uGreen, "
                     "0., 1.); }\n");
        fs::create_directory(folder / "record");
    }
    /// Puts a program of that content before the real ffmpeg, if there is one.
    [[nodiscard]] std::string with(const char* script) const {
        folder.write("bin/ffmpeg", script);
        fs::permissions(folder / "bin/ffmpeg", fs::perms::owner_all);
        return "PATH=\"" + (folder / "bin").string() + ":$PATH\" RECORD=\"" + (folder / "record").string() +
               "\"";
    }
    [[nodiscard]] std::string left() const {
        std::string names;
        for (const auto& each : fs::directory_iterator(folder.path()))
            if (!each.is_directory())
                names += each.path().filename().string() + "\n";
            else if (const std::string name = each.path().filename(); name != "bin" && name != "record")
                names += name + "/\n";
        return names;
    }
    [[nodiscard]] bool has(const char* name) const { return fs::exists(folder / name); }
    Folder folder;
};

/// The frames' RGB bytes, one frame after the other.
std::string pixelsOf(const Folder& folder, int frames) {
    std::string bytes;
    for (int i = 0; i < frames; ++i) {
        const std::string number = std::string(i < 10 ? "000" : "00") + std::to_string(i);
        const auto image = image::readImage(folder / ("s_" + number + ".png"));
        if (!image) return "no frame " + number;
        for (std::size_t at = 0; at < image->data.size(); ++at)
            if (image->components == 3 || at % 4 != 3) bytes += static_cast<char>(image->data[at]);
    }
    return bytes;
}

TEST_F(Film, GetsTheFramesInOrderAndIsOneFile) {
    const Finished run =
        glibra(folder.path(), "render a.glib --frames 17 --fps 10 -o film.mp4 --jobs 2", with(kFfmpeg));
    ASSERT_EQ(run.status, 0) << run.err;
    EXPECT_EQ(readFile(folder / "film.mp4"), "a film\n");
    EXPECT_FALSE(has("film_0000.png"));
    const std::string arguments = readFile(folder / "record/arguments");
    for (const char* each : {"\nrawvideo\n", "\nrgb24\n", "\n20x15\n", "-framerate\n10\n", "\npipe:0\n"})
        EXPECT_NE(arguments.find(each), std::string::npos) << each << arguments;
    ASSERT_EQ(glibra(folder.path(), "render a.glib --frames 17 --fps 10 -o s.png").status, 0);
    EXPECT_EQ(readFile(folder / "record/pixels"), pixelsOf(folder, 17));
    for (const auto& each : fs::directory_iterator(folder.path()))
        EXPECT_FALSE(each.path().filename().string().starts_with(".glibra")) << each.path();
}

TEST_F(Film, IsTheSameInASandbox) {
    const Finished run =
        glibra(folder.path(), "render a.glib --frames 3 -o film.webm --untrusted", with(kFfmpeg));
    ASSERT_EQ(run.status, 0) << run.err;
    EXPECT_EQ(readFile(folder / "film.webm"), "a film\n");
    ASSERT_EQ(glibra(folder.path(), "render a.glib --frames 3 -o s.png").status, 0);
    EXPECT_EQ(readFile(folder / "record/pixels"), pixelsOf(folder, 3));
}

TEST_F(Film, AGifNeedsNoFfmpegAndKeepsItsSize) {
    fs::create_directory(folder / "empty");
    const std::string without = "PATH=\"" + (folder / "empty").string() + "\"";
    const Finished run =
        glibra(folder.path(), "render a.glib --frames 3 --fps 10 -o film.GIF --jobs 2", without);
    ASSERT_EQ(run.status, 0) << run.err;
    EXPECT_NE(readFile(folder / "film.GIF").find("NETSCAPE2.0"), std::string::npos);
    const auto first = image::readImage(folder / "film.GIF");
    ASSERT_TRUE(first);
    EXPECT_EQ(std::pair(first->width, first->height), std::pair(20, 15));
    ASSERT_EQ(glibra(folder.path(), "render a.glib -o one.gif", without).status, 0);
    EXPECT_EQ(readFile(folder / "one.gif").find("NETSCAPE2.0"), std::string::npos)
        << "one frame is a picture";
}

TEST_F(Film, AnAnimatedPngNeedsNoFfmpeg) {
    fs::create_directory(folder / "empty");
    const std::string without = "PATH=\"" + (folder / "empty").string() + "\"";
    const Finished run =
        glibra(folder.path(), "render a.glib --frames 3 --fps 10 -o film.apng --jobs 2", without);
    ASSERT_EQ(run.status, 0) << run.err;
    EXPECT_FALSE(has("film_0000.png"));
    EXPECT_NE(readFile(folder / "film.apng").find("acTL"), std::string::npos);
    const auto first = image::readImage(folder / "film.apng");
    ASSERT_TRUE(first);
    EXPECT_EQ(first->width, 20);
    ASSERT_EQ(glibra(folder.path(), "render a.glib -o one.apng", without).status, 0);
    EXPECT_EQ(readFile(folder / "one.apng").find("acTL"), std::string::npos) << "one frame is a picture";
}

TEST_F(Film, ThatCannotBeWrittenIsNamedItself) {
    folder.write("a.frag",
                 "#version 330\nuniform float uGreen; out vec4 c;\nvoid main() { c = "
                 "vec4(fract(sin(dot(gl_FragCoord.xy, vec2(12.9898, 78.233))) * 43758.5453) + Timer * "
                 "uGreen * .01); }\n");
    for (const char* name : {"a.gif", "out/a.png"}) {
        const Finished finished =
            shell(folder.path(), std::string("(ulimit -f 8; exec '" GLIBRA_PROGRAM
                                             "' render a.glib --size 200x200 --frames 2 -o ") +
                                     name + ")");
        EXPECT_EQ(finished.status, 3) << finished.err;
        EXPECT_TRUE(
            contains(finished.err, std::string("cannot write '") +
                                       (std::string_view(name) == "a.gif" ? "a.gif'" : "out/a_0000.png'")))
            << finished.err;
        EXPECT_FALSE(contains(finished.err, ".glibra-")) << finished.err;
    }
}

TEST_F(Film, WithoutFfmpegNothingIsDrawn) {
    fs::create_directory(folder / "empty");
    const Finished run = glibra(folder.path(), "render a.glib --frames 2 -o film.mp4",
                                "PATH=\"" + (folder / "empty").string() + "\"");
    EXPECT_EQ(run.status, 4);
    EXPECT_NE(run.err.find("ffmpeg is not installed"), std::string::npos) << run.err;
    EXPECT_FALSE(has("film.mp4"));
}

TEST_F(Film, AFailureOfFfmpegIsReportedWithItsMessage) {
    folder.write("film.mp4", "the film of yesterday");
    const Finished run = glibra(folder.path(), "render a.glib --frames 2 -o film.mp4", with(kFailing));
    EXPECT_EQ(run.status, 3);
    EXPECT_NE(run.err.find("cannot write 'film.mp4': ffmpeg: Unknown encoder 'libx264'"), std::string::npos)
        << run.err;
    EXPECT_EQ(readFile(folder / "film.mp4"), "the film of yesterday");
    EXPECT_EQ(left().find(".glibra"), std::string::npos) << left();
}

TEST_F(Film, ASceneWithAnErrorGivesNoFilm) {
    folder.write("a.frag", "#version 330\nout vec4 c;\nvoid main() { c = oops; }\n");
    const Finished run = glibra(folder.path(), "render a.glib --frames 2 -o film.mp4", with(kFfmpeg));
    EXPECT_EQ(run.status, 3);
    EXPECT_FALSE(has("film.mp4"));
    EXPECT_FALSE(has("record/pixels"));
}

TEST_F(Film, OnePictureIsNoVideo) {
    const Finished run = glibra(folder.path(), "render a.glib -o film.mp4", with(kFfmpeg));
    EXPECT_EQ(run.status, 2);
    EXPECT_NE(run.err.find("--frames"), std::string::npos) << run.err;
    EXPECT_FALSE(has("film.mp4"));
}

TEST_F(Film, TheRealProgramWritesFramesOfTheRightNumberAndSize) {
    if (std::system("command -v ffmpeg >/dev/null && command -v ffprobe >/dev/null") != 0)
        GTEST_SKIP() << "no ffmpeg";
    for (const char* name : {"film.mp4", "film.gif"}) {
        const Finished run =
            glibra(folder.path(), std::string("render a.glib --frames 7 --fps 10 -o ") + name);
        ASSERT_EQ(run.status, 0) << run.err;
        const Finished probe =
            shell(folder.path(),
                  "ffprobe -v error -count_frames -show_entries stream=nb_read_frames,width -of "
                  "csv=p=0 " +
                      std::string(name));
        EXPECT_EQ(probe.out, "20,7\n") << name;
    }
}

}  // namespace
}  // namespace glibra::test
