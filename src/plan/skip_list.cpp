#include "plan/skip_list.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstddef>

#include "plan/inputs.h"
#include "plan/texture_uses.h"

namespace glibra::plan {
namespace {

class SkipList {
  public:
    SkipList(const scene::Scene& scene, const Needs& needs, const FramePlan& plan)
        : scene_(scene),
          needs_(needs),
          plan_(plan),
          firstDraws_(scene.shapes.size()),
          hasDraw_(scene.programs.size()),
          programs_(scene.programs.size()),
          textures_(scene.textures.size()),
          files_(scene.files.size()) {}

    std::vector<Skipped> list() && {
        for (std::size_t pass = 0; pass < plan_.nodes->passes.size(); ++pass) addPass(pass);
        addNodes();
        addPrograms();
        addMeshes();
        addTextures();
        addBuffers();
        addFiles();
        return std::move(skipped_);
    }

  private:
    void add(const char* what, std::string why, const Place& place) {
        skipped_.push_back({what, std::move(why), place});
    }

    void useFile(scene::FileIndex file) {
        if (file) files_[file] = true;
    }

    void addPass(std::size_t index) {
        const scene::Pass& pass = plan_.nodes->passes[index];
        if (!needs_.passes[index]) add("pass", pass.isWindow ? clearedAgain() : unseen(pass), pass.place);
        for (std::size_t step = 0; step < pass.steps.size(); ++step) {
            const StepNeed need = needs_.steps[index][step];
            if (const auto* draw = std::get_if<scene::Draw>(&pass.steps[step]))
                addDraw(*draw, {index, step}, need);
            else if (need == StepNeed::coveredByClear)
                add("statement", "Clear: " + clearedAgain(), std::get<scene::Clear>(pass.steps[step]).place);
        }
    }

    void addDraw(const scene::Draw& draw, scene::StepIndex at, StepNeed need) {
        const scene::Draw*& first = firstDraws_[draw.shape];
        if (first == nullptr) first = &draw;
        if (draw.program) hasDraw_[draw.program] = true;
        if (need == StepNeed::coveredByClear) add("draw", draw.word + ": " + clearedAgain(), draw.place);
        if (need == StepNeed::outOfSight)
            add("draw", draw.word + ": " + needs_.outOfSight.at(at), draw.place);
        if (need == StepNeed::drawsNothing)
            add("draw", draw.word + ": it has no size and draws nothing", draw.place);
    }

    void addNodes() {
        for (std::size_t i = 0; i < needs_.dispatches.size(); ++i) {
            const scene::Dispatch& dispatch = plan_.nodes->dispatches[i];
            if (needs_.dispatches[i]) continue;
            add("dispatch",
                fmt::format("'{}': nothing reads what it writes", scene_.programs[dispatch.program].name),
                dispatch.place);
        }
        for (std::size_t i = 0; i < needs_.clears.size(); ++i)
            if (!needs_.clears[i])
                add("statement", "Clear: nothing reads what it clears", plan_.nodes->clears[i].place);
    }

    [[nodiscard]] std::string clearedAgain() const {
        if (needs_.clear.file.empty()) return "it is cleared again";
        return fmt::format("the window is cleared again on line {}", needs_.clear.line);
    }

    /// Why a pass into textures is not needed.
    [[nodiscard]] std::string unseen(const scene::Pass& pass) const {
        std::string names;
        std::vector<scene::TextureIndex> targets = pass.targets;
        if (pass.depth) targets.push_back(pass.depth->texture);
        for (const scene::TextureIndex each : targets)
            if (const std::string& name = scene_.textures[each].name; !name.empty())
                names += fmt::format("{}'{}'", names.empty() ? "" : ", ", name);
        if (names.empty()) return "nothing visible samples its targets";
        return fmt::format("nothing visible reads what it draws into {}", names);
    }

    void addPrograms() {
        for (const PlannedProgram& each : plan_.programs)
            if (each.variant.program) programs_[each.variant.program] = true;
        for (const scene::ProgramIndex i : scene_.programs.indices()) {
            const scene::Program& program = scene_.programs[i];
            if (programs_[i]) {
                for (const scene::StageFile& stage : program.stages) useFile(stage.file);
                continue;
            }
            const bool isWhole =
                (program.hasStage(glsl::Stage::vertex) && program.hasStage(glsl::Stage::fragment)) ||
                (scene_.isModern && program.stages.size() == 1);
            const char* why = !hasDraw_[i] ? "nothing is drawn with it"
                              : !isWhole   ? "it has no vertex or no fragment stage"
                                           : "nothing visible is drawn with it";
            add("program", fmt::format("'{}': {}", program.name, why), program.place);
        }
    }

    void addMeshes() {
        scene::List<const PlannedMesh*, scene::Shape> planned(scene_.shapes.size());
        scene::List<int, scene::Shape> meshes(scene_.shapes.size());  // two if one has adjacency
        for (const PlannedMesh& mesh : plan_.meshes) {
            planned[mesh.shape] = &mesh;
            ++meshes[mesh.shape];
        }
        scene::List<int, scene::Shape> draws(scene_.shapes.size());  // that are planned
        plan_.visitDraws([&](const auto&, const scene::Draw& draw, const auto&) { ++draws[draw.shape]; });
        std::vector<Skipped> attributes;
        for (const scene::ShapeIndex i : scene_.shapes.indices()) {
            const std::string word = firstDraws_[i] != nullptr ? firstDraws_[i]->word : std::string("shape");
            const Place place = firstDraws_[i] != nullptr ? firstDraws_[i]->place : Place{};
            const bool isOfOtherList =
                firstDraws_[i] == nullptr && !(scene_.once.empty() && scene_.steps.empty());
            if (planned[i] == nullptr && isOfOtherList) continue;
            if (planned[i] == nullptr) {
                add("mesh", word + ": nothing visible draws it", place);
                continue;
            }
            useFile(scene_.shapes[i].file);
            if (draws[i] > 1 && meshes[i] == 1)
                add("mesh", fmt::format("{}: one mesh serves all its {} draws", word, draws[i]), place);
            for (const std::string& attribute : attributesOf(scene_.shapes[i]))
                // Few models have colours.
                if (std::ranges::find(planned[i]->attributes, attribute) == planned[i]->attributes.end() &&
                    (scene_.shapes[i].list != nullptr || attribute != geometry::kColor))
                    attributes.push_back(
                        {"attribute", fmt::format("{} of {}: no program reads it", attribute, word), place});
        }
        skipped_.insert(skipped_.end(), attributes.begin(), attributes.end());
    }

    void addTextures() {
        for (const scene::TextureIndex each : plan_.textures) textures_[each] = true;
        for (const scene::TextureIndex i : scene_.textures.indices()) {
            const scene::Texture& texture = scene_.textures[i];
            const auto* picture = std::get_if<scene::PictureSource>(&texture.source);
            const auto* noise = std::get_if<scene::NoiseSource>(&texture.source);
            if (textures_[i]) {
                if (picture != nullptr)
                    for (const scene::FileIndex file : picture->files) useFile(file);
                if (noise != nullptr) useFile(noise->file);
                continue;
            }
            const std::string which = texture.name.empty() ? "unit " + slotText(texture.unit, texture.target)
                                                           : fmt::format("'{}'", texture.name);
            add(noise != nullptr ? "noise texture" : "texture", which + ": no active sampler reads it",
                texture.place);
        }
    }

    void addBuffers() {
        scene::List<bool, scene::Buffer> used(scene_.buffers.size());
        for (const scene::BufferIndex each : plan_.buffers) used[each] = true;
        for (const scene::BufferIndex i : scene_.buffers.indices()) {
            const scene::Buffer& buffer = scene_.buffers[i];
            if (used[i])
                useFile(buffer.file);
            else
                add("buffer", fmt::format("'{}': nothing reads it", buffer.name), buffer.place);
        }
    }

    void addFiles() {
        for (const scene::FileIndex i : scene_.files.indices())
            if (!files_[i])
                add("file", fmt::format("'{}': nothing visible needs it", scene_.files[i].name),
                    scene_.files[i].place);
    }

    const scene::Scene& scene_;
    const Needs& needs_;
    const FramePlan& plan_;
    scene::List<const scene::Draw*, scene::Shape> firstDraws_;  ///< first draw of each shape
    scene::List<bool, scene::Program> hasDraw_;                 ///< some draw has the program, visible or not
    // Used by the plan:
    scene::List<bool, scene::Program> programs_;
    scene::List<bool, scene::Texture> textures_;
    scene::List<bool, scene::FileReference> files_;
    std::vector<Skipped> skipped_;
};

}  // namespace

std::vector<Skipped> listSkipped(const scene::Scene& scene, const Needs& needs, const FramePlan& plan) {
    return SkipList(scene, needs, plan).list();
}

}  // namespace glibra::plan
