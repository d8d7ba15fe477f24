// What the language server answers about one place or one text.

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <iterator>
#include <set>
#include <stdexcept>
#include <utility>

#include "editor/declared_names.h"
#include "editor/format.h"
#include "editor/language_server.h"
#include "editor/reference.h"
#include "editor/scene_places.h"
#include "glib/text.h"
#include "scene/file_lookup.h"

namespace glibra::editor {
namespace {

using nlohmann::json;

// Kinds of LSP 3.17.
enum class ItemKind {
    function = 3,
    field = 5,
    variable = 6,
    keyword = 14,
    word = 12,
    file = 17,
    folder = 19
};
enum class SymbolKind { function = 12, variable = 13, structure = 23, object = 19, space = 3, key = 20 };

ItemKind kindOf(const Completion& each) {
    if (each.type == "command" || each.type == "statement" || each.type == "keyword" || each.type == "type")
        return ItemKind::keyword;
    if (each.type == "file") return ItemKind::file;
    if (each.type == "folder") return ItemKind::folder;
    if (each.type.find('(') != std::string::npos) return ItemKind::function;
    return each.type.starts_with("word") ? ItemKind::word : ItemKind::variable;
}

json symbolItem(const std::string& name, const std::string& detail, SymbolKind kind, const json& whole,
                const json& place) {
    // Clients refuse symbols without a name.
    return {{"name", name.empty() ? "?" : name},
            {"detail", detail},
            {"kind", static_cast<int>(kind)},
            {"range", whole},
            {"selectionRange", place}};
}

std::string_view textAt(std::string_view text, const TextRange& range) {
    return text.substr(range.begin, range.end - range.begin);
}

std::vector<NamedFile> namedFiles(const Document& document) {
    std::vector<NamedFile> named = includesIn(document.text);
    if (document.language == CodeLanguage::glib)
        std::ranges::move(filesIn(document.text), std::back_inserter(named));
    return named;
}

}  // namespace

const Document& LanguageServer::documentOf(const json& parameters) const {
    const auto uri = parameters.at("textDocument").at("uri").get<std::string>();
    if (const Document* document = documents_.find(uri)) return *document;
    throw std::invalid_argument(fmt::format("'{}' is not open", uri));
}

CodeContext LanguageServer::contextOf(const Document& document) const {
    CodeContext context;
    context.language = document.language;
    if (document.language == CodeLanguage::glsl) context.stage = stageOfFile(document.file);
    const auto textOf = [this](const std::filesystem::path& file) { return documents_.textOf(file); };
    for (const auto& [scene, check] : checks_) {
        if (scene != document.file && !check.uses(document.file)) continue;
        context.names.insert(context.names.end(), check.names.values.begin(), check.names.values.end());
        addProgramNames(context, check.names.programs, document.file, textOf);
    }
    // What an #include brings.
    for (const std::filesystem::path& file : withIncludes(document.file)) {
        if (file == document.file) continue;
        for (const DeclaredName& each : declaredNames(documents_.textOf(file)))
            if (each.isGlobal())
                context.names.push_back(
                    {each.name,
                     each.isFunction ? each.declaration : each.type,
                     fmt::format("{} in {}", each.declaration, file.filename().generic_string()),
                     {},
                     CodeLanguage::glsl});
    }
    const scene::SearchFolders folders =
        scene::searchFolders(document.file, {.libraryRoots = options_.libraryRoots});
    context.folders = folders.beside;
    context.folders.insert(context.folders.end(), folders.library.begin(), folders.library.end());
    return context;
}

json LanguageServer::complete(const json& parameters) {
    const Document& document = documentOf(parameters);
    const TextLines lines(document.text);
    const std::size_t cursor = lines.byte(positionIn(parameters.at("position")));
    json items = json::array();
    // A blank begins a word, but only where few words may stand.
    const json trigger = parameters.value("context", json::object()).value("triggerCharacter", json());
    for (const Completion& each : completionsAt(document.text, cursor, contextOf(document))) {
        static const std::set<std::string_view> kAfterBlanks{"file", "folder", "version", "format"};
        if (trigger == " " && !kAfterBlanks.contains(each.type)) continue;
        const json typed = toJson(lines, TextRange{each.begin, cursor});
        // The order of the list is that of importance.
        json item = {{"label", each.word},
                     {"kind", static_cast<int>(kindOf(each))},
                     {"sortText", fmt::format("{:04}", items.size())},
                     {"textEdit", {{"range", typed}, {"newText", each.word}}}};
        if (!each.type.empty()) item["detail"] = each.type;
        if (!each.what.empty()) item["documentation"] = each.what;
        items.push_back(std::move(item));
    }
    return {{"isIncomplete", true}, {"items", std::move(items)}};
}

json LanguageServer::hover(const json& parameters) {
    const Document& document = documentOf(parameters);
    const TextLines lines(document.text);
    const std::size_t byte = lines.byte(positionIn(parameters.at("position")));
    const TextRange word = wordAt(document.text, byte);
    const ReferenceEntry entry = referenceAt(document.text, byte, contextOf(document));
    if (entry.word.empty() || word.begin == word.end) return nullptr;
    std::string text =
        fmt::format("```{}\n{}\n```\n{}", document.language == CodeLanguage::glib ? "glib" : "glsl",
                    fmt::join(entry.code, "\n"), entry.text);
    if (!entry.value.empty()) text += fmt::format("\n\nvalue: `{}`", entry.value);
    if (!entry.chapter.empty()) text += fmt::format("\n\n*{}*", entry.chapter);
    return {{"contents", {{"kind", "markdown"}, {"value", text}}}, {"range", toJson(lines, word)}};
}

std::filesystem::path LanguageServer::found(CodeLanguage language, const std::filesystem::path& from,
                                            const std::string& name) const {
    const scene::InterpretOptions options{.libraryRoots = options_.libraryRoots};
    scene::FolderListings listings;
    std::filesystem::path scene = from;
    if (language == CodeLanguage::glib) {
        const scene::SearchFolders folders = scene::searchFolders(from, options);
        std::filesystem::path path =
            scene::findFile(name, {from.generic_string(), 1, 1}, folders, listings).path;
        if (!path.empty()) return path;  // else perhaps of a shader in the scene
    } else {
        for (const auto& [each, check] : checks_)
            if (check.uses(from)) scene = each;
    }
    return scene::findInclude(name, from.generic_string(), scene.generic_string(), options, listings).path;
}

std::vector<std::filesystem::path> LanguageServer::includesOf(const std::filesystem::path& file) const {
    std::vector<std::filesystem::path> files;
    for (const NamedFile& each : includesIn(documents_.textOf(file)))
        if (std::filesystem::path path = found(CodeLanguage::glsl, file, each.name); !path.empty())
            files.push_back(std::move(path));
    return files;
}

std::set<std::filesystem::path> LanguageServer::withIncludes(const std::filesystem::path& file) const {
    std::set<std::filesystem::path> files{file};
    std::vector<std::filesystem::path> next{file};
    while (!next.empty() && files.size() < kMostTexts) {
        const std::filesystem::path last = std::move(next.back());
        next.pop_back();
        for (const std::filesystem::path& each : includesOf(last))
            if (files.insert(each).second) next.push_back(each);
    }
    return files;
}

json LanguageServer::linkTo(const std::filesystem::path& file, std::string_view text,
                            const TextRange& place) const {
    return {{"uri", documents_.uriOf(file)}, {"range", toJson(TextLines(text), place)}};
}

json LanguageServer::definition(const json& parameters) {
    const Document& document = documentOf(parameters);
    const std::string& text = document.text;
    const TextLines lines(text);
    const std::size_t byte = lines.byte(positionIn(parameters.at("position")));
    const auto isAt = [&](const TextRange& range) { return range.begin <= byte && byte <= range.end; };
    const std::vector<NamedFile> named = namedFiles(document);
    for (const NamedFile& each : named)
        if (isAt(each.place)) {
            const std::filesystem::path file = found(document.language, document.file, each.name);
            return file.empty() ? json() : linkTo(file, {}, {});
        }
    const Symbol symbol = symbolOf(parameters);
    if (!symbol.declaration) return nullptr;
    const Occurrence& place = *symbol.declaration;
    return linkTo(place.file, documents_.textOf(place.file), place.place);
}

json LanguageServer::links(const json& parameters) {
    const Document& document = documentOf(parameters);
    const TextLines lines(document.text);
    json links = json::array();
    for (const NamedFile& each : namedFiles(document))
        if (const std::filesystem::path file = found(document.language, document.file, each.name);
            !file.empty())
            links.push_back({{"range", toJson(lines, each.place)}, {"target", documents_.uriOf(file)}});
    return links;
}

json LanguageServer::symbols(const json& parameters) {
    const Document& document = documentOf(parameters);
    const TextLines lines(document.text);
    json symbols = json::array();
    if (document.language == CodeLanguage::glsl) {
        // Constants and shared variables, too: everything but members, parameters and local variables.
        for (const DeclaredName& each : declaredNames(document.text)) {
            const bool isStructure = each.type == "struct" || each.type == "block";
            if (!each.isGlobal()) continue;
            const json place = toJson(lines, each.place);
            symbols.push_back(symbolItem(each.name, each.declaration,
                                         each.isFunction ? SymbolKind::function
                                         : isStructure   ? SymbolKind::structure
                                                         : SymbolKind::variable,
                                         place, place));
        }
        return symbols;
    }
    for (const Declaration& each : declarationsOf(document.text)) {
        const bool isVariable = each.word == "Let" || each.word == "Bound";
        symbols.push_back(symbolItem(each.name, each.word,
                                     each.isBlock ? SymbolKind::space
                                     : isVariable ? SymbolKind::variable
                                                  : SymbolKind::object,
                                     toJson(lines, each.whole), toJson(lines, each.place)));
    }
    return symbols;
}

json LanguageServer::colors(const json& parameters) {
    const Document& document = documentOf(parameters);
    json colors = json::array();
    if (document.language != CodeLanguage::glib) return colors;
    const TextLines lines(document.text);
    for (const WrittenColor& each : colorsOf(document.text)) {
        const auto& [red, green, blue, alpha] = each.components;
        colors.push_back({{"range", toJson(lines, each.place)},
                          {"color", {{"red", red}, {"green", green}, {"blue", blue}, {"alpha", alpha}}}});
    }
    return colors;
}

json LanguageServer::colorPresentations(const json& parameters) {
    const Document& document = documentOf(parameters);
    const TextLines lines(document.text);
    const std::size_t begin = lines.byte(positionIn(parameters.at("range").at("start")));
    const std::size_t end = std::max(begin, lines.byte(positionIn(parameters.at("range").at("end"))));
    const json& color = parameters.at("color");
    const std::string text = colorText({color.at("red").get<double>(), color.at("green").get<double>(),
                                        color.at("blue").get<double>(), color.at("alpha").get<double>()},
                                       textAt(document.text, {begin, end}));
    json presentations = json::array();
    presentations.push_back(
        {{"label", text}, {"textEdit", {{"range", parameters.at("range")}, {"newText", text}}}});
    return presentations;
}

json LanguageServer::format(const json& parameters) {
    const Document& document = documentOf(parameters);
    json edits = json::array();
    if (document.language != CodeLanguage::glib) return edits;
    const std::string text = formatted(document.text);
    if (text == document.text) return edits;
    // One edit, from the first line that changes to the last one.
    const TextLines before(document.text), after(text);
    const auto lineOf = [](std::string_view whole, const TextLines& lines, std::size_t index) {
        const std::size_t next = index + 1 < lines.count() ? lines.line(index + 1).begin : whole.size();
        return whole.substr(lines.line(index).begin, next - lines.line(index).begin);
    };
    const std::size_t most = std::min(before.count(), after.count());
    std::size_t first = 0, last = 0;
    while (first < most && lineOf(document.text, before, first) == lineOf(text, after, first)) ++first;
    while (last < most - first && lineOf(document.text, before, before.count() - 1 - last) ==
                                      lineOf(text, after, after.count() - 1 - last))
        ++last;
    const auto beginOf = [](std::string_view whole, const TextLines& lines, std::size_t index) {
        return index < lines.count() ? lines.line(index).begin : whole.size();
    };
    const TextRange replaced{beginOf(document.text, before, first),
                             beginOf(document.text, before, before.count() - last)};
    const TextRange by{beginOf(text, after, first), beginOf(text, after, after.count() - last)};
    edits.push_back({{"range", toJson(before, replaced)}, {"newText", textAt(text, by)}});
    return edits;
}

}  // namespace glibra::editor
