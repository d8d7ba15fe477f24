#pragma once
// The inputs of planFrame() (planner.h): options, limits of the driver, and what is known of programs and
// meshes. A program is compiled and a mesh made only if something visible needs it, and what is visible
// depends on the programs and meshes before: so a plan that lacks something asks for it, and is made again
// with the answers.

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "plan/overrides.h"
#include "plan/program_variant.h"
#include "scene/scene.h"

namespace glibra::plan {

/// What is known of the sight of draws.
class Sight {
  public:
    /// `why` nothing of the draw is visible; an empty text if it may be visible or has effects besides those
    /// on its target.
    void add(const scene::StepIndex& at, const std::string& why) {
        if (known_.size() <= at.pass) known_.resize(at.pass + 1);
        std::vector<std::uint8_t>& pass = known_[at.pass];
        if (pass.size() <= at.step) pass.resize(std::max(at.step + 1, 2 * pass.size()));
        const auto same = std::ranges::find(reasons_, why);
        pass[at.step] = static_cast<std::uint8_t>(same - reasons_.begin() + 1);
        if (same == reasons_.end()) reasons_.push_back(why);
    }
    /// What add() was given; null: nothing.
    [[nodiscard]] const std::string* find(const scene::StepIndex& at) const {
        const bool isKnown = at.pass < known_.size() && at.step < known_[at.pass].size();
        const std::size_t reason = isKnown ? known_[at.pass][at.step] : 0;
        return reason == 0 ? nullptr : &reasons_[reason - 1];
    }

  private:
    std::vector<std::vector<std::uint8_t>> known_;  ///< by pass and step: a reason, from 1; 0: not known
    std::vector<std::string> reasons_;              ///< few
};

/// What is known when a plan is made. Nothing need be known at first.
struct Answers {
    std::map<ProgramVariant, const ProgramInterface*> interfaces;  ///< they must outlive the plan
    /// True if a stage of the program may write to an image, a storage block or an atomic counter.
    std::map<scene::ProgramIndex, bool> writers;
    /// The rounds after which the driver ends a shader's loops, 0 if it never does.
    std::optional<int> loopLimit;
    Sight sight;
    bool seesAll = false;    ///< no draw is out of sight, so that nobody asks
    bool asksAhead = false;  ///< for draws, too, that are not needed if others are out of sight
};

/// What a plan cannot be made without, each once. Programs are asked for from the last pass to the first, and
/// after the sight of what they draw.
struct Questions {
    std::vector<ProgramVariant> interfaces;
    std::vector<scene::ProgramIndex> writers;
    bool loopLimit = false;  ///< only if a needed program has long loops
    std::vector<scene::StepIndex> unseen;

    [[nodiscard]] bool isEmpty() const {
        return interfaces.empty() && writers.empty() && !loopLimit && unseen.empty();
    }
};

struct PlanOptions {
    std::vector<Override> overrides;
    int maxTextureUnits = 80;   ///< of the driver, all stages together
    int maxImageUnits = 8;      ///< of the driver
    bool clipsFromZero = true;  ///< the driver can, so that reversed depth is exact
    /// What the driver lacks for compute programs and storage buffers, as "OpenGL 4.3; it has 4.1"; empty if
    /// it has them.
    std::string lacksCompute{};
    bool cutsDispatches = false;  ///< compute programs can run in pieces, also without `tiles`
    /// Objects whose content is wanted besides the window.
    std::vector<scene::ObjectView> roots{};
    bool everything = false;    ///< for `glibra check` and --no-skip: skips nothing
    bool idleNoise = true;      ///< with `everything`: also built-in noise that no sampler reads
    bool reportsNames = true;   ///< false: one of several lists; reportNames() is called with all plans
    bool shareMeshes = true;    ///< false: one mesh per draw
    bool shareTargets = false;  ///< textures may share memory; only `roots` keep their content
};

}  // namespace glibra::plan
