#pragma once
// A scene for tests of the choice. It needs no GL: programs are described by hand.

#include <gtest/gtest.h>

#include <string>
#include <variant>
#include <vector>

#include "budget/budget.h"
#include "glib/script.h"
#include "plan/planner.h"
#include "scene/interpret.h"
#include "scene/view.h"

namespace glibra::budget {

/// A scene, its plan with one description for all programs, and the choice.
class Budget {
  public:
    explicit Budget(const std::string& text) {
        program.usable = true;
        program.facts.placement = glsl::Placement::vertex;
        program.facts.stages = {{glsl::Stage::vertex, "void main() {}", {}, "a.vert", {}, {}},
                                {glsl::Stage::fragment, "void main() {}", {}, "a.frag", {}, {}}};
        program.inputs = {{"aVertex", 0}};
        const glib::Script script = glib::parse(text, "/tmp/scene.glib");
        EXPECT_TRUE(script.diagnostics.empty()) << script.diagnostics.front().text;
        scene = scene::interpret(script);
        request.maxError = .25;
        request.width = request.height = 600;
        request.mostSamples = 4;
        request.clipFromModel = [](const scene::Draw& draw, double aspect) {
            return scene::projectionMatrix(*draw.projection, aspect) * draw.modelView;
        };
    }

    void addSampler(const char* name, scene::TextureTarget target, const char* word) {
        plan::ActiveUniform uniform;
        uniform.name = name;
        uniform.type = {plan::BaseType::sampler, 1, 1, target, word};
        uniform.location = 0;
        program.uniforms.push_back(uniform);
    }

    /// Chooses and puts the choice into the scene.
    const Choice& choose() {
        plan::ProgramInterface builtin;
        builtin.usable = builtin.isBuiltin = true;
        builtin.inputs = {{"aVertex", 0}};
        plan::Answers known;
        known.loopLimit = 0;
        known.seesAll = true;
        const plan::FramePlan plan = plan::planFrame(
            scene, scene.frame, known, {}, [&](const plan::Questions& open, plan::Answers& answers) {
                for (const plan::ProgramVariant& each : open.interfaces)
                    answers.interfaces.emplace(each, each.program ? &program : &builtin);
                for (const scene::ProgramIndex each : open.writers) answers.writers.emplace(each, false);
            });
        choice = budget::choose(scene, plan, request);
        replaced = apply(choice, scene);
        return choice;
    }

    [[nodiscard]] const scene::Draw& draw(std::size_t index) const {
        return std::get<scene::Draw>(scene.frame.passes.front().steps.at(index));
    }
    [[nodiscard]] const std::vector<double>& numbers(std::size_t index) const {
        return scene.shapes[draw(index).shape].numbers;
    }
    [[nodiscard]] std::string decision(const std::string& what) const {
        for (const Decision& each : choice.decisions)
            if (each.what == what) return each.why;
        return "none";
    }

    scene::Scene scene;
    plan::ProgramInterface program;
    Request request;
    Choice choice;
    std::vector<scene::ShapeIndex> replaced;
};

inline const std::string kProgram = "Vertex a.vert\nFragment a.frag\nProgram P uKd .5\n";
inline const std::string kEye = "LookAt 0 0 4 0 0 0 0 1 0\n";

}  // namespace glibra::budget
