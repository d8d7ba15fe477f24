#include <stdlib.h>

#include <algorithm>
#include <fstream>

#include "bench/subjects/scene_pictures.h"
#include "bench/subjects/subjects.h"

namespace glibra::bench {
namespace {

/// A black plane behind a white one, both tilted, 100 units away.
constexpr std::string_view kTwoPlanes = R"(WindowSize 256 256
Let near <.0001 .1 10.>
Let gap <.001 .1 10.>
Camera eye  LookAt 0 0 0  0 0 -1  0 1 0  Perspective 50 (near) 1000
Vertex plane.vert
Fragment black.frag
Program Black
Fragment white.frag
Program White
Group back
    Translate 0 0 (-100 - gap)
    Rotate 40 1 0 0
    QuadXY 0 400 1 1
EndGroup
Group front
    Translate 0 0 -100
    Rotate 40 1 0 0
    QuadXY 0 400 1 1
EndGroup
Pass window from eye
    Use Black
    Draw back
    Use White
    Draw front
EndPass
)";
constexpr std::string_view kPlaneVertex = R"(#version 330 core
void main() { gl_Position = uModelViewProjectionMatrix * aVertex; }
)";
constexpr std::string_view kBlack = R"(#version 330 core
out vec4 fColor;
void main() { fColor = vec4(0., 0., 0., 1.); }
)";
constexpr std::string_view kWhite = R"(#version 330 core
out vec4 fColor;
void main() { fColor = vec4(1.); }
)";

/// A folder with the scene, until it is left.
class PlanesFolder {
  public:
    PlanesFolder() {
        std::string name = std::filesystem::temp_directory_path() / "glibra-planes-XXXXXX";
        if (!::mkdtemp(name.data())) throw Failed({diagnose("file-E10", "cannot make a temporary folder")});
        folder_ = name;
        for (const auto& [file, text] : {std::pair("planes.glib", kTwoPlanes),
                                         {"plane.vert", kPlaneVertex},
                                         {"black.frag", kBlack},
                                         {"white.frag", kWhite}})
            std::ofstream(folder_ / file) << text;
    }
    PlanesFolder(const PlanesFolder&) = delete;
    PlanesFolder& operator=(const PlanesFolder&) = delete;
    ~PlanesFolder() {
        std::error_code ignored;
        std::filesystem::remove_all(folder_, ignored);
    }
    [[nodiscard]] std::filesystem::path scene() const { return folder_ / "planes.glib"; }

  private:
    std::filesystem::path folder_;
};

}  // namespace

std::vector<Figure> measureNearFar(Bench& bench) {
    const PlanesFolder planes;
    Figure figure{.name = "planes",
                  .title = "Two planes of a scene, 100 units away, with far at 1000",
                  .settingName = "far / near",
                  .errorName = "pixels in which the farther one wins",
                  .reference = "the nearer plane, which must be visible in every pixel",
                  .alternatives = Alternatives::none,
                  .countsWrong = true};
    for (const double gap : {1., .1, .01}) {
        const std::string curve = fmt::format("gap of {} units", gap);
        double widest = 0;
        bool isClean = true;
        for (double ratio = 100; ratio <= 1e7; ratio *= 10) {
            RenderOptions options;
            options.samples = 1;
            options.set = {fmt::format("near={}", 1000 / ratio), fmt::format("gap={}", gap)};
            const image::Image picture = need(scenePicture(bench.context(), planes.scene(), options));
            const auto black = std::ranges::count(picture.data, std::byte{0});
            const double wrong = static_cast<double>(black) / static_cast<double>(picture.data.size());
            figure.add(
                curve,
                {ratio, fmt::format("{:.0e}:1", ratio), wrong,
                 bench.time([&] { (void)scenePicture(bench.context(), planes.scene(), options); }, .2)});
            isClean = isClean && wrong == 0;
            if (isClean) widest = ratio;
        }
        if (widest > 0)
            figure.note("{}: no pixel is wrong up to far / near = {:.0e}", curve, widest);
        else
            figure.note("{}: pixels are wrong even with far / near = 100", curve);
    }
    return {std::move(figure)};
}

}  // namespace glibra::bench
