// Every shipped scene with its sliders at both ends (NM06, NM09, NM14 to NM20) has no NaN, no infinity and no
// error. A slider at 0 often leads to a division by 0.

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <vector>

#include "glib/script.h"
#include "render/check/nan_search.h"
#include "support.h"

namespace glibra::stress {
namespace {

namespace fs = std::filesystem;

std::vector<fs::path> scenes() {
    std::vector<fs::path> found;
    for (const auto& each : fs::recursive_directory_iterator(GLIBRA_SOURCE_DIR "/glib"))
        if (each.path().extension() == ".glib") found.push_back(each.path());
    std::sort(found.begin(), found.end());
    return found;
}

/// The sliders of the scene: name, minimum, maximum.
struct Slider {
    std::string name;
    double least = 0, most = 0;
};
std::vector<Slider> slidersOf(const fs::path& scene) {
    std::ostringstream text;
    text << std::ifstream(scene, std::ios::binary).rdbuf();
    std::vector<Slider> sliders;
    for (const glib::Command& command : glib::parse(text.str(), scene.string()).commands)
        for (const glib::UniformSpec& spec : command.uniforms)
            if (spec.form == glib::UniformForm::range && spec.values.size() == 3)
                sliders.push_back({spec.tag, spec.values[0], spec.values[2]});
    return sliders;
}

/// The results of the search for the scene with these values at these times, in seconds.
Diagnostics searched(const fs::path& scene, const std::vector<std::string>& set,
                     const std::vector<double>& times) {
    RenderOptions options;
    options.width = 96;
    options.height = 72;
    options.set = set;
    Result<render::NanSearch> search = render::NanSearch::load(context(), scene, options);
    if (!search) return std::move(search.diagnostics);
    Diagnostics found;
    for (const double time : times) {
        const Diagnostics here = search->at(time);
        found.insert(found.end(), here.begin(), here.end());
    }
    return found;
}

TEST(ShippedScenes, AreFiniteAtAnyTime) {
    ASSERT_GE(scenes().size(), 50U);
    for (const fs::path& scene : scenes()) {
        const Diagnostics found = searched(scene, {}, {0., 5., 1e6 + 9.99});
        EXPECT_TRUE(found.empty()) << scene << "\n" << text(found);
    }
}

TEST(ShippedScenes, AreFiniteWithEverySliderAtItsEnds) {
    for (const fs::path& scene : scenes()) {
        const std::vector<Slider> sliders = slidersOf(scene);
        std::vector<std::vector<std::string>> settings(2);
        for (const Slider& each : sliders) {
            settings[0].push_back(fmt::format("{}={}", each.name, each.least));
            settings[1].push_back(fmt::format("{}={}", each.name, each.most));
            settings.push_back({settings[0].back()});
            settings.push_back({settings[1].back()});
        }
        for (const std::vector<std::string>& set : settings) {
            if (set.empty()) continue;
            const Diagnostics found = searched(scene, set, {2.5});
            EXPECT_TRUE(found.empty()) << scene << " " << fmt::format("{}", fmt::join(set, " ")) << "\n"
                                       << text(found);
        }
    }
}

}  // namespace
}  // namespace glibra::stress
