#pragma once
// Modern scenes made as values, without a script: textures with names, passes into their parts, draws with
// bindings. Squares are given in clip space.

#include <gtest/gtest.h>

#include <array>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "glib/statement_table.h"
#include "render/scene_renderer.h"
#include "scene/scene.h"
#include "scene_text.h"
#include "skip_runs.h"

namespace glibra::test {

/// Places a square as it is given; `vST` is 0..1 over it.
inline constexpr const char* kPlaceVertex = R"(#version 330 core
in vec4 aVertex;
in vec4 aTexCoord0;
out vec2 vST;
void main() {
    vST = aTexCoord0.st;
    gl_Position = vec4(aVertex.xyz, 1.);
}
)";

class ModernScene {
  public:
    scene::Scene scene;

    ModernScene(int width, int height) {
        scene.path = "modern.glib";
        scene.width = width;
        scene.height = height;
        scene.suppliesNames = true;
        scene.usesLookAt = true;
        scene.slotTables.emplace_back();
    }

    scene::ProgramIndex program(const std::string& name, const std::map<glsl::Stage, std::string>& stages) {
        scene::Program made;
        made.name = name;
        made.place = next();
        for (const auto& [stage, text] : stages)
            made.stages.push_back({stage, scene.files.add({name, scene.path, {}, next(), text})});
        return scene.programs.add(std::move(made));
    }
    /// A program that places squares and has this fragment stage.
    scene::ProgramIndex shading(const std::string& name, const std::string& fragment) {
        return program(name, {{glsl::Stage::vertex, kPlaceVertex},
                              {glsl::Stage::fragment, "#version 330 core\nin vec2 vST;\n" + fragment}});
    }

    scene::TextureIndex texture(const std::string& name, base::TexelFormat format, int width, int height,
                                scene::TextureTarget target = scene::TextureTarget::texture2D,
                                int depth = 1) {
        scene::Texture made;
        made.target = target;
        made.source = scene::EmptySource{width, height, depth, format};
        made.name = name;
        made.place = next();
        return scene.textures.add(std::move(made));
    }

    /// Begins a pass that clears the depth and stencil, and its colours to `clear` if that is given.
    scene::Pass& pass(std::vector<scene::TextureIndex> targets, std::optional<glm::dvec4> clear) {
        scene::Pass made;
        made.isWindow = false;
        made.clearColors.assign(targets.size(), clear);
        made.targets = std::move(targets);
        made.clearDepth = true;
        made.clearStencil = 0;
        made.depthBuffer = static_cast<int>(scene.frame.passes.size()) + 1;
        made.place = next();
        return scene.frame.add(std::move(made));
    }
    scene::Pass& window(std::optional<glm::dvec4> clear = glm::dvec4(0, 0, 0, 1)) {
        scene::Pass& made = pass({}, {});
        made.isWindow = true;
        made.depthBuffer = 0;
        made.clearColors = {clear};
        return made;
    }
    /// A square -size..size at depth z (-1..1) of clip space, in the last pass.
    scene::Draw& square(scene::ProgramIndex program, double z = 0, double size = 1) {
        scene::Shape shape;
        shape.command = glib::commandOf("QuadXY");
        shape.numbers = {z, size, 1, 1};
        scene::Draw draw;
        draw.place = next();
        draw.id = {draw.place.line};
        draw.word = "QuadXY";
        draw.shape = scene.shapes.add(std::move(shape));
        draw.program = program;
        draw.projection = glm::dmat4(1);
        draw.slots = scene::SlotTableIndex(0);
        scene.frame.passes.back().steps.emplace_back(std::move(draw));
        return std::get<scene::Draw>(scene.frame.passes.back().steps.back());
    }
    /// Gives the draw values and textures.
    void set(scene::Draw& draw, const std::vector<std::pair<std::string, std::vector<double>>>& values,
             const std::vector<std::pair<std::string, scene::TextureView>>& textures = {}) {
        scene::UniformSet made;
        for (const auto& [tag, numbers] : values)
            made.values.push_back({tag,
                                   numbers.size() == 1 ? glib::UniformForm::number : glib::UniformForm::list,
                                   numbers,
                                   {1, 1},
                                   {1, 1}});
        for (const auto& [tag, view] : textures) made.objects.push_back({tag, view, {1, 1}, {1, 1}});
        draw.uniforms = scene.uniformSets.add(std::move(made));
    }

  private:
    Place next() { return {scene.path, ++line_, 1}; }
    int line_ = 0;
};

struct ModernPicture {
    image::Image image;
    render::Stats stats;
    Diagnostics diagnostics;

    [[nodiscard]] std::array<int, 3> at(int x, int y) const {  ///< from the top left
        const std::size_t first = (static_cast<std::size_t>(y) * static_cast<std::size_t>(image.width) +
                                   static_cast<std::size_t>(x)) *
                                  3;
        return {std::to_integer<int>(image.data.at(first)), std::to_integer<int>(image.data.at(first + 1)),
                std::to_integer<int>(image.data.at(first + 2))};
    }
};

/// The picture at time 0. Fails the test if there is none, unless `mayFail`.
inline ModernPicture draw(const ModernScene& modern, RenderOptions options = {}, bool mayFail = false) {
    ModernPicture made;
    options.view = ViewPolicy::glman;
    render::InterpretedScene interpreted;
    interpreted.scene = modern.scene;
    Result<render::SceneRenderer> loaded =
        render::SceneRenderer::of(sharedContext(), std::move(interpreted), options, made.stats);
    made.diagnostics = loaded.diagnostics;
    if (loaded) {
        Result<image::Image> picture = loaded->draw(0, made.stats);
        append(made.diagnostics, std::move(picture.diagnostics));
        if (picture) made.image = std::move(*picture);
    }
    EXPECT_TRUE(mayFail || !made.image.data.empty()) << text(made.diagnostics);
    return made;
}

}  // namespace glibra::test
