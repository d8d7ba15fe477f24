#include "view/export/hardcopy_job.h"
#include "view/export/video_encoder.h"

#include <cstdio>
#include <cstdlib>

#include "image/read.h"
#include "render/draw/view_matrices.h"
#include "scene_folder.h"

namespace glibra::test {
namespace {

using view::Session;

/// Changes everything that a window can change.
void change(Session& session) {
    session.setValue(knobIndex(session, "uAd"), {.31});
    session.setValue(knobIndex(session, "uDotColor"), {.2, .7, .1});
    session.drag(view::TransformMode::eye, {view::Gesture::rotate, {37, 21}, {300, 200}});
    session.drag(view::TransformMode::scene, {view::Gesture::pan, {13, -5}, {300, 200}});
    session.pickAt(session.width() / 2, session.height() / 2);
    ASSERT_TRUE(session.picked());
    session.drag(view::TransformMode::object, {view::Gesture::scale, {3, 9}, {300, 200}});
    ViewState view = session.view();
    view.projection = ProjectionMode::orthographic;
    view.background = {.1, .2, .3, 1};
    session.setView(view);
    session.setAxes(true);
    view::Clock clock = session.clock();
    clock.setTime(1.375);
    session.setClock(clock);
}

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
        session.resize(300, 200);
        session.drawIfNeeded();
        change(session);
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
        command = GLIBRA_PROGRAM + command.substr(6);
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
    if (!view::hasFfmpeg()) GTEST_SKIP() << "no ffmpeg";
    const view::Hardcopy wanted{folder / "a.mp4", 65, 41, 7, 10};
    const Diagnostics problems = writeAll(session, wanted);
    ASSERT_FALSE(hasError(problems)) << text(problems);
    const std::string command =
        "ffprobe -v error -count_frames -show_entries stream=nb_read_frames,width -of csv=p=0 '" +
        wanted.file.string() + "' >'" + (folder / "probe.txt").string() + "'";
    ASSERT_EQ(std::system(command.c_str()), 0);
    EXPECT_EQ(folder.read("probe.txt"), "66,7\n");
}

TEST_F(ChangedScene, AStoppedVideoLeavesNoFile) {
    if (!view::hasFfmpeg()) GTEST_SKIP() << "no ffmpeg";
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
        left.push_back(each.path().filename());
    EXPECT_EQ(left, std::vector<std::string>{"scene.glib"});
}

TEST_F(ChangedScene, ARunningHardcopyKeepsTheStateItBeganWith) {
    auto job = view::HardcopyJob::begin(context(), session, {folder / "a.png", 0, 0, 2, 4});
    ASSERT_TRUE(job) << text(job.diagnostics);
    const std::vector<std::byte> before = pixelsOf(session);
    session.resetValues();
    session.resetTransforms();
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
