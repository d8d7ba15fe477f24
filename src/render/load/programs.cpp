#include "render/load/programs.h"

#include <fmt/format.h>

#include <embedded/builtin_shaders.h>
#include <algorithm>
#include <utility>

#include "glsl/emit/log.h"
#include "glsl/facts/stage_variables.h"
#include "gpu/object/reflection.h"
#include "gpu/object/uniform.h"
#include "image/file.h"
#include "plan/accesses.h"
#include "render/load/bounded_filter.h"
#include "render/load/gl_names.h"
#include "render/load/hidden_text.h"
#include "scene/file_lookup.h"

namespace glibra::render {
namespace {

/// The bytes as text, without a UTF-8 byte order mark.
std::string asText(const std::vector<std::byte>& bytes) {
    std::string text(reinterpret_cast<const char*>(bytes.data()), bytes.size());
    if (text.starts_with("\xEF\xBB\xBF")) text.erase(0, 3);
    return text;
}

glsl::Target glslTargetOf(const gpu::Capabilities& capabilities) {
    glsl::Target target;
    target.version = std::clamp(capabilities.glslVersion, 410, 450);
    target.lineDirectiveTakesFileName = capabilities.hasExtension("GL_ARB_shading_language_include");
    target.maxGeometryOutputVertices = capabilities.maxGeometryOutputVertices;
    target.maxGeometryTotalOutputComponents = capabilities.maxGeometryTotalOutputComponents;
    target.hasExtension = [&capabilities](std::string_view name) {
        // Without OpenGL 4.3 there is nothing to bind storage with, and without 4.2 no images, whatever
        // shaders may say.
        const bool isStorage =
            name == "GL_ARB_shader_storage_buffer_object" || name == "GL_ARB_shader_atomic_counters";
        const bool isImage = name == "GL_ARB_shader_image_load_store";
        return capabilities.hasExtension(name) && (capabilities.compute || !isStorage) &&
               (capabilities.atLeast(4, 2) || !isImage);
    };
    return target;
}

glsl::SamplerKind samplerKind(scene::TextureTarget target) {
    switch (target) {
        case scene::TextureTarget::texture1D:
            return glsl::SamplerKind::sampler1D;
        case scene::TextureTarget::texture2D:
        case scene::TextureTarget::texture1DArray:  // these are never on a unit
        case scene::TextureTarget::texture2DArray:
        case scene::TextureTarget::cubeArray:
        case scene::TextureTarget::rectangle:
            return glsl::SamplerKind::sampler2D;
        case scene::TextureTarget::texture3D:
            return glsl::SamplerKind::sampler3D;
        case scene::TextureTarget::cube:
            break;
    }
    return glsl::SamplerKind::samplerCube;
}

/// The name that the user wrote. An emitted name may be "glibra_x" or "block.glibra_x[2].glibra_y", and the
/// translator may have renamed any part of it.
std::string userName(const std::string& emitted, const glsl::TranslatedProgram& facts) {
    if (const auto whole = facts.userNames.find(emitted); whole != facts.userNames.end())
        return whole->second;
    std::string name;
    for (std::size_t begin = 0; begin < emitted.size();) {
        const std::size_t end = std::min(emitted.find_first_of(".[]", begin), emitted.size());
        const std::string part = emitted.substr(begin, end - begin);
        const auto renamed = facts.userNames.find(part);
        name += renamed == facts.userNames.end() ? part : renamed->second;
        if (end < emitted.size()) name += emitted[end];
        begin = end + 1;
    }
    return name;
}

/// The values of all uniforms of the default block, which no draw has set yet.
std::vector<InitialValue> initialValues(const BuiltProgram& built) {
    std::vector<InitialValue> values;
    for (std::size_t i = 0; i < built.interface.uniforms.size(); ++i) {
        const base::ActiveUniform& uniform = built.interface.uniforms[i];
        const bool isOpaque =
            uniform.type.base == base::BaseType::sampler || uniform.type.base == base::BaseType::image;
        if (uniform.block >= 0 || isOpaque) continue;
        for (int element = 0; element < std::max(1, uniform.arraySize); ++element)
            values.push_back(
                {plan::UniformIndex(i), element, gpu::getUniform(*built.program, uniform, element)});
    }
    return values;
}

/// The active outputs of the fragment stage by its text, for drivers that do not list them.
std::vector<base::ActiveOutput> declaredOutputs(const glsl::TranslatedProgram& translated,
                                                const gpu::Program& program) {
    std::vector<base::ActiveOutput> outputs;
    for (const glsl::TranslatedStage& stage : translated.stages) {
        if (stage.stage != glsl::Stage::fragment) continue;
        for (const glsl::StageVariable& each : glsl::stageVariables(stage, translated.userNames)) {
            const int location = each.isOutput ? gpu::outputLocation(program, each.expression) : -1;
            if (location < 0) continue;
            const bool isInteger = each.type.starts_with('i'), isUnsigned = each.type.starts_with('u');
            base::ValueType type{.word = each.type};
            type.rows = each.components();
            if (isInteger) type.base = base::BaseType::integer;
            if (isUnsigned) type.base = base::BaseType::unsignedInteger;
            outputs.push_back({each.expression, location, type, std::max(1, each.elements)});
        }
    }
    return outputs;
}

/// Completes the interface of a program that was linked, or failed.
void completeInterface(BuiltProgram& built, glsl::TranslatedProgram facts, bool isBuiltin) {
    for (base::ActiveUniform& each : built.interface.uniforms) each.name = userName(each.emittedName, facts);
    built.interface.facts = std::move(facts);
    built.interface.usable = built.program.has_value();
    built.interface.isBuiltin = isBuiltin;
}

}  // namespace

ProgramLibrary::ProgramLibrary(const gpu::Context& context, const scene::Scene& scene,
                               const RenderOptions& options, bool tiled, Stats& stats, SharedParts* shared)
    : context_(context),
      scene_(scene),
      options_(options),
      tiled_(tiled),
      stats_(stats),
      shared_(shared),
      shown_(scene::shownRoots(scene::searchFolders(scene.path, {.libraryRoots = options.libraryRoots}))) {}

void ProgramLibrary::noteIfHidden(scene::ProgramIndex program, const std::string& file) {
    if (!shown_.contains(file)) hidden_.emplace(program, file);
}

std::string ProgramLibrary::hiddenSource(scene::ProgramIndex program) const {
    const auto found = hidden_.find(program);
    return found == hidden_.end() ? std::string() : found->second;
}

void ProgramLibrary::hideTexts(scene::ProgramIndex program, Diagnostics& diagnostics) const {
    const std::string hidden = hiddenSource(program);
    if (hidden.empty()) return;
    HiddenWords words;
    const auto add = [&](const std::string& file, const std::string& text) {
        if (shown_.contains(file))
            words.addShown(text);
        else
            words.addHidden(text);
    };
    for (const auto& [index, source] : sources_)
        if (source.text) add(source.path, *source.text);
    for (const auto& [path, text] : included_) add(path.string(), text);
    const std::string why = fmt::format(
        "'{}', which lies outside of the scene's folder and the library; add its folder to GLIBRA_PATH",
        hidden);
    for (Diagnostic& each : diagnostics) {
        // Messages about finding and opening a file name the file and nothing else.
        if (each.id.starts_with("file-")) continue;
        if (!each.place.file.empty() && !shown_.contains(each.place.file)) {
            each.text = fmt::format("{}, because it may quote {}", kHiddenText, why);
        } else if (std::string text = words.removedFrom(each.text); text != each.text) {
            each.text = fmt::format("{} (\"...\" stands for words of {})", text, why);
        }
    }
}

const ProgramLibrary::SourceFile& ProgramLibrary::sourceFile(scene::FileIndex file) {
    const auto [entry, isNew] = sources_.try_emplace(file);
    SourceFile& source = entry->second;
    if (!isNew) return source;
    const scene::FileReference& reference = scene_.files[file];
    source.diagnostics = reference.remarks;
    source.path = reference.path.string();
    if (reference.text) source.text = reference.text;
    if (reference.path.empty() || reference.text) return source;
    if (const auto edited = options_.texts.find(reference.path); edited != options_.texts.end()) {
        source.text = edited->second;
        return source;
    }
    stats_.add("files read", 1);
    auto bytes = image::readFile(reference.path, {reference.name, reference.place}, kLargestSource);
    append(source.diagnostics, std::move(bytes.diagnostics));
    if (bytes) source.text = asText(*bytes);
    return source;
}

std::vector<glsl::SamplerKind> ProgramLibrary::samplerKinds(scene::ProgramIndex program,
                                                            std::string_view tag) const {
    std::vector<glsl::SamplerKind> kinds;
    int unit = 0;
    for (const glib::UniformSpec& each : scene_.programs[program].uniforms)
        if (each.tag == tag && !each.values.empty()) unit = static_cast<int>(each.values.front());
    for (const scene::Texture& each : scene_.textures) {
        if (each.unit != unit) continue;
        const glsl::SamplerKind kind = samplerKind(each.target);
        if (std::find(kinds.begin(), kinds.end(), kind) == kinds.end()) kinds.push_back(kind);
    }
    return kinds;
}

glsl::ProgramRequest ProgramLibrary::request(const plan::ProgramVariant& variant, Diagnostics& diagnostics) {
    glsl::ProgramRequest request;
    request.target = glslTargetOf(context_.capabilities());
    request.flatColors = variant.flatColors;
    request.colorTargets = variant.colorTargets;
    request.tiled = tiled_;
    request.inPieces = variant.inPieces;
    if (!variant.program) {
        request.name = "built-in";
        request.stages = {{glsl::Stage::vertex, "flat.vert", std::string(builtin_shaders::flat_vert())},
                          {glsl::Stage::fragment, "flat.frag", std::string(builtin_shaders::flat_frag())}};
        return request;
    }
    const scene::Program& program = scene_.programs[variant.program];
    request.name = program.name;
    request.place = program.place;
    request.shim = options_.shim;
    request.checksUndefined = options_.checkUndefined;
    request.suppliesFullScreenVertex = variant.isFullScreen;
    request.suppliesFragment = variant.suppliesFragment && options_.shim;
    request.suppliesFixedVertex = !variant.isFullScreen && options_.shim;
    request.hasLights = scene_.isModern;
    request.setsLights = scene_.setsLights;
    request.acceptsStorage = scene_.isModern;
    request.geometryInput = program.geometryInput;
    request.geometryOutput = program.geometryOutput;
    request.geometryVerticesOut = program.geometryVerticesOut;
    request.reportsGeometryConflicts = !program.sharesGeometryWords;
    for (const scene::StageFile& stage : program.stages) {
        if (variant.isFill && scene::Program::isLeftOutByFill(stage)) continue;
        const SourceFile& source = sourceFile(stage.file);
        append(diagnostics, source.diagnostics);
        if (!source.path.empty()) noteIfHidden(variant.program, source.path);
        if (source.text) request.stages.push_back({stage.stage, source.path, *source.text});
    }
    request.include = [this, program = variant.program](
                          std::string_view name, std::string_view from) -> std::optional<glsl::IncludedFile> {
        if (const auto given = scene_.glslTexts.find(name); given != scene_.glslTexts.end()) {
            noteIfHidden(program, given->second.path.string());
            return glsl::IncludedFile{given->second.path.string(), *given->second.text,
                                      fmt::format("Glsl {} (line {})", name, given->second.place.line)};
        }
        const scene::FileReference found = scene::findInclude(
            name, from, scene_.path, {options_.libraryRoots, options_.within, options_.texts}, listings_);
        if (found.path.empty()) return std::nullopt;
        stats_.add("files read", 1);
        noteIfHidden(program, found.path.string());
        std::string& text = included_[found.path];
        if (const auto edited = options_.texts.find(found.path); edited != options_.texts.end()) {
            text = edited->second;
        } else {
            const auto bytes = image::readFile(found.path, {found.name, found.place}, kLargestSource);
            if (!bytes) return std::nullopt;
            text = asText(*bytes);
        }
        return glsl::IncludedFile{found.path.string(), text};
    };
    request.samplerKindsOfTag = [this, program = variant.program](std::string_view tag) {
        return samplerKinds(program, tag);
    };
    return request;
}

bool ProgramLibrary::compile(const plan::ProgramVariant& variant, const glsl::TranslatedProgram& translated,
                             BuiltProgram& built, Diagnostics& diagnostics) {
    const Place programPlace = variant.program ? scene_.programs[variant.program].place : Place{};
    const StageTimer timer(stats_, "compile");
    std::vector<gpu::StageSource> stages;
    for (const glsl::TranslatedStage& each : translated.stages)
        stages.push_back({glStage(each.stage), each.source});
    gpu::BuildOutcome outcome = gpu::buildProgram(
        context_.capabilities(), {.stages = stages, .vertexInputs = {}, .fragmentOutputs = {}});
    for (std::size_t i = 0; i < outcome.stages.size(); ++i) {
        if (outcome.stages[i].compiled) continue;
        Diagnostics found = glsl::explainCompileLog(translated, translated.stages[i], outcome.stages[i].log);
        if (!hasError(found))
            found.push_back(diagnose("glsl-E01",
                                     "the driver does not compile the shader: " + outcome.stages[i].log,
                                     {translated.stages[i].path, translated.stages[i].firstLine, 1}));
        append(diagnostics, std::move(found));
    }
    if (!outcome.program && !hasError(diagnostics)) {
        append(diagnostics, glsl::explainLinkLog(translated, outcome.linkLog, programPlace));
        if (!hasError(diagnostics))
            diagnostics.push_back(diagnose(
                "glsl-E02", "the driver does not link the program: " + outcome.linkLog, programPlace));
    }
    stats_.add("programs", 1);
    if (!outcome.program) return false;
    static_cast<base::ActiveResources&>(built.interface) = gpu::reflect(*outcome.program);
    if (!context_.capabilities().atLeast(4, 3))
        built.interface.outputs = declaredOutputs(translated, *outcome.program);
    built.program = std::move(outcome.program);
    countUndefined(translated, built, diagnostics);
    return true;
}

void ProgramLibrary::build(const plan::ProgramVariant& variant, BuiltProgram& built) {
    const Translation& translation = translationOf(variant);
    Diagnostics diagnostics = translation.diagnostics;
    glsl::TranslatedProgram translated;
    if (translation.program) {
        translated = *translation.program;
        for (Diagnostic& each : translated.diagnostics)
            if (each.id != "glsl-W11")
                continue;
            else if (variant.isFill)
                each.text +=
                    "; Fill leaves out the stages before an earlier Program, so write them again "
                    "before this one";
            else if (translated.suppliesVertexStage && each.suggestion.empty())
                each.text += "; the vertex stage that covers the target gives vST alone";
        append(diagnostics, std::move(translated.diagnostics));
    }
    if (!hasError(diagnostics)) {
        if (const auto bound = context_.capabilities().isSoftware ? filterBoundOf(scene_) : std::nullopt)
            for (glsl::TranslatedStage& each : translated.stages)
                if (boundFilter(each, *bound) && variant.program)
                    stats_.skip(
                        "texels",
                        fmt::format("aniso on a software driver: a pixel that covers more than {} texels "
                                    "of the coarsest level reads 16 of them",
                                    kMostTexels),
                        scene_.programs[variant.program].place);
        built.key = keyOf(variant, translated);
        if (BuiltProgram* earlier = earlierByKey(built.key)) {
            built.program = std::exchange(earlier->program, std::nullopt);
            // A copy: the earlier library's plan may still be read.
            static_cast<base::ActiveResources&>(built.interface) = earlier->interface;
            built.remarks = std::move(earlier->remarks);
            built.initialValues = std::move(earlier->initialValues);
        } else if (scene_.isModern || !borrow(variant, built)) {
            if (!compile(variant, translated, built, built.remarks)) built.refused = translated.stages;
            if (scene_.isModern && built.program) built.initialValues = initialValues(built);
        }
        append(diagnostics, built.remarks);
    }
    const bool isBuiltin = !variant.program;
    hideTexts(variant.program, diagnostics);
    if (!hiddenSource(variant.program).empty()) built.refused.clear();
    if (BuiltProgram* earlier = built.program ? nullptr : lastGoodOf(variant)) {
        built.program = std::exchange(earlier->program, std::nullopt);
        built.interface = std::move(earlier->interface);
        built.interface.facts.diagnostics = std::move(diagnostics);
        built.key = std::move(earlier->key);
        built.remarks = std::move(earlier->remarks);
        built.initialValues = std::move(earlier->initialValues);
        built.isLastGood = true;
        return;
    }
    translated.diagnostics = std::move(diagnostics);
    completeInterface(built, std::move(translated), isBuiltin);
}

bool ProgramLibrary::observe(const BuiltProgram& program, const glsl::MainWrapper& fragment) {
    const auto known = std::find_if(programs_.begin(), programs_.end(),
                                    [&](const KnownProgram& each) { return each.second.get() == &program; });
    if (known == programs_.end()) return false;
    glsl::TranslatedProgram stages = program.interface.facts;
    stages.diagnostics.clear();
    for (glsl::TranslatedStage& each : stages.stages)
        if (each.stage == glsl::Stage::fragment) each.source = glsl::wrappedMain(each, fragment);
    auto built = std::make_unique<BuiltProgram>();
    if (!compile(known->first, stages, *built, built->remarks)) return false;
    if (scene_.isModern) built->initialValues = initialValues(*built);
    completeInterface(*built, std::move(stages), program.interface.isBuiltin);
    observed_.emplace(known->first, std::move(built));
    return true;
}

const plan::ProgramInterface& ProgramLibrary::interfaceOf(const plan::ProgramVariant& variant) {
    if (const BuiltProgram* known = find(variant)) return known->interface;
    programs_.emplace_back(variant, std::make_unique<BuiltProgram>());
    build(variant, *programs_.back().second);
    return programs_.back().second->interface;
}

const BuiltProgram* ProgramLibrary::find(const plan::ProgramVariant& variant) const {
    if (observed_ && observed_->first == variant) return observed_->second.get();
    for (const auto& [known, built] : programs_)
        if (known == variant) return built.get();
    return nullptr;
}

bool ProgramLibrary::mayWriteImages(scene::ProgramIndex program) {
    if (scene_.isModern) {
        const Translation& translation = translationOf(plan::ProgramVariant{program});
        return translation.program != nullptr && plan::writesMemory(*translation.program);
    }
    for (const scene::StageFile& stage : scene_.programs[program].stages) {
        const SourceFile& source = sourceFile(stage.file);
        if (source.text && source.text->find("image") != std::string::npos &&
            (source.text->find("imageStore") != std::string::npos ||
             source.text->find("imageAtomic") != std::string::npos ||
             source.text->find("#include") != std::string::npos))
            return true;
    }
    return false;
}

}  // namespace glibra::render
