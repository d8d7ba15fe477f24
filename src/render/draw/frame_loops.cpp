// Draws and dispatches whose programs record which of their loops the driver ends (Frame::recordsLoops).

#include <array>

#include "plan/accesses.h"
#include "render/draw/frame.h"
#include "render/load/derived_program.h"

namespace glibra::render {

const BuiltProgram* FrameDrawer::loopCounterOf(plan::PlannedProgramIndex program, const BuiltProgram& built,
                                               const Frame& frame) const {
    const BuiltProgram* counter = built.loopCounter.get();
    const bool isWanted = frame.recordsLoops && !isCounted_ && !hook_ && !programs_.isReversed() &&
                          plan_.programs[program].hasOpenLoops;
    return isWanted && counter != nullptr && counter->record ? counter : nullptr;
}

void FrameDrawer::useCounter(const BuiltProgram& built) {
    const BuiltProgram& counter = *built.loopCounter;
    bindings_.use(*counter.program);
    copyUniforms(built, *counter.program, counter.interface);
    bindings_.bindBase(*counter.record, GL_SHADER_STORAGE_BUFFER, counter.recordBinding);
}

bool FrameDrawer::recordLoops(const plan::PlannedDraw& planned, const BuiltProgram& built, const Frame& frame,
                              const base::RasterState& raster) {
    if (programOf(planned) != ownProgramOf(planned) ||
        loopCounterOf(planned.program, built, frame) == nullptr)
        return false;
    const bool stores = plan::writesMemory(plan_.programs[planned.program], planned.textures);
    base::RasterState unseen = raster;
    unseen.write.fill({false, false, false, false});
    unseen.depthWrite = false;
    unseen.stencilFront.writeMask = unseen.stencilBack.writeMask = 0;
    useCounter(built);
    if (!stores) raster_.apply(unseen);
    submit(planned, true);
    bindings_.use(*built.program);
    if (!stores) raster_.apply(raster);
    return stores;
}

}  // namespace glibra::render
