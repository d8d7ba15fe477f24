// What the language server answers about one place or one text.

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <deque>
#include <iterator>
#include <optional>
#include <set>
#include <stdexcept>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "editor/completion.h"
#include "editor/declared_names.h"
#include "editor/format.h"
#include "editor/language_server.h"
#include "editor/reference.h"
#include "editor/scene_places.h"
#include "glib/number.h"
#include "glib/parse/statement.h"
#include "glib/text.h"
#include "glsl/read/token.h"
#include "glsl/read/words.h"
#include "scene/file_lookup.h"
#include "source/syntax.h"

namespace glibra::editor {
namespace {

// The parts of a text that an editor can fold.

/// Lines, from 0; the first one stays visible.
struct Fold {
    std::size_t first = 0, last = 0;
    bool isComment = false;
};

void addShaderFolds(std::vector<Fold>& folds, std::string_view text, std::size_t linesBefore) {
    std::string normal(text);  // with as many lines
    for (std::size_t i = 0; i < text.size(); ++i)
        if (text[i] == '\r') normal[i] = text.substr(i + 1, 1) == "\n" ? ' ' : '\n';
    std::deque<std::string> storage;
    const std::vector<glsl::Token> tokens = glsl::lex(normal, storage);
    std::vector<std::size_t> open, conditions;
    const auto close = [&](std::vector<std::size_t>& from, std::size_t last) {
        if (from.empty()) return;
        if (last > from.back()) folds.push_back({from.back(), last, false});
        from.pop_back();
    };
    std::string_view before;  // in the line
    for (const glsl::Token& each : tokens) {
        const std::size_t line = linesBefore + static_cast<std::size_t>(each.line) - 1;
        if (each.kind == glsl::TokenKind::comment) {
            const auto lines = static_cast<std::size_t>(std::ranges::count(each.text, '\n'));
            if (lines > 0) folds.push_back({line, line + lines, true});
        } else if (each.text == "{") {
            open.push_back(line);
        } else if (each.text == "}") {
            close(open, line > 0 ? line - 1 : 0);
        } else if (before == "#" && each.text.starts_with("if")) {
            conditions.push_back(line);
        } else if (before == "#" && (each.text == "endif" || each.text == "else" || each.text == "elif")) {
            close(conditions, line > 0 ? line - 1 : 0);
            if (each.text != "endif") conditions.push_back(line);
        }
        if (each.kind == glsl::TokenKind::newline || glsl::isSignificant(each.kind)) before = each.text;
    }
}

/// Blocks and shaders of a scene; blocks, comments and branches of the preprocessor of a shader.
std::vector<Fold> foldsOf(std::string_view text, source::CodeLanguage language) {
    std::vector<Fold> folds;
    if (language == source::CodeLanguage::glsl) {
        addShaderFolds(folds, text, 0);
        return folds;
    }
    const auto isRow = [](const glib::StatementRow* row, glib::CommandId a, glib::CommandId b) {
        return row && (row->id == a || row->id == b);
    };
    std::vector<std::size_t> open;
    for (const glib::Statement& each : glib::statementsOf(text)) {
        const glib::BlockRole role = each.modern ? each.modern->role : glib::BlockRole::none;
        using Id = glib::CommandId;
        const auto line = static_cast<std::size_t>(each.word.position.line) - 1;
        if (each.body.data() != nullptr) {
            const auto begin = static_cast<std::size_t>(each.bodyPosition.line) - 1;
            const std::size_t lines = TextLines(each.body).count() - 1;
            if (lines > 0) folds.push_back({line, begin + lines - 1, false});
            addShaderFolds(folds, each.body, begin);
        } else if (role == glib::BlockRole::opens || isRow(each.row, Id::glBegin, Id::pushMatrix)) {
            open.push_back(line);
        } else if ((role == glib::BlockRole::closes || isRow(each.row, Id::glEnd, Id::popMatrix)) &&
                   !open.empty()) {
            if (line > open.back() + 1) folds.push_back({open.back(), line - 1, false});
            open.pop_back();
        }
    }
    return folds;
}

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

// What the language server proposes while a text is written: corrections, the arguments of calls, folds.

namespace {

using nlohmann::json;

/// The names in quotes in a message: 'a', `b'.
std::vector<std::string> quotedIn(std::string_view message) {
    std::vector<std::string> found;
    for (std::size_t at = message.find_first_of("'`"); at != std::string_view::npos;
         at = message.find_first_of("'`", at)) {
        const std::size_t end = message.find('\'', at + 1);
        if (end == std::string_view::npos) break;
        found.emplace_back(message.substr(at + 1, end - at - 1));
        at = end + 1;
    }
    return found;
}

/// A slider, or the like, for a uniform of that type; empty if there is none.
std::string controlOf(std::string_view type) {
    if (type == "float" || type == "double") return "<0 .5 1>";
    if (type == "int" || type == "uint") return "<0 1 10>";
    if (type == "bool") return "<true>";
    if (type == "vec2") return "[0 0]";
    if (type == "vec3") return "{1 1 1}";
    return type == "vec4" ? "{1 1 1 1}" : "";
}

/// "<0 8 16>" for "8", which keeps its digits.
std::string sliderAround(std::string_view number, double value) {
    const double far = value == 0 ? 1 : 2 * std::abs(value);
    return fmt::format("<{} {} {}>", value > 0 ? 0 : -far, number, value < 0 ? 0 : far);
}

/// A plain number at the byte that is the value of a variable, or of a uniform that takes a range.
std::optional<glib::Token> numberAt(std::string_view scene, std::size_t byte, const CodeContext& context) {
    const auto takesNone = [&](std::string_view tag) {
        return std::ranges::any_of(context.names, [&](const KnownName& each) {
            return each.name == tag && glsl::isTypeWord(each.type) && !controlOf(each.type).starts_with("<0");
        });
    };
    for (const glib::Statement& each : glib::statementsOf(scene)) {
        if (!each.modern && !each.row) continue;
        const std::string_view word = each.modern ? each.modern->name : each.row->name;
        const bool isProgram = glib::sameWord(word, "Program");
        if (!isProgram && !glib::sameWord(word, "Let")) continue;
        const auto isConst = [&](std::size_t at) {  // what follows is a constant of the shaders
            return at < each.arguments.size() && glib::sameWord(each.arguments[at].text, "const");
        };
        for (std::size_t i = 1; i < each.arguments.size(); ++i) {
            const glib::Token &token = each.arguments[i], &before = each.arguments[i - 1];
            const bool isAlone =
                before.isWord() && (i + 1 == each.arguments.size() || each.arguments[i + 1].isWord());
            if (token.kind == glib::TokenKind::number && token.begin <= byte && byte <= token.end &&
                isAlone && !isConst(i - 2) && !isConst(i - 3) && !(isProgram && takesNone(before.text)) &&
                glib::numberLength(token.text) == token.text.size())
                return token;
        }
    }
    return std::nullopt;
}

}  // namespace

json LanguageServer::signatures(const json& parameters) {
    const Document& document = documentOf(parameters);
    const std::size_t cursor = TextLines(document.text).byte(positionIn(parameters.at("position")));
    const CallHint hint = callAt(document.text, cursor, contextOf(document));
    if (hint.word.empty()) return nullptr;
    json signatures = json::array();
    for (const SignatureParts& each : hint.signatures) {
        const std::size_t begin = each.before.size();
        json argument = {{"label", {begin, begin + each.argument.size()}}};
        signatures.push_back({{"label", each.before + each.argument + each.after},
                              {"parameters", json::array({std::move(argument)})}});
    }
    return {{"signatures", std::move(signatures)}, {"activeSignature", 0}, {"activeParameter", 0}};
}

json LanguageServer::actions(const json& parameters) {
    const Document& document = documentOf(parameters);
    const std::string& text = document.text;
    const TextLines lines(text);
    json actions = json::array();
    const auto add = [&](const std::string& title, const json& changes, const json& message) {
        json action = {{"title", title},
                       {"kind", message.is_null() ? "refactor.rewrite" : "quickfix"},
                       {"edit", changes}};
        if (!message.is_null()) action["diagnostics"] = json::array({message});
        actions.push_back(std::move(action));
    };
    const auto change = [&](const TextRange& place, const std::string& by) -> json {
        return {
            {"changes", {{document.uri, json::array({{{"range", toJson(lines, place)}, {"newText", by}}})}}}};
    };
    for (const json& each : parameters.at("context").at("diagnostics")) {
        const auto message = each.at("message").get<std::string>();
        const std::size_t begin = lines.byte(positionIn(each.at("range").at("start")));
        const std::size_t end = lines.byte(positionIn(each.at("range").at("end")));
        const TextRange line = lines.line(lines.position(begin).line);
        const std::size_t asks = message.find("did you mean");
        const std::vector<std::string> names = quotedIn(message.substr(0, asks));
        if (asks != std::string::npos && !names.empty()) {
            const std::vector<std::string> meant = quotedIn(message.substr(asks));
            std::optional<TextRange> place = findWord(text, names.back(), begin, line.end);
            if (!place) place = findWord(text, names.back(), line.begin, line.end);
            if (place && !meant.empty())
                add(fmt::format("Change '{}' to '{}'", names.back(), meant.front()),
                    change(*place, meant.front()), each);
        }
        if (message.starts_with("missing ';' after")) add("Add ';'", change({end, end}, ";"), each);
        const json code = each.value("code", json());
        if (document.language != CodeLanguage::glib || names.empty()) continue;
        if (code == "glib-W37" && names.size() > 1) {
            const CodeContext context = contextOf(document);
            const auto known = std::ranges::find_if(context.names, [&](const KnownName& name) {
                return name.name == names[0] && !controlOf(name.type).empty();
            });
            for (const glib::Statement& statement : glib::statementsOf(text)) {
                const bool isProgram = statement.word.begin <= begin && begin <= statement.end;
                if (!isProgram || known == context.names.end()) continue;
                add(fmt::format("Add a {} for '{}'", known->type.starts_with("vec") ? "value" : "slider",
                                names[0]),
                    change({statement.end, statement.end}, " " + names[0] + " " + controlOf(known->type)),
                    each);
            }
        }
        // The command says the stage, whatever the suffix.
        const std::string_view command = base::trimmed(textAt(text, line));
        const std::optional<glsl::Stage> stage =
            source::stageOfEndWord("End" + std::string(command.substr(0, command.find_first_of(" \t"))));
        const bool isBeside = std::filesystem::path(names[0]).has_extension() &&
                              !std::filesystem::path(names[0]).is_absolute() &&
                              names[0].find("..") == std::string::npos;
        if (code == "file-E01" && createsFiles_ && stage && isBeside) {
            const std::string uri = uriOf(document.file.parent_path() / names[0]);
            const json start = {{"line", 0}, {"character", 0}};
            json edits = json::array(
                {{{"range", {{"start", start}, {"end", start}}}, {"newText", simplestShader(*stage)}}});
            json changes = json::array(
                {{{"kind", "create"}, {"uri", uri}},
                 {{"textDocument", {{"uri", uri}, {"version", nullptr}}}, {"edits", std::move(edits)}}});
            add(fmt::format("Create {}", names[0]), {{"documentChanges", std::move(changes)}}, each);
        }
    }
    const std::size_t at = lines.byte(positionIn(parameters.at("range").at("start")));
    if (document.language == CodeLanguage::glib)
        if (const auto number = numberAt(text, at, contextOf(document))) {
            glib::MessageLog unused{""};
            add("Make a slider",
                change({number->begin, number->end},
                       sliderAround(number->text, glib::readNumber(*number, unused).value)),
                nullptr);
        }
    return actions;
}

json LanguageServer::folds(const json& parameters) {
    const Document& document = documentOf(parameters);
    json folds = json::array();
    for (const Fold& each : foldsOf(document.text, document.language)) {
        folds.push_back({{"startLine", each.first}, {"endLine", each.last}});
        if (each.isComment) folds.back()["kind"] = "comment";
    }
    return folds;
}

}  // namespace glibra::editor
