// What the language server proposes while a text is written: corrections, the arguments of calls, folds.

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "editor/call_hint.h"
#include "editor/folds.h"
#include "editor/language_server.h"
#include "glib/number.h"
#include "glib/parse/statement.h"
#include "glib/text.h"

namespace glibra::editor {
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

/// The word as a whole in the lines from `begin` to `end`.
std::optional<TextRange> findWord(std::string_view text, std::string_view word, std::size_t begin,
                                  std::size_t end) {
    const auto isOf = [&](std::size_t at) { return at < text.size() && base::isOfName(text[at]); };
    for (std::size_t at = text.find(word, begin); at < end && !word.empty(); at = text.find(word, at + 1))
        if ((at == 0 || !isOf(at - 1)) && !isOf(at + word.size())) return TextRange{at, at + word.size()};
    return std::nullopt;
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

/// "<0 8 16>" for 8.
std::string sliderAround(double value) {
    const double far = value == 0 ? 1 : 2 * std::abs(value);
    return fmt::format("<{:g} {:g} {:g}>", value > 0 ? 0 : -far, value, value < 0 ? 0 : far);
}

/// A plain number that is the value of a uniform or variable at the byte.
std::optional<std::pair<TextRange, double>> numberAt(std::string_view scene, std::size_t byte) {
    for (const glib::Statement& each : glib::statementsOf(scene)) {
        if (!each.modern && !each.row) continue;
        const std::string_view word = each.modern ? each.modern->name : each.row->name;
        if (!glib::sameWord(word, "Program") && !glib::sameWord(word, "Let")) continue;
        for (std::size_t i = 1; i < each.arguments.size(); ++i) {
            const glib::Token& token = each.arguments[i];
            const bool isAlone = each.arguments[i - 1].isWord() &&
                                 (i + 1 == each.arguments.size() || each.arguments[i + 1].isWord());
            if (token.kind != glib::TokenKind::number || byte < token.begin || token.end < byte || !isAlone ||
                glib::numberLength(token.text) != token.text.size())
                continue;
            glib::MessageLog unused{""};
            return std::pair(TextRange{token.begin, token.end}, glib::readNumber(token, unused).value);
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
        const std::optional<glsl::Stage> stage = stageOfFile(names[0]);
        const bool isBeside =
            !std::filesystem::path(names[0]).is_absolute() && names[0].find("..") == std::string::npos;
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
        if (const auto number = numberAt(text, at))
            add("Make a slider", change(number->first, sliderAround(number->second)), nullptr);
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
