#include "support.h"

#include <fmt/format.h>
#include <stdlib.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <memory>
#include <stdexcept>

#include "glib/script.h"
#include "render/scene_renderer.h"
#include "scene/interpret.h"
#include "scene/primitives.h"

namespace glibra::stress {

gpu::Context& context() {
    static const std::unique_ptr<gpu::Context> shared = [] {
        Result<gpu::Context> opened = gpu::openContext();
        if (!opened) throw std::runtime_error(text(opened.diagnostics));
        return std::make_unique<gpu::Context>(std::move(*opened));
    }();
    return *shared;
}

std::size_t FloatPicture::count(const std::function<bool(const std::array<float, 3>&)>& wanted) const {
    std::size_t found = 0;
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) found += wanted(at(x, y)) ? 1 : 0;
    return found;
}

std::size_t FloatPicture::nonFinite() const {
    return static_cast<std::size_t>(
        std::count_if(values.begin(), values.end(), [](float v) { return !std::isfinite(v); }));
}

double FloatPicture::sum(int component) const {
    double total = 0;
    for (std::size_t i = static_cast<std::size_t>(component); i < values.size(); i += 3)
        total += static_cast<double>(values[i]);
    return total;
}

Result<FloatPicture> tryDraw(const std::string& scene, const Files& files, RenderOptions options) {
    char name[] = "/tmp/glibra-stress-XXXXXX";
    if (!::mkdtemp(name)) throw std::runtime_error("mkdtemp");
    const std::filesystem::path folder = name;
    std::ofstream(folder / "scene.glib", std::ios::binary) << scene;
    for (const auto& [file, content] : files) std::ofstream(folder / file, std::ios::binary) << content;
    options.floatPixels = true;
    options.view = ViewPolicy::glman;
    render::Stats stats;
    FloatPicture picture;
    const Diagnostics bad = [&]() -> Diagnostics {
        auto loaded = render::SceneRenderer::load(context(), folder / "scene.glib", options, stats);
        if (!loaded) return loaded.diagnostics;
        auto drawn = loaded->draw(options.time, stats);
        append(loaded.diagnostics, drawn.diagnostics);
        if (!drawn) return loaded.diagnostics;
        picture.diagnostics = loaded.diagnostics;
        picture.width = drawn->width;
        picture.height = drawn->height;
        picture.values.resize(drawn->data.size() / sizeof(float));
        std::memcpy(picture.values.data(), drawn->data.data(), drawn->data.size());
        return {};
    }();
    std::filesystem::remove_all(folder);
    if (picture.width == 0) return bad;
    return picture;
}

FloatPicture draw(const std::string& scene, const Files& files, RenderOptions options) {
    Result<FloatPicture> drawn = tryDraw(scene, files, std::move(options));
    if (drawn) return std::move(*drawn);
    ADD_FAILURE() << text(drawn.diagnostics);
    return {};
}

const char* const kProgram = "Vertex v.vert\nFragment f.frag\nProgram P\n";

Files shaded(const std::string& rgb, const std::string& declarations) {
    return {{"v.vert",
             "#version 330 core\nout vec4 vMC;\nout vec4 vEC;\nout vec3 vN;\nout vec3 vST;\nvoid main() {\n"
             "  vMC = aVertex;\n  vEC = uModelViewMatrix * aVertex;\n  vN = uNormalMatrix * aNormal;\n"
             "  vST = aTexCoord0.stp;\n  gl_Position = uModelViewProjectionMatrix * aVertex;\n}\n"},
            {"f.frag",
             "#version 330 core\nin vec4 vMC;\nin vec4 vEC;\nin vec3 vN;\nin vec3 vST;\nout vec4 fColor;\n" +
                 declarations + "void main() { fColor = vec4(" + rgb + ", 1.); }\n"}};
}

std::string addingFragment(const std::string& rgb, const std::string& declarations) {
    return "#version 330 core\nout vec4 fColor;\n" + declarations +
           "void main() {\n  fColor = vec4(1152921504606846976. * vec3(" + rgb +
           "), 8.673617379884035e-19);\n  gl_FragDepth = .5;\n}\n";
}

std::string shipped(const std::string& path) {
    std::ifstream file(std::filesystem::path(GLIBRA_SOURCE_DIR) / "shaders" / path, std::ios::binary);
    if (!file) throw std::runtime_error("cannot read " + path);
    return {std::istreambuf_iterator<char>(file), {}};
}

std::string replaced(std::string text, const std::string& from, const std::string& to) {
    std::size_t at = text.find(from);
    EXPECT_NE(at, std::string::npos) << from;
    for (; at != std::string::npos; at = text.find(from, at + to.size())) text.replace(at, from.size(), to);
    return text;
}

double spread(std::uint32_t index) {
    std::uint32_t x = index * 0x9e3779b9U + 1;
    x ^= x >> 16U;
    x *= 0x7feb352dU;
    x ^= x >> 15U;
    x *= 0x846ca68bU;
    x ^= x >> 16U;
    return x / 2147483648. - 1;
}

std::string number(double value) {
    return fmt::format("{}", value);
}

std::string text(const Diagnostics& diagnostics) {
    std::string all;
    for (const Diagnostic& each : diagnostics) all += toString(each) + "\n";
    return all;
}

bool has(const Diagnostics& diagnostics, const std::string& id) {
    return std::any_of(diagnostics.begin(), diagnostics.end(),
                       [&](const Diagnostic& each) { return each.id == id; });
}

scene::Scene interpreted(const std::string& text, const std::string& folder) {
    glib::Script script = glib::parse(text, folder + "/scene.glib");
    scene::Scene made = scene::interpret(script);
    Diagnostics all = std::move(script.diagnostics);
    append(all, std::move(made.diagnostics));
    made.diagnostics = std::move(all);
    return made;
}

geometry::Mesh meshOf(const std::string& text) {
    const scene::Scene scene = interpreted(text);
    EXPECT_EQ(scene.shapes.size(), 1U) << text;
    if (scene.shapes.empty()) return {};
    Result<geometry::Mesh> mesh = scene::makeMesh(scene, scene::ShapeIndex(0));
    EXPECT_TRUE(mesh) << text;
    return mesh ? std::move(*mesh) : geometry::Mesh();
}

}  // namespace glibra::stress
