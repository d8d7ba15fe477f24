#include "editor/scene_places.h"

#include <fmt/format.h>

#include <algorithm>
#include <set>

#include "base/text.h"
#include "glib/number.h"
#include "glib/parse/arguments.h"
#include "glib/parse/statement.h"
#include "glib/script.h"
#include "glib/syntax.h"
#include "glib/text.h"
#include "glsl/read/words.h"

namespace glibra::editor {
namespace {

using glib::CommandId;
using glib::Token;
using glib::TokenKind;

std::optional<double> plainNumber(const Token& token) {
    if (token.kind != TokenKind::number || glib::numberLength(token.text) != token.text.size())
        return std::nullopt;
    glib::MessageLog unused{""};
    return glib::readNumber(token, unused).value;
}

/// The numbers from `begin` on, at most those of a colour.
std::vector<double> numbersFrom(const std::vector<Token>& tokens, std::size_t begin) {
    constexpr std::size_t kMostComponents = 4;
    std::vector<double> numbers;
    for (std::size_t i = begin; i < tokens.size() && numbers.size() < kMostComponents; ++i) {
        const std::optional<double> number = plainNumber(tokens[i]);
        if (!number) break;
        numbers.push_back(*number);
    }
    return numbers;
}

WrittenColor colorOf(const std::vector<double>& numbers, TextRange place) {
    WrittenColor color{place};
    std::ranges::copy(numbers, color.components.begin());
    return color;
}

bool isColor(const std::vector<double>& numbers) {
    return numbers.size() >= 3 &&
           std::ranges::all_of(numbers, [](double each) { return each >= 0 && each <= 1; });
}

bool statesColor(const glib::Statement& statement) {
    if (!statement.row) return false;
    const CommandId id = statement.row->id;
    return id == CommandId::color || id == CommandId::background || id == CommandId::glColor;
}

bool namesFiles(const glib::Statement& statement) {
    const glib::StatementRow* row = statement.modern ? statement.modern : statement.row;
    return row && takesFile(*row);
}

}  // namespace

std::vector<Declaration> declarationsOf(std::string_view scene) {
    std::vector<Declaration> found;
    for (const glib::Statement& statement : glib::statementsOf(scene)) {
        const glib::StatementRow* row = statement.modern;
        const std::string_view word = row             ? row->name
                                      : statement.row ? statement.row->name
                                                      : std::string_view();
        if (word.empty()) continue;
        const bool isShader = statement.body.data() != nullptr;
        const bool isBlock = (row && row->role == glib::BlockRole::opens) || isShader;
        const bool declares =
            (row && row->declaresName) || glib::sameWord(word, "Program") || (isBlock && !isShader);
        if (!declares && !isBlock) continue;
        const Token* name = !isShader && !statement.arguments.empty() && statement.arguments.front().isWord()
                                ? &statement.arguments.front()
                                : &statement.word;
        if (name == &statement.word && declares && !isBlock && !glib::sameWord(word, "Program")) continue;
        found.push_back({isShader || name == &statement.word ? std::string(word) : std::string(name->text),
                         std::string(word),
                         {statement.word.begin, std::max(statement.end, name->end)},
                         {name->begin, name->end},
                         isBlock});
    }
    return found;
}

/// The parameters of `Let name(parameters) (...)`; of other statements none.
static std::set<std::string> parametersIn(std::string_view scene, const glib::Statement& statement) {
    const std::vector<Token>& tokens = statement.arguments;
    std::set<std::string> names;
    const bool isFunction = statement.modern != nullptr && glib::sameWord(statement.word.text, "Let") &&
                            tokens.size() > 2 && tokens[1].kind == TokenKind::expression &&
                            tokens[1].begin == tokens[0].end;
    for (std::size_t at = isFunction ? tokens[1].begin : scene.size();
         at < std::min(scene.size(), tokens.size() > 1 ? tokens[1].end : 0); ++at) {
        if (!base::isOfName(scene[at])) continue;
        const TextRange place = wordAt(scene, at);
        names.emplace(scene.substr(place.begin, place.end - place.begin));
        at = place.end;
    }
    return names;
}

/// The index of the first argument that may be a tag, which follows the name of a program; beyond their
/// number if none is.
static std::size_t firstTag(const glib::Statement& statement, CommandId id) {
    const std::vector<Token>& tokens = statement.arguments;
    if (id == CommandId::set || id == CommandId::attribute) return 0;
    if (id == CommandId::program) return tokens.size() > 1 && tokens[1].beginsValue() ? 0 : 1;
    if (id == CommandId::dispatch || id == CommandId::use) return 1;
    const auto with =
        std::ranges::find_if(tokens, [](const Token& each) { return glib::sameWord(each.text, "with"); });
    return static_cast<std::size_t>(with - tokens.begin()) + (id == CommandId::fill ? 2 : tokens.size() + 1);
}

std::vector<SceneWord> namesIn(std::string_view scene) {
    std::vector<SceneWord> found;
    std::set<std::size_t> declared;
    std::set<std::string, std::less<>> programs;
    for (const Declaration& each : declarationsOf(scene)) {
        declared.insert(each.place.begin);
        if (each.word == "Program") programs.insert(each.name);
    }
    for (const glib::Statement& statement : glib::statementsOf(scene)) {
        const glib::StatementRow* row = statement.modern ? statement.modern : statement.row;
        if (!row || statement.body.data() != nullptr) continue;
        const std::size_t tags = firstTag(statement, row->id);
        const std::vector<std::string>& keys = glib::syntaxOf(*row).keys;
        const std::set<std::string> parameters = parametersIn(scene, statement);
        std::string program, owner;
        int depth = 0;
        bool isValue = false;  // what follows a tag or key
        bool isConstant = false;
        for (std::size_t i = 0; i < statement.arguments.size(); ++i) {
            const Token& token = statement.arguments[i];
            if (token.kind == TokenKind::open) ++depth;
            if (token.kind == TokenKind::close) --depth;
            const bool isWord = token.kind == TokenKind::word;
            if (i + 1 == tags) program = token.text;
            bool isTag =
                isWord && depth == 0 && i >= tags && !isValue && (i == 0 || row->id != CommandId::attribute);
            if (isTag && row->id == CommandId::program) {
                const bool isConst = glib::sameWord(token.text, "const");
                const bool isType = std::exchange(isConstant, isConst) && glsl::isTypeWord(token.text);
                isConstant = isConst || isType;
                if (isConstant) continue;
            }
            const bool isKey =
                isWord && depth == 0 && !declared.contains(token.begin) &&
                (row->id != CommandId::program || !isTag) &&
                std::ranges::any_of(keys, [&](const auto& each) { return glib::sameWord(each, token.text); });
            isTag = isTag && !isKey;
            isValue = isTag || (isValue && depth > 0) || (isKey && !glib::sameWord(token.text, "discard"));
            const bool isFile = isWord && namesFiles(statement) && token.text.find('.') != token.text.npos;
            // The name of a program may have any bytes.
            const bool isProgram =
                !isTag && token.isWord() && (i + 1 == tags || programs.contains(token.text));
            if (isFile || isKey || (token.kind != TokenKind::expression && !isWord && !isProgram)) continue;
            for (std::size_t at = token.begin; at < token.end; ++at) {
                if (!isProgram && !base::isOfName(scene[at])) continue;
                const auto text = static_cast<std::size_t>(token.text.data() - scene.data());
                const TextRange place =
                    isProgram ? TextRange{text, text + token.text.size()} : wordAt(scene, at);
                at = isProgram ? token.end : place.end;
                const bool isMember = place.begin > token.begin && scene[place.begin - 1] == '.';
                if (!isProgram && ((isMember && !isTag) || base::isDigit(scene[place.begin]))) continue;
                SceneWord& word = found.emplace_back(SceneWord{
                    std::string(scene.substr(place.begin, place.end - place.begin)), place,
                    declared.contains(isProgram ? token.begin : place.begin),
                    isTag && (isMember || place.begin == token.begin), isTag ? program : std::string(),
                    isMember && !isProgram ? owner : std::string()});
                owner = word.name;
                if (i == 0 || !parameters.contains(word.name)) continue;
                word.function = statement.word.begin;
                word.isDeclaration = i == 1;
            }
        }
    }
    return found;
}

std::vector<WrittenColor> colorsOf(std::string_view scene) {
    std::vector<WrittenColor> found;
    for (const glib::Statement& statement : glib::statementsOf(scene)) {
        const std::vector<Token>& tokens = statement.arguments;
        if (statesColor(statement)) {
            const std::vector<double> numbers = numbersFrom(tokens, 0);
            if (isColor(numbers))
                found.push_back(colorOf(numbers, {tokens.front().begin, tokens[numbers.size() - 1].end}));
            continue;
        }
        for (std::size_t i = 0; i < tokens.size(); ++i) {
            if (tokens[i].kind != TokenKind::open || tokens[i].text != "{") continue;
            const std::vector<double> numbers = numbersFrom(tokens, i + 1);
            const std::size_t close = i + 1 + numbers.size();
            if (!isColor(numbers) || close >= tokens.size() || tokens[close].text != "}") continue;
            found.push_back(colorOf(numbers, {tokens[i].begin, tokens[close].end}));
        }
    }
    return found;
}

std::string colorText(const std::array<double, 4>& components, std::string_view written) {
    const auto numbersIn = [](std::string_view text) {
        std::size_t count = 0;
        bool isInside = false;
        for (const char c : text) {
            const bool isOfNumber = std::string_view(" \t{},").find(c) == std::string_view::npos;
            count += isOfNumber && !isInside ? 1 : 0;
            isInside = isOfNumber;
        }
        return count;
    };
    const std::size_t count = numbersIn(written) == 3 && components[3] >= 1 ? 3 : 4;
    std::string text;
    for (std::size_t i = 0; i < count; ++i) {
        std::string number = fmt::format("{:.3f}", std::clamp(components[i], 0., 1.));
        number.erase(number.find_last_not_of('0') + 1);
        if (number.ends_with('.')) number.pop_back();
        if (number.starts_with("0.")) number.erase(0, 1);
        text += (i == 0 ? "" : " ") + number;
    }
    return written.starts_with('{') ? "{" + text + "}" : text;
}

bool takesFile(const glib::StatementRow& row) {
    return hasNode(row, [](const glib::SyntaxNode& each) {
        return each.type == glib::ValueType::file || each.type == glib::ValueType::texels;
    });
}

std::vector<NamedFile> filesIn(std::string_view scene) {
    std::vector<NamedFile> found;
    for (const glib::Statement& statement : glib::statementsOf(scene)) {
        const std::vector<Token>& arguments = statement.arguments;
        if (!namesFiles(statement) || arguments.empty() || glib::sameWord(arguments.front().text, "inline"))
            continue;
        for (const Token& each : arguments) {
            const bool isFile =
                each.kind == TokenKind::quoted ||
                (each.kind == TokenKind::word && each.text.find('.') != std::string_view::npos);
            if (isFile) found.push_back({std::string(each.text), {each.begin, each.end}});
        }
    }
    return found;
}

std::vector<NamedFile> includesIn(std::string_view shader) {
    std::vector<NamedFile> found;
    for (std::size_t begin = 0; begin < shader.size();) {
        const std::size_t end = std::min(shader.find_first_of("\r\n", begin), shader.size());
        const std::string_view line = shader.substr(begin, end - begin);
        const std::size_t hash = line.find_first_not_of(" \t");
        if (hash != std::string_view::npos && line[hash] == '#') {
            const std::size_t word = line.find_first_not_of(" \t", hash + 1);
            const std::size_t open = line.find_first_of("\"<");
            const std::size_t close =
                open == std::string_view::npos ? open : line.find(line[open] == '<' ? '>' : '"', open + 1);
            if (word != std::string_view::npos && line.substr(word).starts_with("include") &&
                close != std::string_view::npos)
                found.push_back({std::string(line.substr(open + 1, close - open - 1)),
                                 {begin + open + 1, begin + close}});
        }
        begin = end + 1;
    }
    return found;
}

}  // namespace glibra::editor
