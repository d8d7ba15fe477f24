// What the language server answers about one place or one text.

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <iterator>
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
enum class ItemKind { function = 3, field = 5, variable = 6, keyword = 14, word = 12 };
enum class Symbol { function = 12, variable = 13, structure = 23, object = 19, space = 3, key = 20 };

ItemKind kindOf(const Completion& each) {
    if (each.type == "command" || each.type == "statement" || each.type == "keyword" || each.type == "type")
        return ItemKind::keyword;
    if (each.type.find('(') != std::string::npos) return ItemKind::function;
    return each.type.starts_with("word") ? ItemKind::word : ItemKind::variable;
}

json symbol(const std::string& name, const std::string& detail, Symbol kind, const json& whole,
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

/// The place of a declared name, found in its line.
TextRange placeOf(const DeclaredName& name, std::string_view text, const TextLines& lines,
                  std::size_t linesBefore) {
    const TextRange line = lines.line(static_cast<std::size_t>(std::max(name.line, 1)) - 1 + linesBefore);
    for (std::size_t at = line.begin + static_cast<std::size_t>(std::max(name.column, 1)) - 1;
         (at = text.find(name.name, at)) < line.end; ++at)
        if (const TextRange word = wordAt(text, at); textAt(text, word) == name.name) return word;
    return {line.begin, line.begin};
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
    return context;
}

json LanguageServer::complete(const json& parameters) {
    const Document& document = documentOf(parameters);
    const TextLines lines(document.text);
    const std::size_t cursor = lines.byte(positionIn(parameters.at("position")));
    const json typed = toJson(lines, wordBefore(document.text, cursor));
    json items = json::array();
    for (const Completion& each : completionsAt(document.text, cursor, contextOf(document))) {
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

std::filesystem::path LanguageServer::found(const Document& from, const std::string& name) const {
    const scene::InterpretOptions options{.libraryRoots = options_.libraryRoots};
    scene::FolderListings listings;
    if (from.language == CodeLanguage::glsl) {
        for (const auto& [scene, check] : checks_)
            if (check.uses(from.file))
                return scene::findInclude(name, from.file.generic_string(), scene.generic_string(), options,
                                          listings)
                    .path;
        return scene::findInclude(name, from.file.generic_string(), from.file.generic_string(), options,
                                  listings)
            .path;
    }
    const scene::SearchFolders folders = scene::searchFolders(from.file, options);
    std::filesystem::path path =
        scene::findFile(name, {from.file.generic_string(), 1, 1}, folders, listings).path;
    if (path.empty())  // perhaps of a shader in the scene
        path = scene::findInclude(name, from.file.generic_string(), from.file.generic_string(), options,
                                  listings)
                   .path;
    return path;
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
            const std::filesystem::path file = found(document, each.name);
            return file.empty() ? json() : linkTo(file, {}, {});
        }
    const std::string name(textAt(text, wordAt(text, byte)));
    if (name.empty()) return nullptr;
    const LanguageAt at = languageAt(text, byte, {document.language, std::nullopt, {}});
    if (at.language == CodeLanguage::glsl) {
        const std::size_t before = lines.position(at.part.begin).line;
        const std::size_t begin = wordAt(text, byte).begin, row = lines.position(byte).line;
        const CodePlace place{static_cast<int>(row - before) + 1,
                              static_cast<int>(begin - lines.line(row).begin) + 1};
        const bool isMember = begin > 0 && text[begin - 1] == '.';
        const std::vector<DeclaredName> own = declaredNames(textAt(text, at.part));
        if (const DeclaredName* each = declarationOf(own, name, place, isMember))
            return linkTo(document.file, text, placeOf(*each, text, lines, before));
    } else {
        for (const Declaration& each : declarationsOf(text))
            if (each.name == name && !isAt(each.place)) return linkTo(document.file, text, each.place);
    }
    // In what the text includes, and in the shaders of the scene.
    std::vector<std::filesystem::path> others;
    for (const NamedFile& each : named)
        if (std::filesystem::path file = found(document, each.name); !file.empty())
            others.push_back(std::move(file));
    for (const auto& [scene, check] : checks_)
        if (scene == document.file || check.uses(document.file))
            others.insert(others.end(), check.files.begin(), check.files.end());
    for (const std::filesystem::path& file : others) {
        if (file == document.file || glib::sameWord(file.extension().generic_string(), ".glib")) continue;
        const std::string other = documents_.textOf(file);
        const std::vector<DeclaredName> all = declaredNames(other);
        const auto declared = std::ranges::find_if(all, [&](const DeclaredName& each) {
            return each.name == name &&
                   (each.isFunction || each.isInterface || each.type == "macro" || each.type == "struct");
        });
        if (declared == all.end()) continue;
        const TextLines otherLines(other);
        return linkTo(file, other, placeOf(*declared, other, otherLines, 0));
    }
    return nullptr;
}

json LanguageServer::links(const json& parameters) {
    const Document& document = documentOf(parameters);
    const TextLines lines(document.text);
    json links = json::array();
    for (const NamedFile& each : namedFiles(document))
        if (const std::filesystem::path file = found(document, each.name); !file.empty())
            links.push_back({{"range", toJson(lines, each.place)}, {"target", documents_.uriOf(file)}});
    return links;
}

json LanguageServer::symbols(const json& parameters) {
    const Document& document = documentOf(parameters);
    const TextLines lines(document.text);
    json symbols = json::array();
    if (document.language == CodeLanguage::glsl) {
        for (const DeclaredName& each : declaredNames(document.text)) {
            const bool isStructure = each.type == "struct" || each.type == "block";
            if (!each.isFunction && !each.isInterface && !isStructure && each.type != "macro") continue;
            const json place = toJson(lines, placeOf(each, document.text, lines, 0));
            symbols.push_back(symbol(each.name, each.declaration,
                                     each.isFunction ? Symbol::function
                                     : isStructure   ? Symbol::structure
                                                     : Symbol::variable,
                                     place, place));
        }
        return symbols;
    }
    for (const Declaration& each : declarationsOf(document.text)) {
        const bool isVariable = each.word == "Let" || each.word == "Bound";
        symbols.push_back(symbol(each.name, each.word,
                                 each.isBlock ? Symbol::space
                                 : isVariable ? Symbol::variable
                                              : Symbol::object,
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
