#pragma once
// Which parts of a Scene have to be made and drawn for one picture, how, and why the rest is not. No GL:
// programs are asked for through a function, so that only those which something visible needs are ever
// compiled.

#include <functional>
#include <string>
#include <variant>
#include <vector>

#include "plan/program_interface.h"
#include "plan/uniforms.h"
#include "scene/scene.h"

namespace glibra::plan {

/// The same Program statement may need several GL programs: flat or smooth colours, one or several colour
/// targets.
struct ProgramVariant {
    scene::ProgramIndex program{};  ///< none: the built-in program
    bool flatColors = false;
    int colorTargets = 1;
    friend bool operator==(const ProgramVariant&, const ProgramVariant&) = default;
};

/// Called at most once for each variant, in the order of need. The reference must stay valid while the plan
/// is used.
using InterfaceOf = std::function<const ProgramInterface&(const ProgramVariant&)>;
/// True if any stage source of the program could write to an image (asked before anything is compiled).
using MayWriteImages = std::function<bool(scene::ProgramIndex)>;

struct TextureUse {
    UniformIndex uniform{};
    int element = 0;
    int driverUnit = 0;             ///< texture image unit (or image unit) of GL that the plan chose
    scene::TextureIndex texture{};  ///< none: an empty slot, which reads (0, 0, 0, 1)
    scene::TextureTarget target = scene::TextureTarget::texture2D;
    bool clamp = false;  ///< repeat otherwise
    bool isImage = false;
};

/// How the mesh is submitted (language, 4.8).
struct Submission {
    geometry::Topology topology = geometry::Topology::triangles;
    int patchVertices = 0;
};

struct PlannedProgram {
    ProgramVariant variant;
    const ProgramInterface* interface = nullptr;
    std::vector<UniformBinding> values;  ///< literals and supplied values
    std::vector<Control> controls;
};

/// A mesh to make, and the attributes of it that some program reads.
struct PlannedMesh {
    scene::ShapeIndex shape{};
    std::vector<std::string> attributes;  ///< geometry's names, in the order of its constants
};

// Indices into the lists of FramePlan.
using PlannedProgramIndex = scene::Index<PlannedProgram>;
using PlannedMeshIndex = scene::Index<PlannedMesh>;

struct PlannedDraw {
    const scene::Draw* draw = nullptr;
    PlannedProgramIndex program{};
    PlannedMeshIndex mesh{};
    Submission submission;
    std::vector<TextureUse> textures;
};

struct PlannedPass {
    const scene::Pass* pass = nullptr;
    std::vector<std::variant<PlannedDraw, const scene::Clear*>> steps;
};

/// Something that is not done, for --explain and --stats.
struct Skipped {
    std::string what;  ///< "texture", "noise texture", "attribute", "mesh", "program", "pass", "draw",
                       ///< "statement", "file"
    std::string why;   ///< which one, and why: "unit 5 / 3D: no active sampler reads it"
    Place place;
};

struct FramePlan {
    std::vector<PlannedPass> passes;
    scene::List<PlannedProgram> programs;
    scene::List<PlannedMesh> meshes;
    std::vector<scene::TextureIndex> textures;  ///< those that must exist: sources and targets
    std::vector<Skipped> skipped;
    Diagnostics diagnostics;  ///< draw-E.., draw-W.., those of needed programs and uniforms
};

struct PlanOptions {
    std::vector<Override> overrides;
    int maxTextureUnits = 80;  ///< of the driver, all stages together
    int maxImageUnits = 8;     ///< of the driver
    /// Rounds after which the driver ends a shader's loops, 0: never. Asked at most once, and only if a
    /// needed program has long ones. Empty: never.
    std::function<int()> loopLimit{};
    bool everything = false;  ///< glibra check, --no-skip: skip nothing
    bool shareMeshes = true;  ///< false: a mesh for each draw
    /// Why nothing of the draw can be seen, in words; empty: perhaps it can, or it has other effects than on
    /// its target. Asked at most once for each draw, before its program is; not asked with `everything`.
    std::function<std::string(const scene::Draw& draw, const scene::Pass& pass)> outOfSight{};
};

/// The program that draws it in this pass: its own, or the built-in one if that lacks a stage.
ProgramVariant variantOf(const scene::Scene& scene, const scene::Draw& draw, const scene::Pass& pass);

/// Plans one frame of the scene, which must outlive the plan. Errors are in the diagnostics; a picture of a
/// plan with errors is not to be kept, but a window may show the rest: draws with an error of their own are
/// left out, those of an unusable program are in it.
FramePlan planFrame(const scene::Scene& scene, const InterfaceOf& interfaceOf,
                    const MayWriteImages& mayWriteImages, const PlanOptions& options);

}  // namespace glibra::plan
