#include "view/export/hardcopy.h"

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <span>

#include "image/read.h"
#include "image/video/video_file.h"
#include "scene_folder.h"
#include "system/places.h"

namespace glibra::test {
namespace {

using view::Session;

/// The pixels without the alpha channel that readers add.
std::vector<std::byte> rgb(const image::Image& image) {
    std::vector<std::byte> result;
    for (std::size_t i = 0; i < image.data.size(); ++i)
        if (image.components == 3 || i % 4 != 3) result.push_back(image.data[i]);
    return result;
}

/// Writes all frames of a hardcopy.
Diagnostics writeAll(const Session& session, const view::Hardcopy& wanted) {
    Result<view::HardcopyJob> job = view::HardcopyJob::begin(context(), session, wanted);
    Diagnostics diagnostics = std::move(job.diagnostics);
    while (job && !job->isDone()) append(diagnostics, job->step());
    return diagnostics;
}

class ChangedScene : public testing::Test {
  protected:
    ChangedScene() : session(context(), {}) {
        EXPECT_TRUE(session.open(GLIBRA_SOURCE_DIR "/glib/patterns/ovalnoise.glib"));
        session.look().resize(300, 200);
        session.drawIfNeeded();
        changeOvalNoise(session, 150, 100);
        session.drawIfNeeded();
    }
    SceneFolder folder{""};
    Session session;
};

TEST_F(ChangedScene, HardcopyHasThePixelsOfTheScreen) {
    const view::Hardcopy wanted{folder / "a.png"};
    const Diagnostics problems = writeAll(session, wanted);
    ASSERT_FALSE(hasError(problems)) << text(problems);
    const auto image = image::readImage(wanted.file);
    ASSERT_TRUE(image) << text(image.diagnostics);
    EXPECT_TRUE(rgb(*image) == pixelsOf(session));
}

TEST_F(ChangedScene, TheCommandLineGivesTheSameBytes) {
    for (const auto& [width, height] : {std::pair(0, 0), std::pair(517, 233)}) {
        const view::Hardcopy hardcopy{folder / "a.png", width, height};
        ASSERT_FALSE(hasError(writeAll(session, hardcopy)));
        const view::Hardcopy again{folder / "b.png", width, height};
        std::string command = view::renderCommand(session, again);
        ASSERT_TRUE(command.starts_with("glibra render "));
        command = "'" GLIBRA_PROGRAM "'" + command.substr(6);
        ASSERT_EQ(std::system(command.c_str()), 0) << command;
        const auto first = image::readImage(hardcopy.file);
        const auto second = image::readImage(again.file);
        ASSERT_TRUE(first && second);
        EXPECT_EQ(first->width, second->width);
        EXPECT_TRUE(first->data == second->data) << command;
    }
}

TEST_F(ChangedScene, ThePictureCarriesTheCommandLine) {
    for (const char* name : {"a.png", "a.exr", "a.tif", "a.jpg"}) {
        const view::Hardcopy wanted{folder / name};
        const Diagnostics problems = writeAll(session, wanted);
        ASSERT_FALSE(hasError(problems)) << text(problems);
        EXPECT_NE(folder.read(name).find(view::renderCommand(session, wanted)), std::string::npos) << name;
    }
}

TEST_F(ChangedScene, FramesGoOnFromThePresentTime) {
    const view::Hardcopy wanted{folder / "a.png", 0, 0, 2, 4};
    ASSERT_FALSE(hasError(writeAll(session, wanted)));
    const auto first = image::readImage(folder / "a_0000.png");
    ASSERT_TRUE(first);
    EXPECT_TRUE(rgb(*first) == pixelsOf(session));
    EXPECT_TRUE(std::filesystem::exists(folder / "a_0001.png"));
    EXPECT_NE(view::renderCommand(session, wanted).find("--frames 2 --fps 4"), std::string::npos);
}

TEST_F(ChangedScene, AVideoHoldsTheFramesAsked) {
    if (!image::hasFfmpeg()) GTEST_SKIP() << "no ffmpeg";
    const view::Hardcopy wanted{folder / "a.mp4", 65, 41, 7, 10};
    const Diagnostics problems = writeAll(session, wanted);
    ASSERT_FALSE(hasError(problems)) << text(problems);
    const std::string command =
        "ffprobe -v error -count_frames -show_entries stream=nb_read_frames,width -of csv=p=0 '" +
        wanted.file.string() + "' >'" + (folder / "probe.txt").string() + "'";
    ASSERT_EQ(std::system(command.c_str()), 0);
    EXPECT_EQ(folder.read("probe.txt"), "66,7\n");
}

/// A script in place of ffmpeg, first in PATH. It keeps the pixels that it gets.
class FakeFfmpeg {
  public:
    explicit FakeFfmpeg(const SceneFolder& folder) : before_(std::getenv("PATH")) {
        folder.write(
            "ffmpeg",
            "#!/bin/sh\nfor last; do :; done\ncat >\"${0%/*}/pixels\"\necho film >\"${last#file:}\"\n");
        std::filesystem::permissions(folder / "ffmpeg", std::filesystem::perms::owner_all);
        system::setVariable("PATH", (folder / "").string() + ":" + before_, system::Replace::yes);
    }
    ~FakeFfmpeg() { system::setVariable("PATH", before_, system::Replace::yes); }
    FakeFfmpeg(const FakeFfmpeg&) = delete;
    FakeFfmpeg& operator=(const FakeFfmpeg&) = delete;

  private:
    std::string before_;
};

TEST_F(ChangedScene, AFilmGetsThePixelsOfItsFrames) {
    const FakeFfmpeg ffmpeg(folder);
    Result<view::HardcopyJob> job =
        view::HardcopyJob::begin(context(), session, {folder / "a.webm", 0, 0, 2, 4});
    ASSERT_TRUE(job) << text(job.diagnostics);
    EXPECT_FALSE(hasError(job->step()));
    EXPECT_EQ(job->filesWritten(), "") << "the film is not complete";
    EXPECT_FALSE(std::filesystem::exists(folder / "a.webm"));
    EXPECT_FALSE(hasError(job->step()));
    EXPECT_TRUE(job->isDone());
    EXPECT_EQ(job->filesWritten(), (folder / "a.webm").string() + ": 2 frames of 300 x 200 pixels");
    EXPECT_EQ(folder.read("a.webm"), "film\n");
    const std::string pixels = folder.read("pixels");
    ASSERT_EQ(pixels.size(), std::size_t{2} * 300 * 200 * 3);
    const std::vector<std::byte> screen = pixelsOf(session);
    EXPECT_TRUE(std::equal(screen.begin(), screen.end(), std::as_bytes(std::span(pixels)).begin()));
}

TEST_F(ChangedScene, WithoutFfmpegAFilmIsAnErrorWithAHint) {
    const std::string before = std::getenv("PATH");
    system::setVariable("PATH", "/nowhere", system::Replace::yes);
    const Diagnostics problems = writeAll(session, {folder / "a.webm", 0, 0, 2, 4});
    system::setVariable("PATH", before, system::Replace::yes);
    EXPECT_NE(text(problems).find("ffmpeg is not installed"), std::string::npos) << text(problems);
    EXPECT_FALSE(std::filesystem::exists(folder / "a.webm"));
}

TEST_F(ChangedScene, LabelsAreInTheFileWhenTheyAreOnTheScreen) {
    session.look().setLabels(LabelCorner::bottomLeft);
    const view::Hardcopy wanted{folder / "a.png", 600, 600};
    ASSERT_FALSE(hasError(writeAll(session, wanted)));
    const auto labelled = image::readImage(wanted.file);
    session.look().setLabels(LabelCorner::none);
    ASSERT_FALSE(hasError(writeAll(session, wanted)));
    const auto plain = image::readImage(wanted.file);
    ASSERT_TRUE(labelled && plain);
    // Only the lower left part differs, and it has as many lines as the scene has values.
    int left = 600, right = 0, top = 600, bottom = 0;
    for (int y = 0; y < 600; ++y)
        for (int x = 0; x < 600; ++x) {
            const auto at = static_cast<std::size_t>(4 * (y * 600 + x));
            if (std::equal(labelled->data.begin() + static_cast<std::ptrdiff_t>(at),
                           labelled->data.begin() + static_cast<std::ptrdiff_t>(at) + 4,
                           plain->data.begin() + static_cast<std::ptrdiff_t>(at)))
                continue;
            left = std::min(left, x);
            right = std::max(right, x);
            top = std::min(top, y);
            bottom = std::max(bottom, y);
        }
    EXPECT_LT(left, 8);
    EXPECT_LT(right, 400);
    EXPECT_GT(bottom, 570);
    const auto lines = static_cast<int>(session.live().labels().size());
    EXPECT_GT(lines, 4);
    EXPECT_NEAR(bottom - top, lines * 16, 12);
}

TEST_F(ChangedScene, LabelsHaveTheFormOfGlman) {
    const std::vector<std::string> labels = session.live().labels();
    const auto has = [&](const char* line) {
        return std::find(labels.begin(), labels.end(), line) != labels.end();
    };
    EXPECT_TRUE(has("OvalNoise : uAd = 0.3100")) << labels.front();
    EXPECT_TRUE(has("OvalNoise : uDotColor = 0.2000 0.7000 0.1000"));
    EXPECT_TRUE(has("OvalNoise : uUseChromaDepth = false"));
}

TEST_F(ChangedScene, TheCommandOfALabelledHardcopyGivesTheSameBytes) {
    session.look().setLabels(LabelCorner::topRight);
    const view::Hardcopy hardcopy{folder / "a.png", 640, 480};
    ASSERT_FALSE(hasError(writeAll(session, hardcopy)));
    std::string command = view::renderCommand(session, {folder / "b.png", 640, 480});
    EXPECT_NE(command.find("--labels top-right"), std::string::npos) << command;
    command = "'" GLIBRA_PROGRAM "'" + command.substr(6);
    ASSERT_EQ(std::system(command.c_str()), 0) << command;
    const auto first = image::readImage(hardcopy.file);
    const auto second = image::readImage(folder / "b.png");
    ASSERT_TRUE(first && second);
    EXPECT_TRUE(first->data == second->data);
}

TEST_F(ChangedScene, TheFilesThatExistAreNamed) {
    auto job = view::HardcopyJob::begin(context(), session, {folder / "a.png", 30, 20, 3, 4});
    ASSERT_TRUE(job) << text(job.diagnostics);
    EXPECT_EQ(job->filesWritten(), "");
    EXPECT_FALSE(hasError(job->step()));
    EXPECT_EQ(job->filesWritten(), (folder / "a_0000.png").string() + ": 30 x 20 pixels");
    EXPECT_FALSE(hasError(job->step()));
    EXPECT_EQ(job->filesWritten(),
              (folder / "a_0000.png").string() + " to a_0001.png: 2 files of 30 x 20 pixels");
}

TEST(HardcopyName, IsFreeAndCountsOn) {
    const SceneFolder folder("");
    const auto next = [&](const char* name, int frames = 1) {
        return view::freeName({folder / name, 0, 0, frames}).filename().string();
    };
    EXPECT_EQ(next("a.png"), "a.png");
    folder.write("a.png", "x");
    EXPECT_EQ(next("a.png"), "a-2.png");
    EXPECT_EQ(next("a.bmp"), "a.bmp");
    folder.write("a-2.png", "x");
    folder.write("a-4.png", "x");
    EXPECT_EQ(next("a.png"), "a-3.png");
    EXPECT_EQ(next("a-4.png"), "a-5.png");
    EXPECT_EQ(next("a.png", 7), "a.png") << "the frames have other names";
    folder.write("a_0000.png", "x");
    EXPECT_EQ(next("a.png", 7), "a-2.png");
    folder.write("film.mp4", "x");
    EXPECT_EQ(next("film.mp4", 7), "film-2.mp4");
    folder.write("scan-20260101.png", "x");
    EXPECT_EQ(next("scan-20260101.png"), "scan-20260101-2.png") << "a date is no number to count on";
    EXPECT_TRUE(view::replacesFile({folder / "a.png"}));
    EXPECT_FALSE(view::replacesFile({folder / "b.png"}));
}

TEST_F(ChangedScene, AStoppedFilmLeavesNoFile) {
    const FakeFfmpeg ffmpeg(folder);
    {
        auto job = view::HardcopyJob::begin(context(), session, {folder / "a.mp4", 64, 40, 5, 10});
        ASSERT_TRUE(job) << text(job.diagnostics);
        EXPECT_FALSE(hasError(job->step()));
        EXPECT_FALSE(hasError(job->step()));
        EXPECT_EQ(job->framesWritten(), 2);
        EXPECT_FALSE(job->isDone());
    }
    std::vector<std::string> left;
    for (const auto& each : std::filesystem::directory_iterator(folder / ""))
        left.push_back(each.path().filename().string());
    std::sort(left.begin(), left.end());
    EXPECT_EQ(left, (std::vector<std::string>{"ffmpeg", "pixels", "scene.glib"}));
}

TEST_F(ChangedScene, ARunningHardcopyKeepsTheStateItBeganWith) {
    auto job = view::HardcopyJob::begin(context(), session, {folder / "a.png", 0, 0, 2, 4});
    ASSERT_TRUE(job) << text(job.diagnostics);
    const std::vector<std::byte> before = pixelsOf(session);
    session.values().resetAll();
    session.look().resetTransforms();
    EXPECT_FALSE(hasError(job->step()));
    session.setNeedsFrame();
    session.drawIfNeeded();
    EXPECT_FALSE(pixelsOf(session) == before);
    EXPECT_FALSE(hasError(job->step()));
    EXPECT_TRUE(job->isDone());
    const auto first = image::readImage(folder / "a_0000.png");
    ASSERT_TRUE(first);
    EXPECT_TRUE(rgb(*first) == before);
}

TEST_F(ChangedScene, ReportsWhatCannotBeWritten) {
    EXPECT_TRUE(hasError(writeAll(session, {folder / "none/a.png"})));
    EXPECT_TRUE(hasError(writeAll(session, {folder / "a.unknown"})));
}

}  // namespace
}  // namespace glibra::test
