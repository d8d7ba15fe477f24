// Any bytes as the source of one shader stage, and as a driver's log about it.

#include <algorithm>

#include "check.h"
#include "glsl/emit/log.h"
#include "glsl/translate.h"

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    using namespace glibra::glsl;
    using glibra::fuzz::check;
    if (size == 0) return 0;
    // The first byte chooses the stage and the translation.
    const unsigned choice = data[0];
    const std::string text(glibra::fuzz::textOf(data + 1, size - 1));
    ProgramRequest request;
    request.name = "Fuzzed";
    request.place = {"nowhere/scene.glib", 1, 1};
    request.stages.push_back({static_cast<Stage>(choice % kStageCount), "nowhere/stage.glsl", text});
    request.target.version = (choice & 8) ? 410 : 450;
    request.target.lineDirectiveTakesFileName = (choice & 16) != 0;
    request.shim = (choice & 96) != 0;
    request.tiled = (choice & 128) != 0;
    request.include = [&](std::string_view name, std::string_view) -> std::optional<IncludedFile> {
        if (name.size() % 2) return std::nullopt;
        return IncludedFile{"nowhere/" + std::string(name), text};
    };
    const TranslatedProgram program = translate(request);
    glibra::fuzz::checkMessages(program.diagnostics);
    check(program.stages.empty() || !glibra::hasError(program.diagnostics), "an error leaves no source");
    for (const TranslatedStage& stage : program.stages) {
        const auto lines = static_cast<std::size_t>(std::ranges::count(stage.source, '\n'));
        check(stage.lineMap.lines.size() >= lines, "every emitted line has an origin");
        for (const LineOrigin& origin : stage.lineMap.lines)
            check(origin.file < static_cast<int>(stage.lineMap.files.size()), "an origin names a file");
        glibra::fuzz::checkMessages(explainCompileLog(program, stage, text));
    }
    glibra::fuzz::checkMessages(explainLinkLog(program, text, request.place));
    return 0;
}
