// Makes parts of a scene before its programs are compiled. Only the compiler knows which samplers a program
// keeps; this code assumes all that the sources use. A wrong guess costs time on an otherwise idle thread and
// nothing else: the plan uses what it needs and makes what is missing.

#include <algorithm>
#include <cctype>
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "base/text.h"
#include "plan/needs.h"
#include "plan/texture_binding.h"
#include "plan/uniforms.h"
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
    guess.facts.textureBindings = program.textureBindings;
    guess.usable = true;
    return guess;
}

}  // namespace

void SceneState::makeAhead() {
    if (options.maxError > 0) return;  // shapes are chosen after the programs are compiled
    Result<std::vector<plan::Override>> overrides = parseOverrides(options.set);
    if (!overrides) return;
    std::erase_if(*overrides, [](const plan::Override& each) { return !each.word.empty(); });
    const auto usesOf = [&](const scene::Draw& draw, const scene::Pass& pass) {
        const plan::ProgramVariant variant = plan::variantOf(scene, draw, pass);
        const glsl::TranslatedProgram* translated = programs.translated(variant);
        std::vector<plan::ObjectUse> found;
        if (!translated || hasError(translated->diagnostics)) return found;
        device.meshes().bounds(draw.shape, programs.mayReadTangents(variant), nullptr);
        if (!variant.program) return found;
        const plan::ProgramInterface guess = samplersIn(*translated);
        std::vector<bool> used;
        const auto samplers =
            plan::resolveUniforms(scene.programs[variant.program], scene.path, guess, *overrides, used,
                                  {scene.suppliesNames ? &scene : nullptr,
                                   draw.uniforms ? &scene.uniformSets[draw.uniforms] : nullptr})
                .samplers;
        const gpu::Capabilities& driver = context.capabilities();
        const auto units = plan::assignUnits(guess, samplers, driver.combinedTextureUnits, 0);
        if (!units) return found;
        for (const plan::TextureUse& use : plan::textureUses(scene, draw.slots, draw.sampling, guess, *units))
            if (use.view.texture) found.push_back({use.view});
        return found;
    };
    const plan::Needs needs = plan::findNeeds(
        scene, scene.frame,
        {usesOf, [this](scene::ProgramIndex program) { return programs.mayWriteImages(program); },
         [this](const scene::Draw& draw, const scene::Pass& pass) {
             return outOfSight(draw, pass, nullptr);
         }},
        {}, false);
    for (const scene::TextureIndex each : scene.textures.indices())
        if (needs.textures[each]) device.textures().readAhead(each);
}

}  // namespace glibra::render
