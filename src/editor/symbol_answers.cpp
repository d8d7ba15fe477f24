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
#include "glib/text.h"
#include "glsl/read/words.h"

namespace glibra::editor {
namespace {

using nlohmann::json;

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

std::vector<SourceText> LanguageServer::textsAround(const Document& document, const std::string& name) const {
    std::vector<SourceText> texts;
    std::map<std::filesystem::path, std::size_t> known;
    const auto add = [&](const std::filesystem::path& file, CodeLanguage language) {
        for (const std::filesystem::path& each : withIncludes(file)) {
            if (texts.size() >= kMostTexts || !known.try_emplace(each, texts.size()).second) continue;
            texts.push_back({each, documents_.textOf(each), each == file ? language : CodeLanguage::glsl,
                             includesOf(each)});
        }
    };
    // It has to be the first.
    known[document.file] = 0;
    texts.push_back({document.file, document.text, document.language, includesOf(document.file)});
    add(document.file, document.language);
    const auto filesOf = [&](const SceneProgram& program) {
        std::set<std::filesystem::path> files;
        for (const SceneProgram::Stage& each : program.stages) files.merge(withIncludes(each.file));
        return files;
    };
    for (const auto& [scene, check] : checks_) {
        if (scene != document.file && !check.uses(document.file)) continue;
        if (document.language == CodeLanguage::glib) {
            add(scene, CodeLanguage::glib);
            for (const std::filesystem::path& each : check.files)
                add(each, glib::sameWord(each.extension().generic_string(), ".glib") ? CodeLanguage::glib
                                                                                     : CodeLanguage::glsl);
            continue;
        }
        // The programs that share files that have the name with the shader, with each other, and so on.
        std::set<std::filesystem::path> files{document.file};
        std::set<std::string> programs;
        for (bool isMore = true; std::exchange(isMore, false);)
            for (const SceneProgram& each : check.names.programs) {
                const std::set<std::filesystem::path> own = filesOf(each);
                const bool isRelated = std::ranges::any_of(own, [&](const auto& file) {
                    return file != scene && files.contains(file) &&
                           documents_.textOf(file).find(name) != std::string::npos;
                });
                if (!isRelated || !programs.insert(each.name).second) continue;
                files.insert(own.begin(), own.end());
                isMore = true;
            }
        for (const std::filesystem::path& each : files)
            if (each != scene) add(each, CodeLanguage::glsl);
        add(scene, CodeLanguage::glib);
        if (const auto at = known.find(scene); at != known.end()) texts[at->second].programs = programs;
    }
    return texts;
}

Symbol LanguageServer::symbolOf(const json& parameters) const {
    const Document& document = documentOf(parameters);
    const std::size_t byte = TextLines(document.text).byte(positionIn(parameters.at("position")));
    const TextRange word = wordAt(document.text, byte);
    return symbolAt(textsAround(document, document.text.substr(word.begin, word.end - word.begin)), byte);
}

json LanguageServer::references(const json& parameters) {
    const bool withDeclaration =
        parameters.value("context", json::object()).value("includeDeclaration", json(true)) == true;
    json places = json::array();
    RangesOfFiles ranges(documents_);
    for (const Occurrence& each : symbolOf(parameters).all)
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
    const Symbol symbol = symbolOf(parameters);
    const auto name = parameters.at("newName").get<std::string>();
    if (!symbol.declaration) throw std::invalid_argument("no name of this scene or shader stands here");
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
        const TextPosition at = lines.position(each.place.begin);
        const bool isSameLine = at.line == last.line;
        data.push_back(at.line - last.line);
        data.push_back(isSameLine ? at.unit - last.unit : at.unit);
        data.push_back(each.place.end - each.place.begin);
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
        if (glib::sameWord(file.extension().generic_string(), ".glib")) {
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
