#pragma once
// Decides which parts of a Scene are made and drawn for one picture, how, and why the rest is skipped. There
// is no GL here: what the plan must know of the driver and of compiled programs it asks by PlanQuestions.

#include <bitset>
#include <functional>
#include <map>
#include <optional>
#include <set>
#include <span>
#include <string>
#include <variant>
#include <vector>

#include "base/raster_state.h"
#include "plan/buffers.h"
#include "plan/inputs.h"
#include "plan/program_interface.h"
#include "plan/skipped.h"
#include "plan/uniforms.h"
#include "scene/scene.h"

namespace glibra::plan {

/// The same Program statement may need several GL programs: flat or smooth colours, one or several colour
/// targets, its own vertex stage or a supplied one.
struct ProgramVariant {
    scene::ProgramIndex program{};  ///< none: the built-in program
    bool flatColors = false;
    int colorTargets = 1;
    bool isFullScreen = false;      ///< a vertex stage that covers the whole target may be supplied
    bool inPieces = false;          ///< a compute program that runs in several dispatches
    bool isFill = false;            ///< Program::isLeftOutByFill: these stages are left out
    bool suppliesFragment = false;  ///< a fragment stage is missing and needed
    friend bool operator==(const ProgramVariant&, const ProgramVariant&) = default;
};

/// All that a plan asks while it is made. The answers cannot come as values: a program is compiled and a mesh
/// made only if something visible needs it, and what is visible depends on the answers before.
struct PlanQuestions {
    /// The interface of a program. Asked at most once per variant. The reference must stay valid while the
    /// plan is used.
    std::function<const ProgramInterface&(const ProgramVariant&)> interfaceOf;
    /// True if a stage of the program may write to an image. Asked before anything is compiled.
    std::function<bool(scene::ProgramIndex)> mayWriteImages;
    /// The number of rounds after which the driver ends a shader's loops, 0 if it never does. Asked at most
    /// once, and only if a needed program has long loops. May be empty, which means never.
    std::function<int()> loopLimit{};
    /// Says in words why nothing of the draw is visible; empty if it may be visible or has effects besides
    /// those on its target. Asked at most once per draw, before its program is asked for, and never with
    /// PlanOptions::everything. May be empty.
    std::function<std::string(const scene::Draw& draw, const scene::Pass& pass)> outOfSight{};
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
    // What a frame does with objects, in modern scenes only. Everything begins as declared.
    std::vector<NodeAccess> accesses;  ///< one element per node of `order`
    /// What the nodes write before they clear it.
    std::vector<scene::ObjectView> resets;
    /// What the nodes read and none writes; an earlier frame may have written it.
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

struct PlanOptions {
    std::vector<Override> overrides;
    int maxTextureUnits = 80;  ///< of the driver, all stages together
    int maxImageUnits = 8;     ///< of the driver
    /// What the driver lacks for compute programs and storage buffers, as "OpenGL 4.3; it has 4.1"; empty if
    /// it has them.
    std::string lacksCompute{};
    bool cutsDispatches = false;  ///< compute programs can run in pieces, also without `tiles`
    /// Objects of a modern scene whose content is wanted besides the window.
    std::vector<scene::ObjectView> roots{};
    bool everything = false;    ///< for `glibra check` and --no-skip: skips nothing
    bool reportsNames = true;   ///< false: one of several lists; reportNames() is called with all plans
    bool shareMeshes = true;    ///< false: one mesh per draw
    bool shareTargets = false;  ///< textures may share memory; only `roots` keep their content
};

/// The program that draws it in this pass: its own, or the built-in program if its own lacks a stage.
ProgramVariant variantOf(const scene::Scene& scene, const scene::Draw& draw, const scene::Pass& pass);

/// Plans a node list of the scene: `scene.frame`, or that of a Once or Step block. Scene and list must
/// outlive the plan. Errors are in the diagnostics. A plan with errors is good for a window, which shows the
/// rest, but not for a file: draws with an error are left out, while draws with an unusable program stay in
/// the plan.
FramePlan planFrame(const scene::Scene& scene, const scene::NodeList& nodes, const PlanQuestions& questions,
                    const PlanOptions& options);

/// glib-W23 for `--set` names that no program of the plans has, and glib-W24 for those that are declared but
/// not active. `plans` are those of the scene's frame and of its Once and Step blocks, made with the same
/// overrides. For a program that none of them asked for, or that did not link, only the pairs are known, so a
/// name among them is accepted. Also draw-W11 for textures that are read and never written, and glib-W23 for
/// names of Set that look misspelt: no program has them, one has a name that is near, and all programs of the
/// scene are known.
Diagnostics reportNames(const scene::Scene& scene, std::span<const FramePlan* const> plans,
                        std::span<const Override> overrides);

}  // namespace glibra::plan
