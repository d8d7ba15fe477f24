#include "support.h"

#include <gtest/gtest.h>

#include <fstream>
#include <system_error>

#include "../support/new_folder.h"
#include "glib/script.h"

namespace glibra::scene::tests {

Scene run(std::string_view text, const std::filesystem::path& path, const InterpretOptions& options) {
    const glib::Script script = glib::parse(text, path.string());
    EXPECT_FALSE(hasError(script.diagnostics)) << textsOf(script.diagnostics);
    return interpret(script, options);
}

std::vector<Draw> drawsOf(const Scene& scene) {
    std::vector<Draw> draws;
    for (const Pass& pass : scene.frame.passes)
        for (const auto& step : pass.steps)
            if (const auto* draw = std::get_if<Draw>(&step)) draws.push_back(*draw);
    return draws;
}

Draw drawOf(std::string_view text) {
    const std::vector<Draw> draws = drawsOf(run(text));
    EXPECT_EQ(draws.size(), 1U);
    return draws.empty() ? Draw{} : draws.front();
}

std::string idsOf(const Diagnostics& diagnostics) {
    std::string ids;
    for (const Diagnostic& each : diagnostics) ids += (ids.empty() ? "" : " ") + each.id;
    return ids;
}

std::string textsOf(const Diagnostics& diagnostics) {
    std::string texts;
    for (const Diagnostic& each : diagnostics) {
        if (!texts.empty()) texts += '\n';
        texts += std::to_string(each.place.line) + ":" + std::to_string(each.place.column);
        texts += " " + each.id + " " + each.text;
    }
    return texts;
}

Interpretation scriptOf(std::string_view text, const std::filesystem::path& path) {
    glib::Script script = glib::parse(text, path.string());
    EXPECT_EQ(textsOf(script.diagnostics), "");
    return {std::move(script), {}};
}

Scene sceneAt(Interpretation& script, double time) {
    FrameInputs inputs;
    inputs.time = time;
    return script.at(inputs);
}

glm::dvec3 placeOf(const Draw& draw) {
    return glm::dvec3(draw.modelView[3]);
}

const glib::UniformSpec* uniformOf(const Scene& scene, const Draw& draw, std::string_view tag) {
    if (!draw.uniforms) return nullptr;
    for (const glib::UniformSpec& each : scene.uniformSets[draw.uniforms].values)
        if (each.tag == tag) return &each;
    return nullptr;
}

std::vector<double> uniformValues(const Scene& scene, const Draw& draw, std::string_view tag) {
    const glib::UniformSpec* found = uniformOf(scene, draw, tag);
    return found != nullptr ? found->values : std::vector<double>();
}

TemporaryFolder::TemporaryFolder() {
    path_ = test::newFolder("scene");
}

TemporaryFolder::~TemporaryFolder() {
    std::error_code failure;
    if (!path_.empty()) std::filesystem::remove_all(path_, failure);
}

std::filesystem::path TemporaryFolder::write(const std::filesystem::path& name,
                                             std::string_view content) const {
    std::filesystem::path path = path_ / name;
    std::filesystem::create_directories(path.parent_path());
    std::ofstream(path, std::ios::binary) << content;
    return path;
}

}  // namespace glibra::scene::tests
