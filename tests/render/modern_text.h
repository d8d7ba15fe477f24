#pragma once
// Modern scenes as text, loaded and drawn in the context that all tests share, with what their buffers and
// textures hold afterwards.

#include <gtest/gtest.h>

#include <array>
#include <cstring>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "image/image.h"
#include "render/load/device_scene.h"
#include "render/scene_renderer.h"
#include "scene_text.h"
#include "skip_runs.h"

namespace glibra::test {

class TextScene {
  public:
    explicit TextScene(const std::string& scene, const std::map<std::string, std::string>& files = {},
                       const RenderOptions& options = {})
        : folder_(scene, files) {
        Result<render::SceneRenderer> loaded =
            render::SceneRenderer::load(sharedContext(), folder_ / "scene.glib", options, stats_);
        EXPECT_TRUE(loaded) << text(loaded.diagnostics);
        EXPECT_EQ(text(loaded.diagnostics), "");
        renderer_ = std::move(loaded.value);
    }

    /// The picture at a time; an empty one, and a failed test, if there is none.
    image::Image draw(double time = 0) {
        if (!renderer_) return {};
        Result<image::Image> picture = renderer_->draw(time, stats_);
        EXPECT_TRUE(picture) << text(picture.diagnostics);
        return picture ? std::move(*picture) : image::Image{};
    }
    /// The first numbers of a buffer, as the last picture left them.
    [[nodiscard]] std::vector<double> buffer(const std::string& name, std::uint64_t count) const {
        if (!renderer_) return std::vector<double>(count);
        const auto& buffers = renderer_->scene().buffers;
        for (std::size_t i = 0; i < buffers.size(); ++i)
            if (buffers[scene::BufferIndex(i)].name == name)
                return renderer_->device().buffers().read({scene::BufferIndex(i)}, 0, count);
        ADD_FAILURE() << "no buffer " << name;
        return std::vector<double>(count);
    }
    /// The content of a texture, or of a layer or face, top row first.
    image::Image texture(const std::string& name, std::optional<int> layer = {}) {
        if (!renderer_) return {};
        const auto& textures = renderer_->scene().textures;
        for (std::size_t i = 0; i < textures.size(); ++i) {
            if (textures[scene::TextureIndex(i)].name != name) continue;
            Result<image::Image> found =
                renderer_->textureImage({.texture = scene::TextureIndex(i), .layer = layer});
            EXPECT_TRUE(found) << text(found.diagnostics);
            return found ? std::move(*found) : image::Image{};
        }
        ADD_FAILURE() << "no texture " << name;
        return {};
    }
    [[nodiscard]] std::filesystem::path path(const std::string& file) const { return folder_ / file; }

  private:
    SceneFolder folder_;
    render::Stats stats_;
    std::optional<render::SceneRenderer> renderer_;
};

/// The messages of a scene that must not be drawn.
inline std::string refusalOf(const std::string& scene, const std::map<std::string, std::string>& files = {},
                             const RenderOptions& options = {}) {
    const SceneFolder folder(scene, files);
    render::Stats stats;
    Result<render::SceneRenderer> loaded =
        render::SceneRenderer::load(sharedContext(), folder / "scene.glib", options, stats);
    if (!loaded) return text(loaded.diagnostics);
    const Result<image::Image> picture = loaded->draw(0, stats);
    EXPECT_FALSE(picture) << scene;
    return text(picture.diagnostics);
}

/// A component of a pixel, counted from the top left.
inline int byteAt(const image::Image& image, int x, int y, int component = 0) {
    const auto index =
        (static_cast<std::size_t>(y) * static_cast<std::size_t>(image.width) + static_cast<std::size_t>(x)) *
            static_cast<std::size_t>(image.components) +
        static_cast<std::size_t>(component);
    return std::to_integer<int>(image.data.at(index));
}

inline float floatAt(const image::Image& image, std::size_t index) {
    float value = 0;
    std::memcpy(&value, image.data.data() + index * sizeof value, sizeof value);
    return value;
}

}  // namespace glibra::test
