#include "cli/render_answer.h"

#include <fmt/format.h>

#include <exception>
#include <new>
#include <optional>
#include <utility>

#include "base/packed.h"
#include "base/text.h"
#include "cli/scene_arguments.h"

namespace glibra::render {

void eachMember(auto& packed, base::Is<TranslatedShader> auto& of) {
    packed(of.name, of.source);
}

}  // namespace glibra::render

namespace glibra::cli {

void eachMember(auto& packed, base::Is<Answer> auto& of) {
    packed.upTo(kNoDriver, of.status);
    packed(of.explanation, of.statsJson, of.shaders, of.lines, of.remarks.general, of.remarks.ofFrames);
}

namespace {

Answer wrong(const std::string& scene, const char* id, const std::string& text) {
    return {.status = kSceneIsWrong, .remarks = {{diagnose(id, text, {scene, 1, 1})}, {}}};
}

}  // namespace

std::string pack(const Answer& answer) {
    return base::packed(answer);
}

Answer answerOf(const base::Outcome& outcome, const std::string& scene, const suite::Shot& picture,
                const Deed& deed) {
    if (outcome.end == base::Outcome::End::finished)
        if (std::optional<Answer> answer = base::unpacked<Answer>(outcome.answer)) return *std::move(answer);
    if (outcome.end == base::Outcome::End::deviceLost)
        return {.status = kSceneIsWrong, .remarks = {{base::diagnosticOf(outcome.lost, scene)}, {}}};
    if (outcome.end == base::Outcome::End::timedOut)
        return wrong(scene, "draw-E07",
                     fmt::format("not {} within {:g} seconds (--timeout)", deed.participle, picture.timeout));
    return wrong(
        scene, "draw-E06",
        fmt::format(
            "the process that {} the scene ended {}{}", deed.past,
            outcome.signal > 0 ? fmt::format("with signal {}", outcome.signal) : std::string("by itself"),
            outcome.nearMemoryLimit ? ", perhaps because it reached its limit of memory (--memory)" : ""));
}

Answer guarded(const std::string& scene, const std::function<Answer()>& work) {
    try {
        Answer answer = work();
        append(answer.remarks.general, libraryHint(scene, answer.remarks.general));
        return answer;
    } catch (const base::DeviceLost&) {
        throw;  // the worker must not be used any more
    } catch (const std::bad_alloc& failure) {
        return wrong(scene, "draw-E05", base::reasonOf(failure));
    } catch (const std::exception& failure) {
        return wrong(scene, "draw-E06", base::reasonOf(failure));
    }
}

}  // namespace glibra::cli
