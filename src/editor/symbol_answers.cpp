// What the language server answers about names: where they are, what they are, and other names for them.

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <map>
#include <optional>
#include <stdexcept>
#include <utility>

#include "base/text.h"
#include "editor/declared_names.h"
#include "editor/language_server.h"
#include "editor/scene_places.h"
#include "glib/parse/statement.h"
#include "glib/text.h"
#include "glsl/read/words.h"
#include "source/inline_shaders.h"
#include "suite/file/selection.h"

namespace glibra::editor {
namespace {

using nlohmann::json;
namespace fs = std::filesystem;

// Semantic tokens (LSP 3.17): the order of the words is that of the numbers.
constexpr std::array kTokenTypes{"variable", "parameter", "property", "function", "struct", "macro", "class"};
enum class TokenType { variable, parameter, property, function, structure, macro, program };
constexpr std::array kTokenModifiers{"declaration", "readonly"};
constexpr unsigned kDeclaration = 1, kReadOnly = 2;

struct SemanticToken {
    TextRange place;
    TokenType type = TokenType::variable;
    unsigned modifiers = 0;
};

TokenType tokenTypeOf(const DeclaredName& name) {
    if (name.isFunction) return TokenType::function;
    if (name.isParameter) return TokenType::parameter;
    if (name.isMember) return TokenType::property;
    if (name.type == "macro") return TokenType::macro;
    return name.type == "struct" || name.type == "block" ? TokenType::structure : TokenType::variable;
}

void addShaderTokens(std::vector<SemanticToken>& tokens, std::string_view text, std::size_t begin) {
    const ShaderNames names = namesOfShader(text);
    for (const NameUse& each : names.uses) {
        if (each.name == kNoName) continue;
        const DeclaredName& name = names.names[each.name];
        const bool isFixed =
            name.declaration.starts_with("uniform ") || name.declaration.starts_with("const ");
        tokens.push_back({{each.place.begin + begin, each.place.end + begin},
                          tokenTypeOf(name),
                          (each.place == name.place ? kDeclaration : 0) | (isFixed ? kReadOnly : 0)});
    }
}

bool isScene(const fs::path& file) {
    return glib::sameWord(file.extension().generic_string(), ".glib");
}

bool hasWord(std::string_view text, std::string_view word) {
    return findWord(text, word, 0, text.size()).has_value();
}

bool isNewName(const std::string& name, CodeLanguage language) {
    if (name.empty() || base::isDigit(name.front()) || !std::ranges::all_of(name, base::isOfName))
        return false;
    return language == CodeLanguage::glib || (glsl::keywordSince(name) == 0 && !name.starts_with("gl_") &&
                                              name.find("__") == std::string::npos);
}

/// Occurrences as the protocol states them; each file is read once.
class RangesOfFiles {
  public:
    explicit RangesOfFiles(const Documents& documents) : documents_(documents) {}
    json of(const Occurrence& occurrence) {
        File& file = files_[occurrence.file];
        if (!file.lines) {
            file.text = documents_.textOf(occurrence.file);
            file.lines.emplace(file.text);
        }
        return toJson(*file.lines, occurrence.place);
    }

  private:
    struct File {
        std::string text;
        std::optional<TextLines> lines;
    };
    const Documents& documents_;
    std::map<std::filesystem::path, File> files_;
};

}  // namespace

json tokenLegend() {
    return {{"tokenTypes", kTokenTypes}, {"tokenModifiers", kTokenModifiers}};
}

/// What a scene, with those that it includes, says about a name.
struct LanguageServer::SceneLinks {
    std::set<fs::path> scenes;  ///< itself, and what it includes
    /// The files of each program, with what they include. A shader in a scene has the scene's.
    std::vector<std::pair<std::string, std::set<fs::path>>> programs{};
    std::map<glib::CommandId, fs::path> stages{};  ///< those of the next program
    bool declares = false;  ///< a variable or object has the name, so that uniforms read it
    bool isWhole = false;   ///< therefore, or by a Set, all its programs mean the same by the name
};

void LanguageServer::addLinks(SceneLinks& links, const fs::path& scene, const Symbol& symbol) const {
    if (scene.empty() || links.scenes.size() >= kMostTexts || !links.scenes.insert(scene).second) return;
    const std::string text = documents_.textOf(scene);
    for (const Declaration& each : declarationsOf(text))
        links.declares |= each.name == symbol.link && !each.isBlock && each.word != "Program";
    for (const SceneWord& each : namesIn(text))
        links.isWhole |= links.declares || (each.isTag && each.program.empty() && each.name == symbol.name);
    for (const glib::Statement& each : glib::statementsOf(text)) {
        const glib::StatementRow* row = each.modern ? each.modern : each.row;
        if (!row || each.arguments.empty()) continue;
        const bool isInline = each.body.data() != nullptr;
        links.isWhole |= isInline && hasWord(each.body, symbol.link);
        const std::string first(each.arguments.front().text);
        if (row->id == glib::CommandId::include) {
            addLinks(links, found(CodeLanguage::glib, scene, first), symbol);
        } else if (source::stageOfEndWord("End" + std::string(row->name))) {
            links.stages[row->id] = isInline ? scene : found(CodeLanguage::glib, scene, first);
        } else if (row->id == glib::CommandId::program) {
            links.programs.emplace_back(first, std::set<fs::path>());
            for (const auto& [stage, file] : links.stages)
                if (!file.empty()) links.programs.back().second.merge(withIncludes(file));
        }
    }
}

std::vector<SourceText> LanguageServer::textsAround(const Document& document, const Symbol& symbol,
                                                    std::set<fs::path> files) const {
    for (const auto& [uri, each] : documents_.all()) files.insert(each.file);
    for (const auto& [scene, check] : checks_) {
        files.insert(scene);
        files.insert(check.files.begin(), check.files.end());
    }
    const auto isGlib = [&](const fs::path& file) {
        const Document* open = documents_.findFile(file);
        return open ? open->language == CodeLanguage::glib : isScene(file);
    };
    const bool isSceneName = symbol.language == CodeLanguage::glib && !symbol.tagOf;
    std::map<fs::path, bool> known;
    // A shader that declares the name; as a uniform, if that of a variable is meant.
    const auto has = [&](const fs::path& file) {
        const auto [at, isNew] = known.try_emplace(file, false);
        const std::string text = isNew ? documents_.textOf(file) : std::string();
        if (isNew && hasWord(text, symbol.link))
            at->second =
                isGlib(file) || std::ranges::any_of(declaredNames(text), [&](const auto& each) {
                    return each.name == symbol.link && each.isGlobal() && (each.isInterface || !isSceneName);
                });
        return at->second;
    };
    // The shaders that share the name, and the scenes that share its variable.
    std::set<fs::path> sharing;
    if (!isGlib(document.file))
        sharing = withIncludes(document.file);
    else if (!symbol.tagOf)
        sharing = {document.file};
    std::map<fs::path, SceneLinks> scenes;
    std::map<fs::path, std::set<std::string>> programs;  // of scenes, that share the name
    for (bool isMore = true; std::exchange(isMore, false);)
        for (const fs::path& file : files) {
            const bool isOwn = file == document.file;
            const std::string text = documents_.textOf(file);
            if (!isOwn && std::ranges::none_of(sharing, [&](const fs::path& each) {
                    return text.find(each.filename().generic_string()) != text.npos;
                }))
                continue;
            if (!isGlib(file)) {
                if (std::ranges::any_of(includesOf(file), [&](const fs::path& each) {
                        return sharing.contains(each) && (has(each) || each == document.file);
                    }))
                    isMore |= sharing.insert(file).second;
                continue;
            }
            SceneLinks& links = scenes[file];
            if (links.scenes.empty()) addLinks(links, file, symbol);
            const bool isAll = links.isWhole && (!programs[file].empty() || sharing.contains(file) ||
                                                 (isOwn && symbol.tagOf == ""));
            for (const auto& [program, of] : links.programs) {
                if (std::ranges::none_of(of, [&](const fs::path& each) {
                        return has(each) && (isAll || (sharing.contains(each) && !isGlib(each)) ||
                                             (isOwn && program == symbol.tagOf));
                    }))
                    continue;
                for (const fs::path& each : links.scenes) isMore |= programs[each].insert(program).second;
                for (const fs::path& each : of) isMore |= !isGlib(each) && sharing.insert(each).second;
            }
            const bool isShared = std::ranges::any_of(links.scenes, [&](const fs::path& each) {
                return sharing.contains(each) && hasWord(text, symbol.name) &&
                       hasWord(documents_.textOf(each), symbol.name);
            });
            if (isShared || (links.declares && !programs[file].empty()))
                for (const fs::path& each : links.scenes) isMore |= sharing.insert(each).second;
        }
    std::map<fs::path, SourceText> texts{{document.file, {}}};
    for (const fs::path& each : sharing) texts[each].hasNames = isGlib(each);
    for (const auto& [scene, own] : programs)
        if (!own.empty()) texts[scene].programs = own;
    std::vector<SourceText> sorted;  // the document has to be the first
    for (auto& [file, text] : texts) {
        text.file = file;
        text.text = documents_.textOf(file);
        text.language = isGlib(file) ? CodeLanguage::glib : CodeLanguage::glsl;
        text.includes = includesOf(file);
        sorted.insert(file == document.file ? sorted.begin() : sorted.end(), std::move(text));
    }
    return sorted;
}

Symbol LanguageServer::symbolOf(const json& parameters, bool isWide) const {
    const Document& document = documentOf(parameters);
    const std::size_t byte = TextLines(document.text).byte(positionIn(parameters.at("position")));
    Symbol symbol =
        symbolAt(std::array{SourceText{document.file, document.text, document.language, {}, {}, true}}, byte);
    std::set<fs::path> files;
    const fs::path root = rootOf(document.file), own = document.file.parent_path();
    const auto folders = isWide ? std::set{root, root.parent_path() / "shaders", own} : std::set<fs::path>();
    bool isComplete = true;
    for (const fs::path& folder : folders) {
        const auto found = suite::filesThatFit(folder, folder == own && own != root ? "*.*" : "**/*.*");
        isComplete &= static_cast<bool>(found);
        for (const fs::path& each : found ? *found : std::vector<fs::path>())
            if (isScene(each) || stageOfFile(each) ||
                glib::sameWord(each.extension().generic_string(), ".glsl"))
                files.insert(each);
    }
    // What a member belongs to is known once the declaration of its structure has been found.
    for (std::string link; std::exchange(link, symbol.link) != symbol.link;) {
        const std::vector<SourceText> texts = textsAround(document, symbol, files);
        symbol = symbolAt(texts, byte);
        if (!isComplete || texts.size() > kMostTexts)
            symbol.obstacle = "the files around this one cannot all be searched for the name";
    }
    return symbol;
}

json LanguageServer::references(const json& parameters) {
    const bool withDeclaration =
        parameters.value("context", json::object()).value("includeDeclaration", json(true)) == true;
    json places = json::array();
    RangesOfFiles ranges(documents_);
    for (const Occurrence& each : symbolOf(parameters, true).all)
        if (withDeclaration || !each.isDeclaration)
            places.push_back({{"uri", documents_.uriOf(each.file)}, {"range", ranges.of(each)}});
    return places;
}

json LanguageServer::highlights(const json& parameters) {
    const Document& document = documentOf(parameters);
    const TextLines lines(document.text);
    json places = json::array();
    for (const Occurrence& each : symbolOf(parameters).all)
        if (each.file == document.file) places.push_back({{"range", toJson(lines, each.place)}});
    return places;
}

json LanguageServer::prepareRename(const json& parameters) {
    const Symbol symbol = symbolOf(parameters);
    if (!symbol.declaration) return nullptr;
    return {{"range", toJson(TextLines(documentOf(parameters).text), symbol.place)},
            {"placeholder", symbol.name}};
}

json LanguageServer::rename(const json& parameters) {
    const Symbol symbol = symbolOf(parameters, true);
    const auto name = parameters.at("newName").get<std::string>();
    if (!symbol.declaration) throw std::invalid_argument("no name of this scene or shader stands here");
    if (symbol.language == CodeLanguage::glib && !symbol.tagOf && (symbol.name == "i" || name == "i"))
        throw std::invalid_argument("'i' is also the counter of Repeat, arrays and [n of (...)]");
    if (!symbol.obstacle.empty()) throw std::invalid_argument(symbol.obstacle);
    if (!isNewName(name, symbol.language))
        throw std::invalid_argument(
            fmt::format("'{}' cannot be a name here; a name consists of letters, digits "
                        "and '_', begins with no digit, and is no word of the language",
                        name));
    json changes = json::object();
    RangesOfFiles ranges(documents_);
    for (const Occurrence& each : symbol.all)
        changes[documents_.uriOf(each.file)].push_back({{"range", ranges.of(each)}, {"newText", name}});
    return {{"changes", std::move(changes)}};
}

json LanguageServer::tokens(const json& parameters) {
    const Document& document = documentOf(parameters);
    const TextLines lines(document.text);
    std::vector<SemanticToken> tokens;
    if (document.language == CodeLanguage::glsl) {
        addShaderTokens(tokens, document.text, 0);
    } else {
        const auto nameAt = [&](const TextRange& place) {
            return document.text.substr(place.begin, place.end - place.begin);
        };
        std::map<std::string, TokenType> declared;
        for (const Declaration& each : declarationsOf(document.text))
            declared.emplace(each.name, each.word == "Program" ? TokenType::program : TokenType::variable);
        for (const SceneWord& each : namesIn(document.text)) {
            const auto known = declared.find(nameAt(each.place));
            if (each.isTag)
                tokens.push_back({each.place, TokenType::property, 0});
            else if (known != declared.end())
                tokens.push_back({each.place, known->second, each.isDeclaration ? kDeclaration : 0U});
        }
        for (const LanguageAt& each : shadersIn(document.text))
            addShaderTokens(tokens, nameAt(each.part), each.part.begin);
        std::ranges::sort(tokens, {}, [](const SemanticToken& each) { return each.place.begin; });
    }
    json data = json::array();
    TextPosition last;
    for (const SemanticToken& each : tokens) {
        const TextPosition at = lines.position(each.place.begin), end = lines.position(each.place.end);
        const bool isSameLine = at.line == last.line;
        data.push_back(at.line - last.line);
        data.push_back(isSameLine ? at.unit - last.unit : at.unit);
        data.push_back(end.unit - at.unit);
        data.push_back(static_cast<int>(each.type));
        data.push_back(each.modifiers);
        last = at;
    }
    return {{"data", std::move(data)}};
}

json LanguageServer::hints(const json& parameters) {
    const Document& document = documentOf(parameters);
    const TextLines lines(document.text);
    const TextPosition first = positionIn(parameters.at("range").at("start"));
    const TextPosition last = positionIn(parameters.at("range").at("end"));
    json hints = json::array();
    std::map<std::string, std::string> values;
    for (const auto& [scene, check] : checks_)
        if (scene == document.file || check.uses(document.file))
            for (const KnownName& each : check.names.values)
                if (each.in == CodeLanguage::glsl && !each.value.empty())
                    values.emplace(each.name, each.value);
    const auto add = [&](std::string_view shader, std::size_t begin) {
        for (const DeclaredName& each : declaredNames(shader)) {
            const auto value = values.find(each.name);
            if (!each.isInterface || !each.isGlobal() || value == values.end()) continue;
            const TextPosition at = lines.position(begin + each.place.end);
            if (at.line < first.line || at.line > last.line) continue;
            hints.push_back({{"position", toJson(at)},
                             {"label", " = " + value->second},
                             {"tooltip", "the value in the scene"}});
        }
    };
    if (document.language == CodeLanguage::glsl)
        add(document.text, 0);
    else
        for (const LanguageAt& each : shadersIn(document.text))
            add(std::string_view(document.text).substr(each.part.begin, each.part.end - each.part.begin),
                each.part.begin);
    return hints;
}

json LanguageServer::findSymbols(const json& parameters) {
    constexpr std::size_t kHits = 500;
    const std::string query = glib::lower(parameters.at("query").get<std::string>());
    std::set<std::filesystem::path> files;
    for (const auto& [uri, each] : documents_.all()) files.insert(each.file);
    for (const auto& [scene, check] : checks_) {
        files.insert(scene);
        files.insert(check.files.begin(), check.files.end());
    }
    json found = json::array();
    for (const std::filesystem::path& file : files) {
        const std::string text = documents_.textOf(file);
        const TextLines lines(text);
        const json uri = documents_.uriOf(file);
        const auto add = [&](const std::string& name, int kind, const TextRange& place) {
            if (found.size() < kHits && !name.empty() && glib::lower(name).find(query) != std::string::npos)
                found.push_back({{"name", name},
                                 {"kind", kind},
                                 {"location", {{"uri", uri}, {"range", toJson(lines, place)}}}});
        };
        constexpr int kFunction = 12, kVariable = 13, kStructure = 23, kObject = 19;
        if (isScene(file)) {
            for (const Declaration& each : declarationsOf(text)) add(each.name, kObject, each.place);
            continue;
        }
        for (const DeclaredName& each : declaredNames(text))
            if (each.isGlobal())
                add(each.name,
                    each.isFunction                             ? kFunction
                    : tokenTypeOf(each) == TokenType::structure ? kStructure
                                                                : kVariable,
                    each.place);
    }
    return found;
}

}  // namespace glibra::editor
