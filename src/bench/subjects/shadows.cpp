#include <algorithm>
#include <iterator>
#include <string>
#include <utility>
#include <vector>

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
    sweep.values = bench.pick(std::vector{64., 256., 1024.}, {64., 128., 256., 512., 1024., 2048.});
    sweep.options.width = sweep.options.height = bench.pick(128, 600);
    sweep.options.samples = 1;
    RenderOptions finest = sweep.options;
    finest.set = {"resolution=4096"};
    const image::Image reference = need(scenePicture(bench.context(), sweep.scene, finest));
    sweep.reference = &reference;
    Figure figure{.name = "offset",
                  .title = "Shadow maps by their resolution and their offset",
                  .settingName = sweep.name,
                  .errorName = "root mean square of the difference",
                  .errorUnit = "1/255",
                  .reference = "the picture with resolution = 4096 and the offset of the scene"};
    const std::pair<const char*, std::vector<std::string>> offsets[] = {
        {"the offset of the scene", {}},
        {"no offset: stripes of wrong shadow", {"factor=0", "units=0"}},
        {"an offset that detaches shadows", {"units=1000000"}}};
    for (const auto& [name, set] : offsets) {
        SceneSweep each = sweep;
        each.curve = name;
        each.options.set = set;
        for (Figure& one : measureSweep(bench, each)) {
            std::ranges::move(one.curves, std::back_inserter(figure.curves));
            std::ranges::move(one.findings, std::back_inserter(figure.findings));
        }
    }
    return {std::move(figure)};
}

}  // namespace glibra::bench
