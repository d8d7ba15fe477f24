// Statements whose effects last: Once and Step (language, 12.8).

#include <fmt/format.h>

#include <algorithm>
#include <string>
#include <utility>

#include "scene/modern/modern.h"
#include "scene/run/camera_use.h"
#include "scene/run/evaluate.h"
#include "scene/run/scope.h"
#include "scene/run/statements.h"
#include "scene/run/uniforms.h"

namespace glibra::scene {
namespace {

using expression::Depends;

constexpr double kMostStepsPerSecond = 1e9;

/// Runs the statements of a block into its own list of nodes. What the frame has drawn and cleared is put
/// back at the end.
void runBlock(Interpreter& in, const Command& command, OpenBlock& block, NodeList& nodes) {
    const std::size_t index = indexOf(in, command);
    Output outer = std::exchange(in.out, {&nodes});
    in.around.block = &block;
    in.names().beginBlock();
    {
        const Scope scope(in);
        // What has moved and changed the frame so far, perhaps with time, does not act on what lasts.
        in.state.model = glm::dmat4(1);
        in.state.modelView = in.scene.view;
        in.state.local = {};
        resetRaster(in);
        runBody(in, index + 1, command.partner);
    }
    nodes.namedValues = namedValuesOfBlock(in);
    in.names().endBlock(fmt::format("only {} sets it (line {})", block.word, block.place.line));
    in.around.block = nullptr;
    in.out = std::move(outer);
    // The frame depends on the block only through the objects that the block writes.
    constexpr Depends kOfStep = Depends::time | Depends::tick;
    const auto bits = static_cast<std::uint32_t>(block.depends) & ~static_cast<std::uint32_t>(kOfStep);
    in.shared->depends = in.shared->depends | static_cast<Depends>(bits);
    setTime(in);
}

void forgetInputs(Interpreter& in, const std::string& why) {
    for (const char* name : {"mouse", "mouse.down", "frame"}) in.names().forget(name, why);
}

/// The values after `reset`: expressions, or the names of variables and cameras.
std::vector<double> resetValues(Interpreter& in, const KeyedValues& key) {
    std::vector<double> values;
    const auto add = [&](std::span<const double> more) {
        values.insert(values.end(), more.begin(), more.end());
    };
    for (const Value& each : key.values) {
        if (namesCamera(in, each) || choosesCamera(in, each)) {
            const auto camera = cameraNamed(in, each);
            if (!camera) continue;
            const CameraValues now = valuesOf(*camera, 1);
            for (const glm::dmat4* matrix : {&now.view, &now.projection}) add({&(*matrix)[0][0], 16});
        } else if (each.kind == Value::Kind::word) {
            if (const auto value = evaluate(in, each)) add(value->all());
        } else if (const auto numbers = numbersOf(in, {&each, 1})) {
            add(*numbers);
        }
    }
    return values;
}

void doOnce(Interpreter& in, const Command& command) {
    OnceBlock once;
    once.place = in.place(command);
    OpenBlock block;
    block.word = "Once";
    block.place = once.place;
    const std::string why = "what Once writes lasts, so it cannot depend on this";
    forgetInputs(in, why);
    for (const char* name : {"time", "tick", "dt"}) in.names().forget(name, why);
    runBlock(in, command, block, once.nodes);
    once.reads = std::move(block.reads);
    in.scene.once.push_back(std::move(once));
}

void doStep(Interpreter& in, const Command& command) {
    // The statements run even if the rate is wrong, so that their errors are reported at the same time.
    const auto rate = numberOf(in, command.values.front());
    const bool isRight = rate && *rate > 0 && *rate <= kMostStepsPerSecond;
    if (rate && !isRight)
        in.reportAt(
            command.values.front(), "glib-E05",
            fmt::format("Step: the rate {} is not above 0 and at most {}", *rate, kMostStepsPerSecond));
    StepBlock step;
    step.rate = isRight ? *rate : 1;
    step.place = in.place(command);
    OpenBlock block;
    block.word = "Step";
    block.place = step.place;
    block.isStep = true;
    const std::size_t number = in.scene.steps.size();
    const auto of = [&](const std::vector<std::int64_t>& ticks) {
        return static_cast<double>(number < ticks.size() ? ticks[number] : 0);
    };
    const double tick = of(in.inputs.ticks);
    forgetInputs(in, "a step is the same whatever frames are drawn; use a variable");
    in.names().setNumber("tick", std::max(0.0, tick - of(in.inputs.firstTicks)));
    in.names().setNumber("time", tick / step.rate);
    in.names().setNumber("dt", 1 / step.rate);
    if (const KeyedValues* reset = command.key("reset")) {
        in.around.block = &block;  // which depends on what these values depend on
        step.resets = resetValues(in, *reset);
        in.around.block = nullptr;
    }
    runBlock(in, command, block, step.nodes);
    step.dependsOnTick = any(block.depends & (Depends::time | Depends::tick));
    step.fillsDependOnTick = any(block.fillDepends & (Depends::time | Depends::tick));
    if (isRight) in.scene.steps.push_back(std::move(step));
}

}  // namespace

void noteCamera(Interpreter& in, const SceneCamera& camera) {
    OpenBlock* block = in.around.block;
    if (block == nullptr) return;
    const CameraValues values = valuesOf(camera, currentAspect(in));
    for (const glm::dmat4* matrix : {&values.view, &values.projection})
        block->reads.insert(block->reads.end(), &(*matrix)[0][0], &(*matrix)[0][0] + 16);
    noteCameraDepends(in, camera.name);
}

void noteFill(Interpreter& in) {
    OpenBlock* block = in.around.block;
    if (block == nullptr) return;
    if (const auto* symbol = in.names().lookUpInScene(currentCamera(in).name.first + ".view"))
        block->fillDepends = block->fillDepends | in.names().dependsOf(symbol->slot);
}

std::span<const CommandAction> blockActions() {
    static constexpr CommandAction kActions[] = {
        {CommandId::once, doOnce, InList::isWrong, true},
        {CommandId::endOnce, doNothing, InList::isWrong, true},
        {CommandId::step, doStep, InList::isWrong, true},
        {CommandId::endStep, doNothing, InList::isWrong, true},
    };
    return kActions;
}

}  // namespace glibra::scene
