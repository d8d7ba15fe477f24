#pragma once
// Which parts of a Scene are made and drawn for one picture, how, and why the rest is skipped. planFrame()
// (planner.h) makes it. There is no GL here.

#include <glibra/diagnostic.h>
#include <glibra/result.h>

#include <bitset>
#include <cstddef>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <variant>
#include <vector>

#include "base/raster_state.h"
#include "plan/program_variant.h"
#include "scene/scene.h"

namespace glibra::plan {

// Finds the buffer that each block of a program uses (language, 12).

/// A block of a program with the buffer that it uses.
struct BlockUse {
    enum class Kind { uniform, storage, counters };
    Kind kind = Kind::storage;
    /// Index into the interface's list of that kind. Blocks are bound to binding points of the same number;
    /// counters have their own.
    std::size_t index = 0;
    scene::BufferView buffer;
    Place place;  ///< of the block's declaration, or of the program
};

/// The buffers of a program's blocks: those that the draw's or dispatch's set binds by a tag with the block's
/// name or its instance's, otherwise those declared with that name. A uniform block without a buffer has
/// values of its own and no entry. Error memory-E02 for a storage block or atomic counter without a buffer,
/// memory-E14 for counters of one binding with several.
Result<std::vector<BlockUse>> blockUses(const scene::Scene& scene, const scene::Program& program,
                                        scene::UniformSetIndex set, const ProgramInterface& interface);

/// The declared name of a block in messages: "storage block 'Particles'".
std::string describe(const BlockUse& use, const ProgramInterface& interface);

// What a plan leaves out, in words, for --explain and --stats.

struct Skipped {
    std::string what;  ///< "texture", "noise texture", "attribute", "mesh", "program", "pass", "draw",
                       ///< "dispatch", "statement", "file"
    std::string why;   ///< which one, and why: "unit 5 / 3D: no active sampler reads it"
    Place place;
};

struct TextureUse {
    UniformIndex uniform{};
    int element = 0;
    int driverUnit = 0;          ///< texture image unit (or image unit) of GL that the plan chose
    scene::TextureView view{};   ///< without a texture: an empty slot, which reads (0, 0, 0, 1)
    scene::BufferView buffer{};  ///< what is read as a texture of `bufferFormat`, in place of `view`
    base::TexelFormat bufferFormat = base::TexelFormat::rgba32f;
    scene::TextureTarget target = scene::TextureTarget::texture2D;  ///< that the shader reads
    base::SamplerState sampler{};
    bool compares = false;      ///< the shader compares depth, as the sampler says
    bool readsSamples = false;  ///< the shader reads the single samples of a multisampled texture
    bool isImage = false;
    /// Of an image: the format that the shader declares; nothing: the texture's own.
    std::optional<base::TexelFormat> imageFormat{};
    /// The shader may read mipmaps: its sampler does, or it fetches texels.
    bool readsMipmaps = true;
    friend bool operator==(const TextureUse&, const TextureUse&) = default;
};

/// How the mesh is submitted (language, 4.8).
struct Submission {
    geometry::Topology topology = geometry::Topology::triangles;
    int patchVertices = 0;
    std::optional<geometry::ListTopology> strip{};  ///< the primitives share vertices
    friend bool operator==(const Submission&, const Submission&) = default;
};

struct PlannedProgram {
    ProgramVariant variant;
    const ProgramInterface* interface = nullptr;
    std::vector<UniformBinding> values;  ///< literals and values that the runtime supplies
    std::vector<Control> controls;
    std::vector<BlockUse> blocks{};          ///< in buffers of the scene
    std::vector<std::string> foundByName{};  ///< UniformResolution::foundByName
    std::vector<std::string> timed{};        ///< UniformResolution::timed
    /// Its text and these values do not show that its loops are short enough for every driver, nor that they
    /// are not.
    bool hasOpenLoops = false;
};

/// True for members of a uniform block whose values are in a buffer of the scene.
bool isInBuffer(const PlannedProgram& program, const ActiveUniform& uniform);

/// What feeds one vertex input.
struct InputSource {
    /// A mesh attribute by its name in geometry; numbers; or a buffer. An attribute that the mesh lacks reads
    /// (0, 0, 0, 1), and the current colour where it is geometry::kColor.
    std::variant<std::string, std::array<double, 4>, scene::BufferView> from;
    bool isPerInstance = false;  ///< of a buffer
    scene::ElementPart part{};   ///< of a buffer
    bool isKnown = true;         ///< false: nothing feeds it but perhaps a list with an attribute of its name
    friend bool operator==(const InputSource&, const InputSource&) = default;
};

/// What feeds the inputs of a program; one element per input of its interface.
struct PlannedInputs {
    std::vector<InputSource> sources;
};

/// A mesh to make, with those of its attributes that a program reads. A shape without vertex data has an
/// empty one.
struct PlannedMesh {
    scene::ShapeIndex shape{};
    std::vector<std::string> attributes;  ///< geometry's names, in the order of its constants
    /// trianglesAdjacency or linesAdjacency: the triangles of the shape get these indices
    /// (geometry::adjacencyIndices); nothing: the mesh as it is.
    std::optional<geometry::Topology> adjacency{};
    bool isExpanded = false;  ///< each index has a vertex of its own (glsl::ExpandedGeometry)
};

// Indices into the lists of FramePlan.
using PlannedProgramIndex = scene::Index<PlannedProgram>;
using PlannedMeshIndex = scene::Index<PlannedMesh>;
using PlannedInputsIndex = scene::Index<PlannedInputs>;

struct PlannedDraw {
    scene::StepIndex step;  ///< of a Draw
    PlannedProgramIndex program{};
    PlannedMeshIndex mesh{};
    Submission submission;
    std::vector<TextureUse> textures;
    PlannedInputsIndex inputs{};  ///< none: the program is not usable
    /// The colour targets for which the program has no output, one bit each: they keep what they hold.
    std::bitset<base::kRasterTargets> unwritten{};
};

struct PlannedClear {
    scene::StepIndex step;
};

struct PlannedPass {
    std::size_t pass = 0;  ///< index into NodeList::passes
    std::vector<std::variant<PlannedDraw, PlannedClear>> steps;
};

struct PlannedDispatch {
    std::size_t dispatch = 0;  ///< index into NodeList::dispatches
    PlannedProgramIndex program{};
    std::vector<TextureUse> textures;
};

struct PlannedClearObject {
    std::size_t clear = 0;  ///< index into NodeList::clears
};

/// A texture or buffer, whatever part or copy of it.
using Object = std::variant<scene::TextureIndex, scene::BufferIndex>;

/// What a node does with an object.
struct ObjectUse {
    scene::ObjectView object;
    bool reads = true;
    bool writes = false;
    bool stores = false;  ///< writes by stores and atomic operations of shaders, which barriers order
};

/// The two copies of an object with history change their places before a node writes it.
struct PlannedExchange {
    Object object;
    bool keepsContent = true;  ///< the node may leave parts as they were
    /// The text of its shader shows that a dispatch writes all of the object, if it has an invocation for
    /// each texel or element, and each of these sizes reaches as far.
    struct Whole {
        int axes = 1;  ///< components of the place of a texel, or 1 for elements
        std::vector<scene::ObjectView> sizes{};
    };
    std::optional<Whole> whole{};  ///< only with keepsContent
    bool isFilled = false;         ///< with keepsContent: a draw covers all, if it is drawn plainly
};

/// What a node reads, writes and keeps.
struct NodeAccess {
    /// The same object several times if it is used in several ways. Targets of a pass are written, and read
    /// too unless the pass clears them.
    std::vector<ObjectUse> uses;
    std::set<Object> written;
    std::set<Object> overwritten;  ///< all of it gets a new content, whatever it held: it is cleared first
    std::vector<PlannedExchange> exchanges;
};

struct FramePlan {
    const scene::NodeList* nodes = nullptr;  ///< what is planned; it must outlive the plan
    std::vector<PlannedPass> passes;
    std::vector<PlannedDispatch> dispatches;
    std::vector<PlannedClearObject> clears;
    /// What is executed, in order. Each index is into `passes`, `dispatches` or `clears` of this plan.
    std::vector<scene::NodeIndex> order;
    // What a frame does with objects.
    std::vector<NodeAccess> accesses;  ///< one element per node of `order`
    /// What the nodes write before they clear it; it begins as declared. Nothing in a scene that goes on.
    std::vector<scene::ObjectView> resets;
    bool showsEarlierFrames = false;  ///< it begins with what the frame before has left (Scene::goesOn)
    /// What the nodes read and none writes; an earlier frame may have written it. Likewise.
    std::vector<scene::ObjectView> reads;
    /// Textures that a node clears as wholes before anything else happens to them.
    std::vector<scene::TextureIndex> cleared;
    /// Textures that use the memory of another one of `cleared`, because none of them is needed while another
    /// one is. Only with PlanOptions::shareTargets.
    std::map<scene::TextureIndex, scene::TextureIndex> sharing;
    scene::List<PlannedProgram> programs;
    scene::List<PlannedMesh> meshes;
    scene::List<PlannedInputs> inputs;
    std::vector<scene::TextureIndex> textures;  ///< those that must exist: sources and targets
    std::vector<scene::BufferIndex> buffers;    ///< those that must exist
    std::vector<Skipped> skipped;
    std::vector<bool> usedOverrides;  ///< one element per PlanOptions::overrides: a program has the uniform
    Diagnostics diagnostics;          ///< draw-E.., draw-W.., and those of needed programs and uniforms

    [[nodiscard]] const scene::Draw& drawOf(const PlannedDraw& planned) const {
        return nodes->draw(planned.step);
    }
    [[nodiscard]] const scene::Clear& clearOf(const PlannedClear& planned) const {
        return nodes->clear(planned.step);
    }
    [[nodiscard]] const scene::Pass& passOf(const PlannedPass& planned) const {
        return nodes->passes.at(planned.pass);
    }
    [[nodiscard]] const scene::Dispatch& dispatchOf(const PlannedDispatch& planned) const {
        return nodes->dispatches.at(planned.dispatch);
    }
    [[nodiscard]] const scene::ClearObject& clearOf(const PlannedClearObject& planned) const {
        return nodes->clears.at(planned.clear);
    }
    /// The node of the scene that a node of `order` is of, and its place there.
    [[nodiscard]] scene::NodeIndex declared(const scene::NodeIndex& node) const;
    [[nodiscard]] const Place& placeOf(const scene::NodeIndex& node) const;

    /// Calls `visit(planned, draw, pass)` with each PlannedDraw, its scene::Draw and the scene::Pass.
    template <class Visit>
    void visitDraws(Visit&& visit) const {
        for (const PlannedPass& pass : passes)
            for (const auto& step : pass.steps)
                if (const auto* draw = std::get_if<PlannedDraw>(&step))
                    visit(*draw, drawOf(*draw), passOf(pass));
    }
    /// Calls `visit(planned, statement)` with each PlannedDispatch and its scene::Dispatch, then with each
    /// PlannedDraw and its scene::Draw.
    template <class Visit>
    void visitStatements(Visit&& visit) const {
        for (const PlannedDispatch& each : dispatches) visit(each, dispatchOf(each));
        visitDraws([&](const PlannedDraw& each, const scene::Draw& draw, const auto&) { visit(each, draw); });
    }
};

}  // namespace glibra::plan
