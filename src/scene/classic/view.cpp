// Window, projection, viewing transformation, colours and the matrix stack (language, 3.1 and 3.2).

#include <fmt/format.h>

#include <array>
#include <string_view>

#include "scene/classic/classic.h"
#include "scene/run/evaluate.h"
#include "scene/view.h"

namespace glibra::scene {
namespace {

constexpr std::size_t kDeepestStack = 256;

double numberAt(const Command& command, std::size_t index, double otherwise) {
    return index < command.numbers.size() ? command.numbers[index] : otherwise;
}

glm::dvec3 argumentVector(const Command& command, std::size_t first) {
    return {numberAt(command, first, 0), numberAt(command, first + 1, 0), numberAt(command, first + 2, 0)};
}

/// Sets M := M * T. Reports glib-E31 instead if 32-bit floats cannot hold the product.
void multiply(Interpreter& in, const Command& command, const glm::dmat4& transform) {
    const glm::dmat4 product = in.state.modelView * transform;
    if (!isFinite(product)) {
        in.reportAt(command, "glib-E31",
                    fmt::format("{}: the matrix does not fit into 32-bit floats", command.word));
        return;
    }
    in.state.modelView = product;
    in.state.model = in.state.model * transform;
}

void doWindowSize(Interpreter& in, const Command& command) {
    const std::pair size(static_cast<int>(numberAt(command, 0, 600)),
                         static_cast<int>(numberAt(command, 1, 600)));
    if (in.windowSize && *in.windowSize != size)
        in.reportAt(command, "glib-W34",
                    fmt::format("WindowSize is given twice; {} {} replaces {} {}", size.first, size.second,
                                in.windowSize->first, in.windowSize->second));
    in.windowSize = size;
    in.scene.width = size.first;
    in.scene.height = size.second;
}

void doPerspective(Interpreter& in, const Command& command) {
    in.state.projection =
        Perspective{numberAt(command, 0, 50), numberAt(command, 1, .1), numberAt(command, 2, 1000)};
}

void doOrtho(Interpreter& in, const Command& command) {
    in.state.projection =
        Orthographic{numberAt(command, 0, -3), numberAt(command, 1, 3),     numberAt(command, 2, -3),
                     numberAt(command, 3, 3),  numberAt(command, 4, -1000), numberAt(command, 5, 1000)};
}

void doLookAt(Interpreter& in, const Command& command) {
    const glm::dvec3 eye = argumentVector(command, 0);
    const glm::dvec3 centre = argumentVector(command, 3);
    if (eye == centre) {
        in.reportAt(command, "glib-E13", "LookAt: eye and centre are the same point");
        return;
    }
    in.scene.usesLookAt = true;
    auto matrix = viewingMatrix(eye, centre, argumentVector(command, 6));
    constexpr std::array<std::pair<std::string_view, glm::dvec3>, 3> kOthers{
        {{"+y", {0, 1, 0}}, {"+z", {0, 0, 1}}, {"+x", {1, 0, 0}}}};
    for (const auto& [name, up] : kOthers) {
        if (matrix) break;
        matrix = viewingMatrix(eye, centre, up);
        if (matrix)
            in.reportAt(
                command, "glib-W30",
                fmt::format("LookAt: up is parallel to the view direction; {} is used instead", name));
    }
    if (matrix && isFinite(*matrix)) {
        in.state.modelView = in.scene.view = *matrix;
        in.state.model = glm::dmat4(1.0);
    } else
        in.reportAt(command, "glib-E31", "LookAt: the matrix does not fit into 32-bit floats");
}

void doColor(Interpreter& in, const Command& command) {
    in.state.color = glm::dvec4(argumentVector(command, 0), numberAt(command, 3, 1));
    if (!in.list) return;
    for (int i = 0; i < 4; ++i) in.list->current.color[static_cast<std::size_t>(i)] = in.state.color[i];
}

void doBackground(Interpreter& in, const Command& command) {
    in.state.background = command.numbers.empty()
                              ? kInitialBackground
                              : glm::dvec4(argumentVector(command, 0), numberAt(command, 3, 1));
}

void doMultMatrix(Interpreter& in, const Command& command) {
    static constexpr expression::Type kMatrix[] = {expression::Type::matrix(4)};
    if (command.values.empty()) return;
    if (const auto matrix = evaluate(in, command.values.front(), {.types = kMatrix}))
        multiply(in, command, matrix->mat4());
}

void doTranslate(Interpreter& in, const Command& command) {
    multiply(in, command, translation(argumentVector(command, 0)));
}

void doRotate(Interpreter& in, const Command& command) {
    multiply(in, command, rotation(numberAt(command, 0, 0), argumentVector(command, 1)));
}

void doScale(Interpreter& in, const Command& command) {
    const bool isUniform = command.givenNumbers == 1;
    multiply(in, command,
             scaling(isUniform ? glm::dvec3(numberAt(command, 0, 1)) : argumentVector(command, 0)));
}

void doPushMatrix(Interpreter& in, const Command& command) {
    if (in.state.stack.size() == kDeepestStack) {
        in.reportAt(command, "glib-E15",
                    fmt::format("{}: the limit is {} matrices", command.word, kDeepestStack));
        return;
    }
    in.state.stack.push_back({in.state.modelView, in.state.model, in.place(command)});
}

void doPopMatrix(Interpreter& in, const Command& command) {
    if (in.state.stack.empty()) {
        in.reportAt(command, "glib-E06", fmt::format("{} without PushMatrix", command.word));
        return;
    }
    in.state.modelView = in.state.stack.back().modelView;
    in.state.model = in.state.stack.back().model;
    in.state.stack.pop_back();
}

}  // namespace

std::span<const CommandAction> viewActions() {
    static constexpr CommandAction kActions[] = {
        {CommandId::windowSize, doWindowSize},
        {CommandId::perspective, doPerspective},
        {CommandId::ortho, doOrtho},
        {CommandId::lookAt, doLookAt},
        {CommandId::color, doColor, InList::isPart},
        {CommandId::background, doBackground},
        {CommandId::multMatrix, doMultMatrix},
        {CommandId::translate, doTranslate},
        {CommandId::rotate, doRotate},
        {CommandId::scale, doScale},
        {CommandId::pushMatrix, doPushMatrix},
        {CommandId::popMatrix, doPopMatrix},
    };
    return kActions;
}

void checkStack(Interpreter& in) {
    const std::size_t open = in.state.stack.size();
    if (open == 0) return;
    in.report(diagnose("glib-W31",
                       fmt::format("{} PushMatrix without PopMatrix at the end of the file", open),
                       in.state.stack.back().place));
}

}  // namespace glibra::scene
