#include "render/check/scene_check.h"
#include "plan/submission.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <map>

#include "base/text.h"
#include "glsl/es/es.h"
#include "render/consequences.h"
#include "render/scene_state.h"

namespace glibra::render {
namespace {

const char* suffix(glsl::Stage stage) {
    switch (stage) {
        case glsl::Stage::vertex:
            return "vert";
        case glsl::Stage::tessControl:
            return "tesc";
        case glsl::Stage::tessEvaluation:
            return "tese";
        case glsl::Stage::geometry:
            return "geom";
        case glsl::Stage::compute:
            return "comp";
        case glsl::Stage::fragment:
            break;
    }
    return "frag";
}

/// The source without what only this driver accepts: file names in #line become plain source numbers.
std::string portable(std::string_view source) {
    std::string text;
    for (std::size_t begin = 0; begin < source.size();) {
        const std::size_t end = std::min(source.find('\n', begin), source.size());
        const std::string_view line = source.substr(begin, end - begin);
        if (line.starts_with("#line "))
            std::copy_if(line.begin(), line.end(), std::back_inserter(text), [](char c) { return c != '"'; });
        else if (line.find("GL_ARB_shading_language_include") == std::string_view::npos)
            text += line;
        text += '\n';
        begin = end + 1;
    }
    return text;
}

/// Takes the place of a translation that would show the text of a file outside of the scene's folder and the
/// library.
constexpr const char* kNotShown =
    "#error not shown: a source lies outside of the scene's folder and the library; add its folder to "
    "GLIBRA_PATH\n";

void addUnknown(Diagnostics& all, Diagnostics more) {
    for (Diagnostic& problem : more)
        if (std::ranges::none_of(all, [&](const Diagnostic& known) {
                return known.place == problem.place && known.text == problem.text;
            }))
            all.push_back(std::move(problem));
}

std::vector<TranslatedShader> translatedShaders(SceneState& state, bool isForWeb, Diagnostics& diagnostics) {
    const scene::Scene& scene = state.conductor.scene;
    std::map<plan::ProgramVariant, const plan::PlannedProgram*> programs;  // uniforms do not matter
    for (const plan::FramePlan* plan : state.conductor.plans())
        for (const plan::PlannedProgram& each : plan->programs) programs.emplace(each.variant, &each);
    std::vector<TranslatedShader> shaders;
    std::size_t number = 0;
    for (const auto& [variant, planned] : programs) {
        const scene::ProgramIndex program = variant.program;
        std::string name = program ? scene.programs[program].name : "built-in";
        for (char& c : name)
            if (!base::isOfName(c)) c = '_';
        const bool isHidden = !state.conductor.programs.hiddenSource(program).empty();
        glsl::EsProgram es;
        const glsl::TranslatedProgram* core = state.conductor.programs.translated(variant);
        if (isForWeb && core && !hasError(core->diagnostics))
            es = glsl::toEs(*core, {.draws = plan::drawFormsOf(scene, program)});
        state.conductor.programs.hideTexts(program, es.diagnostics);
        addUnknown(diagnostics, std::move(es.diagnostics));
        for (const glsl::TranslatedStage& each : isForWeb ? es.stages : planned->interface->facts.stages)
            shaders.push_back({fmt::format("{}-{}.{}", number, name, suffix(each.stage)),
                               isHidden ? std::string(kNotShown) : portable(each.source)});
        ++number;
    }
    return shaders;
}

}  // namespace

CheckResult checkScene(gpu::Context& context, const std::filesystem::path& path, const RenderOptions& options,
                       SharedParts* shared, bool isForWeb) {
    Stats stats;
    RenderOptions compiled = options;
    compiled.checkUndefined = false;  // nothing is drawn
    CheckResult result;
    Result<InterpretedScene> interpreted = interpretFile(path, options, stats);
    result.diagnostics = std::move(interpreted.diagnostics);
    if (interpreted) {
        if (interpreted->source)
            addUnknown(result.diagnostics, interpreted->source->mistakesLeftOut(interpreted->inputs));
        // A scene with errors in its text is checked further, because its shaders may have errors too.
        SceneState state(context, compiled, std::move(*interpreted), false, stats, shared);
        Result<PlanRequest> everything = state.request(true);
        if (everything) everything->options.idleNoise = false;
        append(result.diagnostics, state.conductor.prepare(std::move(everything)));
        for (const scene::Buffer& each :
             state.conductor.scene.buffers)  // also of those that no program reads
            addUnknown(result.diagnostics, each.values.takeProblems());
        result.shaders = translatedShaders(state, isForWeb, result.diagnostics);
        append(result.diagnostics, context.debugLog().takeDiagnostics());
        state.conductor.judge(result.diagnostics);
    } else {
        applyStrict(result.diagnostics, options.strict);
    }
    return result;
}

}  // namespace glibra::render
