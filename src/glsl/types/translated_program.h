#pragma once
// The result of a translation: the sources for the driver, the origin of each of their lines, and every fact
// about the program that other rooms need, so that no other room has to read shader text.

#include <glibra/diagnostic.h>

#include <array>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "base/tessellation_layout.h"
#include "glsl/types/counted_loop.h"
#include "glsl/types/stage.h"

namespace glibra::glsl {

// ---- Memory
// The memory that a program reads and writes besides its textures, as the text of its stages declares it:
// image uniforms, blocks, and the structures from which layouts are computed. Code that the preprocessor
// removes does not count. All names are the user's.

/// The array sizes of a declaration, the outermost first. 0: runtime-sized, as `a[]`. kUnknownSize: the text
/// does not tell the size; the linked program does.
using ArraySizes = std::vector<long long>;
inline constexpr long long kUnknownSize = -1;

/// A uniform image. What is not readonly counts as written.
struct ImageUniform {
    Place place;
    std::string type;    ///< "image2D", "uimage2D", "image2DArray", ...
    std::string format;  ///< "r32f", "rgba8", ...; empty: none given, which only a writeonly image may omit
    bool isReadonly = false, isWriteonly = false;  ///< in every stage that declares it
    ArraySizes sizes;                              ///< empty: a single image
    std::optional<int> binding;
};

/// How the members of a block are placed.
enum class Packing {
    driver,  ///< `shared`, `packed` or no word: only the linked program knows
    std140,
    std430
};

/// A member of a block or structure.
struct MemoryMember {
    Place place;
    std::string name;
    std::string type;  ///< "float", "vec3", "mat4x2", "Particle"
    ArraySizes sizes;
    std::optional<bool> isRowMajor;          ///< nothing: as what contains it; column major on the outside
    std::optional<long long> offset, align;  ///< layout(offset = n, align = n), bytes
    bool isReadonly = false, isWriteonly = false;
};

/// struct Name { ... }
struct MemoryStructure {
    Place place;
    std::vector<MemoryMember> members;
};
using MemoryStructures = std::map<std::string, MemoryStructure, std::less<>>;

/// `buffer Name { ... } instance;` or `uniform Name { ... } instance;`
struct MemoryBlock {
    Place place;
    std::string name;
    std::string instance;  ///< empty: the members are global names
    ArraySizes sizes;      ///< of the instance; empty: a single block
    bool isStorage = false;
    /// The block or all of its members have the word, in every stage that declares the block. A storage block
    /// that is not readonly counts as written.
    bool isReadonly = false, isWriteonly = false;
    Packing packing = Packing::driver;
    bool isRowMajor = false;
    std::optional<int> binding;
    std::vector<MemoryMember> members;
};

/// A uniform atomic_uint.
struct AtomicCounter {
    Place place;
    std::optional<int> binding;
    long long offset = 0;  ///< bytes, as given or as GL counts on
    ArraySizes sizes;
};

/// An image, or a storage block of a single array, of which the text shows that a compute stage writes all
/// and reads nothing: each invocation writes the texel or element whose place is its gl_GlobalInvocationID,
/// if that lies within the sizes of all of `sizes`.
struct WholeWrite {
    std::string name;                ///< of the image or block
    bool isBlock = false;            ///< its array, not an image, is written
    int axes = 1;                    ///< components of the place
    std::vector<std::string> sizes;  ///< names of images, samplers and blocks; may be empty
};

struct MemoryFacts {
    std::map<std::string, ImageUniform> images;
    std::map<std::string, AtomicCounter> counters;
    std::vector<MemoryBlock> blocks;  ///< in order of declaration; each name once per kind
    /// Uniform variables whose type is a structure with a name, by the variable's name.
    std::map<std::string, MemoryMember, std::less<>> records;
    /// All structures with a name. If stages declare different ones of one name, the first counts.
    MemoryStructures structures;

    /// The block of that name and kind, or null.
    [[nodiscard]] const MemoryBlock* block(std::string_view name, bool isStorage) const {
        for (const MemoryBlock& each : blocks)
            if (each.name == name && each.isStorage == isStorage) return &each;
        return nullptr;
    }
};

// ---- The result

/// The user's line that an emitted line comes from.
struct LineOrigin {
    int file = -1;  ///< index into LineMap::files; -1: written by the translator
    int line = 0;   ///< the user's line, as #line directives count it
};
/// From column `emitted` of an emitted line on, the user's columns count from `user`, in the user's `line`.
struct ColumnShift {
    int emitted = 1;
    int user = 1;
    LineOrigin line{};  ///< that of the emitted line, except inside macro calls of several lines
    int macro = -1;     ///< index into LineMap::macros: from there comes the text that the call expands to
};
/// A word in the text of a macro.
struct MacroPlace {
    std::string name;  ///< the name of the macro
    LineOrigin line;
    int column = 1;
};
/// The origins of the lines of an emitted text. lines[i] and columns[i] belong to line i + 1 of that text.
struct LineMap {
    std::vector<std::string> files;
    std::vector<LineOrigin> lines;
    std::vector<std::vector<ColumnShift>> columns;  ///< an empty entry: the columns are the user's
    std::vector<MacroPlace> macros;
};

/// What the code of a stage does, as far as its tokens show it. Code that the preprocessor removes does not
/// count, and neither do comments.
struct StageFacts {
    /// Calls a function other than constructors and normalize(): its results may not be linear in its inputs.
    bool callsFunctions = false;
    /// Shows the single triangles: has a flat variable, reads gl_PrimitiveID or gl_VertexID, or computes a
    /// normal from derivatives (dFdx and cross).
    bool showsPrimitives = false;
    /// Refracts, or reflects and has a cube map: small errors of a normal become large ones in the picture.
    bool magnifiesNormals = false;
    /// Names gl_FragDepth, perhaps under a condition.
    bool mayWriteDepth = false;
    /// May write memory besides its outputs: names an image or storage block that is not readonly, or an
    /// atomic counter.
    bool writesMemory = false;
    /// May leave a fragment as it is: names discard, gl_SampleMask, or what extensions call it.
    bool mayLeaveFragments = false;
    /// Of a fragment stage: it may show edges between vertices, because it does more with its inputs than to
    /// add them up: it calls functions other than constructors and normalize(), multiplies, or decides.
    bool mayPaintEdges = false;
    /// Names texelFetch or texelFetchOffset, which may read any level, whatever the sampler says.
    bool fetchesTexels = false;
};

/// Two types that do not fit, at an operator or a return: the driver's message does not name both.
struct TypeMismatch {
    Place place;
    std::string text;  ///< "vec4 + vec3", "the value is a vec3, the function returns a float"
};

/// The subscript of an element of a storage block's last array: a constant, or the number of an invocation, a
/// vertex or an instance that nothing compares with a size.
struct ElementSubscript {
    std::string array;   ///< the member of the block
    std::string number;  ///< "gl_GlobalInvocationID.x", "gl_VertexID", ...; empty: `constant`
    long long constant = 0;
    Place place;
};

struct TranslatedStage {
    Stage stage = Stage::vertex;
    std::string source;  ///< complete text for glShaderSource; begins with its #version line, if it has one
    LineMap lineMap;
    std::string path;                ///< the stage's own file
    int firstLine = 1;               ///< of its text, after blank lines
    std::vector<CountedLoop> loops;  ///< the countable loops that main runs, also in the functions it calls
    std::vector<Place> uncounted{};  ///< the other loops that main runs
    StageFacts facts{};
    std::vector<TypeMismatch> mismatches{};
    double emits = 0;  ///< EmitVertex() calls of main outside of conditions and loops
    std::vector<ElementSubscript> subscripts{};
    bool isMerged = false;  ///< it does the work of other stages, too (ExpandedGeometry)
};

/// A uniform as declared in a source, whether or not the compiler keeps it.
struct DeclaredUniform {
    Place place;
    bool hasInitializer = false;
    /// Declared elements of an array of one dimension; 0: it is none, or the text does not show the number.
    int arraySize = 0;
    /// Of a subroutine uniform, which is emitted as an int: the functions that it counts.
    std::vector<std::string> subroutines{};
};

/// The value of a uniform's initialiser. GLSL ES has none, so whoever draws sets it when the program is
/// linked.
struct InitialValue {
    std::string uniform;          ///< as emitted; of a structure its member: "lights[0].color"
    std::string type;             ///< GLSL word of one element
    std::vector<double> numbers;  ///< of all elements; matrices by columns, booleans as 0 and 1
};

/// A place of a shader where something undefined may happen. The program counts how often it does, in the
/// storage block `glibra_Undefined`, an array of numbers: for site i the count at 3 i; then the subscript,
/// texel or number of vertices that was first found, and its limit.
struct UndefinedSite {
    enum class Kind { subscript, texel, level, vertices, divisor };
    Kind kind = Kind::subscript;
    std::string text;  ///< of the user: "weights[i]", "texelFetch(uMap, place, 0)", the divisor
    Place place;
};
inline constexpr const char* kUndefinedBlock = "glibra_Undefined";
inline constexpr std::size_t kNumbersPerSite = 3;
inline constexpr const char* kCutLoopsBlock = "glibra_CutLoops";

/// How a program places its vertices, as far as its text proves it. A program with a known placement has only
/// a vertex stage, or a vertex and a fragment stage, and has no effects except on the picture.
enum class Placement {
    unknown,
    vertex,  ///< gl_Position is the model-view-projection matrix times the vertex
    point    ///< gl_Position is that matrix times vec4(vertex.xyz, 1)
};

/// Of GLSL ES: the vertex stage does the work of geometry and tessellation stages (glsl/es/parts.h).
/// An instance is a primitive of the mesh or a patch.
struct ExpandedGeometry {
    /// Inputs of the vertex stage for each attribute, at consecutive locations: the corners of a primitive of
    /// the mesh or of a patch. 0: the program has neither stage.
    int corners = 0;
    int vertices = 0;     ///< of a primitive that the geometry stage takes, or that a patch becomes
    int ofPrimitive = 0;  ///< 1, 2 or 3 of them are a point, a line or a triangle
    /// How patches are divided; nothing: there are none. Instance i is patch i % glibra_Patches, and the
    /// texture kCoordinates has in texel i, row by row, the texel of its first coordinate and the number
    /// of its vertices; the coordinates follow.
    std::optional<base::TessellationLayout> tessellation{};
    /// No instances, but the vertices of all patches after each other: the uniform glibra_Count has the
    /// number of the texels i, which also have 65,536ths of the vertices before theirs, and the rest of them.
    bool areInSequence = false;
    /// With the uniform glibra_Measures, the first vertex of a patch delivers its levels in the outputs of
    /// kLevelOutputs.
    bool measuresLevels = false;
    /// The most vertices that the geometry stage emits for a primitive, if it is worth to ask how many it
    /// emits; 0: it is not. With the uniform glibra_Mode, each instance has 0: the corners of the primitives
    /// that are emitted, 1: the vertices in the order in which they are emitted, 2: one vertex, whose outputs
    /// kStripOutputs tell the strips.
    int mostEmitted = 0;
    /// Inputs of the vertex stage that do not fit into its attributes. The texture kFetchedInputs has them in
    /// texels, row by row: all of them for each vertex, the corners of a primitive after each other.
    struct Fetched {
        std::string name, type;  ///< in the core text; a GLSL word
    };
    std::vector<Fetched> fetched{};
    /// The vertex stage numbers primitives for the fragment stage: each index needs a vertex of its own, and
    /// its number divided by the uniform glibra_PerPrimitive is that of its primitive.
    bool numbersPrimitives = false;
};
inline constexpr const char* kFetchedInputs = "glibra_Inputs";
inline constexpr const char* kCoordinates = "glibra_Coordinates";
/// The outputs of levels: four outer ones, two inner ones.
inline constexpr std::array<const char*, 2> kLevelOutputs{"glibra_OuterLevels", "glibra_InnerLevels"};
inline constexpr int kLevelComponents = 6;  ///< of these
/// A bit for each vertex that begins a strip, from the lowest one on, and how many vertices are emitted.
inline constexpr std::array<const char*, 3> kStripOutputs{"glibra_Begins", "glibra_MoreBegins",
                                                          "glibra_Emitted"};
inline constexpr int kMostMeasured = 256;  ///< vertices, whose bits these have

/// Of GLSL ES: the vertex stage can make quads of lines, for drivers whose lines are thin. Its instance i is
/// the line i % glibra_Pairs of the instance i / glibra_Pairs of the draw, and has the six corners of two
/// triangles. The texture kLineEnds has rows of kEndsWidth numbers: the two vertices of each line, then, from
/// the next row on, the captured outputs of each of the glibra_Vertices vertices of each instance.
struct WideLines {
    /// Outputs, interleaved, after kLevelOutputs if the program measures levels. Empty: it makes no quads.
    std::vector<std::string> captured{};
    int components = 0;  ///< of all of them
};
inline constexpr const char* kLineEnds = "glibra_Ends";
inline constexpr int kEndsWidth = 2048;
/// The values of the uniform glibra_Wide: the vertices are delivered as they are, or quads are, whose lines
/// are clipped to z from -w to w, to z from 0 to w, or, where depth is clamped, to w > 0.
enum class WideMode { off, fromMinusW, fromZero, depthClamped };

struct TranslatedProgram {
    std::vector<TranslatedStage> stages;  ///< empty if `diagnostics` has an error
    Diagnostics diagnostics;

    std::map<std::string, std::string> userNames;     ///< emitted name to the user's, where they differ
    std::map<std::string, DeclaredUniform> uniforms;  ///< of all stages, by the user's name
    /// layout(binding = n) of samplers and images, by the user's name.
    std::map<std::string, int> textureBindings;
    MemoryFacts memory;  ///< images, blocks and structures of all stages
    /// layout(local_size_x = ...) of a compute stage; 0: the text does not show the number.
    std::array<int, 3> localSize{};
    std::vector<WholeWrite> wholeWrites;        ///< of a compute stage
    bool inPieces = false;                      ///< a compute program that may run in several dispatches
    std::map<std::string, Place> vertexInputs;  ///< the inputs that the user's vertex stage declares
    /// Of a program that got a fragment stage (ProgramRequest::suppliesFragment): "gl_FrontColor" or the
    /// output that it draws; empty for the current colour.
    std::optional<std::string> suppliedColor{};
    bool suppliesVertexStage = false;  ///< it is that of ProgramRequest::suppliesFullScreenVertex
    bool mayReadTangents = false;      ///< the vertex stage names the tangent input
    bool writesPointSize = false;      ///< in the last stage before rasterisation
    bool writesLayer = false;          ///< in the last stage before rasterisation
    int clipDistances = 0;             ///< number of gl_ClipDistance elements that this stage writes
    int patchVertices = 0;             ///< layout(vertices = n) of the control stage; 0: none
    /// The vertices of a patch that the first tessellation stage reads, as far as its subscripts show it, and
    /// where it reads the last of them, as "gl_in[3]".
    int patchVerticesRead = 0;
    Place patchReadPlace;
    std::string patchRead;
    int maxVertices = 0;     ///< layout(max_vertices = n) of the geometry stage; 0: none
    Place maxVerticesPlace;  ///< of that layout
    /// The axes along which a compute stage distinguishes its invocations or groups.
    std::array<bool, 3> invocationAxes{};
    /// Uniforms (by the user's names) whose values reach gl_TessLevelOuter and gl_TessLevelInner by
    /// assignments in the control stage and, as the text shows, nothing else: no position, no colour, no
    /// condition. Scalars of type float or int. Empty if the program has a geometry stage or delivers points,
    /// because then the picture shows the single triangles or vertices.
    std::set<std::string> levelUniforms;
    /// The geometry stage's input primitive, a plain GLSL word; empty: no such stage.
    std::string geometryInput;
    /// The geometry stage's output: "points", "line_strip" or "triangle_strip"; empty: no such stage.
    std::string geometryOutput;
    std::string tessellationOutput;  ///< "triangles", "lines" or "points" that the evaluation stage delivers
    int fragmentOutputs = 1;         ///< number of colour locations written; 0 without a fragment stage
    std::vector<UndefinedSite> undefinedSites;  ///< of all stages (ProgramRequest::checksUndefined)
    /// With ProgramRequest::recordsLoops: the loops of all stages. Loop i writes 1 to element i of an array
    /// of numbers in the storage block `glibra_CutLoops` if it is left though its condition holds, which
    /// happens where a driver ends loops early. In GLSL ES: the loops that are guarded (es/additions.h).
    std::vector<Place> loopSites{};
    Placement placement = Placement::unknown;
    /// The well-known names on which the placement rests: it holds for draws that give none of them a value.
    /// What products of such matrices lose in floats has no bound either.
    std::vector<std::string> placementNames{};
    /// The placement that the text alone shows.
    [[nodiscard]] Placement knownPlacement() const {
        return placementNames.empty() ? placement : Placement::unknown;
    }
    /// Of GLSL ES: the values of initialisers of uniforms, which it does not have.
    std::vector<InitialValue> initialValues{};
    ExpandedGeometry expanded{};
    WideLines wideLines{};
    bool isOpaque = false;  ///< the text proves that the only colour written always has alpha 1

    std::string name;  ///< the Program's name, for the notes after compile errors
    Place place;       ///< the scene line of the Program
    /// Where the stages declare their inputs, outputs and uniforms, by the user's name: for link logs.
    std::map<std::string, std::vector<Place>> interfaceNames;
};

}  // namespace glibra::glsl
