// Makes parts of a scene before its programs are compiled. Only the compiler knows which samplers a program
// keeps; this code assumes all that the sources use. A wrong guess costs time on an otherwise idle thread and
// nothing else: the plan uses what it needs and makes what is missing.

#include <algorithm>
#include <cctype>
#include <cstddef>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "base/text.h"
#include "plan/planner.h"
#include "render/scene_state.h"

namespace glibra::render {
namespace {

/// The words of a GLSL text, in order.
std::vector<std::string_view> wordsOf(std::string_view text) {
    std::vector<std::string_view> words;
    for (std::size_t i = 0; i < text.size();) {
        const std::size_t begin = i;
        while (i < text.size() && base::isOfName(text[i])) ++i;
        if (i > begin)
            words.push_back(text.substr(begin, i - begin));
        else
            ++i;
    }
    return words;
}

std::optional<scene::TextureTarget> textureTargetOf(std::string_view samplerType) {
    if (samplerType == "sampler1D") return scene::TextureTarget::texture1D;
    if (samplerType == "sampler2D") return scene::TextureTarget::texture2D;
    if (samplerType == "sampler3D") return scene::TextureTarget::texture3D;
    if (samplerType == "samplerCube") return scene::TextureTarget::cube;
    return std::nullopt;
}

/// The samplers that a stage declares and uses, as if the compiler had kept them.
plan::ProgramInterface samplersIn(const glsl::TranslatedProgram& program) {
    plan::ProgramInterface guess;
    for (const glsl::TranslatedStage& stage : program.stages) {
        if (stage.source.find("sampler") == std::string::npos) continue;
        const std::vector<std::string_view> words = wordsOf(stage.source);
        for (std::size_t i = 1; i + 1 < words.size(); ++i) {
            const std::optional<scene::TextureTarget> target = textureTargetOf(words[i]);
            if (!target || words[i - 1] != "uniform" || std::ranges::count(words, words[i + 1]) < 2) continue;
            plan::ActiveUniform& sampler = guess.uniforms.emplace_back();
            sampler.name = words[i + 1];
            if (const auto renamed = program.userNames.find(sampler.name); renamed != program.userNames.end())
                sampler.name = renamed->second;
            sampler.type.base = plan::BaseType::sampler;
            sampler.type.target = target;
            sampler.type.word = words[i];
        }
    }
    guess.facts = program;
    guess.usable = true;
    return guess;
}

}  // namespace

void SceneState::makeAhead() {
    const RenderOptions& options = conductor.options;
    const scene::Scene& scene = conductor.scene;
    ProgramLibrary& programs = conductor.programs;
    DeviceScene& device = conductor.device;
    if (options.maxError > 0) return;  // shapes are chosen after the programs are compiled
    Result<std::vector<plan::Override>> overrides = parseOverrides(options.set);
    if (!overrides) return;
    std::erase_if(*overrides, [](const plan::Override& each) { return !each.word.empty(); });
    std::map<plan::ProgramVariant, plan::ProgramInterface> guesses;
    const auto answer = [&](const plan::Questions& asked, plan::Answers& answers) {
        for (const plan::ProgramVariant& each : asked.interfaces) {
            const glsl::TranslatedProgram* translated = programs.translated(each);
            const bool isKnown = each.program && translated && !hasError(translated->diagnostics);
            const auto guess =
                guesses.emplace(each, isKnown ? samplersIn(*translated) : plan::ProgramInterface()).first;
            answers.interfaces.emplace(each, &guess->second);
        }
        for (const scene::ProgramIndex each : asked.writers)
            answers.writers.emplace(each, programs.mayWriteImages(each));
        answers.loopLimit = 0;
        for (const scene::StepIndex& each : asked.unseen)
            answers.sight.add(each,
                              outOfSight(scene.frame.draw(each), scene.frame.passes[each.pass], nullptr));
    };
    plan::PlanOptions planOptions = planOptionsOf(conductor.context.capabilities());
    planOptions.overrides = std::move(*overrides);
    planOptions.lacksCompute = "nothing of it is known before its programs are compiled";
    planOptions.reportsNames = false;
    const plan::FramePlan guessed = plan::planFrame(scene, scene.frame, {}, planOptions, answer);
    guessed.visitDraws([&](const plan::PlannedDraw& planned, const scene::Draw& draw, const auto&) {
        const plan::ProgramVariant& variant = guessed.programs[planned.program].variant;
        device.meshes().bounds(draw.shape, programs.mayReadTangents(variant), nullptr);
    });
    for (const scene::TextureIndex each : guessed.textures) device.textures().readAhead(each);
}

}  // namespace glibra::render
