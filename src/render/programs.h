#pragma once
// Program statements to linked GL programs, made when a plan asks for them and kept by variant.

#include <glibra/render.h>

#include <filesystem>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "glsl/emit/emitted_lines.h"
#include "glsl/types/request.h"
#include "gpu/context.h"
#include "gpu/program.h"
#include "gpu/reflection.h"
#include "plan/frame_plan.h"
#include "render/shared_parts.h"
#include "render/stats.h"
#include "scene/scene.h"

namespace glibra::render {

/// A program of the driver with its two descriptions: `reflected` is GL's, `interface` the plan's. Their
/// uniforms, blocks and inputs stand in the same order.
struct BuiltProgram {
    std::optional<gpu::Program> program;  ///< nothing if it did not translate, compile or link
    gpu::ProgramInterface reflected;
    plan::ProgramInterface interface;
    std::string key;          ///< its translated sources and its tags: equal keys, equal programs
    Diagnostics remarks;      ///< what the compiler said of those sources
    bool isLastGood = false;  ///< the sources as they are now fail; this is an earlier state of them
    std::vector<glsl::TranslatedStage> refused;  ///< what the driver did not take; empty if it took them
};

class ProgramLibrary {
  public:
    /// `tiled`: programs are made so that a part of a larger picture can be drawn. `shared`: programs that
    /// other scenes needed, or null; they are borrowed from there, and what was built goes there in the end.
    ProgramLibrary(const gpu::Context& context, const scene::Scene& scene, const RenderOptions& options,
                   bool tiled, Stats& stats, SharedParts* shared = nullptr);
    ProgramLibrary(const ProgramLibrary&) = delete;
    ProgramLibrary& operator=(const ProgramLibrary&) = delete;
    ~ProgramLibrary();

    /// What the scene had before it was read again, with a scene that is still there. interfaceOf takes
    /// programs from it that are still the same, and for those that now fail the last good state;
    /// forgetPrevious() ends that.
    void inherit(ProgramLibrary& previous) { previous_ = &previous; }
    void forgetPrevious() { previous_ = nullptr; }
    /// Every file that was read for a program, includes among them.
    [[nodiscard]] std::vector<std::filesystem::path> filesRead() const;
    /// How the program places its vertices; it is translated for that, not compiled.
    glsl::Placement placementOf(const plan::ProgramVariant& variant);
    /// The translation; null if a source is missing.
    const glsl::TranslatedProgram* translated(const plan::ProgramVariant& variant) {
        return translationOf(variant).program.get();
    }
    /// True if the variant may read tangents.
    bool mayReadTangents(const plan::ProgramVariant& variant);
    /// What became of that line of a source in the programs that the driver refused: of the first stage that
    /// has the line. Nothing if no refused program has it.
    [[nodiscard]] std::vector<glsl::EmittedLine> refusedLines(const Place& place) const;
    /// Translates, compiles and links at the first call for a variant.
    const plan::ProgramInterface& interfaceOf(const plan::ProgramVariant& variant);
    /// What interfaceOf has made; null for a variant never asked for.
    [[nodiscard]] const BuiltProgram* find(const plan::ProgramVariant& variant) const;
    /// True if any source of the program names an image function.
    bool mayWriteImages(scene::ProgramIndex program);

  private:
    /// A shader file as read, or the diagnostics that prevented it.
    struct SourceFile {
        std::optional<std::string> text;
        std::string path;
        Diagnostics diagnostics;
    };
    /// Null if a source is missing, for the reasons given.
    struct Translation {
        std::shared_ptr<const glsl::TranslatedProgram> program;
        Diagnostics diagnostics;
    };
    const SourceFile& sourceFile(scene::FileIndex file);
    const Translation& translationOf(const plan::ProgramVariant& variant);
    std::shared_ptr<const glsl::TranslatedProgram> translate(glsl::ProgramRequest asked);
    bool borrow(const plan::ProgramVariant& variant, BuiltProgram& built);
    [[nodiscard]] glsl::ProgramRequest request(const plan::ProgramVariant& variant, Diagnostics& diagnostics);
    [[nodiscard]] std::vector<glsl::SamplerKind> samplerKinds(scene::ProgramIndex program,
                                                              std::string_view tag) const;
    void build(const plan::ProgramVariant& variant, BuiltProgram& built);
    [[nodiscard]] std::string keyOf(const plan::ProgramVariant& variant,
                                    const glsl::TranslatedProgram& translated) const;
    /// Which of the programs of the same name it is, and the name.
    [[nodiscard]] std::pair<int, std::string> identityOf(const plan::ProgramVariant& variant) const;
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
    std::map<scene::FileIndex, SourceFile> sources_;
    std::set<std::filesystem::path> included_;
    std::vector<std::pair<plan::ProgramVariant, std::unique_ptr<Translation>>> translations_;
    std::vector<std::pair<plan::ProgramVariant, std::unique_ptr<BuiltProgram>>> programs_;
};

/// GL's description in the plan's terms: the user's own names, targets that scenes can fill.
plan::ProgramInterface describe(const gpu::ProgramInterface& reflected, glsl::TranslatedProgram facts);

}  // namespace glibra::render
