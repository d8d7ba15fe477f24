#include "glib/command_table.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cassert>
#include <iterator>
#include <limits>
#include <vector>

#include "base/text.h"
#include "geometry/list_mesh.h"
#include "geometry/shapes/primitive.h"
#include "glib/limits.h"
#include "glib/message_log.h"
#include "glib/number.h"
#include "glib/text.h"

namespace glibra::glib {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

// ---- Arguments: their names, defaults and limits.

using Default = std::optional<double>;

constexpr Argument number(std::string_view name, Default byDefault = {}) {
    return {.name = name, .byDefault = byDefault};
}
constexpr Argument filled(std::string_view name, double filler) {
    return {.name = name, .filler = filler};
}
constexpr Argument optional(std::string_view name) {
    return {.name = name, .optional = true};
}
constexpr Argument integer(std::string_view name, Default byDefault, double least, double most,
                           std::string_view unit = {}) {
    return {.name = name,
            .type = ArgumentType::integer,
            .byDefault = byDefault,
            .rule = ArgumentRule::within,
            .least = least,
            .most = most,
            .unit = unit};
}
constexpr Argument positive(std::string_view name, Default byDefault, double least, double most,
                            std::string_view unit) {
    return {.name = name,
            .byDefault = byDefault,
            .rule = ArgumentRule::positive,
            .least = least,
            .most = most,
            .unit = unit};
}
constexpr Argument component(std::string_view name, Default byDefault, Default filler = {}) {
    return {.name = name, .byDefault = byDefault, .filler = filler, .rule = ArgumentRule::component};
}
constexpr Argument texels(std::string_view name, double most = kLargestTextureSide) {
    return {.name = name,
            .type = ArgumentType::integer,
            .optional = true,
            .rule = ArgumentRule::texels,
            .least = 1,
            .most = most,
            .unit = "texels"};
}
constexpr Argument textual(std::string_view name, ArgumentType type, bool optional = false) {
    return {.name = name, .type = type, .optional = optional};
}

constexpr Argument kUnit{
    .name = "unit", .type = ArgumentType::integer, .rule = ArgumentRule::unit, .most = kHighestUnit};
constexpr double kInt = std::numeric_limits<int>::max();

constexpr Argument kWindowSize[] = {integer("width", 600, 1, 16384, "pixels"),
                                    integer("height", 600, 1, 16384, "pixels")};
constexpr Argument kPerspective[] = {{.name = "angle",
                                      .byDefault = 50,
                                      .rule = ArgumentRule::between,
                                      .least = 0,
                                      .most = 180,
                                      .unit = "degrees"},
                                     number("near", .1),
                                     number("far", 1000)};
constexpr Argument kOrtho[] = {number("left", -3), number("right", 3),    number("bottom", -3),
                               number("top", 3),   number("near", -1000), number("far", 1000)};
constexpr Argument kLookAt[] = {number("ex"), number("ey"), number("ez"), number("lx"), number("ly"),
                                number("lz"), number("ux"), number("uy"), number("uz")};
constexpr Argument kColor[] = {component("r", {}), component("g", {}, 0), component("b", {}, 0),
                               component("a", 1)};
/// The defaults are the initial background (language, 2.1).
constexpr Argument kBackground[] = {component("r", kDefaultBackground[0]),
                                    component("g", kDefaultBackground[1], 0),
                                    component("b", kDefaultBackground[2], 0), component("a", 1)};
constexpr Argument kTranslate[] = {filled("tx", 0), filled("ty", 0), filled("tz", 0)};
constexpr Argument kRotate[] = {
    {.name = "angle", .unit = "degrees"}, filled("ax", 0), filled("ay", 0), filled("az", 0)};
constexpr Argument kScale[] = {number("sx"), filled("sy", 1), filled("sz", 1)};

constexpr Argument kGlVertex[] = {number("x"), number("y"), filled("z", 0), optional("w")};
constexpr Argument kGlNormal[] = {number("x"), number("y"), number("z")};
constexpr Argument kGlColor[] = {number("r"), number("g"), number("b"), number("a", 1)};
constexpr Argument kGlTexCoord[] = {number("s"), number("t", 0), number("p", 0), number("q", 1)};
constexpr Argument kPixels[] = {positive("size", {}, 0, kInfinity, "pixels")};
constexpr Argument kPointSizeMode[] = {integer("mode", 1, -kInt - 1, kInt)};
constexpr Argument kPatchVertices[] = {integer("vertices", {}, 1, 32)};

constexpr Argument kTexture1D[] = {kUnit, texels("width")};
constexpr Argument kTexture2D[] = {kUnit, texels("width"), texels("height")};
constexpr Argument kTexture3D[] = {kUnit, texels("width", kLargestVolumeSide),
                                   texels("height", kLargestVolumeSide), texels("depth", kLargestVolumeSide)};
constexpr Argument kCubeMap[] = {kUnit, textual("six files", ArgumentType::file)};
constexpr Argument kFile[] = {textual("file", ArgumentType::file, true)};
constexpr Argument kProgram[] = {textual("name", ArgumentType::name, true),
                                 textual("tags", ArgumentType::uniforms, true)};
constexpr Argument kTopology[] = {textual("topology", ArgumentType::word)};
constexpr Argument kSwitch[] = {textual("on", ArgumentType::word, true)};
constexpr Argument kVerticesOut[] = {{.name = "vertices",
                                      .type = ArgumentType::integer,
                                      .optional = true,
                                      .rule = ArgumentRule::within,
                                      .least = 1,
                                      .most = kMostVertices}};
constexpr Argument kGroups[] = {textual("points", ArgumentType::pointGroups)};
constexpr Argument kNoise2D[] = {integer("size", 64, 4, 4096, "texels")};
constexpr Argument kNoise3D[] = {integer("size", 64, 4, 400, "texels")};
constexpr Argument kTimer[] = {positive("period", 10, 1e-3, 1e6, "seconds")};
constexpr Argument kMessage[] = {textual("text", ArgumentType::text, true)};

// ---- Words.

constexpr std::string_view kInputTopologies[] = {"points", "lines", "lines_adjacency", "triangles",
                                                 "triangles_adjacency"};
constexpr std::string_view kOutputTopologies[] = {"points", "line_strip", "triangle_strip"};

constexpr TextureFormat kFormats[] = {{"RGBA8", 4}, {"RGBA16F", 8}, {"RGBA32F", 16}, {"R32F", 4}};

// ---- Rules about several numbers of one command (language, 3.1 and 3.2).

/// Returns the place of number `index`, or the place of the command if the file does not state the number.
Position placeOf(const Command& command, std::span<const Position> places, std::size_t index) {
    return index < places.size() ? places[index] : command.position;
}

void checkPerspective(Command& command, std::span<const Position> places, MessageLog& log) {
    const double near = command.numbers[1];
    const double far = command.numbers[2];
    if (near <= 0)
        log.report("glib-E05", fmt::format("Perspective: near {} is not above 0", numberText(near)),
                   placeOf(command, places, 1));
    else if (far <= near)
        log.report("glib-E29",
                   fmt::format("Perspective: near {} is not below far {}", numberText(near), numberText(far)),
                   placeOf(command, places, places.size() > 2 ? 2 : 1));
}

void checkOrtho(Command& command, std::span<const Position> places, MessageLog& log) {
    static constexpr std::array<bool, 7> kIncomplete = {false, true, true, true, false, true, false};
    if (kIncomplete.at(command.givenNumbers))
        log.report(
            "glib-W06",
            fmt::format("Ortho: {}, the rest are defaults", base::counted(command.givenNumbers, "number")),
            command.position);
    static constexpr std::array<const char*, 2> kSides = {"left and right", "bottom and top"};
    for (std::size_t axis = 0; axis < kSides.size(); ++axis) {
        double& low = command.numbers[2 * axis];
        double& high = command.numbers[2 * axis + 1];
        if (low != high) continue;
        low = -1;
        high = 1;
        log.report("glib-W29", fmt::format("Ortho: {} are equal, -1 ... 1 used", kSides.at(axis)),
                   placeOf(command, places, 2 * axis));
    }
    if (command.numbers[4] == command.numbers[5])
        log.report("glib-E29", fmt::format("Ortho: near and far are both {}", numberText(command.numbers[4])),
                   placeOf(command, places, places.size() > 5 ? 5 : 4));
}

void checkRotate(Command& command, std::span<const Position> places, MessageLog& log) {
    if (command.numbers[1] == 0 && command.numbers[2] == 0 && command.numbers[3] == 0)
        log.report("glib-W42", "Rotate: the axis is 0 0 0, no rotation", placeOf(command, places, 1));
}

void checkScale(Command& command, std::span<const Position> places, MessageLog& log) {
    for (std::size_t i = 0; i < command.numbers.size(); ++i) {
        if (command.numbers[i] != 0) continue;
        log.report("glib-W42", "Scale: factor 0 kept", placeOf(command, places, i));
        return;
    }
}

// ---- Commands.

using Id = CommandId;
using Form = ArgumentForm;

/// A row of what acts on the frame alone.
constexpr CommandRow ofFrame(CommandRow row) {
    row.restartsSimulation = false;
    return row;
}

/// The primitives' rows come between these two.
constexpr CommandRow kRowsBefore[] = {
    // Window, view, colour (3.1)
    {Id::windowSize, {"WindowSize"}, kWindowSize, "size of the window or image"},
    {.id = Id::perspective,
     .names = {"Perspective", "Persp"},
     .arguments = kPerspective,
     .summary = "symmetric perspective, vertical full angle",
     .together = checkPerspective},
    {.id = Id::ortho,
     .names = {"Ortho"},
     .arguments = kOrtho,
     .summary = "orthographic box, shown whole and undistorted",
     .together = checkOrtho},
    {Id::lookAt, {"LookAt"}, kLookAt, "replaces ModelView by the view from eye to centre with up"},
    {Id::color, {"Color", "Colour"}, kColor, "sets the current colour", Form::numbers, LoneNumber::grey},
    ofFrame({Id::background,
             {"Background"},
             kBackground,
             "sets the clear colour",
             Form::numbers,
             LoneNumber::firstThree}),
    {Id::clear, {"Clear"}, {}, "clears colour and depth of the current target"},
    // Transforms (3.2)
    ofFrame({Id::translate, {"Translate"}, kTranslate, "moves what follows"}),
    ofFrame({.id = Id::rotate,
             .names = {"Rotate"},
             .arguments = kRotate,
             .summary = "turns what follows about an axis through the origin",
             .together = checkRotate}),
    ofFrame({.id = Id::scale,
             .names = {"Scale"},
             .arguments = kScale,
             .summary = "scales what follows, by one factor or by one per axis",
             .loneNumber = LoneNumber::firstThree,
             .together = checkScale}),
    ofFrame({Id::pushMatrix, {"PushMatrix", "TransformBegin"}, {}, "saves ModelView"}),
    ofFrame({Id::popMatrix, {"PopMatrix", "TransformEnd"}, {}, "restores ModelView"}),
};
constexpr CommandRow kRowsAfter[] = {
    // Geometry (3.3) that is not a primitive
    ofFrame({Id::obj, {"Obj"}, kFile, "OBJ model as triangles", Form::file}),
    ofFrame({Id::wireObj, {"WireObj"}, kFile, "edges of an OBJ model", Form::file}),
    ofFrame({Id::objAdj, {"ObjAdj"}, kFile, "OBJ model as triangles with adjacency", Form::file}),
    ofFrame({Id::objPatch, {"ObjPatch"}, kFile, "OBJ model as patches of three vertices", Form::file}),
    ofFrame({Id::shp, {"Shp"}, kFile, "lines of an ESRI shapefile", Form::file}),
    ofFrame({.id = Id::linesAdjacency,
             .names = {"LinesAdjacency"},
             .arguments = kGroups,
             .summary = "lines with adjacency, four points each",
             .form = Form::pointGroups,
             .groupMultiple = 4}),
    ofFrame({.id = Id::triangles,
             .names = {"Triangles"},
             .arguments = kGroups,
             .summary = "triangles, three points each",
             .form = Form::pointGroups,
             .groupMultiple = 3}),
    {.id = Id::glBegin,
     .names = {"glBegin"},
     .arguments = kTopology,
     .summary = "starts a list of vertices",
     .form = Form::topology,
     .words = geometry::kListTopologyWords},
    {Id::glVertex, {"glVertex"}, kGlVertex, "a vertex of the list"},
    {Id::glNormal, {"glNormal"}, kGlNormal, "normal of the following vertices"},
    {Id::glColor, {"glColor"}, kGlColor, "colour of the following vertices"},
    {Id::glTexCoord, {"glTexCoord"}, kGlTexCoord, "texture coordinates of the following vertices"},
    {Id::glEnd, {"glEnd"}, {}, "draws the list"},
    {Id::lineWidth, {"LineWidth"}, kPixels, "width of lines"},
    {Id::pointSize, {"PointSize"}, kPixels, "size of points"},
    {Id::pointSizeMode, {"PointSizeMode"}, kPointSizeMode, "if not 0, the program sets the size of points"},
    {Id::numPatchVertices, {"NumPatchVertices"}, kPatchVertices, "number of vertices per patch"},
    {Id::flat, {"Flat"}, {}, "colours are not interpolated"},
    {Id::smooth, {"Smooth"}, {}, "colours are interpolated"},
    // Textures and targets (3.4)
    {Id::texture1D, {"Texture1D"}, kTexture1D, "1D texture from a file, or an empty one", Form::texture},
    {Id::texture2D, {"Texture2D"}, kTexture2D, "2D texture from a file, or an empty one", Form::texture},
    {Id::texture3D, {"Texture3D"}, kTexture3D, "3D texture from a file, or an empty one", Form::texture},
    {Id::texture, {"Texture"}, kTexture3D, "texture whose dimension its file or sizes decide", Form::texture},
    {Id::cubeMap,
     {"CubeMap"},
     kCubeMap,
     "cube map from six square pictures: +x -x +y -y +z -z",
     Form::cubeMap},
    {Id::renderToTexture,
     {"RenderToTexture"},
     {&kUnit, 1},
     "draws into textures; without units into the window",
     Form::units},
    {Id::clamp, {"Clamp"}, kSwitch, "textures are clamped to their edge, or repeat", Form::switchWord},
    // Shaders and programs (3.5)
    {Id::vertex, {"Vertex"}, kFile, "current vertex shader", Form::file},
    {Id::tessControl, {"TessControl"}, kFile, "current tessellation control shader", Form::file},
    {Id::tessEvaluation, {"TessEvaluation"}, kFile, "current tessellation evaluation shader", Form::file},
    {Id::geometry, {"Geometry"}, kFile, "current geometry shader", Form::file},
    {Id::fragment, {"Fragment"}, kFile, "current fragment shader", Form::file},
    {Id::program,
     {"Program"},
     kProgram,
     "links the current shaders and sets uniform variables",
     Form::program},
    {.id = Id::geometryInput,
     .names = {"GeometryInput", "GeometryInputType"},
     .arguments = kTopology,
     .summary = "input of a geometry shader without layout",
     .form = Form::topology,
     .words = kInputTopologies},
    {.id = Id::geometryOutput,
     .names = {"GeometryOutput", "GeometryOutputType"},
     .arguments = kTopology,
     .summary = "output of a geometry shader without layout",
     .form = Form::topology,
     .words = kOutputTopologies},
    {Id::geometryVerticesOut,
     {"GeometryVerticesOut"},
     kVerticesOut,
     "largest number of vertices that a geometry shader without layout emits"},
    {Id::gstap, {"GSTAP", "gstap.h"}, {}, "no effect: its names are always defined"},
    // Noise, time, messages (3.6)
    {Id::noise2D, {"Noise2D"}, kNoise2D, "size of the 2D noise texture"},
    {Id::noise3D, {"Noise3D"}, kNoise3D, "size of the 3D noise texture"},
    {Id::timer, {"Timer"}, kTimer, "period of the uniform variable Timer"},
    ofFrame({Id::messageBox, {"MessageBox"}, kMessage, "shows a message once", Form::message}),
    ofFrame({Id::verbose, {"Verbose"}, {}, "prints each command as it is carried out"}),
};

// ---- Primitives.

Argument argumentOf(const geometry::ShapeArgument& shape) {
    Argument argument{.name = shape.name, .byDefault = shape.byDefault};
    switch (shape.kind) {
        case geometry::ArgumentKind::number:
            break;
        case geometry::ArgumentKind::size:
            argument.rule = ArgumentRule::size;
            break;
        case geometry::ArgumentKind::count:
        case geometry::ArgumentKind::seed:
            argument.type = ArgumentType::integer;
            argument.rule =
                shape.kind == geometry::ArgumentKind::count ? ArgumentRule::count : ArgumentRule::within;
            argument.least = shape.least;
            argument.most = shape.most;
            break;
    }
    return argument;
}

/// All rows. Those of the primitives are made from geometry's.
struct Table {
    std::vector<Argument> arguments;  ///< of all primitives, one after the other
    std::vector<CommandRow> rows;

    Table() {
        for (const geometry::PrimitiveSpec* each : geometry::primitives())
            for (const geometry::ShapeArgument& argument : each->arguments)
                if (!argument.isFixed) arguments.push_back(argumentOf(argument));
        rows.assign(std::begin(kRowsBefore), std::end(kRowsBefore));
        std::span<const Argument> rest = arguments;
        int id = static_cast<int>(CommandId::firstPrimitive);
        for (const geometry::PrimitiveSpec* each : geometry::primitives()) {
            const auto stated = static_cast<std::size_t>(std::ranges::count_if(
                each->arguments, [](const geometry::ShapeArgument& argument) { return !argument.isFixed; }));
            rows.push_back({.id = static_cast<CommandId>(id++),
                            .names = each->names,
                            .arguments = rest.first(stated),
                            .summary = each->summary,
                            .loneNumber = each->oneSizeForAll ? LoneNumber::firstThree : LoneNumber::first,
                            .restartsSimulation = false});
            rest = rest.subspan(stated);
        }
        rows.insert(rows.end(), std::begin(kRowsAfter), std::end(kRowsAfter));
    }
};

}  // namespace

std::span<const CommandRow> commandTable() {
    static const Table kTable;
    return kTable.rows;
}

const CommandRow* findCommand(std::string_view word) {
    struct Named {
        std::string_view name;
        const CommandRow* row;
    };
    static const auto kByFirstLetter = [] {
        std::array<std::vector<Named>, 26> lists;
        for (const CommandRow& row : commandTable())
            for (const std::string_view name : row.names)
                if (!name.empty())
                    lists.at(static_cast<std::size_t>(lower(name[0]) - 'a')).push_back({name, &row});
        return lists;
    }();
    if (word.empty() || !isLetter(word[0])) return nullptr;
    for (const Named& each : kByFirstLetter.at(static_cast<std::size_t>(lower(word[0]) - 'a')))
        if (sameWord(each.name, word)) return each.row;
    return nullptr;
}

CommandId commandOf(std::string_view word) {
    const CommandRow* row = findCommand(word);
    assert(row != nullptr);
    return row->id;
}

const geometry::PrimitiveSpec* primitiveOf(CommandId id) {
    if (id < CommandId::firstPrimitive) return nullptr;
    const std::span<const geometry::PrimitiveSpec* const> all = geometry::primitives();
    const std::size_t index =
        static_cast<std::size_t>(id) - static_cast<std::size_t>(CommandId::firstPrimitive);
    return index < all.size() ? all[index] : nullptr;
}

std::span<const TextureFormat> textureFormats() {
    return kFormats;
}

}  // namespace glibra::glib
