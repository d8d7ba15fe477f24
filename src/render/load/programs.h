#pragma once
// Turns Program statements into linked GL programs. A program is made when a plan asks for it and kept by
// variant.

#include <glibra/render.h>

#include <array>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "glsl/emit/emit.h"
#include "glsl/es/additions.h"
#include "glsl/types/request.h"
#include "gpu/context/context.h"
#include "gpu/object/buffer.h"
#include "gpu/object/program.h"
#include "plan/frame_plan.h"
#include "render/load/program_sources.h"
#include "render/load/shared_parts.h"
#include "render/stats.h"
#include "scene/scene.h"

namespace glibra::render {

/// The value of an element of a uniform after linking.
struct InitialValue {
    plan::UniformIndex uniform{};
    int element = 0;
    std::vector<double> values;
};

/// A program of the driver and what it reads.
struct BuiltProgram {
    std::optional<gpu::Program> program;  ///< nothing if it failed to translate, compile or link
    plan::ProgramInterface interface;
    std::string key;          ///< from translated sources and tags; programs with equal keys are equal
    Diagnostics remarks;      ///< the compiler's diagnostics of those sources
    bool isLastGood = false;  ///< the current sources fail; this program is of an earlier state
    std::vector<InitialValue>
        initialValues;  ///< if draws of the scene set values of their own; otherwise empty
    mutable const void* literalsOf =
        nullptr;  ///< the part of a FrameDrawer whose constants the uniforms have; null: none
    /// The first group of the piece of a dispatch and the groups of the whole, as the uniforms say them.
    mutable std::optional<std::array<std::array<std::uint64_t, 3>, 2>> piece;
    /// With RenderOptions::checkUndefined: what facts.undefinedSites count; of a loop counter: which of
    /// facts.loopSites the driver has ended. And where it is bound.
    std::optional<gpu::Buffer> record{};
    unsigned recordBinding = 0;
    /// The program with ProgramRequest::recordsLoops, which makes the same and stores in the same places.
    /// countLoops() makes it; null: none.
    std::unique_ptr<BuiltProgram> loopCounter{};
    /// Of a program with guarded loops (glsl/es/additions.h): what FrameDrawer::tryLoops() has found.
    struct Tried {
        int rounds = glsl::kMostRounds;  ///< that the loops may have
        int site = 0;                    ///< of facts.loopSites, from 1 on: the loop that these end; 0: none
        double pixels = 0;               ///< of the target
    };
    mutable Tried tried{};
    std::vector<glsl::TranslatedStage> refused;  ///< the stages, if the driver refused them
};

class ProgramLibrary {
  public:
    /// `tiled`: makes programs that can draw a part of a larger picture. `shared`: programs of other scenes,
    /// or null; the library borrows from it, and its destructor gives the programs back.
    ProgramLibrary(const gpu::Context& context, const scene::Scene& scene, const RenderOptions& options,
                   bool tiled, Stats& stats, SharedParts* shared = nullptr);
    ProgramLibrary(const ProgramLibrary&) = delete;
    ProgramLibrary& operator=(const ProgramLibrary&) = delete;
    ~ProgramLibrary();

    /// Sets the library of the scene before it was read again; it must exist until forgetPrevious().
    /// interfaceOf takes unchanged programs from it, and the last good state of programs that now fail.
    void inherit(ProgramLibrary& previous) { previous_ = &previous; }
    void forgetPrevious() { previous_ = nullptr; }
    /// Every file that was read for a program, including #include files.
    [[nodiscard]] std::vector<std::filesystem::path> filesRead() const { return sources_.filesRead(); }
    [[nodiscard]] const std::set<std::filesystem::path>& filesMissing() const {
        return sources_.filesMissing();
    }
    /// How the program places its vertices. This translates the program but does not compile it.
    glsl::Placement placementOf(const plan::ProgramVariant& variant);
    /// The translation; null if a source is missing.
    const glsl::TranslatedProgram* translated(const plan::ProgramVariant& variant) {
        return translationOf(variant).program.get();
    }
    /// True if the variant may read tangents.
    bool mayReadTangents(const plan::ProgramVariant& variant);
    /// The translation of a source line, from the first stage that has the line in a program that the driver
    /// refused. Empty if no refused program has it.
    [[nodiscard]] std::vector<glsl::EmittedLine> refusedLines(const Place& place) const;
    /// Translates, compiles and links the program at the first call for a variant.
    const plan::ProgramInterface& interfaceOf(const plan::ProgramVariant& variant);
    /// The program that interfaceOf has made; null before its first call for the variant.
    [[nodiscard]] const BuiltProgram* find(const plan::ProgramVariant& variant) const;
    /// From now on interfaceOf() and find() give another program in place of one that find() has given: its
    /// fragment stage does more. Returns false, and changes nothing, if the driver does not link it.
    bool observe(const BuiltProgram& program, const glsl::MainWrapper& fragment);
    void stopObserving() { observed_.reset(); }
    /// What the programs did since the last call that GLSL leaves undefined: glsl-W29 ... W32.
    Diagnostics takeUndefined();
    /// Makes BuiltProgram::loopCounter of the planned programs with open loops, if the driver has means for
    /// it.
    void countLoops(const plan::FramePlan& plan);
    /// The loops of programs with a counter that the driver has ended since the last call, after `limit`
    /// rounds: draw-W08, once for each place.
    Diagnostics takeCutLoops(int limit);
    void forgetCutLoops() { cutLoops_.clear(); }
    /// The invocations of compute programs that are made from now on run in reverse.
    void reverseOrder() { isReversed_ = true; }
    [[nodiscard]] bool isReversed() const { return isReversed_; }
    /// ProgramSources::hiddenSource; it is known after interfaceOf.
    [[nodiscard]] std::string hiddenSource(scene::ProgramIndex program) const {
        return sources_.hiddenSource(program);
    }
    /// ProgramSources::hideTexts, likewise.
    void hideTexts(scene::ProgramIndex program, Diagnostics& diagnostics) const {
        sources_.hideTexts(program, diagnostics);
    }
    /// True if the program may write to an image, a storage block or an atomic counter.
    bool mayWriteImages(scene::ProgramIndex program);

  private:
    /// A translated program; null if a source is missing, with the reasons in `diagnostics`.
    struct Translation {
        std::shared_ptr<const glsl::TranslatedProgram> program;
        Diagnostics diagnostics;
    };
    const Translation& translationOf(const plan::ProgramVariant& variant);
    /// In the language of the driver.
    [[nodiscard]] glsl::TranslatedProgram translationFor(const glsl::ProgramRequest& asked) const;
    std::shared_ptr<const glsl::TranslatedProgram> translate(glsl::ProgramRequest asked);
    bool borrow(const plan::ProgramVariant& variant, BuiltProgram& built);
    [[nodiscard]] glsl::ProgramRequest request(const plan::ProgramVariant& variant, Diagnostics& diagnostics);
    void build(const plan::ProgramVariant& variant, BuiltProgram& built);
    [[nodiscard]] std::string keyOf(const plan::ProgramVariant& variant,
                                    const glsl::TranslatedProgram& translated) const;
    /// The program's name, and its index among the programs of that name.
    [[nodiscard]] std::pair<int, std::string> identityOf(const plan::ProgramVariant& variant) const;
    /// Separates the block of that name, in which the program records in `numbers` numbers what happens, from
    /// those of the scene.
    static void takeRecord(const char* block, std::size_t numbers, BuiltProgram& built,
                           Diagnostics& diagnostics);
    BuiltProgram* earlierByKey(const std::string& key);
    BuiltProgram* lastGoodOf(const plan::ProgramVariant& variant);
    bool compile(const plan::ProgramVariant& variant, const glsl::TranslatedProgram& translated,
                 BuiltProgram& built, Diagnostics& diagnostics);

    const gpu::Context& context_;
    const scene::Scene& scene_;
    const RenderOptions& options_;
    bool tiled_;
    Stats& stats_;
    SharedParts* shared_;
    ProgramLibrary* previous_ = nullptr;
    ProgramSources sources_;
    std::vector<std::pair<plan::ProgramVariant, std::unique_ptr<Translation>>> translations_;
    using KnownProgram = std::pair<plan::ProgramVariant, std::unique_ptr<BuiltProgram>>;
    std::vector<KnownProgram> programs_;
    std::optional<KnownProgram> observed_;
    Diagnostics cutLoops_;  ///< that were reported
    bool isReversed_ = false;
};

}  // namespace glibra::render
