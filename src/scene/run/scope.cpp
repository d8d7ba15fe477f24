#include "scene/run/scope.h"

#include <fmt/format.h>

namespace glibra::scene {

void resetRaster(Interpreter& in) {
    in.state.raster = {};
    in.state.local.rasterStatements = {};
}

void noteRasterStatement(Interpreter& in, const Command& command, RasterPart part) {
    in.state.local.rasterStatements.at(static_cast<std::size_t>(part)) = &command;
}

void noteFreshRaster(Interpreter& in, const Command& command) {
    for (const Command* each : in.state.local.rasterStatements)
        if (each != nullptr)
            in.modern.rasterLost.try_emplace(each,
                                             LostRaster{in.place(*each), in.place(command), command.word});
}

void reportUnusedRaster(Interpreter& in) {
    for (const auto& [statement, lost] : in.modern.rasterLost) {
        if (in.modern.rasterUsed.contains(statement)) continue;
        in.report(diagnose(
            "glib-W39",
            fmt::format("{} has no effect: {} (line {}) begins with the default state{}", statement->word,
                        lost.word, lost.pass.line, lost.word == "Pass" ? "; move it into the pass" : ""),
            lost.place));
    }
}

}  // namespace glibra::scene
