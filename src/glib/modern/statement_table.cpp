#include "glib/modern/statement_table.h"

#include <algorithm>
#include <array>
#include <vector>

#include "base/suggest.h"
#include "glib/command_table.h"
#include "glib/text.h"

namespace glibra::glib {
namespace {

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
    {"tolerance", "{within tolerance:number | of target:object}"},
};

constexpr StatementRow kStatementRows[] = {
    // Variables and structure
    {.id = CommandId::let,
     .name = "Let",
     .syntax = "name:array value:constant",
     .summary = "a variable: a slider, a choice, a number, a list or an expression",
     .standing = Standing::declaration,
     .declaresName = true},
    {.id = CommandId::bound,
     .name = "Bound",
     .syntax = "name:name value:constant",
     .summary = "a slider from the cheapest to the finest value, among which --max-error chooses",
     .standing = Standing::declaration,
     .declaresName = true},
    {.id = CommandId::set,
     .name = "Set",
     .syntax = "pairs+",
     .summary = "uniform variables of the following draws of the scope"},
    {.id = CommandId::material,
     .name = "Material",
     .syntax = "({ambient color:components | diffuse color:components | specular color:components | emission "
               "color:components | shininess exponent:number}+ | preset:word | preset:expression)",
     .summary = "sets material.*, gl_FrontMaterial and gl_BackMaterial, by a preset or value by value"},
    {.id = CommandId::light,
     .name = "Light",
     .syntax =
         "(ambient color:components | number:number {position place:number+4 | ambient color:components "
         "| diffuse color:components | specular color:components | spot direction:number*3 | cutoff "
         "angle:number | exponent value:number | attenuation factors:number*3}+)",
     .summary = "sets gl_LightSource[number]; without a number gl_LightModel.ambient"},
    {.id = CommandId::group,
     .name = "Group",
     .syntax = "[name:name pairs]",
     .summary = "statements that Draw repeats; without a name a scope in place",
     .role = BlockRole::opens,
     .standing = Standing::anywhere},
    {.id = CommandId::endGroup,
     .name = "EndGroup",
     .summary = "ends a Group",
     .role = BlockRole::closes,
     .opener = CommandId::group},
    {.id = CommandId::draw,
     .name = "Draw",
     .syntax = "group:name pairs",
     .summary = "runs the statements of a group",
     .restartsSimulation = false},
    {.id = CommandId::repeat,
     .name = "Repeat",
     .syntax = "(count:number | words:words) [as counter:name]",
     .summary = "runs statements several times, or once per word",
     .role = BlockRole::opens},
    {.id = CommandId::endRepeat,
     .name = "EndRepeat",
     .summary = "ends a Repeat",
     .role = BlockRole::closes,
     .opener = CommandId::repeat},
    {.id = CommandId::when,
     .name = "When",
     .syntax = "condition:number",
     .summary = "runs statements if the condition holds",
     .role = BlockRole::opens},
    {.id = CommandId::elseBranch,
     .name = "Else",
     .summary = "the statements for a When that does not hold",
     .role = BlockRole::divides,
     .opener = CommandId::when},
    {.id = CommandId::endWhen,
     .name = "EndWhen",
     .summary = "ends a When",
     .role = BlockRole::closes,
     .opener = CommandId::when},
    {.id = CommandId::include,
     .name = "Include",
     .syntax = "file:file pairs",
     .summary = "the statements of another scene file, with values for its variables"},
    {.id = CommandId::vertex,
     .name = "Vertex",
     .syntax = "inline",
     .summary = "a vertex shader in the script, up to EndVertex",
     .standing = Standing::declaration,
     .takesBody = true},
    {.id = CommandId::tessControl,
     .name = "TessControl",
     .syntax = "inline",
     .summary = "a tessellation control shader in the script, up to EndTessControl",
     .standing = Standing::declaration,
     .takesBody = true},
    {.id = CommandId::tessEvaluation,
     .name = "TessEvaluation",
     .syntax = "inline",
     .summary = "a tessellation evaluation shader in the script, up to EndTessEvaluation",
     .standing = Standing::declaration,
     .takesBody = true},
    {.id = CommandId::geometry,
     .name = "Geometry",
     .syntax = "inline",
     .summary = "a geometry shader in the script, up to EndGeometry",
     .standing = Standing::declaration,
     .takesBody = true},
    {.id = CommandId::fragment,
     .name = "Fragment",
     .syntax = "inline",
     .summary = "a fragment shader in the script, up to EndFragment",
     .standing = Standing::declaration,
     .takesBody = true},
    {.id = CommandId::glslText,
     .name = "Glsl",
     .syntax = "name:name inline",
     .summary = "GLSL in the script that shaders of the scene include by this name, up to EndGlsl",
     .standing = Standing::declaration,
     .takesBody = true},
    {.id = CommandId::program,
     .name = "Program",
     .syntax = "name:program pairs",
     .summary = "a program whose tags are expressions or name textures, buffers and variables",
     .standing = Standing::declaration},
    {.id = CommandId::use,
     .name = "Use",
     .syntax = "program:program",
     .summary = "makes an earlier program current"},
    {.id = CommandId::key,
     .name = "Key",
     .syntax = "key:key (restart | held variable:name value:any | variable:name values:any...)",
     .summary = "a key of the keyboard that sets, cycles or moves a variable, or restarts",
     .standing = Standing::declaration,
     .restartsSimulation = false},
    {.id = CommandId::multMatrix,
     .name = "MultMatrix",
     .syntax = "matrix:expression",
     .summary = "multiplies the current matrix by a 4 x 4 matrix"},
    {.id = CommandId::fps,
     .name = "Fps",
     .syntax = "rate:number",
     .summary = "frames per second, for the number of the frame",
     .standing = Standing::declaration},
    // Cameras
    {.id = CommandId::camera,
     .name = "Camera",
     .syntax = "name:array (LookAt view:number*9 $lens | At place:number*3 Axes axes:number*9 $lens | "
               "Reflect camera:object plane:number*4 [clip] | Shift camera:object offset:number*3 | "
               "Face face:number place:number*3 range:number*2 | view:expression projection:expression)",
     .summary = "a view and a projection with a name",
     .declaresName = true},
    // Textures and targets
    {.id = CommandId::namedTexture1D,
     .name = "Texture1D",
     .syntax = "name:name (size:number format:word | file:file) $options",
     .summary = "a 1D texture with a name",
     .standing = Standing::declaration,
     .declaresName = true},
    {.id = CommandId::namedTexture2D,
     .name = "Texture2D",
     .syntax = "name:name (size:number*2 format:word | file:file) $options",
     .summary = "a 2D texture with a name",
     .standing = Standing::declaration,
     .declaresName = true},
    {.id = CommandId::namedTexture3D,
     .name = "Texture3D",
     .syntax = "name:name (size:number*3 format:word | files:file...) $options",
     .summary = "a 3D texture with a name, from one raw texture or from pictures, one per slice",
     .standing = Standing::declaration,
     .declaresName = true},
    {.id = CommandId::textureArray1D,
     .name = "Texture1DArray",
     .syntax = "name:name (size:number*2 format:word | files:file...) $options",
     .summary = "layers of 1D textures with a name, empty or from the bottom rows of pictures",
     .standing = Standing::declaration,
     .declaresName = true},
    {.id = CommandId::textureArray,
     .name = "Texture2DArray",
     .syntax = "name:name (size:number*3 format:word | files:file...) $options",
     .summary = "layers of 2D textures with a name, empty or from pictures",
     .standing = Standing::declaration,
     .declaresName = true},
    {.id = CommandId::textureRect,
     .name = "TextureRect",
     .syntax = "name:name (size:number*2 format:word | file:file) $options",
     .summary = "a 2D texture with a name that shaders read by texel coordinates",
     .standing = Standing::declaration,
     .declaresName = true},
    {.id = CommandId::namedCubeMap,
     .name = "CubeMap",
     .syntax = "name:name (size:number format:word [layers count:number] | faces:file*6 | picture:file) "
               "$options",
     .summary = "a cube map with a name, from six files, a panorama, a cross, or empty; several as layers",
     .standing = Standing::declaration,
     .declaresName = true},
    {.id = CommandId::sampler,
     .name = "Sampler",
     .syntax = "name:name {$sampling}+",
     .summary = "filters and wrap modes with a name, for texture.name",
     .standing = Standing::declaration,
     .declaresName = true},
    {.id = CommandId::pass,
     .name = "Pass",
     .syntax =
         "targets:object... {from camera:object | (clear [color:color]... {depth value:number | stencil "
         "value:number | keep part:color,depth,stencil...} | keep [part:color,depth,stencil]...)}",
     .summary = "draws into the window or into parts of textures",
     .role = BlockRole::opens,
     .standing = Standing::notInPass,
     .restartsSimulation = false},
    {.id = CommandId::endPass,
     .name = "EndPass",
     .summary = "ends a Pass",
     .role = BlockRole::closes,
     .opener = CommandId::pass,
     .restartsSimulation = false},
    {.id = CommandId::fill,
     .name = "Fill",
     .syntax = "targets:object... with program:program pairs",
     .summary = "fills targets with one full-screen triangle",
     .standing = Standing::notInPass,
     .restartsSimulation = false},
    {.id = CommandId::clearParts,
     .name = "Clear",
     .syntax = "(part:color,depth,stencil... | object:object)",
     .summary = "clears parts of the current target, or a texture or buffer",
     .restartsSimulation = false},
    {.id = CommandId::viewport,
     .name = "Viewport",
     .syntax = "area:number*4",
     .summary = "where the picture goes, in fractions of the target: x y width height",
     .restartsSimulation = false},
    {.id = CommandId::scissor,
     .name = "Scissor",
     .syntax = "area:number*4",
     .summary = "the only pixels that change, in fractions of the target: x y width height",
     .restartsSimulation = false},
    // State and draws
    {.id = CommandId::state,
     .name = "State",
     .syntax =
         "(default | {cull faces:off,back,front,both | front winding:ccw,cw | polygon "
         "mode:fill,line,point | offset values:number*2 | depth test:off,$compare | depthwrite "
         "on:$switch | depthrange range:number*2 | depthclamp on:$switch | blend.# $blending | "
         "blendcolor color:number*4 | stencil.front,back test:$compare reference:number [mask:number] | "
         "stencilop.front,back fail:$operation depthfail:$operation pass:$operation | "
         "stencilwrite.front,back mask:number | (mark value:number | where value:number) | write.# "
         "components:$mask | provoking vertex:first,last | samples on:$switch | alphatocoverage "
         "on:$switch | discard on:$switch}+)",
     .summary = "how fragments are tested, blended and written, until the scope ends",
     .restartsSimulation = false},
    {.id = CommandId::instances,
     .name = "Instances",
     .syntax = "(from buffer:object [at word:number] | count:number)",
     .summary = "how often each following shape is drawn"},
    {.id = CommandId::vertices,
     .name = "Vertices",
     .syntax = "topology:$topology (indices index:object | (from buffer:object [at word:number] | "
               "count:number) [indices index:object])",
     .summary = "draws vertices without data of their own, in order or by indices",
     .restartsSimulation = false},
    {.id = CommandId::attribute,
     .name = "Attribute",
     .syntax = "name:name (as role:word | values:number+4 | buffer:object {per instance | "
               "offset bytes:number | stride bytes:number})",
     .summary = "a vertex input: values, a role, or a buffer"},
    {.id = CommandId::tessLevels,
     .name = "TessLevels",
     .syntax = "levels:number*6",
     .summary = "four outer and two inner levels for programs without a control stage"},
    // Buffers and compute
    {.id = CommandId::buffer,
     .name = "Buffer",
     .syntax = "name:name ([type:word] size:number [values:list | value:expression | file:file] | type:word "
               "(values:list | file:file)) [history]",
     .summary = "a buffer with a name",
     .standing = Standing::declaration,
     .declaresName = true},
    {.id = CommandId::mesh,
     .name = "Mesh",
     .syntax = "name:name shape:word (sizes:number... | [file:file])",
     .summary = "the vertices and indices of a shape as buffers, NAME.position and so on",
     .standing = Standing::declaration,
     .declaresName = true},
    {.id = CommandId::compute,
     .name = "Compute",
     .syntax = "(inline | file:file)",
     .summary = "the compute shader of the next Program; in the script up to EndCompute",
     .standing = Standing::declaration,
     .takesBody = true},
    {.id = CommandId::dispatch,
     .name = "Dispatch",
     .syntax =
         "program:program (over (size:number+3 | object:object) | from buffer:object [at word:number] | "
         "groups:number+3) [tiles count:number] [discard] pairs",
     .summary = "runs a compute program",
     .restartsSimulation = false},
    {.id = CommandId::once,
     .name = "Once",
     .summary = "statements that run at the start, and when a variable that they read changes",
     .role = BlockRole::opens,
     .standing = Standing::outermost},
    {.id = CommandId::endOnce,
     .name = "EndOnce",
     .summary = "ends a Once",
     .role = BlockRole::closes,
     .opener = CommandId::once},
    {.id = CommandId::step,
     .name = "Step",
     .syntax = "rate:number [reset values:any...]",
     .summary = "statements that run `rate` times per second of scene time, anew when the values change",
     .role = BlockRole::opens,
     .standing = Standing::outermost},
    {.id = CommandId::endStep,
     .name = "EndStep",
     .summary = "ends a Step",
     .role = BlockRole::closes,
     .opener = CommandId::step},
    // Checks
    {.id = CommandId::expect,
     .name = "Expect",
     .syntax = "(pixel place:number*2 color:components $tolerance | mean area:number*4 color:components "
               "$tolerance | count color:components number:number+2 $tolerance | buffer name:object (at "
               "index:number values:list | values:list) $within | range name:object bounds:number*2 | sum "
               "name:object (values:list | total:number) $within | "
               "same a:object b:object $within | different a:object b:object $within | finite name:object | "
               "primitives count:number $within | samples count:number $within | error id:word | "
               "condition:expression) [at "
               "seconds:number]",
     .summary = "a check of the picture, a buffer, a count or a condition",
     .restartsSimulation = false},
    {.id = CommandId::print,
     .name = "Print",
     .syntax = "buffer:object [range:number+2]",
     .summary = "reports elements of a buffer",
     .restartsSimulation = false},
};

/// The rows whose words begin with a letter, for a quick answer to words that are none.
const StatementRow* rowOf(std::string_view word) {
    static const auto kByFirstLetter = [] {
        std::array<std::vector<const StatementRow*>, 26> lists;
        for (const StatementRow& row : kStatementRows)
            lists.at(static_cast<std::size_t>(lower(row.name[0]) - 'a')).push_back(&row);
        return lists;
    }();
    if (word.empty() || !isLetter(word[0])) return nullptr;
    for (const StatementRow* row : kByFirstLetter.at(static_cast<std::size_t>(lower(word[0]) - 'a')))
        if (sameWord(row->name, word)) return row;
    return nullptr;
}

}  // namespace

bool StatementRow::sharesWord() const {
    return findCommand(name) != nullptr;
}

std::span<const StatementRow> statementTable() {
    return kStatementRows;
}

const StatementRow* findStatement(std::string_view word) {
    const StatementRow* row = rowOf(word);
    return row != nullptr && !row->sharesWord() ? row : nullptr;
}

const StatementRow* modernFormOf(std::string_view word) {
    const StatementRow* row = rowOf(word);
    return row != nullptr && row->sharesWord() ? row : nullptr;
}

const StatementRow* statementOf(CommandId id) {
    for (const StatementRow& row : kStatementRows)
        if (row.id == id) return &row;
    return nullptr;
}

bool restartsSimulation(CommandId id) {
    const auto classic = std::ranges::find(commandTable(), id, &CommandRow::id);
    if (classic != commandTable().end()) return classic->restartsSimulation;
    const StatementRow* statement = statementOf(id);
    return statement == nullptr || statement->restartsSimulation;
}

std::string_view nameOf(CommandId id) {
    for (const CommandRow& row : commandTable())
        if (row.id == id) return row.name();
    const StatementRow* statement = statementOf(id);
    return statement != nullptr ? statement->name : std::string_view();
}

std::string_view nearestCommand(std::string_view word) {
    std::vector<std::string_view> names;
    for (const CommandRow& row : commandTable())
        for (const std::string_view name : row.names)
            if (!name.empty()) names.push_back(name);
    for (const StatementRow& row : statementTable())
        if (!row.sharesWord()) names.push_back(row.name);
    const auto nearest = std::ranges::find(names, base::nearestName(word, names));
    return nearest != names.end() ? *nearest : std::string_view();
}

std::string_view syntaxFragment(std::string_view name) {
    if (name == "topology") {
        static const std::string kTopologies = [] {
            std::string all;
            for (const std::string_view each : findCommand("glBegin")->words)
                all.append(all.empty() ? "" : ",").append(each);
            return all;
        }();
        return kTopologies;
    }
    for (const Fragment& each : kFragments)
        if (each.name == name) return each.text;
    return {};
}

std::vector<std::string_view> wordsOfFragment(std::string_view name) {
    std::vector<std::string_view> words;
    std::string_view text = syntaxFragment(name);
    while (!text.empty()) {
        const std::size_t comma = std::min(text.find(','), text.size());
        words.push_back(text.substr(0, comma));
        text.remove_prefix(std::min(comma + 1, text.size()));
    }
    return words;
}

}  // namespace glibra::glib
