#include <algorithm>

#include "bench/subjects/scene_pictures.h"
#include "bench/subjects/subjects.h"

namespace glibra::bench {

std::vector<Figure> measureShadows(Bench& bench) {
    (void)bench.context();
    const std::vector<ShippedScene> scenes = shippedScenes();
    const auto scene = std::ranges::find(scenes, "modern/shadow_map", &ShippedScene::name);
    if (scene == scenes.end()) throw Failed({diagnose("bench-E05", "the library has no modern/shadow_map")});
    SceneSweep sweep;
    sweep.scene = scene->path;
    sweep.name = "resolution";
    sweep.values = bench.pick(std::vector{64., 256., 1024.}, {64., 128., 256., 512., 1024., 2048., 4096.});
    sweep.options.width = sweep.options.height = bench.pick(128, 600);
    sweep.options.samples = 1;
    std::vector<Figure> figures;
    // With the offset of the scene, with none (stripes of wrong shadow), and with one that detaches shadows.
    for (const auto& [name, title, factor] : {std::tuple("offset", "the offset of the scene", 2),
                                              {"no-offset", "no offset", 0},
                                              {"large-offset", "four times the offset", 8}}) {
        SceneSweep each = sweep;
        each.options.set = {fmt::format("factor={}", factor), fmt::format("units={}", 2 * factor)};
        for (Figure& figure : measureSweep(bench, each)) {
            figure.name = name;
            figure.title = fmt::format("Shadow maps by their resolution, with {}", title);
            figures.push_back(std::move(figure));
        }
    }
    return figures;
}

}  // namespace glibra::bench
