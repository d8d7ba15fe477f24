#include "scene/modern/scope.h"

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
}

}  // namespace glibra::scene
