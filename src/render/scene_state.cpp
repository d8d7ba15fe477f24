// Makes the plan of a scene and puts on the device what it needs.

#include "render/scene_state.h"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <set>
#include <utility>

#include "budget/budget.h"
#include "render/draw/sight.h"
#include "render/probe/patch_probe.h"
#include "render/probe/picture_probe.h"
#include "scene/primitives.h"
#include "scene/texture_name.h"
#include "scene/texture_parts.h"

namespace glibra::render {

bool SceneRenderer::State::isStopped(const Diagnostics& diagnostics) {
    if (!hasError(diagnostics)) return false;
    isIncomplete = options.incomplete;
    return isBroken || !options.incomplete;
}

/// Chooses counts for what a first plan needs. The scene is then planned again with the chosen shapes.
Diagnostics SceneRenderer::State::keepBudget(plan::PlanOptions& planOptions, Stats& stats) {
    const plan::FramePlan first = planList(scene.frame, planOptions);
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
    for (const scene::ShapeIndex shape : budget::apply(choice, scene)) device.meshes().forget(shape);
    planOptions.overrides.insert(planOptions.overrides.end(), choice.levels.begin(), choice.levels.end());
    stats.decisions.insert(stats.decisions.end(), choice.decisions.begin(), choice.decisions.end());
    std::stable_sort(
        stats.decisions.begin(), stats.decisions.end(),
        [](const budget::Decision& a, const budget::Decision& b) { return a.place.line < b.place.line; });
    return std::move(choice.diagnostics);
}

Diagnostics SceneRenderer::State::preparePlan(Stats& stats, bool everything) {
    isBroken = true;  // until there is a plan
    Result<std::vector<plan::Override>> overrides = parseOverrides(options.set);
    if (!overrides) return std::move(overrides.diagnostics);
    plan::PlanOptions planOptions = planOptionsOf(context.capabilities());
    planOptions.overrides = std::move(*overrides);
    std::erase_if(planOptions.overrides, [&](const plan::Override& each) {
        return each.program.empty() && scene.usedVariables.contains(each.name);
    });
    for (const std::string& each : options.wantedObjects) {
        const Result<scene::ObjectView> wanted = scene::objectNamed(scene, each);
        if (!wanted) return wanted.diagnostics;
        planOptions.roots.push_back(*wanted);
    }
    if (options.checks)
        for (const scene::Check& each : scene.checks)
            for (const auto& object : {each.object, each.other})
                if (object) planOptions.roots.push_back(*object);
    if (options.checks)
        for (const scene::Check& check : scene.checks)
            for (const scene::BufferIndex each : check.reads)
                planOptions.roots.emplace_back(scene::BufferView{each});
    for (const scene::Print& each : scene.prints) planOptions.roots.emplace_back(each.buffer);
    planOptions.everything = everything || !options.skip;
    planOptions.shareMeshes = options.skip;
    planOptions.reportsNames = !hasBlocks();
    planOptions.shareTargets = options.skip && !options.checkNan;  // the search looks into every target
    Diagnostics diagnostics;
    if (options.checkUndefined && !context.capabilities().compute)
        diagnostics.push_back(
            diagnose("check-E03",
                     fmt::format("--check-undefined needs OpenGL 4.3; this driver has {}.{}",
                                 context.capabilities().major, context.capabilities().minor),
                     {scene.path, 1, 1}));
    // A picture of another moment would need other counts.
    if (options.maxError > 0 && !everything && !changesWithTime)
        append(diagnostics, keepBudget(planOptions, stats));
    else if (options.maxError > 0 && !everything && !isMoving)
        stats.decisions.push_back(
            {"scene", "counts, samples and noise kept: it changes with time", {scene.path, 1, 1}});
    options.samples = std::max(1, options.samples);
    Diagnostics meshDiagnostics;
    // Primitives out of sight count, too.
    const bool countsPrimitives =
        options.checks && std::any_of(scene.checks.begin(), scene.checks.end(), [](const scene::Check& each) {
            return each.kind == scene::Check::Kind::primitives;
        });
    decltype(plan::PlanQuestions::outOfSight) unseen;
    if (!planOptions.everything && !countsPrimitives)
        unseen = [&](const scene::Draw& draw, const scene::Pass& pass) {
            return outOfSight(draw, pass, &meshDiagnostics);
        };
    plan = planList(scene.frame, planOptions, std::move(unseen));
    isBroken = false;
    if (!isMoving) {
        stats.skipped.insert(stats.skipped.begin(), plan.skipped.begin(), plan.skipped.end());
        listFoundByName(stats);
    }
    append(diagnostics, std::move(plan.diagnostics));
    plan.diagnostics.clear();
    append(diagnostics, std::move(meshDiagnostics));
    const bool isFirst = !simulation;
    if (!isStopped(diagnostics)) {
        Diagnostics ofSteps = planBlocks(planOptions, stats);
        isBroken = hasError(ofSteps);
        append(diagnostics, std::move(ofSteps));
    }
    if (!isStopped(diagnostics)) append(diagnostics, device.prepare(plan, programs));
    if (!isStopped(diagnostics) && isFirst && simulation) {
        Diagnostics ofSteps = simulation->make();
        isBroken = hasError(ofSteps);
        append(diagnostics, std::move(ofSteps));
    }
    return diagnostics;
}

/// Nodes of all lists may be skipped; what one of them uses is not.
void SceneRenderer::State::explainSimulation(Stats& stats) const {
    std::vector<Place> used;
    for (const plan::FramePlan* each : simulation->plans()) {
        for (const plan::PlannedProgram& program : each->programs) {
            if (!program.variant.program) continue;
            const scene::Program& own = scene.programs[program.variant.program];
            used.push_back(own.place);
            for (const scene::StageFile& stage : own.stages)
                if (stage.file) used.push_back(scene.files[stage.file].place);
        }
        for (const scene::TextureIndex texture : each->textures)
            used.push_back(scene.textures[texture].place);
    }
    const auto isNode = [](const plan::Skipped& each) {
        return each.what == "pass" || each.what == "draw" || each.what == "dispatch" ||
               each.what == "statement";
    };
    std::erase_if(stats.skipped, [&](const plan::Skipped& each) {
        return !isNode(each) && std::find(used.begin(), used.end(), each.place) != used.end();
    });
    for (const plan::FramePlan* each : simulation->plans())
        std::copy_if(each->skipped.begin(), each->skipped.end(), std::back_inserter(stats.skipped), isNode);
}

Diagnostics SceneRenderer::State::planBlocks(const plan::PlanOptions& planOptions, Stats& stats) {
    const bool isFirst = !simulation;
    Diagnostics diagnostics = planSimulation(planOptions, changesWithTime);
    if (!isFirst || !simulation) return diagnostics;
    explainSimulation(stats);
    return diagnostics;
}

void SceneRenderer::State::listFoundByName(Stats& stats) const {
    std::set<std::pair<scene::ProgramIndex, std::string>> seen;  // draws may have variants of a program
    for (const plan::PlannedProgram& each : plan.programs)
        for (const std::string& found : each.foundByName)
            if (seen.emplace(each.variant.program, found).second)
                stats.foundByName.push_back({"'" + scene.programs[each.variant.program].name + "'", found,
                                             scene.programs[each.variant.program].place});
}

std::string SceneRenderer::State::outOfSight(const scene::Draw& draw, const scene::Pass& pass,
                                             Diagnostics* remarks) {
    const geometry::Topology topology = scene::topologyOf(scene.shapes[draw.shape]);
    const plan::ProgramVariant variant = plan::variantOf(scene, draw, pass);
    const glsl::Placement placement = programs.placementOf(variant);
    if (topology == geometry::Topology::patches || placement == glsl::Placement::unknown ||
        !isPlacedByMatrices(draw) || scene.shapes[draw.shape].bare)
        return {};
    Screen screen{width, height, {0, 0, width, height}, options.samples, options.tileSize > 0};
    if (!pass.isWindow) {
        const auto size = scene::targetSize(scene, pass);
        if (!size) return {};
        const auto [targetWidth, targetHeight] = *size;
        const int samples = pass.targets.empty() ? scene.textures[pass.depth->texture].samples
                                                 : scene.textures[pass.targets.front()].samples;
        screen = {
            targetWidth, targetHeight, {0, 0, targetWidth, targetHeight}, samples, options.tileSize > 0};
    }
    const VertexBox& bounds = device.meshes().bounds(draw.shape, programs.mayReadTangents(variant), remarks);
    const ViewMatrices seen = isMoved(scene.frame, pass) ? view.shifted(pass.shift) : view.unmoved();
    const DrawView drawView = drawViewOf(draw, topology, seen, screen, context.capabilities());
    return std::string(describe(sightOf(placed(bounds, placement), drawView)));
}

/// A target that is drawn into or read before it is cleared in this frame shows the previous frame.
bool SceneRenderer::State::mayShowEarlierFrames() {
    if (scene.isModern) return false;  // what the frame writes begins as declared
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
            (!pass.isWindow && !freshDepths.contains(pass.depthBuffer)))
            return true;
        for (const auto& step : steps)
            if (const auto* draw = std::get_if<plan::PlannedDraw>(&step))
                for (const plan::TextureUse& use : draw->textures)
                    if (isOld(use.view.texture)) return true;
    }
    return false;
}

}  // namespace glibra::render
