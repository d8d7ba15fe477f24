#pragma once
// Program statements to linked GL programs, made when a plan asks for them and kept by variant.

#include <glibra/render.h>

#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "gpu/context.h"
#include "gpu/program.h"
#include "gpu/reflection.h"
#include "plan/frame_plan.h"
#include "render/stats.h"
#include "scene/scene.h"

namespace glibra::render {

/// A program of the driver with its two descriptions: `reflected` is GL's, `interface` the plan's. Their
/// uniforms, blocks and inputs stand in the same order.
struct BuiltProgram {
    std::optional<gpu::Program> program;  ///< nothing if it did not translate, compile or link
    gpu::ProgramInterface reflected;
    plan::ProgramInterface interface;
};

class ProgramLibrary {
  public:
    /// `tiled`: programs are made so that a part of a larger picture can be drawn.
    ProgramLibrary(const gpu::Context& context, const scene::Scene& scene, const RenderOptions& options,
                   bool tiled, Stats& stats);

    /// Translates, compiles and links at the first call for a variant.
    const plan::ProgramInterface& interfaceOf(const plan::ProgramVariant& variant);
    /// What interfaceOf has made; null for a variant never asked for.
    [[nodiscard]] const BuiltProgram* find(const plan::ProgramVariant& variant) const;
    /// True if any source of the program names an image function.
    bool mayWriteImages(int program);

  private:
    /// A shader file as read, or the diagnostics that prevented it.
    struct SourceFile {
        std::optional<std::string> text;
        std::string path;
        Diagnostics diagnostics;
    };
    const SourceFile& sourceFile(int file);
    [[nodiscard]] glsl::ProgramRequest request(const plan::ProgramVariant& variant, Diagnostics& diagnostics);
    [[nodiscard]] std::vector<glsl::SamplerKind> samplerKinds(int program, std::string_view tag) const;
    void build(const plan::ProgramVariant& variant, BuiltProgram& built);

    const gpu::Context& context_;
    const scene::Scene& scene_;
    const RenderOptions& options_;
    bool tiled_;
    Stats& stats_;
    std::map<int, SourceFile> sources_;
    std::vector<std::pair<plan::ProgramVariant, std::unique_ptr<BuiltProgram>>> programs_;
};

/// GL's description in the plan's terms: the user's own names, targets that scenes can fill.
plan::ProgramInterface describe(const gpu::ProgramInterface& reflected, glsl::TranslatedProgram facts);

}  // namespace glibra::render
