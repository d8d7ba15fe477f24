#include "scene/run/scope.h"

#include <fmt/format.h>

#include <string_view>

#include "base/text.h"

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

// ---- Counts

namespace {

/// Elements that expressions of `i` may give lists and arrays of one frame. Those of buffers do not count:
/// their memory is limited.
constexpr std::size_t kMostElements = 10'000'000;

/// Reports once that the frame is too long. Nothing more of it runs.
bool stop(Interpreter& in, const Place& place, std::string_view what, std::size_t most) {
    if (!std::exchange(in.counts.isFull, true))
        in.report(diagnose(
            "glib-E15", fmt::format("the frame has more than {} {}", base::groupedText(most), what), place));
    return false;
}

}  // namespace

bool countStatement(Interpreter& in, const Command& command) {
    return ++in.counts.statements <= kMostStatements ||
           stop(in, in.place(command), "statements, with repetitions", kMostStatements);
}

bool countRound(Interpreter& in, const Command& command) {
    return ++in.counts.rounds <= kMostStatements ||
           stop(in, in.place(command), "rounds of Repeat", kMostStatements);
}

bool countElements(Interpreter& in, const Value& owner, double count) {
    in.counts.elements += static_cast<std::size_t>(count);
    return in.counts.elements <= kMostElements ||
           stop(in, in.place(owner), "elements that are computed", kMostElements);
}

}  // namespace glibra::scene
