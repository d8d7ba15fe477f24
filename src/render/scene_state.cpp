// Makes the plan of a scene and puts on the device what it needs.

#include "render/scene_state.h"

#include <algorithm>
#include <set>
#include <utility>

#include "budget/budget.h"
#include "gpu/context/loop_limit.h"
#include "render/draw/sight.h"
#include "render/probe/patch_probe.h"
#include "render/probe/picture_probe.h"
#include "scene/primitives.h"
#include "scene/view.h"

namespace glibra::render {

plan::FramePlan SceneRenderer::State::planScene(const plan::PlanOptions& planOptions) {
    return plan::planFrame(
        scene,
        [this](const plan::ProgramVariant& variant) -> const plan::ProgramInterface& {
            return programs.interfaceOf(variant);
        },
        [this](scene::ProgramIndex program) { return programs.mayWriteImages(program); }, planOptions);
}

/// Chooses counts for what a first plan needs. The scene is then planned again with the chosen shapes.
Diagnostics SceneRenderer::State::keepBudget(plan::PlanOptions& planOptions, Stats& stats) {
    const plan::FramePlan first = planScene(planOptions);
    if (hasError(first.diagnostics)) return {};
    const StageTimer timer(stats, "budget");
    const PictureProbe pictures{context, scene, options, width, height, view, parts};
    PatchProbe probe(context, scene, options, width, height);
    budget::Choice choice =
        budget::choose(scene, first,
                       {.maxError = options.maxError,
                        .overrideCounts = options.overrideCounts,
                        .width = width,
                        .height = height,
                        .areSamplesFree = options.samples == 0,
                        .mostSamples = context.capabilities().maxSamples,
                        .clipFromModel =
                            [&](const scene::Draw& draw, double aspect) {
                                return view.projection(draw.projection, aspect) * view.modelView(draw);
                            },
                        .contourShift = [&](const budget::Choice& from,
                                            const budget::Choice& to) { return pictures.shift(from, to); },
                        .mostLevel = context.capabilities().maxTessellationLevel,
                        .overrides = planOptions.overrides,
                        .patches = [&](std::size_t pass, std::size_t step,
                                       auto values) { return probe.patches(pass, step, values); }});
    if (options.samples == 0) options.samples = choice.samples;
    for (const scene::ShapeIndex shape : budget::apply(choice, scene)) device.forgetMesh(shape);
    planOptions.overrides.insert(planOptions.overrides.end(), choice.levels.begin(), choice.levels.end());
    stats.decisions = std::move(choice.decisions);
    return std::move(choice.diagnostics);
}

Diagnostics SceneRenderer::State::preparePlan(Stats& stats, bool everything) {
    Result<std::vector<plan::Override>> overrides = parseOverrides(options.set);
    if (!overrides) return std::move(overrides.diagnostics);
    plan::PlanOptions planOptions;
    planOptions.overrides = std::move(*overrides);
    std::erase_if(planOptions.overrides, [&](const plan::Override& each) {
        return each.program.empty() && scene.usedVariables.contains(each.name);
    });
    planOptions.maxTextureUnits = context.capabilities().combinedTextureUnits;
    planOptions.loopLimit = [this] { return gpu::measureLoopLimit(context); };
    planOptions.everything = everything || !options.skip;
    planOptions.shareMeshes = options.skip;
    Diagnostics diagnostics;
    // A picture of another moment would need other counts.
    if (options.maxError > 0 && !everything && !changesWithTime)
        append(diagnostics, keepBudget(planOptions, stats));
    options.samples = std::max(1, options.samples);
    Diagnostics meshDiagnostics;
    if (!planOptions.everything)
        planOptions.outOfSight = [&](const scene::Draw& draw, const scene::Pass& pass) {
            return outOfSight(draw, pass, &meshDiagnostics);
        };
    plan = planScene(planOptions);
    if (!isMoving) stats.skipped.insert(stats.skipped.begin(), plan.skipped.begin(), plan.skipped.end());
    append(diagnostics, std::move(plan.diagnostics));
    plan.diagnostics.clear();
    append(diagnostics, std::move(meshDiagnostics));
    if (!hasError(diagnostics)) append(diagnostics, device.prepare(plan, programs));
    return diagnostics;
}

std::string SceneRenderer::State::outOfSight(const scene::Draw& draw, const scene::Pass& pass,
                                             Diagnostics* remarks) {
    const geometry::Topology topology = scene::topologyOf(scene.shapes[draw.shape]);
    const plan::ProgramVariant variant = plan::variantOf(scene, draw, pass);
    const glsl::Placement placement = programs.placementOf(variant);
    if (topology == geometry::Topology::patches || placement == glsl::Placement::unknown) return {};
    Screen screen{width, height, {0, 0, width, height}, options.samples, options.tileSize > 0};
    if (!pass.targets.empty()) {
        const scene::Texture& target = scene.textures[pass.targets.front()];
        const auto* size = std::get_if<scene::EmptySource>(&target.source);
        if (!size) return {};
        screen = {size->width, size->height, {0, 0, size->width, size->height}, 1, options.tileSize > 0};
    }
    const VertexBox& bounds = device.bounds(draw.shape, programs.mayReadTangents(variant), remarks);
    const DrawView drawView = drawViewOf(draw, topology, view, screen, context.capabilities());
    return std::string(describe(sightOf(placed(bounds, placement), drawView)));
}

/// A target that is drawn into or read before it is cleared in this frame shows the previous frame.
bool SceneRenderer::State::mayShowEarlierFrames() {
    const bool writesImages =
        std::any_of(plan.programs.begin(), plan.programs.end(), [this](const plan::PlannedProgram& each) {
            return each.variant.program && programs.mayWriteImages(each.variant.program);
        });
    if (writesImages) return true;
    std::set<scene::TextureIndex> targets;
    for (const plan::PlannedPass& each : plan.passes)
        targets.insert(plan.passOf(each).targets.begin(), plan.passOf(each).targets.end());
    std::set<scene::TextureIndex> fresh;  // targets whose content is of this frame
    std::set<int> freshDepths;            // depth buffers likewise
    for (const plan::PlannedPass& planned : plan.passes) {
        const auto& steps = planned.steps;
        const scene::Pass& pass = plan.passOf(planned);
        const bool isCleared = !steps.empty() && std::holds_alternative<plan::PlannedClear>(steps.front());
        for (std::size_t i = 0; i < pass.targets.size(); ++i)
            if (isCleared || pass.clearColors[i]) fresh.insert(pass.targets[i]);
        if (isCleared || pass.clearDepth) freshDepths.insert(pass.depthBuffer);
        const auto isOld = [&](scene::TextureIndex texture) {
            return targets.contains(texture) && !fresh.contains(texture);
        };
        if (std::any_of(pass.targets.begin(), pass.targets.end(), isOld) ||
            (!pass.targets.empty() && !freshDepths.contains(pass.depthBuffer)))
            return true;
        for (const auto& step : steps)
            if (const auto* draw = std::get_if<plan::PlannedDraw>(&step))
                for (const plan::TextureUse& use : draw->textures)
                    if (isOld(use.texture)) return true;
    }
    return false;
}

Diagnostics SceneRenderer::State::placeEye(Stats& stats) {
    Diagnostics diagnostics;
    if (options.view != ViewPolicy::glman && !scene.usesLookAt) {
        const StageTimer timer(stats, "view");
        const scene::ViewMove move = scene::autoView(
            scene, [&](scene::ShapeIndex shape) { return device.mesh(shape, false, &diagnostics); },
            static_cast<double>(width) / height);
        eyeDistance = move.distance;
        append(diagnostics, move.diagnostics);
    }
    view = ViewMatrices(options.viewState, scene.view, eyeDistance);
    return diagnostics;
}

}  // namespace glibra::render
