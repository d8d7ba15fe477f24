#include "scene_folder.h"

#include <fstream>
#include <iterator>
#include <memory>
#include <stdexcept>

#include "../support/new_folder.h"
#include "gpu/object/readback.h"

namespace glibra::test {

gpu::Context& context() {
    static const std::unique_ptr<gpu::Context> shared = [] {
        Result<gpu::Context> opened = gpu::openContext();
        if (!opened) throw std::runtime_error(text(opened.diagnostics));
        return std::make_unique<gpu::Context>(std::move(*opened));
    }();
    return *shared;
}

SceneFolder::SceneFolder(std::string_view scene, const std::map<std::string, std::string>& files) {
    folder_ = newFolder("view");
    write("scene.glib", scene);
    for (const auto& [file, content] : files) write(file, content);
}

SceneFolder::~SceneFolder() {
    std::error_code ignored;
    std::filesystem::remove_all(folder_, ignored);
}

void SceneFolder::write(std::string_view name, std::string_view content) const {
    std::filesystem::create_directories((folder_ / name).parent_path());
    std::ofstream(folder_ / name, std::ios::binary) << content;
}

std::string SceneFolder::read(std::string_view name) const {
    std::ifstream file(folder_ / name, std::ios::binary);
    return {std::istreambuf_iterator<char>(file), {}};
}

std::vector<std::byte> pixelsOf(const view::Session& session) {
    const gpu::Target* picture = session.picture();
    if (!picture) return {};
    auto pixels = gpu::readPixels(context().capabilities(), picture->readable(), 0,
                                  {0, 0, picture->width(), picture->height()}, {3, gpu::TexelType::u8});
    return pixels ? std::move(*pixels) : std::vector<std::byte>();
}

Color pixelOf(const view::Session& session, int x, int y) {
    const std::vector<std::byte> all = pixelsOf(session);
    const std::size_t at =
        3 * (static_cast<std::size_t>(y) * static_cast<std::size_t>(session.look().width()) +
             static_cast<std::size_t>(x));
    if (at + 2 >= all.size()) return {-1, -1, -1};
    return {std::to_integer<int>(all[at]), std::to_integer<int>(all[at + 1]),
            std::to_integer<int>(all[at + 2])};
}

std::size_t knobIndex(const view::Session& session, std::string_view tag) {
    for (std::size_t i = 0; i < session.values().knobs().size(); ++i)
        if (session.values().knobs()[i].tag == tag) return i;
    ADD_FAILURE() << "no knob " << tag;
    return 0;
}

void changeOvalNoise(view::Session& session, int x, int y) {
    session.values().set(knobIndex(session, "uAd"), {.31});
    session.values().set(knobIndex(session, "uDotColor"), {.2, .7, .1});
    session.look().drag(view::TransformMode::eye, {view::Gesture::rotate, {37, 21}, {300, 200}});
    session.look().drag(view::TransformMode::scene, {view::Gesture::pan, {13, -5}, {300, 200}});
    session.pickAt(x, y);
    ASSERT_TRUE(session.look().picked());
    session.look().drag(view::TransformMode::object, {view::Gesture::scale, {3, 9}, {300, 200}});
    ViewState view = session.look().view();
    view.projection = ProjectionMode::orthographic;
    view.background = {.1, .2, .3, 1};
    session.look().setView(view);
    session.look().setAxes(true);
    session.clock().setTime(1.375);
}

std::string text(const Diagnostics& diagnostics) {
    std::string all;
    for (const Diagnostic& each : diagnostics) all += toString(each) + "\n";
    return all;
}

}  // namespace glibra::test
