// The rows of all statements, the fragments of their notation, and the rules between the numbers of one
// statement.

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <iterator>
#include <string>
#include <vector>

#include "base/text.h"
#include "geometry/list_mesh.h"
#include "geometry/shapes/primitive.h"
#include "glib/messages.h"
#include "glib/number.h"
#include "glib/script.h"
#include "glib/statement_table.h"

namespace glibra::glib {
namespace {

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

// ---- What rows have in common.

using Id = CommandId;

/// A statement that acts on the frame alone.
constexpr StatementRow ofFrame(StatementRow row) {
    row.restartsSimulation = false;
    return row;
}
constexpr StatementRow placed(Standing standing, StatementRow row) {
    row.standing = standing;
    return row;
}
/// A statement that declares a name.
constexpr StatementRow object(StatementRow row, Standing standing = Standing::declaration) {
    row.declaresName = true;
    return placed(standing, row);
}
/// GLSL in the script.
constexpr StatementRow shader(StatementRow row) {
    row.takesBody = true;
    return placed(Standing::declaration, row);
}
constexpr StatementRow opens(StatementRow row, Standing standing = Standing::anywhere) {
    row.role = BlockRole::opens;
    return placed(standing, row);
}
constexpr StatementRow divides(StatementRow row, CommandId opener) {
    row.role = BlockRole::divides;
    row.opener = opener;
    return row;
}
constexpr StatementRow closes(StatementRow row, CommandId opener) {
    row.role = BlockRole::closes;
    row.opener = opener;
    return row;
}

// ---- Classic statements. The primitives' rows come between the two parts.

constexpr StatementRow kRowsBefore[] = {
    // Window, view, colour (3.1)
    {Id::windowSize, "WindowSize", "width:integer=600/1..16384/pixels height:integer=600/1..16384/pixels",
     "size of the window or image"},
    {Id::perspective, "Perspective", "angle:between=50/0..180/degrees near:number=.1 far:number=1000",
     "symmetric perspective, vertical full angle", "Persp", checkPerspective},
    {Id::ortho,
     "Ortho",
     "left:number=-3 right:number=3 bottom:number=-3 top:number=3 near:number=-1000 far:number=1000",
     "orthographic box, shown whole and undistorted",
     {},
     checkOrtho},
    {Id::lookAt, "LookAt",
     "ex:number ey:number ez:number lx:number ly:number lz:number ux:number uy:number uz:number",
     "replaces ModelView by the view from eye to centre with up"},
    {Id::color, "Color", "r:component g:component~0 b:component~0 a:component=1", "sets the current colour",
     "Colour", nullptr, LoneNumber::grey},
    ofFrame({Id::background,
             "Background",
             "r:component=red g:component=green~0 b:component=blue~0 a:component=1",
             "sets the clear colour",
             {},
             nullptr,
             LoneNumber::firstThree}),
    {Id::clear, "Clear", "", "clears colour and depth of the current target"},
    // Transforms (3.2)
    ofFrame({Id::translate, "Translate", "tx:number~0 ty:number~0 tz:number~0", "moves what follows"}),
    ofFrame({Id::rotate,
             "Rotate",
             "angle:number/degrees ax:number~0 ay:number~0 az:number~0",
             "turns what follows about an axis through the origin",
             {},
             checkRotate}),
    ofFrame({Id::scale,
             "Scale",
             "sx:number sy:number~1 sz:number~1",
             "scales what follows, by one factor or by one per axis",
             {},
             checkScale,
             LoneNumber::firstThree}),
    ofFrame({Id::pushMatrix, "PushMatrix", "", "saves ModelView", "TransformBegin"}),
    ofFrame({Id::popMatrix, "PopMatrix", "", "restores ModelView", "TransformEnd"}),
};
constexpr StatementRow kRowsAfter[] = {
    // Geometry (3.3) that is not a primitive
    ofFrame({Id::obj, "Obj", "[file:file]", "OBJ model as triangles"}),
    ofFrame({Id::wireObj, "WireObj", "[file:file]", "edges of an OBJ model"}),
    ofFrame({Id::objAdj, "ObjAdj", "[file:file]", "OBJ model as triangles with adjacency"}),
    ofFrame({Id::objPatch, "ObjPatch", "[file:file]", "OBJ model as patches of three vertices"}),
    ofFrame({Id::shp, "Shp", "[file:file]", "lines of an ESRI shapefile"}),
    ofFrame(
        {Id::linesAdjacency, "LinesAdjacency", "points:points*4", "lines with adjacency, four points each"}),
    ofFrame({Id::triangles, "Triangles", "points:points*3", "triangles, three points each"}),
    {Id::glBegin, "glBegin", "topology:$topology", "starts a list of vertices"},
    {Id::glVertex, "glVertex", "x:number y:number z:number~0 [w:number]", "a vertex of the list"},
    {Id::glNormal, "glNormal", "x:number y:number z:number", "normal of the following vertices"},
    {Id::glColor, "glColor", "r:number g:number b:number a:number=1", "colour of the following vertices"},
    {Id::glTexCoord, "glTexCoord", "s:number t:number=0 p:number=0 q:number=1",
     "texture coordinates of the following vertices"},
    {Id::glEnd, "glEnd", "", "draws the list"},
    {Id::lineWidth, "LineWidth", "size:positive/0../pixels", "width of lines"},
    {Id::pointSize, "PointSize", "size:positive/0../pixels", "size of points"},
    {Id::pointSizeMode, "PointSizeMode", "mode:integer=1/-2147483648..2147483647",
     "if not 0, the program sets the size of points"},
    {Id::numPatchVertices, "NumPatchVertices", "vertices:integer/1..32", "number of vertices per patch"},
    {Id::flat, "Flat", "", "colours are not interpolated"},
    {Id::smooth, "Smooth", "", "colours are interpolated"},
    // Textures and targets (3.4)
    {Id::texture1D, "Texture1D", "$unit [width:texels/1..side/texels]",
     "1D texture from a file, or an empty one"},
    {Id::texture2D, "Texture2D", "$unit [width:texels/1..side/texels height:texels/1..side/texels]",
     "2D texture from a file, or an empty one"},
    {Id::texture3D, "Texture3D", "$unit $volume", "3D texture from a file, or an empty one"},
    {Id::texture, "Texture", "$unit $volume", "texture whose dimension its file or sizes decide"},
    {Id::cubeMap, "CubeMap", "$unit six_files:file*6",
     "cube map from six square pictures: +x -x +y -y +z -z"},
    {Id::renderToTexture, "RenderToTexture", "$unit...",
     "draws into textures; without units into the window"},
    {Id::clamp, "Clamp", "[on:truth]", "textures are clamped to their edge, or repeat"},
    // Shaders and programs (3.5)
    {Id::vertex, "Vertex", "[file:file]", "current vertex shader"},
    {Id::tessControl, "TessControl", "[file:file]", "current tessellation control shader"},
    {Id::tessEvaluation, "TessEvaluation", "[file:file]", "current tessellation evaluation shader"},
    {Id::geometry, "Geometry", "[file:file]", "current geometry shader"},
    {Id::fragment, "Fragment", "[file:file]", "current fragment shader"},
    {Id::program, "Program", "[name:program] [pairs]",
     "links the current shaders and sets uniform variables"},
    {Id::geometryInput, "GeometryInput",
     "topology:points,lines,lines_adjacency,triangles,triangles_adjacency",
     "input of a geometry shader without layout", "GeometryInputType"},
    {Id::geometryOutput, "GeometryOutput", "topology:points,line_strip,triangle_strip",
     "output of a geometry shader without layout", "GeometryOutputType"},
    {Id::geometryVerticesOut, "GeometryVerticesOut", "[vertices:integer/1..vertices]",
     "largest number of vertices that a geometry shader without layout emits"},
    {Id::gstap, "GSTAP", "", "no effect: its names are always defined", "gstap.h"},
    // Noise, time, messages (3.6)
    {Id::noise2D, "Noise2D", "size:integer=64/4..4096/texels", "size of the 2D noise texture"},
    {Id::noise3D, "Noise3D", "size:integer=64/4..400/texels", "size of the 3D noise texture"},
    {Id::timer, "Timer", "period:positive=10/.001..1000000/seconds", "period of the uniform variable Timer"},
    ofFrame({Id::messageBox, "MessageBox", "[text:line]", "shows a message once"}),
    ofFrame({Id::verbose, "Verbose", "", "prints each command as it is carried out"}),
};

// ---- Primitives.

/// The names of arguments have blanks, which the notation writes as _.
std::string syntaxOfPrimitive(const geometry::PrimitiveSpec& primitive) {
    std::string text;
    for (const geometry::ShapeArgument& each : primitive.arguments) {
        if (each.isFixed) continue;
        static constexpr std::array<const char*, 4> kTypes{"number", "size", "count", "integer"};
        std::string name(each.name);
        std::ranges::replace(name, ' ', '_');
        text += fmt::format("{}{}:{}={}", text.empty() ? "" : " ", name,
                            kTypes.at(static_cast<std::size_t>(each.kind)), numberText(each.byDefault));
        const bool hasLimits =
            each.kind == geometry::ArgumentKind::count || each.kind == geometry::ArgumentKind::seed;
        if (hasLimits) text += fmt::format("/{}..{}", numberText(each.least), numberText(each.most));
    }
    return text;
}

/// All rows. Those of the primitives are made from geometry's.
struct ClassicTable {
    std::vector<std::string> syntax;  ///< of the primitives
    std::vector<StatementRow> rows{std::begin(kRowsBefore), std::end(kRowsBefore)};

    ClassicTable() {
        for (const geometry::PrimitiveSpec* each : geometry::primitives())
            syntax.push_back(syntaxOfPrimitive(*each));
        for (std::size_t i = 0; i < syntax.size(); ++i) {
            const geometry::PrimitiveSpec& primitive = *geometry::primitives()[i];
            rows.push_back(
                {.id = static_cast<CommandId>(static_cast<std::size_t>(CommandId::firstPrimitive) + i),
                 .name = primitive.names[0],
                 .syntax = syntax[i],
                 .summary = primitive.summary,
                 .alias = primitive.names[1],
                 .loneNumber = primitive.oneSizeForAll ? LoneNumber::firstThree : LoneNumber::first,
                 .restartsSimulation = false});
        }
        rows.insert(rows.end(), std::begin(kRowsAfter), std::end(kRowsAfter));
    }
};

// ---- Modern statements.

/// The modern statements, in the order of the specification.
constexpr StatementRow kModernRows[] = {
    // Variables and structure
    object(
        {Id::let, "Let", "name:array value:constant",
         "a variable: a slider, a choice, a number, a list or an expression; name(x) (...) is a function"}),
    object({Id::bound, "Bound", "name:name value:constant",
            "a slider from the cheapest to the finest value, among which --max-error chooses"}),
    {Id::set, "Set", "pairs+", "uniform variables of the following draws of the scope"},
    {Id::material, "Material",
     "({ambient color:components | diffuse color:components | specular color:components | emission "
     "color:components | shininess exponent:number}+ | preset:word | preset:expression)",
     "sets material.*, gl_FrontMaterial and gl_BackMaterial, by a preset or value by value"},
    {Id::light, "Light",
     "(ambient color:components | number:number {position place:number+4 | ambient color:components | "
     "diffuse color:components | specular color:components | spot direction:number*3 | cutoff angle:number | "
     "exponent value:number | attenuation factors:number*3}+)",
     "sets gl_LightSource[number]; without a number gl_LightModel.ambient"},
    opens({Id::group, "Group", "[name:name pairs]",
           "statements that Draw repeats; without a name a scope in place"}),
    closes({Id::endGroup, "EndGroup", "", "ends a Group"}, Id::group),
    ofFrame({Id::draw, "Draw", "group:name pairs", "runs the statements of a group"}),
    opens({Id::repeat, "Repeat",
           "(count:number | words:words) {until condition:expression | as counter:name}",
           "runs statements several times, or once per word"}),
    closes({Id::endRepeat, "EndRepeat", "", "ends a Repeat"}, Id::repeat),
    opens({Id::when, "When", "condition:number", "runs statements if the condition holds"}),
    divides({Id::elseBranch, "Else", "", "the statements for a When that does not hold"}, Id::when),
    closes({Id::endWhen, "EndWhen", "", "ends a When"}, Id::when),
    {Id::include, "Include", "file:file pairs",
     "the statements of another scene file, with values for its variables"},
    shader({Id::vertex, "Vertex", "inline", "a vertex shader in the script, up to EndVertex"}),
    shader({Id::tessControl, "TessControl", "inline",
            "a tessellation control shader in the script, up to EndTessControl"}),
    shader({Id::tessEvaluation, "TessEvaluation", "inline",
            "a tessellation evaluation shader in the script, up to EndTessEvaluation"}),
    shader({Id::geometry, "Geometry", "inline", "a geometry shader in the script, up to EndGeometry"}),
    shader({Id::fragment, "Fragment", "inline", "a fragment shader in the script, up to EndFragment"}),
    shader({Id::glslText, "Glsl", "name:name inline",
            "GLSL in the script that shaders of the scene include by this name, up to EndGlsl"}),
    placed(
        Standing::declaration,
        {Id::program, "Program",
         "name:program [const [type:int,uint,float,bool,vec2,vec3,vec4,ivec2,ivec3,ivec4,uvec2,uvec3,uvec4,"
         "mat2,mat3,mat4] name:name value:any | pairs]...",
         "a program whose tags are expressions or name textures, buffers and variables; const: a constant "
         "of its shaders"}),
    {Id::use, "Use", "program:program", "makes an earlier program current"},
    ofFrame(placed(
        Standing::declaration,
        {Id::key, "Key", "key:key (restart | held variable:name value:any | variable:name values:any...)",
         "a key of the keyboard that sets, cycles or moves a variable, or restarts"})),
    {Id::multMatrix, "MultMatrix", "matrix:expression", "multiplies the current matrix by a 4 x 4 matrix"},
    placed(Standing::declaration,
           {Id::fps, "Fps", "rate:number", "frames per second, for the number of the frame"}),
    // Cameras
    object({Id::camera, "Camera",
            "name:array (LookAt view:number*9 $lens | At place:number*3 Axes axes:number*9 $lens | Reflect "
            "camera:object plane:number*4 [clip] | Shift camera:object offset:number*3 | Face face:number "
            "place:number*3 range:number*2 | view:expression projection:expression)",
            "a view and a projection with a name"},
           Standing::anywhere),
    // Textures and targets
    object({Id::namedTexture1D, "Texture1D", "name:name (size:number format:word | file:file) $options",
            "a 1D texture with a name"}),
    object({Id::namedTexture2D, "Texture2D", "name:name (size:number*2 format:word | file:file) $options",
            "a 2D texture with a name"}),
    object({Id::namedTexture3D, "Texture3D", "name:name (size:number*3 format:word | files:file...) $options",
            "a 3D texture with a name, from one raw texture or from pictures, one per slice"}),
    object({Id::textureArray1D, "Texture1DArray",
            "name:name (size:number*2 format:word | files:file...) $options",
            "layers of 1D textures with a name, empty or from the bottom rows of pictures"}),
    object({Id::textureArray, "Texture2DArray",
            "name:name (size:number*3 format:word | files:file...) $options",
            "layers of 2D textures with a name, empty or from pictures"}),
    object({Id::textureRect, "TextureRect", "name:name (size:number*2 format:word | file:file) $options",
            "a 2D texture with a name that shaders read by texel coordinates"}),
    object(
        {Id::namedCubeMap, "CubeMap",
         "name:name (size:number format:word [layers count:number] | faces:file*6 | picture:file) $options",
         "a cube map with a name, from six files, a panorama, a cross, or empty; several as layers"}),
    object({Id::sampler, "Sampler", "name:name {$sampling}+",
            "filters and wrap modes with a name, for texture.name"}),
    ofFrame(opens({Id::pass, "Pass",
                   "targets:object... {from camera:object | reversed | (clear [color:color]... {depth "
                   "value:number | stencil "
                   "value:number | keep part:color,depth,stencil...} | keep [part:color,depth,stencil]...)}",
                   "draws into the window or into parts of textures"},
                  Standing::notInPass)),
    ofFrame(closes({Id::endPass, "EndPass", "", "ends a Pass"}, Id::pass)),
    ofFrame(placed(Standing::notInPass, {Id::fill, "Fill", "targets:object... with program:program pairs",
                                         "fills targets with one full-screen triangle"})),
    ofFrame({Id::clearParts, "Clear", "(part:color,depth,stencil... | object:object)",
             "clears parts of the current target, or a texture or buffer"}),
    ofFrame({Id::viewport, "Viewport", "area:number*4",
             "where the picture goes, in fractions of the target: x y width height"}),
    ofFrame({Id::scissor, "Scissor", "area:number*4",
             "the only pixels that change, in fractions of the target: x y width height"}),
    // State and draws
    ofFrame(
        {Id::state, "State",
         "(default | {cull faces:off,back,front,both | front winding:ccw,cw | polygon mode:fill,line,point | "
         "offset values:number*2 | depth test:off,$compare | depthwrite on:$switch | depthrange "
         "range:number*2 | depthclamp on:$switch | blend.# $blending | blendcolor color:number*4 | "
         "stencil.front,back test:$compare reference:number [mask:number] | stencilop.front,back "
         "fail:$operation depthfail:$operation pass:$operation | stencilwrite.front,back mask:number | (mark "
         "value:number | where value:number) | write.# components:$mask | provoking vertex:first,last | "
         "samples on:$switch | alphatocoverage on:$switch | discard on:$switch}+)",
         "how fragments are tested, blended and written, until the scope ends"}),
    {Id::instances, "Instances", "(from buffer:object [at word:number] | count:number)",
     "how often each following shape is drawn"},
    ofFrame({Id::vertices, "Vertices",
             "topology:$topology (indices index:object | (from buffer:object [at word:number] | "
             "count:number) [indices index:object])",
             "draws vertices without data of their own, in order or by indices"}),
    {Id::attribute, "Attribute",
     "name:name (as role:word | values:number+4 | buffer:object {per instance | offset bytes:number | stride "
     "bytes:number})",
     "a vertex input: values, a role, or a buffer"},
    {Id::tessLevels, "TessLevels", "levels:number*6",
     "four outer and two inner levels for programs without a control stage"},
    // Buffers and compute
    object({Id::buffer, "Buffer",
            "name:name ([type:word] size:number [values:list | value:expression | file:file] | type:word "
            "(values:list | file:file)) [history]",
            "a buffer with a name"}),
    object({Id::mesh, "Mesh", "name:name shape:word (sizes:number... | [file:file])",
            "the vertices and indices of a shape as buffers, NAME.position and so on"}),
    shader({Id::compute, "Compute", "(inline | file:file)",
            "the compute shader of the next Program; in the script up to EndCompute"}),
    ofFrame({Id::dispatch, "Dispatch",
             "program:program (over (size:number+3 | object:object) | from buffer:object [at word:number] | "
             "groups:number+3) [tiles count:number] [discard] pairs",
             "runs a compute program"}),
    opens({Id::once, "Once", "",
           "statements that run at the start, and when a variable that they read changes"},
          Standing::outermost),
    closes({Id::endOnce, "EndOnce", "", "ends a Once"}, Id::once),
    opens({Id::step, "Step", "rate:number [reset values:any...]",
           "statements that run `rate` times per second of scene time, anew when the values change"},
          Standing::outermost),
    closes({Id::endStep, "EndStep", "", "ends a Step"}, Id::step),
    // Checks
    ofFrame(
        {Id::expect, "Expect",
         "(pixel place:number*2 color:components $tolerance | mean area:number*4 color:components "
         "$tolerance | count color:components number:number+2 $parts | buffer name:object (at "
         "index:number values:list | values:list) $within | range name:object bounds:number*2 $area | sum "
         "name:object (values:list | total:number) $near | same a:object b:object $near | different "
         "a:object b:object $near | finite name:object $area | primitives count:number $within | samples "
         "count:number $within | error id:word | condition:expression) [at seconds:number]",
         "a check of the picture, a buffer, a count or a condition"}),
    ofFrame({Id::print, "Print", "(value:expression | object:object (in area:number+4 | [range:number+2]))",
             "reports a value, elements of a buffer, or texels"}),
};

// ---- Fragments.

struct Fragment {
    std::string_view name;
    std::string_view text;
};

/// The words are GL's, in lower case and without their prefix.
constexpr Fragment kFragments[] = {
    {"compare", "never,less,lequal,equal,gequal,greater,notequal,always"},
    {"factor",
     "zero,one,src_color,one_minus_src_color,dst_color,one_minus_dst_color,src_alpha,one_minus_src_alpha,"
     "dst_alpha,one_minus_dst_alpha,constant_color,one_minus_constant_color,constant_alpha,"
     "one_minus_constant_alpha,src_alpha_saturate"},
    {"equation", "add,subtract,reverse_subtract,min,max"},
    {"operation", "keep,zero,replace,incr,incr_wrap,decr,decr_wrap,invert"},
    {"mask", "none,r,g,b,a,rg,rb,ra,gb,ga,ba,rgb,rga,rba,gba,rgba"},
    {"switch", "on,off"},
    {"lens", "(Perspective lens:number*3 [aspect ratio:number] | Ortho box:number*6 | Frustum box:number*6)"},
    {"filter",
     "(nearest | linear | mipmap | nearest_mipmap_nearest | linear_mipmap_nearest | nearest_mipmap_linear | "
     "linear_mipmap_linear)"},
    {"wrap", "(repeat | mirror | clamp | border [color:components])..."},
    {"sampling", "$filter | aniso limit:number | compare test:$compare | $wrap"},
    {"options",
     "{$sampling | flip | srgb | samples count:number | levels count:number | generate | history}"},
    {"blending",
     "(source:$factor destination:$factor [equation:$equation] [alpha source:$factor destination:$factor "
     "[equation:$equation]] | mode:off,alpha,add,multiply,premultiplied)"},
    {"within", "{within tolerance:number}"},
    {"unit", "unit:unit/0..unit"},
    {"volume",
     "[width:texels/1..volume/texels height:texels/1..volume/texels depth:texels/1..volume/texels]"},
    {"tolerance", "{within tolerance:number | of target:object}"},
    {"area", "[in area:number+4]"},
    {"near", "{within tolerance:number | in area:number+4}"},
    {"parts", "{within tolerance:number | of target:object | in area:number+4}"},
};

constexpr TextureFormat kFormats[] = {{"RGBA8", 4}, {"RGBA16F", 8}, {"RGBA32F", 16}, {"R32F", 4}};

}  // namespace

std::span<const StatementRow> commandTable() {
    static const ClassicTable kTable;
    return kTable.rows;
}

std::span<const StatementRow> statementTable() {
    return kModernRows;
}

std::string_view syntaxFragment(std::string_view name) {
    if (name == "topology") {
        static const auto kTopologies = fmt::format("{}", fmt::join(geometry::kListTopologyWords, ","));
        return kTopologies;
    }
    for (const Fragment& each : kFragments)
        if (each.name == name) return each.text;
    return {};
}

std::span<const TextureFormat> textureFormats() {
    return kFormats;
}

}  // namespace glibra::glib
