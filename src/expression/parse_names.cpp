#include <fmt/format.h>

#include <algorithm>
#include <numbers>
#include <utility>

#include "base/suggest.h"
#include "expression/parser.h"

namespace glibra::expression {

bool Parser::settle(const Operand& operand) {
    if (operand.unknownWord.empty()) return true;
    const auto symbol = names_.find(operand.unknownWord);
    if (symbol)
        noValue(std::string(operand.unknownWord), *symbol, operand.range);
    else if (!functionsNamed(operand.unknownWord).empty())
        problem(operand.range, "expr-E01",
                fmt::format("'{}' is a function; its arguments follow in parentheses", operand.unknownWord));
    else
        unknownName(operand.unknownWord, operand.range);
    return false;
}

void Parser::unknownName(std::string_view name, Range range) {
    std::vector<std::string> known = names_.known({});
    std::vector<std::string_view> candidates(known.begin(), known.end());
    candidates.insert(candidates.end(), wanted_.words.begin(), wanted_.words.end());
    for (const std::string_view each : {"true", "false", "pi"}) candidates.push_back(each);
    std::string hint = base::suggestion(name, candidates);
    if (hint.empty() && !wanted_.words.empty())
        hint = fmt::format(
            "; the words here are {}",
            joined(std::vector<std::string>(wanted_.words.begin(), wanted_.words.end()), " and "));
    problem(range, "expr-E02", fmt::format("unknown name {}{}", quoted(code_.text, range), hint));
}

bool Parser::compareWithChoice(const Operand& choice, Operand& word) {
    const std::vector<std::string>& words = code_.uses[*choice.choice].symbol.words;
    const std::string_view text = textOf(word.range);
    const auto found = std::ranges::find(words, text);
    if (found == words.end()) {
        problem(word.range, "expr-E02",
                fmt::format("unknown word {}; {} is {}", quoted(code_.text, word.range),
                            code_.uses[*choice.choice].path, joined(words, " or ")));
        return false;
    }
    build_.setValue(word, static_cast<double>(found - words.begin()));
    word.type = Type::number();
    word.unknownWord = {};
    return true;
}

Parser::Parsed Parser::named(const Token& first) {
    if (first.text == "true" || first.text == "false")
        return build_.pushed(first.text == "true" ? 1 : 0, Type::boolean(), first.range);
    std::string path(first.text);
    std::optional<Symbol> symbol = names_.find(path);
    if (!symbol) return unnamed(first);
    Parsed index;
    while (true) {
        if (token_.is("[") && symbol->count > 0 && !index) {
            index = subscript(symbol->count);
            if (!index) return std::nullopt;
        } else if (token_.is(".")) {
            const Lexer before = lexer_;
            const Token dot = token_;
            const std::uint32_t end = lastEnd_;
            take();
            if (token_.kind != TokenKind::name) return unexpected("the name of a field or component");
            const Token field = token_;
            auto inner = names_.find(path + "." + std::string(field.text));
            if (inner) {
                take();
                path += "." + std::string(field.text);
                symbol = std::move(inner);
                continue;
            }
            if (symbol->type.kind == Kind::record && (symbol->count == 0 || index))
                return noSuchField(path, *symbol, field);
            if (symbol->count > 0 && !index) {
                if (field.text != "count") return noSuchField(path, *symbol, field);
                take();
                return build_.pushed(static_cast<double>(symbol->count), Type::number(),
                                     since(first.range.begin));
            }
            // A component: postfix() reads it again.
            lexer_ = before;
            token_ = dot;
            lastEnd_ = end;
            break;
        } else {
            break;
        }
    }
    const bool isValue = symbol->type.kind != Kind::record && (symbol->count == 0 || index);
    if (!isValue && path == first.text && !index) return unnamed(first);  // perhaps the word of a choice
    return loaded(path, *symbol, index, since(first.range.begin));
}

std::nullopt_t Parser::noValue(const std::string& path, const Symbol& symbol, Range range) {
    if (symbol.count > 0 && symbol.type.kind != Kind::record)
        return problem(range, "expr-E08",
                       fmt::format("'{}' is an array; use an element, {}[0] to {}[{}], or {}.count", path,
                                   path, path, symbol.count - 1, path));
    const std::vector<std::string> fields = names_.known(path);
    return problem(range, "expr-E08",
                   fmt::format("'{}' is {} {}, not a value{}{}", path, article(symbol.what), symbol.what,
                               fields.empty() ? "" : "; use one of its fields ", joined(fields, " and ")));
}

std::nullopt_t Parser::noSuchField(const std::string& path, const Symbol& symbol, const Token& field) {
    std::vector<std::string> known = names_.known(path);
    if (symbol.count > 0 && symbol.type.kind != Kind::record) known.assign(1, "count");
    const std::vector<std::string_view> candidates(known.begin(), known.end());
    std::string help = base::suggestion(field.text, candidates);
    if (help.empty() && !known.empty()) help = fmt::format("; it has {}", joined(known, " and "));
    return problem(field.range, "expr-E02",
                   fmt::format("'{}' has no field {}{}", path, quoted(code_.text, field.range), help));
}

Parser::Parsed Parser::loaded(const std::string& path, Symbol symbol, const Parsed& index, Range range) {
    if ((symbol.count > 0 && !index) || symbol.type.kind == Kind::record) return noValue(path, symbol, range);
    if (index && symbol.count == 0)
        return problem(range, "expr-E08", fmt::format("'{}' is not an array", path));
    const bool isChoice = !symbol.words.empty() && symbol.type.isNumber();
    Operand result{.type = symbol.type, .range = range, .begin = index ? index->begin : build_.end()};
    Instruction load;
    load.op = index ? Op::loadAt : Op::load;
    load.n = static_cast<std::uint8_t>(symbol.type.size());
    const std::size_t place = build_.use(path, std::move(symbol));
    load.target = static_cast<std::uint32_t>(place);
    if (isChoice) result.choice = place;
    build_.emit(load, range, index ? 1 : 0, load.n);
    return result;
}

Parser::Parsed Parser::unnamed(const Token& first) {
    if (first.text == "pi") return build_.pushed(std::numbers::pi, Type::number(), first.range);
    const auto word = std::ranges::find(wanted_.words, first.text);
    const bool isWanted = word != wanted_.words.end() && wants(Type::word());
    Operand operand = build_.pushed(isWanted ? static_cast<double>(word - wanted_.words.begin()) : 0,
                                    Type::word(), first.range);
    if (!isWanted) operand.unknownWord = first.text;
    return operand;
}

}  // namespace glibra::expression
