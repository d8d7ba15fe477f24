// Preparing the next shots changes neither the picture nor the messages of a shot.

#include "suite/run/shot_renderer.h"

#include <gtest/gtest.h>

#include <initializer_list>

#include "folder.h"
#include "gpu/context/context.h"

namespace glibra::suite {
namespace {

class ShotRendering : public testing::Test {
  protected:
    void SetUp() override {
        writeText(folder / "a.vert",
                  "#version 330 core\nvoid main() { gl_Position = vec4(aVertex.xy, 0., 1.); }\n");
        writeText(folder / "a.frag",
                  "#version 330 core\nuniform float uRed;\nout vec4 f;\nvoid main() { f = vec4(uRed, "
                  "texture(Noise3, gl_FragCoord.xyz * .03).r, fract(Timer), 1.); }\n");
        const std::string start = "Vertex a.vert\nFragment a.frag\n";
        writeText(folder / "a.glib", start + "Program P uRed .25 uMistake 1.\nQuadXY 0 1 1 1\n");
        writeText(folder / "b.glib", start + "Program P uRed .75\nQuadXY 0 .5 1 1\n");
        writeText(folder / "wrong.glib", start + "Fragment nothing.frag\nProgram P\nQuadXY 0 1 1 1\n");
        for (const char* script : {"a.glib", "b.glib", "wrong.glib"})
            for (const double time : {0., 3.}) {
                Shot& shot = shots.emplace_back();
                shot.name = script + std::to_string(time);
                shot.script = folder / script;
                shot.options.width = 24;
                shot.options.height = 16;
                shot.options.time = time;
            }
        Result<gpu::Context> opened = gpu::openContext();
        ASSERT_TRUE(opened);
        context.emplace(std::move(*opened));
        for (const Shot& each : shots) alone.push_back(seenOf(ShotRenderer(*context).render(each)));
    }

    static std::string seenOf(const Rendering& rendering) {
        std::string text;
        for (const Diagnostic& each : rendering.diagnostics) text += toString(each) + "\n";
        if (rendering.picture)
            for (const std::byte each : rendering.picture->data) text += static_cast<char>(each);
        return text;
    }
    void expectAsAlone(ShotRenderer& renderer, std::size_t shot, std::initializer_list<std::size_t> next) {
        std::vector<const Shot*> coming;
        for (const std::size_t each : next) coming.push_back(&shots[each]);
        EXPECT_EQ(seenOf(renderer.render(shots[shot], coming)), alone[shot]) << shots[shot].name;
    }

    Folder folder;
    std::vector<Shot> shots;
    std::vector<std::string> alone;
    std::optional<gpu::Context> context;
};

TEST_F(ShotRendering, GivesEveryShotAfterEveryOtherThePictureThatItHasAlone) {
    ASSERT_NE(alone[0], alone[2]);
    ASSERT_NE(alone[0], alone[1]);
    ShotRenderer renderer(*context);
    for (std::size_t i = 0; i < shots.size(); ++i)
        for (std::size_t next = 0; next < shots.size(); ++next) {
            expectAsAlone(renderer, i, {next});
            expectAsAlone(renderer, next, {i});
        }
}

TEST_F(ShotRendering, IsTheSameWithEveryPairOfShotsPrepared) {
    ShotRenderer renderer(*context);
    for (std::size_t i = 0; i < shots.size(); ++i)
        for (std::size_t next = 0; next < shots.size(); ++next)
            for (std::size_t last = 0; last < shots.size(); ++last) {
                expectAsAlone(renderer, i, {next, last});
                expectAsAlone(renderer, next, {last});
                expectAsAlone(renderer, last, {});
            }
}

TEST_F(ShotRendering, IgnoresWrongPredictions) {
    ShotRenderer renderer(*context);
    for (std::size_t i = 0; i < 3 * shots.size(); ++i) {
        const std::size_t next = (i * 5 + 2) % shots.size();
        expectAsAlone(renderer, i % shots.size(), {next, (i * 3 + 1) % shots.size()});
        if (i % 7 == 3) renderer.forget();
        if (i % 3 == 1) expectAsAlone(renderer, next, {});
    }
}

TEST_F(ShotRendering, EndsInTheMiddleOfAPreparation) {
    for (int i = 0; i < 5; ++i) {
        ShotRenderer renderer(*context);
        expectAsAlone(renderer, 0, {2, 4});
    }
}

}  // namespace
}  // namespace glibra::suite
