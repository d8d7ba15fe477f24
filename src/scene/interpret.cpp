#include "scene/interpret.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <exception>
#include <utility>

#include "glib/command_table.h"
#include "glib/number.h"
#include "scene/state.h"

namespace glibra::scene {
namespace {

using glib::CommandId;

/// What a command is to a glBegin list that is open.
enum class InList {
    isPart,     ///< belongs to it
    goesFirst,  ///< is executed before the list is drawn: glib-W32
    isWrong,    ///< glib-E07
};

struct CommandAction {
    Handler handler = nullptr;
    CommandId id{};
    InList inList = InList::goesFirst;
};

constexpr CommandAction kActions[] = {
    {doWindowSize, CommandId::windowSize},
    {doPerspective, CommandId::perspective},
    {doOrtho, CommandId::ortho},
    {doLookAt, CommandId::lookAt},
    {doColor, CommandId::color, InList::isPart},
    {doBackground, CommandId::background},
    {doClear, CommandId::clear},
    {doTranslate, CommandId::translate},
    {doRotate, CommandId::rotate},
    {doScale, CommandId::scale},
    {doPushMatrix, CommandId::pushMatrix},
    {doPopMatrix, CommandId::popMatrix},
    {doModel, CommandId::obj},
    {doModel, CommandId::wireObj},
    {doModel, CommandId::objAdj},
    {doModel, CommandId::objPatch},
    {doModel, CommandId::shp},
    {doPointGroups, CommandId::linesAdjacency},
    {doPointGroups, CommandId::triangles},
    {doGlBegin, CommandId::glBegin, InList::isWrong},
    {doGlVertex, CommandId::glVertex, InList::isPart},
    {doGlNormal, CommandId::glNormal, InList::isPart},
    {doGlColor, CommandId::glColor, InList::isPart},
    {doGlTexCoord, CommandId::glTexCoord, InList::isPart},
    {doGlEnd, CommandId::glEnd, InList::isPart},
    {doLineWidth, CommandId::lineWidth},
    {doPointSize, CommandId::pointSize},
    {doPointSizeMode, CommandId::pointSizeMode},
    {doNumPatchVertices, CommandId::numPatchVertices},
    {doFlat, CommandId::flat},
    {doSmooth, CommandId::smooth},
    {doTexture, CommandId::texture1D},
    {doTexture, CommandId::texture2D},
    {doTexture, CommandId::texture3D},
    {doTexture, CommandId::texture},
    {doCubeMap, CommandId::cubeMap},
    {doRenderToTexture, CommandId::renderToTexture, InList::isWrong},
    {doClamp, CommandId::clamp},
    {doStage, CommandId::vertex},
    {doStage, CommandId::tessControl},
    {doStage, CommandId::tessEvaluation},
    {doStage, CommandId::geometry},
    {doStage, CommandId::fragment},
    {doProgram, CommandId::program, InList::isWrong},
    {doGeometryInput, CommandId::geometryInput},
    {doGeometryOutput, CommandId::geometryOutput},
    {doGeometryVerticesOut, CommandId::geometryVerticesOut},
    {doNothing, CommandId::gstap},
    {doNoise2D, CommandId::noise2D},
    {doNoise3D, CommandId::noise3D},
    {doTimer, CommandId::timer},
    {doMessageBox, CommandId::messageBox},
    {doNothing, CommandId::verbose},
};

constexpr bool rowsStandInOrder() {
    for (std::size_t i = 0; i < std::size(kActions); ++i)
        if (static_cast<std::size_t>(kActions[i].id) != i) return false;
    return static_cast<std::size_t>(CommandId::firstPrimitive) == std::size(kActions);
}
static_assert(rowsStandInOrder(), "every CommandId has its row, in the order of the enumeration");

/// True for commands whose own message tells more than a repetition of the statement.
bool isGeometry(CommandId id) {
    return id >= CommandId::firstPrimitive || (id >= CommandId::obj && id <= CommandId::triangles) ||
           id == CommandId::glEnd;
}

void execute(Interpreter& in, const glib::Command& command) {
    const auto index = static_cast<std::size_t>(command.id);
    if (index >= std::size(kActions) && glib::primitiveOf(command.id) == nullptr) return;
    const CommandAction action = index < std::size(kActions) ? kActions[index] : CommandAction{doPrimitive};
    if (in.list && action.inList == InList::isWrong) {
        in.reportError(command, "glib-E07",
                       fmt::format("{} is not possible inside glBegin ... glEnd", command.word));
        return;
    }
    if (in.list && action.inList == InList::goesFirst)
        in.reportWarning(command, "glib-W32",
                         fmt::format("{} inside glBegin {} before the list", command.word,
                                     isGeometry(command.id) ? "is drawn" : "is carried out"));
    if (action.inList != InList::isPart) in.isOrphan = false;
    if (in.scene.verbose && !isGeometry(command.id))
        in.report(note("glib-N02", textOf(command), in.place(command)));
    action.handler(in, command);
}

}  // namespace

std::string textOf(const glib::Command& command) {
    std::string text = command.word;
    const std::size_t shown = std::min(command.numbers.size(), std::size_t{16});
    for (std::size_t i = 0; i < shown; ++i) text += " " + glib::numberText(command.numbers[i]);
    if (!command.text.empty()) text += fmt::format(" '{}'", command.text);
    for (const std::string& file : command.files) text += fmt::format(" '{}'", file);
    return text;
}

FileIndex fileOf(Interpreter& in, const std::string& name, const Place& place) {
    FileIndex& index = in.files[name];
    if (!index) index = in.scene.files.add(findFile(name, place, in.folders, in.listings));
    return index;
}

Scene interpret(const glib::Script& script, const InterpretOptions& options) {
    Interpreter in{.script = script,
                   .scene = {},
                   .state = {},
                   .folders = searchFolders(script.path, options),
                   .listings = {},
                   .list = {},
                   .files = {},
                   .shapes = {},
                   .listShapes = {},
                   .clearedTextures = {},
                   .depthBuffers = {},
                   .clearedDepths = {},
                   .windowSize = {}};
    in.scene.path = script.path;
    in.scene.verbose =
        std::any_of(script.commands.begin(), script.commands.end(),
                    [](const glib::Command& command) { return command.id == CommandId::verbose; });
    try {
        addNoiseTextures(in);
        for (const glib::Command& command : script.commands) execute(in, command);
        checkList(in);
        checkStack(in);
        finishPasses(in);
        finishNoise(in);
    } catch (const std::exception& problem) {
        in.report(
            error("glib-E15", fmt::format("the scene cannot be run: {}", problem.what()), script.place({})));
    }
    std::stable_sort(in.scene.diagnostics.begin(), in.scene.diagnostics.end(),
                     [](const Diagnostic& a, const Diagnostic& b) {
                         return std::pair(a.place.line, a.place.column) <
                                std::pair(b.place.line, b.place.column);
                     });
    return std::move(in.scene);
}

}  // namespace glibra::scene
