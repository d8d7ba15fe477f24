#include <algorithm>
#include <cstddef>
#include <string>
#include <string_view>

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
# The farther plane is drawn last: it wins where both have the same depth.
Pass window from eye
    Use White
    Draw front
    Use Black
    Draw back
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

}  // namespace

std::vector<Figure> measureNearFar(Bench& bench) {
    RenderOptions planes;
    planes.samples = 1;
    planes.sceneText = kTwoPlanes;
    planes.texts = {{"plane.vert", std::string(kPlaneVertex)},
                    {"black.frag", std::string(kBlack)},
                    {"white.frag", std::string(kWhite)}};
    Figure figure{.name = "planes",
                  .title = "Two planes of a scene, 100 units away, with far at 1000",
                  .settingName = "far / near",
                  .errorName = "pixels in which the nearer one does not win",
                  .reference = "the nearer plane, which must be visible in every pixel",
                  .alternatives = Alternatives::none,
                  .countsWrong = true};
    for (const double gap : {1., .1, .01}) {
        const std::string curve = fmt::format("gap of {} units", gap);
        double widest = 0;
        bool isClean = true;
        for (double ratio = 100; ratio <= 1e7; ratio *= 10) {
            RenderOptions options = planes;
            options.set = {fmt::format("near={}", 1000 / ratio), fmt::format("gap={}", gap)};
            const auto draw = [&] { return scenePicture(bench.context(), "planes.glib", options); };
            const image::Image picture = need(draw());
            const auto black = std::ranges::count(picture.data, std::byte{0});
            const double wrong = static_cast<double>(black) / static_cast<double>(picture.data.size());
            figure.add(curve,
                       {ratio, fmt::format("{:.0e}:1", ratio), wrong, bench.time([&] { (void)draw(); }, .2)});
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
