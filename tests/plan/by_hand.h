#pragma once
// Scenes and program interfaces made by hand, for the tests of plan.

#include <algorithm>
#include <initializer_list>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "glib/statement_table.h"
#include "plan/planner.h"
#include "plan/type_table.h"

namespace glibra::plan::test {

/// The messages with this id.
inline Diagnostics withId(const Diagnostics& all, std::string_view id) {
    Diagnostics found;
    for (const Diagnostic& each : all)
        if (each.id == id) found.push_back(each);
    return found;
}
/// The text of the only message with this id; "" if there is none, "several" if there are more.
inline std::string textOf(const Diagnostics& all, std::string_view id) {
    const Diagnostics found = withId(all, id);
    if (found.empty()) return "";
    return found.size() == 1 ? found.front().text : "several";
}
/// The ids in order: "glib-W20 glib-W27".
inline std::string ids(const Diagnostics& all) {
    std::string text;
    for (const Diagnostic& each : all) text += (text.empty() ? "" : " ") + each.id;
    return text;
}

inline ValueType valueType(std::string word) {
    static const std::map<std::string, ValueType> kTypes{
        {"float", {BaseType::floating, 1, 1, {}, ""}},
        {"double", {BaseType::doublePrecision, 1, 1, {}, ""}},
        {"int", {BaseType::integer, 1, 1, {}, ""}},
        {"uint", {BaseType::unsignedInteger, 1, 1, {}, ""}},
        {"bool", {BaseType::boolean, 1, 1, {}, ""}},
        {"vec2", {BaseType::floating, 1, 2, {}, ""}},
        {"vec3", {BaseType::floating, 1, 3, {}, ""}},
        {"vec4", {BaseType::floating, 1, 4, {}, ""}},
        {"dvec3", {BaseType::doublePrecision, 1, 3, {}, ""}},
        {"ivec3", {BaseType::integer, 1, 3, {}, ""}},
        {"ivec4", {BaseType::integer, 1, 4, {}, ""}},
        {"uvec2", {BaseType::unsignedInteger, 1, 2, {}, ""}},
        {"bvec2", {BaseType::boolean, 1, 2, {}, ""}},
        {"mat2", {BaseType::floating, 2, 2, {}, ""}},
        {"mat2x3", {BaseType::floating, 2, 3, {}, ""}},
        {"mat3", {BaseType::floating, 3, 3, {}, ""}},
        {"mat4", {BaseType::floating, 4, 4, {}, ""}},
        {"sampler1D", {BaseType::sampler, 1, 1, scene::TextureTarget::texture1D, ""}},
        {"sampler2D", {BaseType::sampler, 1, 1, scene::TextureTarget::texture2D, ""}},
        {"isampler2D", {BaseType::sampler, 1, 1, scene::TextureTarget::texture2D, ""}},
        {"sampler3D", {BaseType::sampler, 1, 1, scene::TextureTarget::texture3D, ""}},
        {"samplerCube", {BaseType::sampler, 1, 1, scene::TextureTarget::cube, ""}},
        {"sampler2DArray", {BaseType::sampler, 1, 1, {}, ""}},
        {"image2D", {BaseType::image, 1, 1, scene::TextureTarget::texture2D, ""}},
        {"atomic_uint", {BaseType::other, 1, 1, {}, ""}},
    };
    ValueType type = kTypes.at(word);
    type.word = std::move(word);
    return type;
}

/// "vec3", or "vec3[4]" for an array.
inline ActiveUniform uniform(std::string name, std::string word) {
    ActiveUniform result;
    result.name = std::move(name);
    result.location = 0;
    if (const std::size_t bracket = word.find('['); bracket != std::string::npos) {
        result.isArray = true;
        result.arraySize = std::stoi(word.substr(bracket + 1));
        word.resize(bracket);
    }
    result.type = valueType(word);
    return result;
}

using Values = std::vector<double>;

/// What a uniform of that type reads from values of that form.
inline Reading readingOf(const std::string& word, glib::UniformForm form, const Values& values) {
    return readValue({"uA", form, values, {"scene.glib", 7, 3}, {"scene.glib", 7, 9}}, uniform("uA", word));
}

inline ProgramInterface interfaceWith(std::initializer_list<std::pair<std::string, std::string>> uniforms) {
    ProgramInterface result;
    result.usable = true;
    for (const auto& [name, word] : uniforms) {
        result.uniforms.push_back(uniform(name, word));
        result.facts.uniforms[name.substr(0, name.find_first_of(".["))] = {};
    }
    result.inputs.push_back({"aVertex", 0});
    result.outputs.push_back({"fColor", 0, valueType("vec4"), 1});
    return result;
}

inline glib::UniformSpec spec(std::string tag, glib::UniformForm form, std::vector<double> values) {
    return {std::move(tag), form, std::move(values), {7, 3}, {7, 9}};
}
inline glib::UniformSpec number(std::string tag, double value) {
    return spec(std::move(tag), glib::UniformForm::number, {value});
}

inline constexpr const char* kScenePath = "scene.glib";
inline Place at(int line) {
    return {kScenePath, line, 1};
}

/// Builds a Scene statement by statement. Statements have consecutive lines, beginning with 1.
class SceneByHand {
  public:
    scene::Scene scene;

    SceneByHand() {
        scene.path = kScenePath;
        scene.slotTables.emplace_back();
        window();
    }

    scene::FileIndex file(const std::string& name) {
        return scene.files.add({name, name, {}, at(nextLine())});
    }
    /// Adds a program with these stages and makes it current. The stages' files are NAME.vert, NAME.frag ...
    scene::ProgramIndex program(const std::string& name, std::initializer_list<glsl::Stage> stages = {
                                                             glsl::Stage::vertex, glsl::Stage::fragment}) {
        static const char* const kSuffixes[] = {".vert", ".tcs", ".tes", ".geom", ".frag"};
        scene::Program result;
        result.name = name;
        for (const glsl::Stage stage : stages)
            result.stages.push_back({stage, file("shaders/" + name + kSuffixes[static_cast<int>(stage)])});
        result.place = at(nextLine());
        return currentProgram = scene.programs.add(std::move(result));
    }
    scene::TextureIndex texture(int unit, scene::TextureTarget target = scene::TextureTarget::texture2D) {
        return addTexture({target, scene::PictureSource{{file("picture" + std::to_string(unit) + ".png")}},
                           at(nextLine()), unit});
    }
    scene::TextureIndex noise(int dimensions) {
        const auto target =
            dimensions == 2 ? scene::TextureTarget::texture2D : scene::TextureTarget::texture3D;
        return addTexture({target, scene::NoiseSource{.dimensions = dimensions, .remarks = {}},
                           at(nextLine()), dimensions});
    }
    scene::TextureIndex emptyTexture(int unit) {
        return addTexture(
            {scene::TextureTarget::texture2D, scene::EmptySource{64, 64, 1, {}}, at(nextLine()), unit});
    }
    /// RenderToTexture into these textures; without textures, into the window.
    scene::Pass& target(std::vector<scene::TextureIndex> textures) {
        scene::Pass pass;
        pass.depthBuffer = textures.empty() ? 0 : depthBufferOf(textures.front());
        pass.isWindow = textures.empty();
        pass.targets = std::move(textures);
        pass.place = at(nextLine());
        pass.clearDepth = true;
        scene.frame.add(std::move(pass));
        return scene.frame.passes.back();
    }
    static int depthBufferOf(scene::TextureIndex texture) { return static_cast<int>(texture.position()) + 1; }
    scene::Pass& window() { return target({}); }

    scene::ShapeIndex shape(glib::CommandId command, std::vector<double> numbers = {1, 1, 4, 4}) {
        for (const scene::ShapeIndex i : scene.shapes.indices())
            if (scene.shapes[i].command == command && scene.shapes[i].numbers == numbers) return i;
        return scene.shapes.add({command, std::move(numbers), {}, nullptr});
    }
    /// The mesh of a glBegin list with the vertices of exactly one primitive.
    scene::ShapeIndex list(geometry::Topology topology, int patchVertices = 0) {
        auto mesh = std::make_shared<geometry::Mesh>();
        mesh->topology = topology;
        mesh->patchVertices = patchVertices;
        mesh->attributes.push_back({std::string(geometry::kPosition), 3, std::vector<float>(18)});
        for (int i = 0; i < geometry::verticesPerPrimitive(topology, patchVertices); ++i)
            mesh->indices.push_back(static_cast<std::uint32_t>(i));
        return scene.shapes.add({glib::CommandId::glBegin, {}, {}, mesh});
    }
    scene::Draw& draw(std::string word, scene::ShapeIndex shapeIndex) {
        scene::Draw result;
        result.place = at(nextLine());
        result.id = {result.place.line};
        result.word = std::move(word);
        result.shape = shapeIndex;
        result.program = currentProgram;
        result.slots = scene::SlotTableIndex(scene.slotTables.size() - 1);
        scene.frame.passes.back().steps.emplace_back(result);
        return std::get<scene::Draw>(scene.frame.passes.back().steps.back());
    }
    scene::Draw& sphere() { return draw("Sphere", shape(glib::commandOf("Sphere"), {1, 60, 60})); }
    scene::Draw& teapot() { return draw("Teapot", shape(glib::commandOf("Teapot"))); }
    void clear() { scene.frame.passes.back().steps.emplace_back(scene::Clear{at(nextLine())}); }

    scene::ProgramIndex currentProgram;
    int line = 0;

  private:
    int nextLine() { return ++line; }
    scene::TextureIndex addTexture(scene::Texture texture) {
        const scene::TextureIndex index(scene.textures.size());
        scene::SlotTable slots = scene.slotTables.back();
        std::erase_if(slots, [&](const scene::Slot& slot) {
            return slot.unit == texture.unit && slot.target == texture.target;
        });
        slots.push_back({texture.unit, texture.target, index});
        scene.slotTables.push_back(std::move(slots));
        scene.textures.push_back(std::move(texture));
        return index;
    }
};

/// Supplies interfaces of programs by index, and records the requests in order.
struct Programs {
    std::map<scene::ProgramIndex, ProgramInterface> byIndex;
    ProgramInterface builtin;
    std::vector<scene::ProgramIndex> imageWriters;
    std::vector<ProgramVariant> asked;
    std::vector<scene::ProgramIndex> askedForImages;

    Programs() {
        builtin.usable = true;
        builtin.isBuiltin = true;
        builtin.uniforms.push_back(uniform("uModelViewProjectionMatrix", "mat4"));
        builtin.inputs = {{"aVertex", 0}, {"aColor", 1}};
    }
    /// `outOfSight`: Answers::sight of a draw; without it all are seen.
    FramePlan plan(
        const scene::Scene& scene, const PlanOptions& options = {},
        const std::function<std::string(const scene::Draw&, const scene::Pass&)>& outOfSight = {}) {
        Answers known;
        known.seesAll = !outOfSight;
        return planFrame(scene, scene.frame, known, options, [&](const Questions& open, Answers& answers) {
            for (const ProgramVariant& each : open.interfaces) {
                asked.push_back(each);
                answers.interfaces.emplace(each, each.program ? &byIndex.at(each.program) : &builtin);
            }
            for (const scene::ProgramIndex each : open.writers) {
                askedForImages.push_back(each);
                answers.writers.emplace(each, std::ranges::find(imageWriters, each) != imageWriters.end());
            }
            answers.loopLimit = 0;
            for (const scene::StepIndex& each : open.unseen)
                answers.sight.add(each, outOfSight(scene.frame.draw(each), scene.frame.passes[each.pass]));
        });
    }
    [[nodiscard]] std::vector<scene::ProgramIndex> askedPrograms() const {
        std::vector<scene::ProgramIndex> programs;
        for (const ProgramVariant& each : asked) programs.push_back(each.program);
        return programs;
    }
};

/// The words of the planned draws, pass by pass, with "Clear" for a Clear: "Sphere Teapot | Sphere".
inline std::string drawn(const FramePlan& plan) {
    std::string text;
    for (const PlannedPass& pass : plan.passes) {
        if (&pass != plan.passes.data()) text += " |";
        for (const auto& step : pass.steps) {
            const auto* draw = std::get_if<PlannedDraw>(&step);
            if (!text.empty()) text += ' ';
            text += draw != nullptr ? plan.drawOf(*draw).word : "Clear";
        }
    }
    return text;
}

/// The reasons (`why`) of all skipped things of this kind.
inline std::vector<std::string> skipped(const FramePlan& plan, std::string_view what) {
    std::vector<std::string> found;
    for (const Skipped& each : plan.skipped)
        if (each.what == what) found.push_back(each.why);
    return found;
}

}  // namespace glibra::plan::test
