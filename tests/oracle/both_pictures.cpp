#include "both_pictures.h"

#include <glibra/render.h>
#include <stdlib.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <set>
#include <stdexcept>

#include "glib/script.h"
#include "image/write.h"
#include "scene/interpret.h"

namespace glibra::oracle {
namespace {

/// The view of all cases: the eye looks down a little at the origin.
constexpr const char* kView =
    "WindowSize 96 96\nPerspective 90 .25 64\nLookAt .75 1.5 2  0 0 0  0 1 0\nBackground .1 .2 .3\n";

struct NamedStage {
    glsl::Stage stage;
    const char* command;
    const char* suffix;
    std::string Stages::* text;
};
const std::array<NamedStage, 5>& namedStages() {
    static const std::array<NamedStage, 5> all{
        {{glsl::Stage::vertex, "Vertex", ".vert", &Stages::vertex},
         {glsl::Stage::tessControl, "TessControl", ".tesc", &Stages::tessControl},
         {glsl::Stage::tessEvaluation, "TessEvaluation", ".tese", &Stages::tessEvaluation},
         {glsl::Stage::geometry, "Geometry", ".geom", &Stages::geometry},
         {glsl::Stage::fragment, "Fragment", ".frag", &Stages::fragment}}};
    return all;
}

std::string programStatements(const Stages& stages, const std::string& file, const std::string& tags) {
    std::string text;
    for (const NamedStage& each : namedStages())
        text += each.command + ((stages.*each.text).empty() ? "\n" : " " + file + each.suffix + "\n");
    return text + "Program Case " + tags + "\n";
}

std::string sceneText(const Case& each) {
    std::string text =
        kView + each.before + programStatements(each.stages, each.name, each.tags) + each.draws;
    if (!each.showDraws.empty())
        text += programStatements(each.show, each.name + "-show", each.showTags) + each.showDraws;
    return text;
}

/// The stages that the oracle compiles.
std::vector<Source> sourcesOf(const Stages& stages, const Stages& byHand) {
    std::vector<Source> sources;
    for (const NamedStage& each : namedStages()) {
        const std::string& text = (byHand.*each.text).empty() ? stages.*each.text : byHand.*each.text;
        if (!text.empty()) sources.push_back({each.stage, text});
    }
    return sources;
}

/// A picture without symmetry, made of two waves and a grid.
image::Image pattern(int width, int height, double phase) {
    image::Image picture{width, height, 4, image::Component::u8, {}};
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) {
            const double s = (x + .5) / width;
            const double t = (y + .5) / height;
            const bool line = x % 8 == 0 || y % 16 == 3;
            for (const double value :
                 {.5 + .5 * std::sin(9 * s + phase), t, line ? 1. : .3 + .2 * phase / 6, 1.})
                picture.data.push_back(static_cast<std::byte>(std::lround(255 * std::clamp(value, 0., 1.))));
        }
    return picture;
}

}  // namespace

struct BothWays::State {
    std::filesystem::path folder;
    std::unique_ptr<Renderer> renderer;
    std::unique_ptr<CompatibilityContext> context;

    void write(const std::string& file, const std::string& text) const {
        std::ofstream(folder / file, std::ios::binary) << text;
    }
    void write(const std::string& file, const image::Image& picture) const {
        if (hasError(image::writeImage(picture, folder / file)))
            throw std::runtime_error("cannot write " + file);
    }
};

BothWays::BothWays() : state_(std::make_unique<State>()) {
    std::string name = (std::filesystem::temp_directory_path() / "glibra-oracle-XXXXXX").string();
    if (!::mkdtemp(name.data())) throw std::runtime_error("cannot make a temporary folder");
    state_->folder = name;
    state_->write("pattern.png", pattern(64, 64, 0));
    state_->write("ramp.png", pattern(16, 1, 1));
    double phase = 0;
    for (const char* face : {"right", "left", "top", "bottom", "front", "back"})
        state_->write(std::string(face) + ".png", pattern(32, 32, ++phase));
    Result<Renderer> opened = Renderer::open();
    if (!opened) throw std::runtime_error(toString(opened.diagnostics.front()));
    state_->renderer = std::make_unique<Renderer>(std::move(*opened));
    state_->context = std::make_unique<CompatibilityContext>();
}

BothWays::~BothWays() {
    std::error_code ignored;
    std::filesystem::remove_all(state_->folder, ignored);
}

Pixels BothWays::translated(const Case& each) {
    for (const NamedStage& stage : namedStages()) {
        if (const std::string& text = each.stages.*stage.text; !text.empty())
            state_->write(each.name + stage.suffix, text);
        if (const std::string& text = each.show.*stage.text; !text.empty())
            state_->write(each.name + "-show" + stage.suffix, text);
    }
    state_->write(each.name + ".glib", sceneText(each));
    RenderOptions options;
    options.view = ViewPolicy::glman;
    options.alpha = true;
    Result<Picture> picture = state_->renderer->render(state_->folder / (each.name + ".glib"), options);
    if (!picture) {
        std::string why;
        for (const Diagnostic& diagnostic : picture.diagnostics) why += toString(diagnostic) + "\n";
        throw std::runtime_error("glibra draws no picture:\n" + why);
    }
    return {picture->width, picture->height, std::move(picture->data)};
}

Pixels BothWays::asWritten(const Case& each) {
    const glib::Script script =
        glib::parse(sceneText(each), (state_->folder / (each.name + ".glib")).string());
    const scene::Scene scene = scene::interpret(script);
    std::vector<std::vector<Source>> sources{sourcesOf(each.stages, each.byHand)};
    if (!each.showDraws.empty()) sources.push_back(sourcesOf(each.show, {}));
    return drawAsWritten(*state_->context, scene, sources, each.written);
}

Difference difference(const Pixels& a, const Pixels& b) {
    if (a.width != b.width || a.height != b.height || a.data.size() != b.data.size())
        throw std::runtime_error("pictures of different sizes");
    Difference found;
    for (std::size_t pixel = 0; 4 * pixel < a.data.size(); ++pixel) {
        int largest = 0;
        for (std::size_t i = 4 * pixel; i < 4 * pixel + 4; ++i)
            largest = std::max(largest,
                               std::abs(std::to_integer<int>(a.data[i]) - std::to_integer<int>(b.data[i])));
        if (largest > 0) ++found.pixels;
        if (largest <= found.largest) continue;
        found.largest = largest;
        found.x = static_cast<int>(pixel) % a.width;
        found.y = static_cast<int>(pixel) / a.width;
    }
    return found;
}

Content contentOf(const Pixels& picture) {
    std::set<std::array<std::byte, 4>> colors;
    Content content;
    for (std::size_t i = 0; i < picture.data.size(); i += 4) {
        std::array<std::byte, 4> color{};
        std::memcpy(color.data(), picture.data.data() + i, 4);
        colors.insert(color);
        if (std::memcmp(picture.data.data() + i, picture.data.data(), 4) != 0) ++content.pixels;
    }
    content.colors = static_cast<int>(colors.size());
    return content;
}

}  // namespace glibra::oracle
