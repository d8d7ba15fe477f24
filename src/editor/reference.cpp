#include "editor/reference.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <utility>

#include "base/suggest.h"
#include "editor/declared_names.h"
#include "expression/functions.h"
#include "expression/known_names.h"
#include "glib/command_table.h"
#include "glib/modern/statement_table.h"
#include "glsl/read/words.h"
#include "scene/shader_names.h"

namespace glibra::editor {
namespace {

/// "Sphere radius = 1, slices = 60, stacks = 60".
std::string usageOf(const glib::CommandRow& row) {
    std::string text(row.name());
    for (const glib::Argument& each : row.arguments) {
        text += each.name == row.arguments.front().name ? " " : ", ";
        const bool mayMiss = each.optional || each.byDefault || each.filler;
        text += mayMiss ? fmt::format("[{}", each.name) : std::string(each.name);
        if (each.byDefault || each.filler)
            text += fmt::format(" = {:g}", each.byDefault ? *each.byDefault : *each.filler);
        if (mayMiss) text += "]";
        if (!each.unit.empty()) text += fmt::format(" ({})", each.unit);
    }
    if (!row.words.empty()) text += fmt::format(" {}", fmt::join(row.words, " | "));
    return text;
}

void addTo(ReferenceEntry& entry, std::string_view sentence) {
    if (sentence.empty()) return;
    if (!entry.text.empty()) entry.text += "\n";
    entry.text += sentence;
}

ReferenceEntry glibEntry(std::string_view word) {
    ReferenceEntry entry;
    const glib::CommandRow* command = glib::findCommand(word);
    const glib::StatementRow* statement = command ? glib::modernFormOf(word) : glib::findStatement(word);
    if (command) {
        entry.word = command->name();
        entry.code.push_back(usageOf(*command));
        addTo(entry, command->summary);
        entry.chapter = "docs/language.md, section 3";
    }
    if (statement) {
        entry.word = statement->name;
        entry.code.push_back(glib::usage(*statement));
        for (const glib::WordList& each : glib::wordLists(*statement))
            entry.code.push_back(fmt::format("{}: {}", each.name, fmt::join(each.words, " ")));
        addTo(entry, statement->summary);
        entry.chapter = "docs/language.md, section 12";
    }
    if (!entry.word.empty()) return entry;
    for (const expression::FunctionRow& each : expression::functionsNamed(word)) {
        entry.word = word;
        entry.code.emplace_back(each.prototype);
        addTo(entry, each.summary);
        entry.chapter = "docs/language.md, section 1.8";
    }
    for (const expression::NameRow& each : expression::sceneNames())
        if (each.path == word) {
            entry.word = word;
            entry.code.push_back(fmt::format("{} {}", expression::name(each.type), each.path));
            addTo(entry, each.summary);
            entry.chapter = "docs/language.md, section 1.8";
        }
    return entry;
}

ReferenceEntry glslEntry(std::string_view word) {
    ReferenceEntry entry;
    for (const scene::ShaderName& each : scene::shaderNames()) {
        if (std::ranges::find(each.names, word) == each.names.end()) continue;
        entry.word = word;
        entry.code.push_back(fmt::format("{} {} {}", each.isInput ? "in" : "uniform", each.type, word));
        addTo(entry, each.meaning + "; glibra supplies it, it needs no declaration");
        entry.chapter = "docs/language.md, section 6";
    }
    if (!entry.word.empty()) return entry;
    if (const GlslRow* row = findGlsl(word)) {
        entry.word = word;
        entry.code.emplace_back(row->signature);
        entry.text = row->summary;
        entry.chapter = fmt::format("GLSL, from version {}", row->since);
        if (row->until < 1000) entry.chapter += fmt::format(" to before {}", row->until);
    } else if (const int since = glsl::keywordSince(word); since > 0 && since != glsl::kReserved) {
        entry.word = word;
        entry.text = glsl::isTypeWord(word) ? "a type of GLSL" : "a keyword of GLSL";
        entry.chapter = fmt::format("GLSL, from version {}", since);
    }
    return entry;
}

std::string nearest(std::string_view word, CodeLanguage language) {
    std::vector<std::string_view> known;
    const std::vector<scene::ShaderName> names = scene::shaderNames();
    if (language == CodeLanguage::glsl) {
        for (const GlslRow& each : glslTable()) known.push_back(each.name);
        for (const scene::ShaderName& each : names)
            known.insert(known.end(), each.names.begin(), each.names.end());
    } else if (const std::string_view command = glib::nearestCommand(word); !command.empty()) {
        known.push_back(command);
    }
    return base::suggestion(word, known);
}

}  // namespace

ReferenceEntry referenceOf(std::string_view word, CodeLanguage language, const CodeContext& context) {
    ReferenceEntry entry = language == CodeLanguage::glib ? glibEntry(word) : glslEntry(word);
    for (const KnownName& each : context.names) {
        if (each.name != word || each.in != language) continue;
        if (entry.word.empty()) {
            entry.word = each.name;
            entry.code.push_back(fmt::format("{} {}", each.type, each.name));
            entry.text = each.what;
        }
        if (entry.value.empty()) entry.value = each.value;
    }
    if (entry.word.empty() && !word.empty())
        entry.text = fmt::format("there is no entry for '{}'{}", word, nearest(word, language));
    return entry;
}

ReferenceEntry referenceAt(std::string_view text, std::size_t byte, const CodeContext& context) {
    const TextRange range = wordAt(text, byte);
    const std::string_view word = text.substr(range.begin, range.end - range.begin);
    const LanguageAt at = languageAt(text, byte, context);
    ReferenceEntry entry = referenceOf(word, at.language, context);
    if (at.language == CodeLanguage::glib || word.empty()) return entry;
    const std::string_view part = text.substr(at.part.begin, at.part.end - at.part.begin);
    const auto line =
        1 + std::count(text.begin(), text.begin() + static_cast<std::ptrdiff_t>(range.begin), '\n');
    const auto firstLine =
        std::count(text.begin(), text.begin() + static_cast<std::ptrdiff_t>(at.part.begin), '\n');
    // The last declaration up to the line; without one the first after it.
    std::vector<DeclaredName> all = declaredNames(part);
    std::erase_if(all, [&](const DeclaredName& each) { return each.name != word; });
    if (all.empty()) return entry;
    const DeclaredName* declared = &all.front();
    for (const DeclaredName& each : all)
        if (each.line + firstLine <= line) declared = &each;
    entry.word = word;
    entry.code = {declared->declaration};
    entry.text = fmt::format("declared in line {}", declared->line + firstLine);
    entry.chapter.clear();
    return entry;
}

// ---- The functions and built-in variables of GLSL (The OpenGL Shading Language 4.50, chapters 7 and 8).

namespace {

constexpr auto kRows = std::to_array<GlslRow>({
    // Angles and trigonometry
    {"radians", "T radians(T degrees)", "degrees in radians"},
    {"degrees", "T degrees(T radians)", "radians in degrees"},
    {"sin", "T sin(T angle)", "the sine of an angle in radians"},
    {"cos", "T cos(T angle)", "the cosine of an angle in radians"},
    {"tan", "T tan(T angle)", "the tangent of an angle in radians"},
    {"asin", "T asin(T x)", "the angle from -pi/2 to pi/2 whose sine is x"},
    {"acos", "T acos(T x)", "the angle from 0 to pi whose cosine is x"},
    {"atan", "T atan(T y, T x)   T atan(T y_over_x)",
     "the angle whose tangent is y / x; with two arguments from -pi to pi"},
    {"sinh", "T sinh(T x)", "the hyperbolic sine", 130},
    {"cosh", "T cosh(T x)", "the hyperbolic cosine", 130},
    {"tanh", "T tanh(T x)", "the hyperbolic tangent", 130},
    {"asinh", "T asinh(T x)", "the inverse of sinh", 130},
    {"acosh", "T acosh(T x)", "the inverse of cosh that is not negative", 130},
    {"atanh", "T atanh(T x)", "the inverse of tanh", 130},
    // Powers
    {"pow", "T pow(T x, T y)", "x to the power y; undefined for x < 0"},
    {"exp", "T exp(T x)", "e to the power x"},
    {"log", "T log(T x)", "the natural logarithm; undefined for x <= 0"},
    {"exp2", "T exp2(T x)", "2 to the power x"},
    {"log2", "T log2(T x)", "the logarithm to the base 2; undefined for x <= 0"},
    {"sqrt", "T sqrt(T x)", "the square root; undefined for x < 0"},
    {"inversesqrt", "T inversesqrt(T x)", "1 / sqrt(x); undefined for x <= 0"},
    // Common functions
    {"abs", "T abs(T x)", "x without its sign"},
    {"sign", "T sign(T x)", "-1, 0 or 1"},
    {"floor", "T floor(T x)", "the nearest integer that is not larger"},
    {"trunc", "T trunc(T x)", "the nearest integer towards 0", 130},
    {"round", "T round(T x)", "the nearest integer; halves go as the driver likes", 130},
    {"roundEven", "T roundEven(T x)", "the nearest integer; halves go to the even one", 130},
    {"ceil", "T ceil(T x)", "the nearest integer that is not smaller"},
    {"fract", "T fract(T x)", "x - floor(x)"},
    {"mod", "T mod(T x, T y)", "x - y * floor(x / y); y may be a float"},
    {"modf", "T modf(T x, out T whole)", "the fraction of x; its whole part goes into `whole`", 130},
    {"min", "T min(T x, T y)", "the smaller one"},
    {"max", "T max(T x, T y)", "the larger one"},
    {"clamp", "T clamp(T x, T low, T high)", "min(max(x, low), high)"},
    {"mix", "T mix(T x, T y, T a)", "x * (1 - a) + y * a; with bools, chooses x or y"},
    {"step", "T step(T edge, T x)", "0 where x < edge, otherwise 1"},
    {"smoothstep", "T smoothstep(T low, T high, T x)",
     "goes smoothly from 0 at `low` to 1 at `high`; undefined for low >= high"},
    {"isnan", "bool isnan(T x)", "true where x is not a number", 130},
    {"isinf", "bool isinf(T x)", "true where x is infinite", 130},
    {"floatBitsToInt", "int floatBitsToInt(T x)", "the bits of a float as an int", 330},
    {"floatBitsToUint", "uint floatBitsToUint(T x)", "the bits of a float as a uint", 330},
    {"intBitsToFloat", "T intBitsToFloat(int x)", "the float that has these bits", 330},
    {"uintBitsToFloat", "T uintBitsToFloat(uint x)", "the float that has these bits", 330},
    {"fma", "T fma(T a, T b, T c)", "a * b + c, rounded once where the driver can", 400},
    {"frexp", "T frexp(T x, out int exponent)", "the significand, 0.5 to 1, and the exponent of 2", 400},
    {"ldexp", "T ldexp(T x, int exponent)", "x times 2 to the power of the exponent", 400},
    // Packing
    {"packUnorm2x16", "uint packUnorm2x16(vec2 v)", "two numbers from 0 to 1 in 16 bits each", 420},
    {"packSnorm2x16", "uint packSnorm2x16(vec2 v)", "two numbers from -1 to 1 in 16 bits each", 420},
    {"packUnorm4x8", "uint packUnorm4x8(vec4 v)", "four numbers from 0 to 1 in 8 bits each", 400},
    {"packSnorm4x8", "uint packSnorm4x8(vec4 v)", "four numbers from -1 to 1 in 8 bits each", 400},
    {"packHalf2x16", "uint packHalf2x16(vec2 v)", "two numbers as 16-bit floats", 420},
    {"unpackUnorm2x16", "vec2 unpackUnorm2x16(uint p)", "the inverse of packUnorm2x16", 420},
    {"unpackSnorm2x16", "vec2 unpackSnorm2x16(uint p)", "the inverse of packSnorm2x16", 420},
    {"unpackUnorm4x8", "vec4 unpackUnorm4x8(uint p)", "the inverse of packUnorm4x8", 400},
    {"unpackSnorm4x8", "vec4 unpackSnorm4x8(uint p)", "the inverse of packSnorm4x8", 400},
    {"unpackHalf2x16", "vec2 unpackHalf2x16(uint p)", "the inverse of packHalf2x16", 420},
    // Geometry
    {"length", "float length(T x)", "the length of a vector"},
    {"distance", "float distance(T a, T b)", "length(a - b)"},
    {"dot", "float dot(T a, T b)", "the scalar product"},
    {"cross", "vec3 cross(vec3 a, vec3 b)", "the vector product"},
    {"normalize", "T normalize(T x)", "x with length 1; undefined for the zero vector"},
    {"faceforward", "T faceforward(T n, T i, T reference)", "n if dot(reference, i) < 0, otherwise -n"},
    {"reflect", "T reflect(T i, T n)", "i - 2 * dot(n, i) * n; n must have length 1"},
    {"refract", "T refract(T i, T n, float eta)",
     "the refracted direction; 0 at total reflection. eta: the ratio of the indices of refraction"},
    {"ftransform", "vec4 ftransform()", "gl_ModelViewProjectionMatrix * gl_Vertex", 110, "v", 140},
    // Matrices
    {"matrixCompMult", "mat matrixCompMult(mat a, mat b)", "the product component by component"},
    {"outerProduct", "mat outerProduct(vec c, vec r)", "the matrix c * transpose(r)", 120},
    {"transpose", "mat transpose(mat m)", "rows and columns exchanged", 120},
    {"determinant", "float determinant(mat m)", "the determinant", 150},
    {"inverse", "mat inverse(mat m)", "the inverse; undefined for a singular matrix", 140},
    // Comparisons
    {"lessThan", "bvec lessThan(vec x, vec y)", "x < y for every component"},
    {"lessThanEqual", "bvec lessThanEqual(vec x, vec y)", "x <= y for every component"},
    {"greaterThan", "bvec greaterThan(vec x, vec y)", "x > y for every component"},
    {"greaterThanEqual", "bvec greaterThanEqual(vec x, vec y)", "x >= y for every component"},
    {"equal", "bvec equal(vec x, vec y)", "x == y for every component"},
    {"notEqual", "bvec notEqual(vec x, vec y)", "x != y for every component"},
    {"any", "bool any(bvec x)", "true if a component is true"},
    {"all", "bool all(bvec x)", "true if all components are true"},
    {"not", "bvec not(bvec x)", "the opposite of every component"},
    // Integers
    {"bitfieldExtract", "I bitfieldExtract(I value, int offset, int bits)", "some bits of an integer", 400},
    {"bitfieldInsert", "I bitfieldInsert(I base, I insert, int offset, int bits)",
     "`base` with some bits replaced", 400},
    {"bitfieldReverse", "I bitfieldReverse(I value)", "the bits in opposite order", 400},
    {"bitCount", "int bitCount(I value)", "the number of bits that are 1", 400},
    {"findLSB", "int findLSB(I value)", "the lowest bit that is 1; -1 without one", 400},
    {"findMSB", "int findMSB(I value)", "the highest significant bit; -1 without one", 400},
    {"uaddCarry", "uint uaddCarry(uint x, uint y, out uint carry)", "the sum, and its carry", 400},
    {"usubBorrow", "uint usubBorrow(uint x, uint y, out uint borrow)", "the difference, and its borrow", 400},
    {"umulExtended", "void umulExtended(uint x, uint y, out uint high, out uint low)",
     "the product of 64 bits", 400},
    {"imulExtended", "void imulExtended(int x, int y, out int high, out int low)", "the product of 64 bits",
     400},
    // Textures
    {"texture", "vec4 texture(S sampler, P place)   vec4 texture(S sampler, P place, float bias)",
     "the texel at a place, filtered. Coordinates go from 0 to 1", 130},
    {"textureLod", "vec4 textureLod(S sampler, P place, float level)", "texture() from that mipmap level",
     130},
    {"textureProj", "vec4 textureProj(S sampler, P place)",
     "texture() at the place divided by its last component", 130},
    {"textureProjLod", "vec4 textureProjLod(S sampler, P place, float level)",
     "textureProj() from that mipmap level", 130},
    {"textureGrad", "vec4 textureGrad(S sampler, P place, P dPdx, P dPdy)",
     "texture() with these derivatives", 130},
    {"textureOffset", "vec4 textureOffset(S sampler, P place, ivec offset)", "texture() some texels further",
     130},
    {"textureSize", "ivec textureSize(S sampler, int level)", "the size of a level in texels", 130},
    {"textureQueryLod", "vec2 textureQueryLod(S sampler, P place)",
     "the mipmap level that texture() would read", 400, "f"},
    {"textureQueryLevels", "int textureQueryLevels(S sampler)", "the number of mipmap levels", 430},
    {"textureGather", "vec4 textureGather(S sampler, P place, int component)",
     "one component of the four texels around a place", 400},
    {"texelFetch", "vec4 texelFetch(S sampler, ivec texel, int level)",
     "a texel by its number, without filtering", 130},
    {"texelFetchOffset", "vec4 texelFetchOffset(S sampler, ivec texel, int level, ivec offset)",
     "texelFetch() some texels further", 130},
    {"texture1D", "vec4 texture1D(sampler1D sampler, float s)",
     "the texel at s; `texture` from version 130 on", 110, "", 140},
    {"texture2D", "vec4 texture2D(sampler2D sampler, vec2 st)",
     "the texel at st; `texture` from version 130 on", 110, "", 140},
    {"texture3D", "vec4 texture3D(sampler3D sampler, vec3 stp)",
     "the texel at stp; `texture` from version 130 on", 110, "", 140},
    {"textureCube", "vec4 textureCube(samplerCube sampler, vec3 direction)",
     "the texel in a direction; `texture` from version 130 on", 110, "", 140},
    {"texture2DProj", "vec4 texture2DProj(sampler2D sampler, vec4 place)",
     "texture2D at the place divided by its last component", 110, "", 140},
    {"shadow2D", "vec4 shadow2D(sampler2DShadow sampler, vec3 place)", "compares the depth with place.z", 110,
     "", 140},
    // Derivatives and interpolation
    {"dFdx", "T dFdx(T p)", "how much p changes from this pixel to the next one on the right", 110, "f"},
    {"dFdy", "T dFdy(T p)", "how much p changes from this pixel to the next one above", 110, "f"},
    {"fwidth", "T fwidth(T p)", "abs(dFdx(p)) + abs(dFdy(p))", 110, "f"},
    {"interpolateAtCentroid", "T interpolateAtCentroid(T input)",
     "an input at a place that the triangle covers", 400, "f"},
    {"interpolateAtSample", "T interpolateAtSample(T input, int sample)", "an input at that sample", 400,
     "f"},
    {"interpolateAtOffset", "T interpolateAtOffset(T input, vec2 offset)",
     "an input at that distance from the pixel's centre", 400, "f"},
    // Geometry shaders
    {"EmitVertex", "void EmitVertex()", "ends a vertex; all outputs are undefined afterwards", 150, "g"},
    {"EndPrimitive", "void EndPrimitive()", "ends the primitive and begins another one", 150, "g"},
    // Images, atomics and barriers
    {"imageLoad", "vec4 imageLoad(G image, P texel)", "reads a texel of an image", 420},
    {"imageStore", "void imageStore(G image, P texel, vec4 data)", "writes a texel of an image", 420},
    {"imageSize", "ivec imageSize(G image)", "the size of an image in texels", 430},
    {"imageAtomicAdd", "uint imageAtomicAdd(G image, P texel, uint data)",
     "adds to a texel and returns what it was", 420},
    {"imageAtomicMin", "uint imageAtomicMin(G image, P texel, uint data)",
     "keeps the smaller one and returns what the texel was", 420},
    {"imageAtomicMax", "uint imageAtomicMax(G image, P texel, uint data)",
     "keeps the larger one and returns what the texel was", 420},
    {"imageAtomicExchange", "uint imageAtomicExchange(G image, P texel, uint data)",
     "writes a texel and returns what it was", 420},
    {"imageAtomicCompSwap", "uint imageAtomicCompSwap(G image, P texel, uint compare, uint data)",
     "writes a texel that equals `compare` and returns what it was", 420},
    {"atomicAdd", "I atomicAdd(inout I memory, I data)", "adds and returns what the memory was", 430},
    {"atomicMin", "I atomicMin(inout I memory, I data)",
     "keeps the smaller one and returns what the memory was", 430},
    {"atomicMax", "I atomicMax(inout I memory, I data)",
     "keeps the larger one and returns what the memory was", 430},
    {"atomicAnd", "I atomicAnd(inout I memory, I data)",
     "the bits that both have; returns what the memory was", 430},
    {"atomicOr", "I atomicOr(inout I memory, I data)",
     "the bits that one of them has; returns what the memory was", 430},
    {"atomicXor", "I atomicXor(inout I memory, I data)", "the bits that differ; returns what the memory was",
     430},
    {"atomicExchange", "I atomicExchange(inout I memory, I data)", "writes and returns what the memory was",
     430},
    {"atomicCompSwap", "I atomicCompSwap(inout I memory, I compare, I data)",
     "writes if the memory equals `compare`; returns what it was", 430},
    {"atomicCounter", "uint atomicCounter(atomic_uint c)", "the value of a counter", 420},
    {"atomicCounterIncrement", "uint atomicCounterIncrement(atomic_uint c)",
     "adds 1 and returns what the counter was", 420},
    {"atomicCounterDecrement", "uint atomicCounterDecrement(atomic_uint c)",
     "subtracts 1 and returns what the counter is", 420},
    {"barrier", "void barrier()", "waits for all invocations of the patch or group", 400, "ck"},
    {"memoryBarrier", "void memoryBarrier()", "what was written before is seen by what is read after", 420},
    {"memoryBarrierShared", "void memoryBarrierShared()", "memoryBarrier() for shared variables", 430, "k"},
    {"memoryBarrierBuffer", "void memoryBarrierBuffer()", "memoryBarrier() for buffers", 430},
    {"memoryBarrierImage", "void memoryBarrierImage()", "memoryBarrier() for images", 430},
    {"groupMemoryBarrier", "void groupMemoryBarrier()", "memoryBarrier() within the group", 430, "k"},
    // Built-in variables
    {"gl_Position", "vec4 gl_Position",
     "the vertex in clip space: an output, and a member of gl_in[] in later stages", 110, "vceg"},
    {"gl_PointSize", "float gl_PointSize", "the size of a point in pixels", 110, "vceg"},
    {"gl_ClipDistance", "float gl_ClipDistance[]", "distances from clip planes; negative is cut away", 130,
     "vcegf"},
    {"gl_VertexID", "int gl_VertexID", "the number of the vertex", 130, "v"},
    {"gl_InstanceID", "int gl_InstanceID", "the number of the instance", 140, "v"},
    {"gl_in", "gl_PerVertex gl_in[]", "the vertices of the patch or primitive, as the stage before left them",
     150, "ceg"},
    {"gl_out", "gl_PerVertex gl_out[]", "the vertices of the patch that the control stage makes", 400, "c"},
    {"gl_InvocationID", "int gl_InvocationID", "the number of this invocation: of the vertex in a patch", 400,
     "cg"},
    {"gl_PatchVerticesIn", "int gl_PatchVerticesIn", "the number of vertices of the patch", 400, "ce"},
    {"gl_TessLevelOuter", "float gl_TessLevelOuter[4]", "into how many parts the edges of the patch are cut",
     400, "ce"},
    {"gl_TessLevelInner", "float gl_TessLevelInner[2]", "into how many parts the inside of the patch is cut",
     400, "ce"},
    {"gl_TessCoord", "vec3 gl_TessCoord", "the place of the vertex in the patch, 0 to 1", 400, "e"},
    {"gl_PrimitiveID", "int gl_PrimitiveID", "the number of the primitive", 150, "cegf"},
    {"gl_PrimitiveIDIn", "int gl_PrimitiveIDIn", "the number of the primitive that comes in", 150, "g"},
    {"gl_Layer", "int gl_Layer", "the layer of the target that is drawn into", 150, "gf"},
    {"gl_FragCoord", "vec4 gl_FragCoord",
     "x and y: pixels from the lower left corner; z: depth, 0 to 1; w: 1 / clip w", 110, "f"},
    {"gl_FrontFacing", "bool gl_FrontFacing", "true on the front side of a triangle", 110, "f"},
    {"gl_PointCoord", "vec2 gl_PointCoord", "the place in a point, 0 to 1 from the upper left corner", 120,
     "f"},
    {"gl_FragDepth", "float gl_FragDepth", "the depth that is written, in place of gl_FragCoord.z", 110, "f"},
    {"gl_FragColor", "vec4 gl_FragColor",
     "the colour of the fragment; from version 130 on declare `out vec4`", 110, "f", 420},
    {"gl_FragData", "vec4 gl_FragData[]", "the colours of the fragment for several targets", 110, "f", 420},
    {"gl_SampleID", "int gl_SampleID", "the number of the sample", 400, "f"},
    {"gl_SampleMask", "int gl_SampleMask[]", "the samples that are written", 400, "f"},
    {"gl_FrontColor", "vec4 gl_FrontColor", "the colour for front sides; gl_Color in the fragment stage", 110,
     "v", 150},
    {"gl_BackColor", "vec4 gl_BackColor", "the colour for back sides; gl_Color in the fragment stage", 110,
     "v", 150},
    {"gl_TexCoord", "vec4 gl_TexCoord[]", "texture coordinates from the vertex to the fragment stage", 110,
     "vgf", 150},
    {"gl_FogFragCoord", "float gl_FogFragCoord", "the fog coordinate from the vertex to the fragment stage",
     110, "vgf", 150},
    {"gl_GlobalInvocationID", "uvec3 gl_GlobalInvocationID", "the number of this invocation among all", 430,
     "k"},
    {"gl_LocalInvocationID", "uvec3 gl_LocalInvocationID", "the number of this invocation in its group", 430,
     "k"},
    {"gl_LocalInvocationIndex", "uint gl_LocalInvocationIndex", "the same as one number", 430, "k"},
    {"gl_WorkGroupID", "uvec3 gl_WorkGroupID", "the number of the group", 430, "k"},
    {"gl_WorkGroupSize", "uvec3 gl_WorkGroupSize", "the size of a group, layout(local_size_x = ...)", 430,
     "k"},
    {"gl_NumWorkGroups", "uvec3 gl_NumWorkGroups", "the number of groups", 430, "k"},
});

/// The keywords that not every stage has, with the letters of those that do.
constexpr std::array<std::pair<std::string_view, std::string_view>, 4> kKeywords{
    {{"attribute", "v"}, {"discard", "f"}, {"patch", "ce"}, {"shared", "k"}}};

bool hasStage(std::string_view letters, glsl::Stage stage) {
    constexpr std::string_view kLetters = "vcegfk";  // in the order of glsl::Stage
    return letters.find(kLetters[static_cast<std::size_t>(stage)]) != std::string_view::npos;
}

}  // namespace

std::span<const GlslRow> glslTable() {
    return kRows;
}

const GlslRow* findGlsl(std::string_view name) {
    const auto* const found = std::ranges::find(kRows, name, &GlslRow::name);
    return found == kRows.end() ? nullptr : found;
}

bool isIn(const GlslRow& row, glsl::Stage stage) {
    return row.where.empty() || hasStage(row.where, stage);
}

bool isKeywordIn(std::string_view keyword, glsl::Stage stage) {
    return std::ranges::all_of(
        kKeywords, [&](const auto& each) { return each.first != keyword || hasStage(each.second, stage); });
}

}  // namespace glibra::editor
