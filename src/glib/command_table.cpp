#include "glib/command_table.h"

#include <array>
#include <limits>
#include <string>
#include <vector>

#include "glib/limits.h"
#include "glib/suggest.h"
#include "glib/text.h"

namespace glibra::glib {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

// ---- Arguments: what they are called, which value stands for a missing one, which values they take.

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
constexpr Argument size(std::string_view name, double byDefault) {
    return {.name = name, .byDefault = byDefault, .rule = ArgumentRule::size};
}
constexpr Argument count(std::string_view name, double byDefault, double least,
                         double most = kMostSubdivisions) {
    return {.name = name,
            .type = ArgumentType::integer,
            .byDefault = byDefault,
            .rule = ArgumentRule::count,
            .least = least,
            .most = most};
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
constexpr Argument kRadius = size("radius", 1);
constexpr Argument kHeight = size("height", 1);
constexpr double kInt = std::numeric_limits<int>::max();
constexpr double kUnsigned = std::numeric_limits<unsigned>::max();

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
/// Without any number the initial value of the language's section 2.1.
constexpr Argument kBackground[] = {component("r", kDefaultBackground[0]),
                                    component("g", kDefaultBackground[1], 0),
                                    component("b", kDefaultBackground[2], 0), component("a", 1)};
constexpr Argument kTranslate[] = {filled("tx", 0), filled("ty", 0), filled("tz", 0)};
constexpr Argument kRotate[] = {
    {.name = "angle", .unit = "degrees"}, filled("ax", 0), filled("ay", 0), filled("az", 0)};
constexpr Argument kScale[] = {number("sx"), filled("sy", 1), filled("sz", 1)};

constexpr Argument kBox[] = {size("dx", 2), size("dy", 2), size("dz", 2)};
constexpr Argument kSphere[] = {kRadius, count("slices", 60, 3), count("stacks", 60, 2)};
constexpr Argument kWireSphere[] = {kRadius, count("slices", 20, 3), count("stacks", 20, 2)};
constexpr Argument kCylinder[] = {kRadius, kHeight, count("slices", 60, 3), count("stacks", 20, 1)};
constexpr Argument kWireCylinder[] = {kRadius, kHeight, count("slices", 20, 3), count("stacks", 5, 1)};
constexpr Argument kTorus[] = {size("radius", 1), size("radius", .5), count("sides", 20, 3),
                               count("rings", 40, 3)};
constexpr Argument kSoccerball[] = {kRadius};
constexpr Argument kDisk[] = {number("z", 0), kRadius, count("slices", 60, 3), count("rings", 10, 1)};
constexpr Argument kQuadXY[] = {number("z", 0), size("size", 1), count("nx", 4, 1), count("ny", 4, 1)};
constexpr Argument kQuadXZ[] = {number("y", 0), size("size", 1), count("nx", 4, 1), count("nz", 4, 1)};
constexpr Argument kQuadYZ[] = {number("x", 0), size("size", 1), count("ny", 4, 1), count("nz", 4, 1)};
constexpr Argument kQuadBox[] = {count("quads", 10, 1, kMostVertices / 4)};
constexpr Argument kXarrow[] = {count("slices", 100, 2)};
constexpr Argument kPointCloud[] = {count("nx", 10, 1), count("ny", 10, 1), count("nz", 10, 1)};
constexpr Argument kJitterCloud[] = {count("nx", 10, 1), count("ny", 10, 1), count("nz", 10, 1),
                                     integer("seed", 0, -kInt - 1, kUnsigned)};
constexpr Argument kWireCube[] = {size("side", 1)};
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

constexpr std::string_view kListTopologies[] = {"points",
                                                "lines",
                                                "line_strip",
                                                "line_loop",
                                                "triangles",
                                                "triangle_strip",
                                                "triangle_fan",
                                                "polygon",
                                                "quads",
                                                "quad_strip",
                                                "lines_adjacency",
                                                "line_strip_adjacency",
                                                "triangles_adjacency",
                                                "triangle_strip_adjacency",
                                                "patches"};
constexpr std::string_view kInputTopologies[] = {"points", "lines", "lines_adjacency", "triangles",
                                                 "triangles_adjacency"};
constexpr std::string_view kOutputTopologies[] = {"points", "line_strip", "triangle_strip"};

constexpr TextureFormat kFormats[] = {{"RGBA8", 4}, {"RGBA16F", 8}, {"RGBA32F", 16}, {"R32F", 4}};

// ---- Commands.

using Id = CommandId;
using Form = ArgumentForm;

constexpr CommandRow kRows[] = {
    // Window, view, colour (3.1)
    {Id::windowSize, Form::numbers, {"WindowSize"}, kWindowSize, "size of the window or image"},
    {Id::perspective,
     Form::numbers,
     {"Perspective", "Persp"},
     kPerspective,
     "symmetric perspective, vertical full angle"},
    {Id::ortho, Form::numbers, {"Ortho"}, kOrtho, "orthographic box, shown whole and undistorted"},
    {Id::lookAt,
     Form::numbers,
     {"LookAt"},
     kLookAt,
     "replaces ModelView by the view from eye to centre with up"},
    {Id::color, Form::numbers, {"Color", "Colour"}, kColor, "current colour", LoneNumber::grey},
    {Id::background, Form::numbers, {"Background"}, kBackground, "clear colour", LoneNumber::firstThree},
    {Id::clear, Form::numbers, {"Clear"}, {}, "clears colour and depth of the current target"},
    // Transforms (3.2)
    {Id::translate, Form::numbers, {"Translate"}, kTranslate, "moves what follows"},
    {Id::rotate, Form::numbers, {"Rotate"}, kRotate, "turns what follows about an axis through the origin"},
    {Id::scale,
     Form::numbers,
     {"Scale"},
     kScale,
     "scales what follows, by one factor or one an axis",
     LoneNumber::firstThree},
    {Id::pushMatrix, Form::numbers, {"PushMatrix", "TransformBegin"}, {}, "saves ModelView"},
    {Id::popMatrix, Form::numbers, {"PopMatrix", "TransformEnd"}, {}, "restores ModelView"},
    // Geometry (3.3)
    {Id::box, Form::numbers, {"Box", "Cube"}, kBox, "box with these sides, centred", LoneNumber::firstThree},
    {Id::sphere, Form::numbers, {"Sphere"}, kSphere, "sphere, poles on the y axis"},
    {Id::cylinder, Form::numbers, {"Cylinder"}, kCylinder, "closed cylinder, base at y = 0"},
    {Id::cone, Form::numbers, {"Cone"}, kCylinder, "closed cone, base at y = 0"},
    {Id::torus, Form::numbers, {"Torus"}, kTorus, "torus about the z axis; the larger radius is the ring's"},
    {Id::teapot, Form::numbers, {"Teapot"}, {}, "the classic teapot"},
    {Id::soccerball, Form::numbers, {"Soccerball"}, kSoccerball, "sphere of 12 pentagons and 20 hexagons"},
    {Id::diskXY, Form::numbers, {"DiskXY"}, kDisk, "disk parallel to XY"},
    {Id::quadXY, Form::numbers, {"QuadXY"}, kQuadXY, "square -size..size parallel to XY"},
    {Id::quadXZ, Form::numbers, {"QuadXZ"}, kQuadXZ, "square -size..size parallel to XZ"},
    {Id::quadYZ, Form::numbers, {"QuadYZ"}, kQuadYZ, "square -size..size parallel to YZ"},
    {Id::quadBox, Form::numbers, {"QuadBox"}, kQuadBox, "stack of squares filling -1..1"},
    {Id::xarrow, Form::numbers, {"Xarrow"}, kXarrow, "arrow along x"},
    {Id::pointCloud, Form::numbers, {"PointCloud"}, kPointCloud, "regular grid of points"},
    {Id::jitterCloud, Form::numbers, {"JitterCloud"}, kJitterCloud, "grid of displaced points"},
    {Id::wireSphere, Form::numbers, {"WireSphere"}, kWireSphere, "sphere as lines"},
    {Id::wireTorus, Form::numbers, {"WireTorus"}, kTorus, "torus as lines"},
    {Id::wireCylinder, Form::numbers, {"WireCylinder"}, kWireCylinder, "cylinder as lines"},
    {Id::wireCone, Form::numbers, {"WireCone"}, kWireCylinder, "cone as lines"},
    {Id::wireCube, Form::numbers, {"WireCube"}, kWireCube, "edges of a cube"},
    {Id::wireBox, Form::numbers, {"WireBox"}, kBox, "edges of a box"},
    {Id::wireTeapot, Form::numbers, {"WireTeapot"}, {}, "the teapot as lines"},
    {Id::obj, Form::file, {"Obj"}, kFile, "OBJ model as triangles"},
    {Id::wireObj, Form::file, {"WireObj"}, kFile, "edges of an OBJ model"},
    {Id::objAdj, Form::file, {"ObjAdj"}, kFile, "OBJ model as triangles with adjacency"},
    {Id::objPatch, Form::file, {"ObjPatch"}, kFile, "OBJ model as patches of three vertices"},
    {Id::shp, Form::file, {"Shp"}, kFile, "lines of an ESRI shapefile"},
    {.id = Id::linesAdjacency,
     .form = Form::pointGroups,
     .names = {"LinesAdjacency"},
     .arguments = kGroups,
     .summary = "lines with adjacency, four points each",
     .groupMultiple = 4},
    {.id = Id::triangles,
     .form = Form::pointGroups,
     .names = {"Triangles"},
     .arguments = kGroups,
     .summary = "triangles, three points each",
     .groupMultiple = 3},
    {.id = Id::glBegin,
     .form = Form::topology,
     .names = {"glBegin"},
     .arguments = kTopology,
     .summary = "starts a list of vertices",
     .words = kListTopologies},
    {Id::glVertex, Form::numbers, {"glVertex"}, kGlVertex, "a vertex of the list"},
    {Id::glNormal, Form::numbers, {"glNormal"}, kGlNormal, "normal of the following vertices"},
    {Id::glColor, Form::numbers, {"glColor"}, kGlColor, "colour of the following vertices"},
    {Id::glTexCoord,
     Form::numbers,
     {"glTexCoord"},
     kGlTexCoord,
     "texture coordinates of the following vertices"},
    {Id::glEnd, Form::numbers, {"glEnd"}, {}, "draws the list"},
    {Id::lineWidth, Form::numbers, {"LineWidth"}, kPixels, "width of lines"},
    {Id::pointSize, Form::numbers, {"PointSize"}, kPixels, "size of points"},
    {Id::pointSizeMode,
     Form::numbers,
     {"PointSizeMode"},
     kPointSizeMode,
     "not 0: the program sets the size of points"},
    {Id::numPatchVertices, Form::numbers, {"NumPatchVertices"}, kPatchVertices, "vertices of a patch"},
    {Id::flat, Form::numbers, {"Flat"}, {}, "colours are not interpolated"},
    {Id::smooth, Form::numbers, {"Smooth"}, {}, "colours are interpolated"},
    // Textures and targets (3.4)
    {Id::texture1D, Form::texture, {"Texture1D"}, kTexture1D, "1D texture from a file, or an empty one"},
    {Id::texture2D, Form::texture, {"Texture2D"}, kTexture2D, "2D texture from a file, or an empty one"},
    {Id::texture3D, Form::texture, {"Texture3D"}, kTexture3D, "3D texture from a file, or an empty one"},
    {Id::texture, Form::texture, {"Texture"}, kTexture3D, "texture whose file or sizes tell the dimension"},
    {Id::cubeMap,
     Form::cubeMap,
     {"CubeMap"},
     kCubeMap,
     "cube map from six square pictures: +x -x +y -y +z -z"},
    {Id::renderToTexture,
     Form::units,
     {"RenderToTexture"},
     {&kUnit, 1},
     "draws into textures; alone: into the window"},
    {Id::clamp, Form::switchWord, {"Clamp"}, kSwitch, "textures are clamped to their edge, or repeat"},
    // Shaders and programs (3.5)
    {Id::vertex, Form::file, {"Vertex"}, kFile, "current vertex shader"},
    {Id::tessControl, Form::file, {"TessControl"}, kFile, "current tessellation control shader"},
    {Id::tessEvaluation, Form::file, {"TessEvaluation"}, kFile, "current tessellation evaluation shader"},
    {Id::geometry, Form::file, {"Geometry"}, kFile, "current geometry shader"},
    {Id::fragment, Form::file, {"Fragment"}, kFile, "current fragment shader"},
    {Id::program,
     Form::program,
     {"Program"},
     kProgram,
     "links the current shaders and sets uniform variables"},
    {.id = Id::geometryInput,
     .form = Form::topology,
     .names = {"GeometryInput", "GeometryInputType"},
     .arguments = kTopology,
     .summary = "input of a geometry shader without layout",
     .words = kInputTopologies},
    {.id = Id::geometryOutput,
     .form = Form::topology,
     .names = {"GeometryOutput", "GeometryOutputType"},
     .arguments = kTopology,
     .summary = "output of a geometry shader without layout",
     .words = kOutputTopologies},
    {Id::geometryVerticesOut,
     Form::numbers,
     {"GeometryVerticesOut"},
     kVerticesOut,
     "most vertices that a geometry shader without layout emits"},
    {Id::gstap, Form::numbers, {"GSTAP", "gstap.h"}, {}, "no effect: its names are always there"},
    // Noise, time, messages (3.6)
    {Id::noise2D, Form::numbers, {"Noise2D"}, kNoise2D, "size of the 2D noise texture"},
    {Id::noise3D, Form::numbers, {"Noise3D"}, kNoise3D, "size of the 3D noise texture"},
    {Id::timer, Form::numbers, {"Timer"}, kTimer, "period of the uniform variable Timer"},
    {Id::messageBox, Form::message, {"MessageBox"}, kMessage, "shows a message once"},
    {Id::verbose, Form::numbers, {"Verbose"}, {}, "prints what is done"},
};

}  // namespace

std::span<const CommandRow> commandTable() {
    return kRows;
}

const CommandRow* findCommand(std::string_view word) {
    struct Named {
        std::string_view name;
        const CommandRow* row;
    };
    static const auto kByFirstLetter = [] {
        std::array<std::vector<Named>, 26> lists;
        for (const CommandRow& row : kRows)
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

std::string_view nameOf(CommandId id) {
    for (const CommandRow& row : kRows)
        if (row.id == id) return row.name();
    return {};
}

std::string_view nearestCommand(std::string_view word) {
    std::vector<std::string_view> names;
    for (const CommandRow& row : kRows)
        for (const std::string_view name : row.names)
            if (!name.empty()) names.push_back(name);
    const std::string nearest = nearestName(word, names);
    for (const std::string_view name : names)
        if (name == nearest) return name;
    return {};
}

std::span<const TextureFormat> textureFormats() {
    return kFormats;
}

}  // namespace glibra::glib
