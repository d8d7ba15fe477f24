#include "plan/program_variant.h"

#include <algorithm>

namespace glibra::plan {
namespace {

/// True if fragments of the draw are seen: a pass without colours needs no fragment stage.
bool needsFragments(const scene::Draw& draw, const scene::Pass& pass) {
    return !draw.raster->discard && (pass.isWindow || !pass.targets.empty());
}

}  // namespace

ProgramVariant plainVariant(const scene::Scene& scene, scene::ProgramIndex program) {
    return {.program = program,
            .constants = program ? scene.programs[program].constants : std::vector<glsl::Constant>()};
}

ProgramVariant variantOf(const scene::Scene& scene, const scene::Draw& draw, const scene::Pass& pass) {
    const auto* space = std::get_if<scene::ClipSpace>(&*draw.projection);
    ProgramVariant variant{.flatColors = draw.flatColors,
                           .colorTargets = std::max<int>(1, static_cast<int>(pass.targets.size()))};
    if (usesBuiltin(scene, draw)) return variant;
    const scene::Program& program = scene.programs[draw.program];
    variant.program = draw.program;
    variant.constants = program.constants;
    variant.isFullScreen = (space != nullptr && space->hasStage) ||
                           (scene.shapes[draw.shape].bare && isWithoutVertexStage(program));
    variant.suppliesFragment = !program.hasStage(glsl::Stage::fragment) && needsFragments(draw, pass);
    variant.isFill = draw.isFill && std::ranges::any_of(program.stages, scene::Program::isLeftOutByFill);
    return variant;
}

bool isWithoutVertexStage(const scene::Program& program, bool isFill) {
    const auto isUsed = [&](const scene::StageFile& each) {
        return !(isFill && scene::Program::isLeftOutByFill(each));
    };
    return program.hasStage(glsl::Stage::fragment) && std::ranges::count_if(program.stages, isUsed) == 1;
}

bool usesBuiltin(const scene::Scene& scene, const scene::Draw& draw) {
    if (!draw.program) return true;
    const scene::Program& program = scene.programs[draw.program];
    if (draw.isFill && !program.hasStage(glsl::Stage::fragment)) return true;
    return !program.hasStage(glsl::Stage::vertex, draw.isFill) && !isWithoutVertexStage(program, draw.isFill);
}

}  // namespace glibra::plan
