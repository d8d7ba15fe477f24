#include "noise/noise_file.h"

#include <cstdlib>
#include <string>

#include "scene_folder.h"

namespace glibra::test {
namespace {

noise::NoiseFile playedWith() {
    noise::NoiseFile noise;
    noise.options.lattice = noise::Lattice::both;
    noise.options.octaves = 2;
    noise.options.cells = 6;
    noise.options.seed = 9;
    noise.options.turbulence = true;
    noise.options.heights = {{1, -.75}, {3, 1 / 3.}};
    noise.options.gradients = {{2, 4.5}};
    noise.options.curvatures = {{5, -12.25}};
    noise.colors = noise::ColorScale::uniform;
    noise.width = 61;
    noise.height = 40;
    return noise;
}

TEST(NoiseFile, IsWhatTheCommandThatItCopiesWrites) {
    const SceneFolder folder("");
    for (const char* name : {"graph.png", "graph.svg", "it's a graph.tex", "picture.png", "picture.tex"}) {
        noise::NoiseFile noise = playedWith();
        if (std::string(name).starts_with("picture")) noise.options.dimensions = 2;
        if (std::string(name) == "graph.svg") noise.options.smoothness = noise::Smoothness::cubic;
        const std::string own = std::string("own-") + name;
        ASSERT_TRUE(noise::writeNoise(noise, folder / own).empty()) << name;
        std::string command = noise::noiseCommand(noise, (folder / name).string());
        ASSERT_TRUE(command.starts_with("glibra ")) << command;
        command = "'" GLIBRA_PROGRAM "'" + command.substr(6);
        ASSERT_EQ(std::system(command.c_str()), 0) << command;
        EXPECT_FALSE(folder.read(name).empty());
        EXPECT_TRUE(folder.read(own) == folder.read(name)) << command;
    }
}

TEST(NoiseFile, ReportsWhyItCannotBeWritten) {
    const Diagnostics problems = noise::writeNoise(playedWith(), "/nonexistent/noise.png");
    ASSERT_EQ(problems.size(), 1U);
    EXPECT_EQ(problems[0].severity, Severity::error);
    EXPECT_EQ(noise::endingOf("a/B.TeX"), ".tex");
}

}  // namespace
}  // namespace glibra::test
