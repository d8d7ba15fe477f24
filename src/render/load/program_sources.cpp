#include "render/load/program_sources.h"

#include <embedded/builtin_shaders.h>
#include <fmt/format.h>

#include <algorithm>
#include <cstddef>
#include <deque>
#include <utility>

#include "base/files.h"
#include "base/text.h"
#include "glsl/read/token.h"
#include "glsl/read/words.h"
#include "image/file.h"

namespace glibra::render {

// ---- Hidden texts

namespace {

/// Shorter words are parts of too many others. The preprocessor can join them with other words, which then
/// tell little.
constexpr std::size_t kShortestPart = 4;

bool isWordByte(char c) {
    return base::isOfName(c) || static_cast<unsigned char>(c) >= 0x80;
}

/// Calls `visit` with each longest run of bytes of words, and each run of other bytes.
template <class Visit>
void visitRuns(std::string_view text, Visit&& visit) {
    for (std::size_t begin = 0; begin < text.size();) {
        const bool isWord = isWordByte(text[begin]);
        std::size_t end = begin;
        while (end < text.size() && isWordByte(text[end]) == isWord) ++end;
        visit(text.substr(begin, end - begin), isWord);
        begin = end;
    }
}

/// Calls `visit` with each word of the source outside of comments.
template <class Visit>
void visitWords(std::string_view source, Visit&& visit) {
    const std::string text = glsl::normalizeLines(source);
    std::deque<std::string> storage;
    for (const glsl::Token& token : glsl::lex(text, storage))
        if (token.kind != glsl::TokenKind::comment)
            visitRuns(token.text, [&](std::string_view run, bool isWord) {
                if (isWord) visit(run);
            });
}

}  // namespace

void HiddenWords::addShown(std::string_view source) {
    visitWords(source, [this](std::string_view word) { shown_.emplace(word); });
}

void HiddenWords::addHidden(std::string_view source) {
    visitWords(source, [this](std::string_view word) {
        hidden_.emplace(word);
        // Compilers end a number where its letters are wrong, and go on with a word.
        const auto letter = std::ranges::find_if_not(word, base::isDigit);
        const auto digits = static_cast<std::size_t>(letter - word.begin());
        if (digits == 0 || digits == word.size()) return;
        hidden_.emplace(word.substr(0, digits));
        hidden_.emplace(word.substr(digits));
    });
}

bool HiddenWords::mayBeHidden(std::string_view word) const {
    if (shown_.contains(word) || glsl::keywordSince(word) != 0) return false;
    if (hidden_.contains(word)) return true;
    return std::ranges::any_of(hidden_, [&](const std::string& each) {
        return each.size() >= kShortestPart && word.find(each) != std::string_view::npos;
    });
}

std::string HiddenWords::removedFrom(std::string_view message) const {
    std::string text;
    visitRuns(message, [&](std::string_view run, bool isWord) {
        text += isWord && mayBeHidden(run) ? std::string_view("...") : run;
    });
    return text;
}

// ---- Sources

namespace {

/// The bytes as text, without a UTF-8 byte order mark.
std::string asText(const std::vector<std::byte>& bytes) {
    std::string text(base::asText(bytes));
    if (text.starts_with("\xEF\xBB\xBF")) text.erase(0, 3);
    return text;
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

}  // namespace

ProgramSources::ProgramSources(const scene::Scene& scene, const RenderOptions& options, Stats& stats)
    : scene_(scene),
      options_(options),
      stats_(stats),
      search_{options.libraryRoots, options.within, scene::memoryFiles(options.texts, options.reader)},
      shown_(scene::shownRoots(scene::searchFolders(scene.path, {.libraryRoots = options.libraryRoots}))) {}

std::vector<std::filesystem::path> ProgramSources::filesRead() const {
    std::vector<std::filesystem::path> files;
    for (const auto& [path, text] : included_) files.push_back(path);
    for (const auto& [file, source] : sources_)
        if (!source.path.empty()) files.emplace_back(source.path);
    return files;
}

void ProgramSources::noteIfHidden(scene::ProgramIndex program, const std::string& file) {
    if (!isShown(file)) hidden_.emplace(program, file);
}

bool ProgramSources::isShown(const std::string& file) const {
    return shown_.contains(file) || (options_.sceneText && file == scene_.path) ||
           (search_.inMemory && search_.inMemory(file));
}

std::string ProgramSources::hiddenSource(scene::ProgramIndex program) const {
    const auto found = hidden_.find(program);
    return found == hidden_.end() ? std::string() : found->second;
}

void ProgramSources::hideTexts(scene::ProgramIndex program, Diagnostics& diagnostics) const {
    const std::string hidden = hiddenSource(program);
    if (hidden.empty()) return;
    HiddenWords words;
    const auto add = [&](const std::string& file, const std::string& text) {
        if (isShown(file))
            words.addShown(text);
        else
            words.addHidden(text);
    };
    for (const auto& [index, source] : sources_)
        if (source.text) add(source.path, *source.text);
    for (const auto& [path, text] : included_) add(path.generic_string(), text);
    const std::string why = scene::whyHidden(hidden);
    for (Diagnostic& each : diagnostics) {
        // Messages about finding and opening a file name the file and nothing else.
        if (each.id.starts_with("file-")) continue;
        if (!each.place.file.empty() && !isShown(each.place.file)) {
            each.text = std::string(scene::kHiddenText) + why;
        } else if (std::string text = words.removedFrom(each.text); text != each.text) {
            each.text = fmt::format("{} (\"...\" stands for words of {})", text, why);
        }
    }
}

const ProgramSources::SourceFile& ProgramSources::file(scene::FileIndex index) {
    const auto [entry, isNew] = sources_.try_emplace(index);
    SourceFile& source = entry->second;
    if (!isNew) return source;
    const scene::FileReference& reference = scene_.files[index];
    source.diagnostics = reference.remarks;
    source.path = reference.path.generic_string();
    if (reference.text) source.text = reference.text;
    if (reference.path.empty() || reference.text) return source;
    stats_.add("files read", 1);
    auto bytes = image::readFile(reference.source(), {reference.name, reference.place}, kLargestSource);
    append(source.diagnostics, std::move(bytes.diagnostics));
    if (bytes) source.text = asText(*bytes);
    return source;
}

std::vector<glsl::SamplerKind> ProgramSources::samplerKinds(scene::ProgramIndex program,
                                                            std::string_view tag) const {
    std::vector<glsl::SamplerKind> kinds;
    int unit = 0;
    for (const glib::UniformSpec& each : scene_.programs[program].uniforms)
        if (each.tag == tag && !each.values.empty()) unit = static_cast<int>(each.values.front());
    for (const scene::Texture& each : scene_.textures) {
        if (each.unit != unit) continue;
        const glsl::SamplerKind kind = samplerKind(each.target);
        if (std::ranges::find(kinds, kind) == kinds.end()) kinds.push_back(kind);
    }
    return kinds;
}

glsl::ProgramRequest ProgramSources::request(const plan::ProgramVariant& variant, bool tiled,
                                             Diagnostics& diagnostics) {
    glsl::ProgramRequest request;
    request.flatColors = variant.flatColors;
    request.colorTargets = variant.colorTargets;
    request.tiled = tiled;
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
    request.hasLights = scene_.suppliesNames;
    request.setsLights = scene_.setsLights;
    request.acceptsStorage = scene_.suppliesNames;
    request.suppliesMatrices = scene_.suppliesNames;
    request.constants = variant.constants;
    request.constantPlaces = program.constantPlaces;
    request.geometryInput = program.geometryInput;
    request.geometryOutput = program.geometryOutput;
    request.geometryVerticesOut = program.geometryVerticesOut;
    request.reportsGeometryConflicts = !program.sharesGeometryWords;
    for (const scene::StageFile& stage : program.stages) {
        if (variant.isFill && scene::Program::isLeftOutByFill(stage)) continue;
        const SourceFile& source = file(stage.file);
        append(diagnostics, source.diagnostics);
        if (!source.path.empty()) noteIfHidden(variant.program, source.path);
        if (source.text) request.stages.push_back({stage.stage, source.path, *source.text});
    }
    request.include = [this, program = variant.program](
                          std::string_view name, std::string_view from) -> std::optional<glsl::IncludedFile> {
        if (const auto given = scene_.glslTexts.find(name); given != scene_.glslTexts.end()) {
            noteIfHidden(program, given->second.path.generic_string());
            return glsl::IncludedFile{given->second.path.generic_string(), *given->second.text,
                                      fmt::format("Glsl {} (line {})", name, given->second.place.line)};
        }
        const scene::FileReference found = scene::findInclude(name, from, scene_.path, search_, listings_);
        if (found.path.empty()) {
            for (std::filesystem::path& each :
                 scene::placesOf(name, scene::includeFolders(from, scene_.path, search_)))
                missing_.insert(std::move(each));
            return std::nullopt;
        }
        stats_.add("files read", 1);
        noteIfHidden(program, found.path.generic_string());
        const auto bytes = image::readFile(found.source(), {found.name, found.place}, kLargestSource);
        std::string& text = included_[found.path];
        if (!bytes) return std::nullopt;
        text = asText(*bytes);
        return glsl::IncludedFile{found.path.generic_string(), text};
    };
    request.samplerKindsOfTag = [this, program = variant.program](std::string_view tag) {
        return samplerKinds(program, tag);
    };
    return request;
}

}  // namespace glibra::render
