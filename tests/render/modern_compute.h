#pragma once
// Modern scenes with buffers and compute programs, made as values, and what tests ask of them.

#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "gpu/context/context.h"
#include "modern_by_hand.h"
#include "render/load/device_scene.h"

namespace glibra::test {

/// A scene with buffers and compute programs.
class ComputeScene : public ModernScene {
  public:
    using ModernScene::ModernScene;

    scene::ProgramIndex compute(const std::string& name, const std::string& text) {
        return program(name, {{glsl::Stage::compute, "#version 430 core\n" + text}});
    }
    scene::BufferIndex buffer(const std::string& name, const std::string& type,
                              std::optional<std::uint64_t> count, std::vector<double> values = {}) {
        scene::Buffer made;
        made.name = name;
        made.type = type;
        made.count = count;
        made.values = std::move(values);
        made.place = {scene.path, 90 + static_cast<int>(scene.buffers.size()), 1};
        return scene.buffers.add(std::move(made));
    }
    static scene::Dispatch over(scene::ProgramIndex program, const scene::ObjectView& object) {
        scene::Dispatch made;
        made.program = program;
        made.groups = scene::Over{object};
        made.place = {"modern.glib", 70, 1};
        return made;
    }
    /// Three vertices without data that cover the window, with a fragment stage alone.
    scene::Draw& fill(scene::ProgramIndex program) {
        scene::Draw& draw = square(program);
        draw.shape = bare(geometry::Topology::triangles, 3);
        draw.word = "Fill";
        return draw;
    }
    scene::ShapeIndex bare(geometry::Topology topology, int vertices) {
        scene::Shape shape;
        shape.bare = topology;
        shape.numbers = {static_cast<double>(vertices)};
        return scene.shapes.add(std::move(shape));
    }
    scene::ProgramIndex fragment(const std::string& name, const std::string& text) {
        return program(name, {{glsl::Stage::fragment, "#version 430 core\n" + text}});
    }
    /// Binds objects to the tags of a dispatch.
    void bind(scene::Dispatch& dispatch,
              const std::vector<std::pair<std::string, scene::ObjectView>>& objects) {
        scene::UniformSet made;
        for (const auto& [tag, view] : objects) made.objects.push_back({tag, view, {1, 1}, {1, 1}});
        dispatch.uniforms = scene.uniformSets.add(std::move(made));
    }
};

class ModernCompute : public testing::Test {
  protected:
    void SetUp() override {
        if (!sharedContext().capabilities().compute) GTEST_SKIP() << "needs GL 4.3";
    }
    /// The loaded scene; fails the test if there is none.
    std::optional<render::SceneRenderer> load(const ModernScene& modern, RenderOptions options = {}) {
        options.view = ViewPolicy::glman;
        render::InterpretedScene interpreted;
        interpreted.scene = modern.scene;
        Result<render::SceneRenderer> loaded =
            render::SceneRenderer::of(sharedContext(), std::move(interpreted), options, stats_);
        EXPECT_TRUE(loaded) << text(loaded.diagnostics);
        EXPECT_FALSE(hasError(loaded.diagnostics)) << text(loaded.diagnostics);
        return std::move(loaded.value);
    }
    std::vector<std::byte> draw(render::SceneRenderer& scene, double time = 0) {
        Result<image::Image> picture = scene.draw(time, stats_);
        EXPECT_TRUE(picture) << text(picture.diagnostics);
        return picture ? picture->data : std::vector<std::byte>();
    }
    /// The messages that keep a scene from being drawn.
    std::string refusal(const ModernScene& modern, double time = 0, RenderOptions options = {}) {
        options.view = ViewPolicy::glman;
        render::InterpretedScene interpreted;
        interpreted.scene = modern.scene;
        Result<render::SceneRenderer> loaded =
            render::SceneRenderer::of(sharedContext(), std::move(interpreted), options, stats_);
        if (!loaded) return text(loaded.diagnostics);
        const Result<image::Image> picture = loaded->draw(time, stats_);
        return picture ? "" : text(picture.diagnostics);
    }
    /// What the buffer holds after one frame in which everything runs, whether the picture shows it or not.
    std::vector<double> resultOf(const ModernScene& modern, scene::BufferIndex buffer, std::uint64_t count) {
        RenderOptions everything;
        everything.skip = false;
        auto loaded = load(modern, everything);
        if (!loaded) return {};
        draw(*loaded);
        return read(*loaded, buffer, count);
    }
    static std::vector<double> read(const render::SceneRenderer& scene, scene::BufferIndex buffer,
                                    std::uint64_t count) {
        return scene.device().buffers().read({buffer}, 0, count);
    }
    render::Stats stats_;
};

}  // namespace glibra::test
