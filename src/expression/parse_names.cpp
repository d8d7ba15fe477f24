// Names and function calls in an expression: variables, their fields, words of a choice, functions and the
// constructors of vectors and matrices.

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <algorithm>
#include <cmath>
#include <memory>
#include <numbers>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "base/suggest.h"
#include "base/text.h"
#include "expression/apply.h"
#include "expression/functions.h"
#include "expression/measures.h"
#include "expression/parser.h"

namespace glibra::expression {

bool Parser::settle(const Operand& operand) {
    if (operand.unknownWord.empty()) return true;
    const auto symbol = find(operand.unknownWord);
    if (symbol)
        noValue(std::string(operand.unknownWord), *symbol, operand.range);
    else if (!functionsNamed(operand.unknownWord).empty() ||
             names_.findFunction(operand.unknownWord) != nullptr)
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
    if (frame_ != nullptr)
        candidates.insert(candidates.end(), frame_->function->parameters.begin(),
                          frame_->function->parameters.end());
    std::string hint = base::suggestion(name, candidates);
    if (frame_ != nullptr && std::ranges::find(wanted_.words, name) != wanted_.words.end())
        hint = "; a function has no words as its value";
    else if (hint.empty() && !wanted_.words.empty())
        hint = fmt::format(
            "; the words here are {}",
            joined(std::vector<std::string>(wanted_.words.begin(), wanted_.words.end()), " and "));
    problem(range, "expr-E02", fmt::format("unknown name {}{}", quoted(text_, range), hint));
}

bool Parser::compareWithChoice(const Operand& choice, Operand& word) {
    const std::vector<std::string>& words = code_.uses[*choice.choice].symbol.words;
    const std::string_view text = textOf(word.range);
    const auto found = std::ranges::find(words, text);
    if (found == words.end()) {
        problem(word.range, "expr-E02",
                fmt::format("unknown word {}; {} is {}", quoted(text_, word.range),
                            code_.uses[*choice.choice].path, joined(words, " or ")));
        return false;
    }
    build_.setValue(word, static_cast<double>(found - words.begin()));
    word.type = Type::number();
    word.unknownWord = {};
    return true;
}

std::optional<Symbol> Parser::find(std::string_view path) const {
    return frame_ != nullptr ? names_.findInScene(path) : names_.find(path);
}

Parser::Parsed Parser::parameter(const Token& name) {
    if (frame_ == nullptr) return std::nullopt;
    const std::vector<std::string>& names = frame_->function->parameters;
    const auto found = std::ranges::find(names, name.text);
    if (found == names.end()) return std::nullopt;
    const Argument& argument = frame_->arguments[static_cast<std::size_t>(found - names.begin())];
    const Type type = argument.operand.type;
    if (argument.operand.isConstant) return build_.pushed(argument.constant, type, name.range);
    Operand result{.type = type, .range = name.range, .begin = build_.end()};
    Instruction local;
    local.op = Op::local;
    local.n = static_cast<std::uint8_t>(type.size());
    local.target = static_cast<std::uint32_t>(argument.place);
    build_.emit(local, name.range, 0, local.n);
    return result;
}

Parser::Parsed Parser::named(const Token& first) {
    if (first.text == "true" || first.text == "false")
        return build_.pushed(first.text == "true" ? 1 : 0, Type::boolean(), first.range);
    if (Parsed own = parameter(first)) return own;
    std::string path(first.text);
    std::optional<Symbol> symbol = find(path);
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
            auto inner = find(path + "." + std::string(field.text));
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
    if (any(symbol.depends & Depends::buffer) || symbol.what == "buffer")
        return problem(
            range, "expr-E08",
            fmt::format("'{0}' is a buffer, not a value; write {0}.count, or in Expect (...) and Print (...) "
                        "{1}sum({0}{2})",
                        path, symbol.count > 0 ? path + "[0] or " : "", symbol.count > 0 ? "" : ".MEMBER"));
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
                   fmt::format("'{}' has no field {}{}", path, quoted(text_, field.range), help));
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
    const bool isWanted = word != wanted_.words.end() && wants(Type::word()) && frame_ == nullptr;
    Operand operand = build_.pushed(isWanted ? static_cast<double>(word - wanted_.words.begin()) : 0,
                                    Type::word(), first.range);
    if (!isWanted) operand.unknownWord = first.text;
    return operand;
}

namespace {

// vec3(...), mat4(...), float(...) and the other constructors.

/// What to do with the arguments of a constructor, or why it does not take them. `id` is that of the problem.
struct Construction {
    Call call;
    const char* id = nullptr;
    std::string why;
};

const char* applyCut(double* stack, const Instruction& /*i*/) {
    stack[0] = std::trunc(stack[0]);
    return nullptr;
}

/// The type that a constructor makes.
Type typeNamed(std::string_view name) {
    if (name == "float" || name == "int") return Type::number();
    if (name == "bool") return Type::boolean();
    const auto size = static_cast<std::size_t>(name.back() - '0');
    if (name.starts_with("mat")) return Type::matrix(size);
    return Type::vector(size, name.starts_with("bvec") ? Kind::boolean : Kind::number);
}

Construction with(const Type& type, Apply apply, std::size_t components) {
    Construction construction{{type, {}}, nullptr, {}};
    construction.call.instruction.op = Op::call;
    construction.call.instruction.apply = apply;
    construction.call.instruction.a = static_cast<std::uint8_t>(components);
    construction.call.instruction.n = static_cast<std::uint8_t>(type.size());
    return construction;
}

/// `name` is that of a row without apply().
Construction construct(std::string_view name, std::span<const Type> arguments) {
    const Type type = typeNamed(name);
    const auto fail = [](const char* id, std::string why) { return Construction{{}, id, std::move(why)}; };
    std::size_t components = 0;
    for (const Type& each : arguments) {
        if (each.kind != Kind::number && each.kind != Kind::boolean)
            return fail("expr-E03", fmt::format("{} is not made of a {}", name, expression::name(each)));
        if (each.isMatrix() && (arguments.size() > 1 || type.isVector()))
            return fail("expr-E03",
                        fmt::format("{} is not made of a matrix; use its columns, such as m[0]", name));
        components += each.size();
    }
    const std::size_t wanted = type.size();
    const Type first = arguments.empty() ? Type{} : arguments.front();
    if (wanted == 1) {
        if (arguments.size() != 1)
            return fail("expr-E04", fmt::format("{} takes 1 argument, found {}", name, arguments.size()));
        return with(type, name == "int" ? applyCut : name == "bool" ? applyTruth : applyFirst, components);
    }
    if (arguments.size() == 1 && first.isMatrix()) return with(type, applyResize, components);
    if (arguments.size() == 1 && first.size() == 1 && type.isMatrix())
        return with(type, applyDiagonal, components);
    const auto booleans = [&](Construction construction) {
        if (type.kind != Kind::boolean) return construction;
        construction.call.instruction.apply =
            construction.call.instruction.apply == applySpread
                ? +[](double* stack, const Instruction& i) {
                      applySpread(stack, i);
                      return applyTruth(stack, i);
                  }
                : applyTruth;
        return construction;
    };
    if (arguments.size() == 1 && first.size() == 1) return booleans(with(type, applySpread, components));
    // GLSL: the last argument may have more components than are needed, but not only such.
    const bool hasUnused =
        components > wanted && (type.isMatrix() || components - arguments.back().size() >= wanted);
    if (components < wanted || hasUnused)
        return fail("expr-E04", fmt::format("{} needs {} components, found {}", name, wanted, components));
    return booleans(with(type, applyFirst, components));
}

constexpr std::size_t kMostArguments = 16;

}  // namespace

Parser::Parsed Parser::measured(const MeasureCall& call) {
    if (!call.why.empty()) return problem(call.range, "expr-E04", call.why);
    auto symbol = frame_ == nullptr ? names_.find(call.path) : std::nullopt;
    if (!symbol)
        return problem(
            call.range, "expr-E07",
            fmt::format("{} has no value here: only Expect (condition) and Print (expression) read "
                        "what textures and buffers hold{}",
                        quoted(text_, call.range),
                        frame_ == nullptr ? "" : "; give the value to the function as an argument"));
    lexer_.goTo(call.range.end);
    take();
    lastEnd_ = call.range.end;
    return loaded(call.path, std::move(*symbol), std::nullopt, call.range);
}

Parser::Parsed Parser::call(const Token& function) {
    const std::span<const FunctionRow> forms = functionsNamed(function.text);
    if (forms.empty()) {
        if (frame_ != nullptr && frame_->function->name == function.text) return recursion(function);
        const auto ofScene = find(function.text) ? nullptr : names_.findFunction(function.text);
        return ofScene != nullptr ? callOfScene(ofScene, function) : unknownFunction(function);
    }
    const bool takesAll = forms.front().takesAll;
    build_.unchecked += takesAll ? 1 : 0;
    const auto arguments = argumentList(function);
    build_.unchecked -= takesAll ? 1 : 0;
    if (!arguments) return std::nullopt;
    const Range range = since(function.range.begin);
    std::vector<Type> types;
    for (const Operand& each : *arguments) types.push_back(each.type);
    if (forms.front().apply == nullptr) {
        Construction made = construct(function.text, types);
        if (made.id != nullptr) return problem(range, made.id, std::move(made.why));
        return build_.combined(*arguments, made.call.instruction, made.call.result, range);
    }
    for (const FunctionRow& form : forms) {
        const auto found = callOf(form, types);
        if (!found) continue;
        if (!form.readsTime) return build_.combined(*arguments, found->instruction, found->result, range);
        return moving(*arguments, *found, function, range);
    }
    return noSuchForm(forms, types, range);
}

Parser::Parsed Parser::moving(std::vector<Operand> arguments, const Call& call, const Token& function,
                              Range range) {
    const auto time = find("time");
    if (!time || !time->type.isNumber() || time->count > 0)
        return problem(range, "expr-E07",
                       fmt::format("{} needs 'time', which has no value here", function.text));
    const Parsed now = loaded("time", *time, std::nullopt, range);
    if (!now) return std::nullopt;
    arguments.push_back(*now);
    return build_.combined(arguments, call.instruction, call.result, range);
}

std::nullopt_t Parser::unknownFunction(const Token& function) {
    if (find(function.text))
        return problem(function.range, "expr-E08",
                       fmt::format("'{}' is a value, not a function; write '*' to multiply", function.text));
    std::vector<std::string_view> candidates;
    for (const FunctionRow& each : functionTable())
        if (candidates.empty() || candidates.back() != each.name()) candidates.push_back(each.name());
    const std::vector<std::string> ofScene = names_.knownFunctions();
    candidates.insert(candidates.end(), ofScene.begin(), ofScene.end());
    return problem(function.range, "expr-E02",
                   fmt::format("unknown function {}{}", quoted(text_, function.range),
                               base::suggestion(function.text, candidates)));
}

std::nullopt_t Parser::noSuchForm(std::span<const FunctionRow> forms, std::span<const Type> types,
                                  Range range) {
    std::vector<std::string> prototypes, counts;
    for (const FunctionRow& each : forms) {
        const std::size_t count = parameterCount(each);
        if (count == types.size()) prototypes.emplace_back(each.prototype);
        const std::string number = std::to_string(count);
        if (counts.empty() || counts.back() != number) counts.push_back(number);
    }
    if (prototypes.empty())
        return problem(range, "expr-E04",
                       fmt::format("{} takes {} argument{}, found {}", forms.front().name(),
                                   joined(counts, " or "), counts.back() == "1" ? "" : "s", types.size()));
    std::vector<std::string> names;
    for (const Type& each : types) names.push_back(name(each));
    return problem(range, "expr-E03",
                   fmt::format("there is no {}({}), only {}", forms.front().name(), joined(names, ", "),
                               joined(prototypes, " and ")));
}

std::optional<std::vector<Operand>> Parser::argumentList(const Token& function) {
    const Level level(*this);
    if (depth_ > limits_.depth) return tooDeep();
    std::vector<Operand> arguments;
    take();  // the parenthesis
    if (takeIf(")"))
        return problem(since(function.range.begin), "expr-E04",
                       fmt::format("{} needs arguments, found none", function.text));
    do {
        const Parsed argument = expression();
        if (!argument || !settle(*argument)) return std::nullopt;
        arguments.push_back(*argument);
        if (arguments.size() > kMostArguments)
            return problem(since(function.range.begin), "expr-E04",
                           fmt::format("{} has more than {} arguments", function.text, kMostArguments));
    } while (takeIf(","));
    if (!takeIf(")")) return unexpected("',' or ')'");
    return arguments;
}

// ---- Functions of the scene.

std::nullopt_t Parser::recursion(const Token& name) {
    return problem(name.range, "expr-E09",
                   fmt::format("'{}' calls itself; a function cannot, but the elements of an array may read "
                               "earlier ones",
                               name.text));
}

Parser::Parsed Parser::callOfScene(const std::shared_ptr<const Function>& function, const Token& name) {
    if (frame_ != nullptr && function->order >= frame_->function->order)
        return problem(name.range, "expr-E09",
                       fmt::format("'{}' is declared below, on line {}; a function calls those above it",
                                   function->name, function->origin.line));
    const std::size_t begin = build_.end();
    auto arguments = argumentsOfScene(*function, name);
    if (!arguments) return std::nullopt;
    bodyBytes_ += function->body.size();
    if (bodyBytes_ > limits_.bodies)
        return problem(since(name.range.begin), "expr-E05",
                       fmt::format("the functions that are called have more than {} bytes, each counted as "
                                   "often as it is called",
                                   base::groupedText(limits_.bodies)));
    const bool isConstant = std::ranges::all_of(*arguments, &Operand::isConstant, &Argument::operand);
    Parsed result = body({function, std::move(*arguments)}, since(name.range.begin));
    if (!result) return result;
    result->isConstant = result->isConstant && isConstant;
    result->range = since(name.range.begin);
    result->begin = begin;
    return result;
}

std::optional<std::vector<Parser::Argument>> Parser::argumentsOfScene(const Function& function,
                                                                      const Token& name) {
    const Level level(*this);
    if (depth_ > limits_.depth) return tooDeep();
    std::vector<Argument> arguments;
    take();  // the parenthesis
    if (!takeIf(")")) {
        do {
            const std::size_t place = build_.depth();
            const Parsed argument = expression();
            if (!argument || !settle(*argument)) return std::nullopt;
            if (argument->type.kind == Kind::word)
                return problem(argument->range, "expr-E03",
                               fmt::format("a word is no argument of '{}'", function.name));
            Argument& made = arguments.emplace_back(Argument{*argument, place, {}});
            if (argument->isConstant) {
                const std::span<const double> value = build_.valueOf(*argument);
                made.constant.assign(value.begin(), value.end());
                build_.erase(argument->begin, build_.end(), value.size());
            }
        } while (takeIf(",") && arguments.size() <= function.parameters.size());
        if (arguments.size() <= function.parameters.size() && !takeIf(")")) return unexpected("',' or ')'");
    }
    if (arguments.size() == function.parameters.size()) return arguments;
    const std::string all = fmt::format("{}({})", function.name, fmt::join(function.parameters, ", "));
    return problem(
        since(name.range.begin), "expr-E04",
        fmt::format(
            "{} takes {} argument{}, found {}", all, function.parameters.size(),
            function.parameters.size() == 1 ? "" : "s",
            arguments.size() > function.parameters.size() ? "more" : std::to_string(arguments.size())));
}

Parser::Parsed Parser::body(Frame frame, Range call) {
    const std::string_view text = frame.function->body;
    const std::uint32_t outerBegin = build_.textBegin;
    const auto next = code_.bodies.empty()
                          ? static_cast<std::uint32_t>(code_.text.size() + 1)
                          : code_.bodies.back().begin +
                                static_cast<std::uint32_t>(code_.bodies.back().function->body.size() + 1);
    // A call in a body belongs to the call in the text that leads to it.
    if (outerBegin == 0) callOfText_ = call;
    code_.bodies.push_back({next, frame.function, callOfText_});
    build_.textBegin = next;
    const std::string_view outerText = std::exchange(text_, text);
    const Lexer outerLexer = std::exchange(lexer_, Lexer(text));
    const Token outerToken = std::exchange(token_, {});
    const std::uint32_t outerEnd = std::exchange(lastEnd_, 0);
    const Frame* const outerFrame = std::exchange(frame_, &frame);
    take();
    Parsed result = wholeBody();
    if (result) {
        std::size_t arguments = 0;
        for (const Argument& each : frame.arguments)
            arguments += each.operand.isConstant ? 0 : each.operand.type.size();
        if (arguments > 0) {
            Instruction leave;
            leave.op = Op::leave;
            leave.n = static_cast<std::uint8_t>(result->type.size());
            leave.target = static_cast<std::uint32_t>(arguments);
            build_.emit(leave, result->range, leave.n + arguments, leave.n);
        }
        result = withinLimits(result);
    }
    build_.textBegin = outerBegin;
    text_ = outerText;
    lexer_ = outerLexer;
    token_ = outerToken;
    lastEnd_ = outerEnd;
    frame_ = outerFrame;
    return result;
}

Parser::Parsed Parser::wholeBody() {
    Parsed result = expression();
    if (!result || !settle(*result)) return std::nullopt;
    if (token_.kind != TokenKind::end) return unexpected("an operator or the end of the expression");
    result->choice.reset();
    return result;
}

std::optional<Problem> Parser::parseBody(const std::shared_ptr<const Function>& function,
                                         std::span<const Type> types) {
    Frame frame{function, {}};
    for (const Type& each : types) frame.arguments.emplace_back().operand.type = each;
    frame_ = &frame;
    wholeBody();
    frame_ = nullptr;
    return std::move(problem_);
}

}  // namespace glibra::expression
