#include "scene/modern/scope.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <utility>

namespace glibra::scene {

Scope::Scope(Interpreter& in)
    : in_(in),
      modelView_(in.state.modelView),
      model_(in.state.model),
      program_(in.state.program),
      set_(in.modern.set),
      stack_(std::exchange(in.state.stack, {})),
      local_(in.state.local),
      raster_(in.state.raster) {
    in.shared->environment.beginScope();
}

Scope::~Scope() {
    in_.shared->environment.endScope();
    in_.state.modelView = modelView_;
    in_.state.model = model_;
    in_.state.program = program_;
    in_.modern.set = std::move(set_);
    in_.state.stack = std::move(stack_);
    in_.state.local = local_;
    // Classic commands set these, which no scope ends.
    raster_.lineWidth = in_.state.raster.lineWidth;
    raster_.pointSize = in_.state.raster.pointSize;
    raster_.pointSizeFromShader = in_.state.raster.pointSizeFromShader;
    in_.state.raster = raster_;
}

void resetRaster(Interpreter& in) {
    RasterState fresh;
    fresh.lineWidth = in.state.raster.lineWidth;
    fresh.pointSize = in.state.raster.pointSize;
    fresh.pointSizeFromShader = in.state.raster.pointSizeFromShader;
    in.state.raster = fresh;
    in.state.local.rasterStatements = {};
}

void noteRasterStatement(Interpreter& in, const glib::Command& command) {
    constexpr std::array kKinds{glib::CommandId::state, glib::CommandId::viewport, glib::CommandId::scissor};
    const auto kind = std::find(kKinds.begin(), kKinds.end(), command.id) - kKinds.begin();
    in.state.local.rasterStatements.at(static_cast<std::size_t>(kind)) = &command;
}

void noteFreshRaster(Interpreter& in, const glib::Command& command) {
    for (const glib::Command* each : in.state.local.rasterStatements)
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
