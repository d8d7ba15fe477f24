#include "glsl/read/macros.h"

#include <algorithm>
#include <utility>

#include "base/text.h"
#include "glsl/read/extensions.h"

namespace glibra::glsl {

// ---- Expansion

namespace {

bool mayBeMacro(const Token& token) {
    return token.kind == TokenKind::word && !token.directive && !token.synthetic;
}

bool needBlank(const Token& left, const Token& right) {
    if (left.text.empty() || right.text.empty()) return false;
    const char next = right.text.front();
    return growTogether(left.text.back(), next) ||
           (left.kind == TokenKind::number && (base::isOfName(next) || next == '.'));
}

}  // namespace

Macro* Expander::find(std::string_view name) {
    if (!stage_.constants.empty()) constantNamed(name);
    if (Macro* const known = macros_.find(name)) return known;
    if (!name.starts_with("GL_") && !name.starts_with("__")) return nullptr;
    std::optional<std::string> text = predefinedMacro(name, stage_.dialect, stage_.request->target);
    if (!text) return nullptr;
    Macro macro;
    macro.isPredefined = true;
    BodyToken& number = macro.body.emplace_back();
    number.text = stage_.storage.emplace_back(std::move(*text));
    number.kind = TokenKind::number;
    macros_.define(name, std::move(macro));
    return macros_.find(name);
}

bool Expander::isDefined(std::string_view name) {
    return isPlaceMacro(name) || find(name) != nullptr;
}

bool Expander::countStep() {
    isExhausted_ = isExhausted_ || ++steps_ > kMostSteps;
    return !isExhausted_;
}

void Expander::run(const std::function<bool()>& more) {
    more_ = &more;
    Pieces result;
    for (;;) {
        if (at_ == input_.size()) {
            firstOrder_ += static_cast<std::uint32_t>(input_.size());
            input_.clear();
            at_ = 0;
            if (!more()) break;
            continue;
        }
        const Token token = input_[at_++];
        if (mayBeMacro(token) && declaresConstant(token)) continue;
        if (!mayBeMacro(token) || isExhausted_ || !isDefined(token.text)) {
            write(token);
            continue;
        }
        result.clear();
        lineEnds_.clear();
        name({token, firstOrder_ + static_cast<std::uint32_t>(at_ - 1)}, {0, true}, result);
        drain({0, true}, result);
        flush(result);
    }
    more_ = nullptr;
}

const Constant* Expander::constantNamed(std::string_view name) {
    const auto found = std::ranges::find(stage_.constants, name, &Constant::name);
    if (found == stage_.constants.end()) return nullptr;
    stage_.namedConstants.insert(found->name);
    return &*found;
}

bool Expander::defineConstant(const Constant& constant, std::string_view type, const Token& at) {
    auto text = textOf(constant, constant.type.empty() ? type : std::string_view(constant.type));
    if (constant.components.empty()) text = "1";
    if (!text) {
        complain_("glsl-E18",
                  "'" + constant.name + "' is " + std::string(type) + " here, and the scene gives it " +
                      valueText(constant),
                  at);
        return false;
    }
    Macro macro;
    macro.line = at.line;
    for (const Token& each : lex(stage_.storage.emplace_back(*text), stage_.storage))
        if (isSignificant(each.kind)) {
            BodyToken& body = macro.body.emplace_back();
            body.text = each.text;
            body.kind = each.kind;
        }
    macros_.define(constant.name, std::move(macro));
    return true;
}

const Token* Expander::nextSignificant() {
    for (std::size_t i = at_;; ++i) {
        while (i == input_.size())
            if (!(*more_)()) return nullptr;
        const Token& each = input_[i];
        if (isSignificant(each.kind) && !each.directive && !each.synthetic) return &each;
    }
}

bool Expander::declaresConstant(const Token& name) {
    if (stage_.constants.empty() || declared_.contains(name.text)) return false;
    const Constant* const constant = constantNamed(name.text);
    if (constant == nullptr) return false;
    // The words of the statement so far, from its end.
    constexpr std::size_t kMost = 256;
    std::vector<std::string_view> words;
    for (auto each = stage_.tokens.rbegin(); each != stage_.tokens.rend() && words.size() < kMost; ++each) {
        if (!isSignificant(each->kind) || each->directive) continue;
        if (each->text == ";" || each->text == "{" || each->text == "}") break;
        words.push_back(each->text);
    }
    const bool isAfterType = !words.empty() && isTypeWord(words.front());
    const bool isConst = std::ranges::find(words, "const") != words.end();
    if (!isAfterType && !(isConst && !words.empty() && words.front() == ",")) return false;
    const Token* const next = nextSignificant();
    const bool hasValue = next != nullptr && next->text == "=";
    if (isConst && hasValue && constant->components.empty()) {
        declared_.insert(constant->name);
        macros_.undefine(name.text);
        return false;
    }
    if (isConst && hasValue) {
        std::string type;
        for (const std::string_view each : words)
            if (isTypeWord(each)) type = each;
        writeConstant(*constant, type, name);
        return true;
    }
    if (!isAfterType) return false;
    complain_("glsl-E18",
              "'" + constant->name +
                  "' is a constant that the Program statement gives, so it is declared as 'const " +
                  std::string(words.front()) + " " + constant->name + " = ...;', as a #define or not at all",
              name);
    declared_.insert(constant->name);
    macros_.undefine(name.text);
    write(name);
    return true;
}

void Expander::writeConstant(const Constant& constant, const std::string& type, const Token& name) {
    declared_.insert(constant.name);
    macros_.undefine(name.text);
    const auto text = textOf(constant, type);
    const bool fits = text && (constant.type.empty() || constant.type == type);
    if (!fits)
        complain_("glsl-E18",
                  "'" + constant.name + "' is declared as " + type + ", and the scene gives it " +
                      (constant.type.empty() ? "" : constant.type + " ") + valueText(constant),
                  name);
    write(name);
    bool isBefore = true, isWritten = false;
    for (int depth = 0; nextSignificant() != nullptr;) {
        const Token token = input_[at_];
        if (isSignificant(token.kind) && depth == 0 && (token.text == "," || token.text == ";")) return;
        ++at_;
        if (!isSignificant(token.kind) || isBefore || !fits) {
            write(token);
            isBefore = isBefore && token.text != "=";
            continue;
        }
        depth += opensBracket(token.text) ? 1 : closesBracket(token.text) ? -1 : 0;
        if (std::exchange(isWritten, true)) continue;
        Token value = token;
        value.text = stage_.storage.emplace_back(*text);
        value.kind = TokenKind::number;
        for (const Token& each : lex(value.text, stage_.storage)) {
            value.text = each.text;
            value.kind = each.kind;
            write(value);
        }
    }
}

std::vector<Piece> Expander::expand(std::vector<Piece> pieces) {
    Pieces result;
    const std::size_t base = contexts_.size();
    push(std::move(pieces), nullptr);
    drain({base, false}, result);
    return result;
}

void Expander::push(Pieces pieces, Macro* macro) {
    if (macro) macro->expanding = true;
    contexts_.push_back({std::move(pieces), 0, macro});
}

void Expander::popExhausted(std::size_t base) {
    while (contexts_.size() > base && contexts_.back().at == contexts_.back().pieces.size()) {
        if (contexts_.back().macro) contexts_.back().macro->expanding = false;
        contexts_.pop_back();
    }
}

void Expander::drain(Reach reach, Pieces& out) {
    for (;;) {
        popExhausted(reach.base);
        if (contexts_.size() <= reach.base) return;
        if (isExhausted_) {
            contexts_.back().at = contexts_.back().pieces.size();
            continue;
        }
        Context& top = contexts_.back();
        name(top.pieces[top.at++], reach, out);
    }
}

void Expander::name(Piece piece, Reach reach, Pieces& out) {
    const bool isName = piece.token.kind == TokenKind::word && !piece.painted && countStep();
    if (isName && isPlaceMacro(piece.token.text)) piece = placeMacro(piece);
    Macro* const macro = isName && piece.token.kind == TokenKind::word ? find(piece.token.text) : nullptr;
    if (macro && macro->expanding) piece.painted = true;
    if (!macro || piece.painted) {
        out.push_back(piece);
        return;
    }
    std::vector<Pieces> arguments;
    if (macro->takesArguments) {
        if (!takeParenthesis(reach)) {
            out.push_back(piece);
            return;
        }
        if (!takeArguments(reach, arguments)) {
            if (!isExhausted_)
                complain_("glsl-E15",
                          "the call of the macro '" + std::string(piece.token.text) + "' has no closing ')'",
                          piece.token);
            return;
        }
        if (arguments.size() == 1 && arguments[0].empty() && macro->parameters.empty()) arguments.clear();
        if (arguments.size() != macro->parameters.size()) {
            // In the text of a macro it is one mistake, however often that is used.
            if (piece.token.body == kNone || reported_.insert(piece.token.body).second)
                complain_("glsl-E15",
                          "macro '" + std::string(piece.token.text) + "' takes " +
                              base::counted(macro->parameters.size(), "argument") + ", found " +
                              std::to_string(arguments.size()),
                          piece.token);
            return;
        }
    }
    push(substitute(*macro, arguments, piece), macro);
}

Piece Expander::placeMacro(const Piece& piece) {
    Piece number = piece;
    const long long value = piece.token.text == "__LINE__" ? piece.token.line : fileNumber_;
    number.token.text = stage_.storage.emplace_back(std::to_string(value));
    number.token.kind = TokenKind::number;
    return number;
}

bool Expander::takeParenthesis(Reach reach) {
    popExhausted(reach.base);
    if (contexts_.size() > reach.base) {
        Context& top = contexts_.back();
        if (top.pieces[top.at].token.text != "(") return false;
        ++top.at;
        return true;
    }
    if (!reach.text) return false;
    std::size_t i = at_;
    const auto isPassedOver = [&](const Token& token) {
        return !isSignificant(token.kind) || token.directive || token.synthetic;
    };
    do {
        while (i < input_.size() && isPassedOver(input_[i])) ++i;
    } while (i == input_.size() && (*more_)());
    if (i == input_.size() || input_[i].text != "(") return false;
    Piece parenthesis;
    return nextOfText(parenthesis);
}

bool Expander::takeArguments(Reach reach, std::vector<Pieces>& arguments) {
    arguments.emplace_back();
    Piece piece;
    for (int depth = 1; next(reach, piece);) {
        const std::string_view text = piece.token.text;
        if (text == "(") ++depth;
        if (text == ")" && --depth == 0) return true;
        if (text == "," && depth == 1) {
            arguments.emplace_back();
            continue;
        }
        if (depth_ > 0 && !countStep()) return false;
        if (piece.token.kind == TokenKind::word && !piece.painted) {
            const Macro* const macro = macros_.find(text);
            piece.painted = macro && macro->expanding;
        }
        arguments.back().push_back(piece);
    }
    return false;
}

bool Expander::next(Reach reach, Piece& piece) {
    popExhausted(reach.base);
    if (contexts_.size() <= reach.base) return reach.text && nextOfText(piece);
    Context& top = contexts_.back();
    piece = top.pieces[top.at++];
    return true;
}

bool Expander::nextOfText(Piece& piece) {
    for (bool blank = false;; blank = true) {
        if (at_ == input_.size() && !(*more_)()) return false;
        if (at_ == input_.size()) continue;
        const Token token = input_[at_];
        const std::uint32_t order = firstOrder_ + static_cast<std::uint32_t>(at_++);
        if (isSignificant(token.kind) && !token.directive && !token.synthetic) {
            piece = {token, order, blank};
            return true;
        }
        keepLineEnds(token, order);
    }
}

/// Line ends and directives inside a call stay in the text, so that line numbers stay right.
void Expander::keepLineEnds(const Token& token, std::uint32_t order) {
    if (token.directive || token.synthetic || token.kind == TokenKind::newline) {
        lineEnds_.push_back({token, order});
        return;
    }
    Token end = token;
    end.kind = TokenKind::newline;
    end.text = "\n";
    for (auto count = std::ranges::count(token.text, '\n'); count > 0; --count) {
        lineEnds_.push_back({end, order});
        ++end.line;
    }
}

std::vector<Piece> Expander::substitute(const Macro& macro, const std::vector<Pieces>& arguments,
                                        const Piece& call) {
    std::vector<std::optional<Pieces>> expanded(arguments.size());
    const auto expandedArgument = [&](std::size_t index) -> const Pieces& {
        if (expanded[index]) return *expanded[index];
        if (++depth_ > kDeepestCalls && !isExhausted_) {
            isExhausted_ = true;
            complain_("glsl-E15", "macro calls stand in each other's arguments more than 200 deep",
                      call.token);
        }
        expanded[index] = isExhausted_ ? Pieces{} : expand(arguments[index]);
        --depth_;
        return *expanded[index];
    };
    Pieces result;
    bool pasteNext = false;
    const auto add = [&](Piece piece) {
        if (std::exchange(pasteNext, false) && !result.empty())
            paste(result, result.size() - 1, piece);
        else
            result.push_back(piece);
    };
    for (const BodyToken& each : macro.body) {
        if (!countStep()) break;
        pasteNext = each.isAfterPaste;
        if (each.parameter < 0) {
            Piece piece;
            piece.token.text = each.text;
            piece.token.kind = each.kind;
            piece.token.line = call.token.line;
            piece.token.column = call.token.column;
            piece.token.file = call.token.file;
            piece.token.body = each.body;
            piece.order = call.order;
            piece.blank = each.blank;
            add(piece);
            continue;
        }
        const auto index = static_cast<std::size_t>(each.parameter);
        const bool isOperand = each.isPasted || each.isAfterPaste;
        const Pieces& argument = isOperand ? arguments[index] : expandedArgument(index);
        if (argument.empty() && isOperand) {
            // Stands for nothing until all is pasted.
            Piece nothing;
            nothing.token.text = {};
            nothing.token.kind = TokenKind::blank;
            nothing.order = call.order;
            add(nothing);
        }
        for (std::size_t i = 0; i < argument.size() && countStep(); ++i) {
            Piece piece = argument[i];
            if (i == 0) piece.blank = each.blank;
            add(piece);
        }
    }
    std::erase_if(result, [](const Piece& each) { return each.token.text.empty(); });
    if (!result.empty()) result.front().blank = call.blank;
    return result;
}

void Expander::paste(Pieces& pieces, std::size_t left, Piece right) {
    Piece& to = pieces[left];
    if (right.token.text.empty()) return;
    if (to.token.text.empty()) {
        right.blank = to.blank;
        to = right;
        return;
    }
    const std::string both = std::string(to.token.text) + std::string(right.token.text);
    std::deque<std::string> unused;
    const std::vector<Token> tokens = lex(both, unused);
    if (tokens.size() != 1 || !isSignificant(tokens[0].kind)) {
        complain_("glsl-E15",
                  "'" + std::string(to.token.text) + "' ## '" + std::string(right.token.text) +
                      "' does not make one token",
                  to.token);
        return;
    }
    to.token.kind = tokens[0].kind;
    to.token.text = stage_.storage.emplace_back(both);
    to.painted = false;
}

void Expander::flush(const Pieces& result) {
    std::size_t end = 0;
    const auto writeLineEnds = [&](std::uint32_t before) {
        for (; end < lineEnds_.size() && lineEnds_[end].order < before; ++end) write(lineEnds_[end].token);
    };
    bool isFirst = true;
    for (const Piece& each : result) {
        writeLineEnds(each.order);
        if (each.blank && !isFirst) writeBlank(each.token);
        isFirst = false;
        afterCall_ = true;
        write(each.token);
        stage_.tokens.back().expanded = true;
    }
    writeLineEnds(kNone);
    afterCall_ = true;
}

void Expander::write(const Token& token) {
    // Elsewhere the source itself keeps tokens apart.
    if (std::exchange(afterCall_, false) && !stage_.tokens.empty() && needBlank(stage_.tokens.back(), token))
        writeBlank(token);
    if (!token.directive && !token.synthetic && token.kind == TokenKind::punctuator &&
        token.text.front() == '#')
        complain_("glsl-E14",
                  "'" + std::string(token.text) + "' stands only at the start of a directive's line", token);
    stage_.tokens.push_back(token);
}

void Expander::writeBlank(const Token& before) {
    if (stage_.tokens.empty() || !isSignificant(stage_.tokens.back().kind)) return;
    Token blank = before;
    blank.text = " ";
    blank.kind = TokenKind::blank;
    blank.synthetic = true;
    blank.body = kNone;
    blank.expanded = true;
    stage_.tokens.push_back(blank);
}

bool Macro::isSameAs(const Macro& other) const {
    return takesArguments == other.takesArguments && parameters == other.parameters &&
           std::equal(body.begin(), body.end(), other.body.begin(), other.body.end(),
                      [&](const BodyToken& a, const BodyToken& b) {
                          const bool isFirst = &a == body.data();
                          return a.text == b.text && (isFirst || a.blank == b.blank) &&
                                 a.isPasted == b.isPasted;
                      });
}

void MacroTable::define(std::string_view name, Macro macro) {
    current_.insert_or_assign(name, &all_.emplace_back(std::move(macro)));
}

// ---- Predefined macros

namespace {

constexpr int kFirstWithProfiles = 150;
constexpr int kFirstWithPrecision = 130;

bool isDefined(std::string_view name, const Dialect& dialect, const Target& target) {
    if (name == "GL_ES") return dialect.es;
    if (name == "GL_FRAGMENT_PRECISION_HIGH") return dialect.es || dialect.version >= kFirstWithPrecision;
    const bool hasProfiles = !dialect.es && dialect.version >= kFirstWithProfiles;
    if (name == "GL_core_profile") return hasProfiles;
    if (name == "GL_compatibility_profile") return hasProfiles && !dialect.core;
    return isInCore(name, target.version) || (target.hasExtension && target.hasExtension(name));
}

}  // namespace

std::optional<std::string> predefinedMacro(std::string_view name, const Dialect& dialect,
                                           const Target& target) {
    if (name == "__VERSION__") return std::to_string(dialect.written);
    if (name.starts_with("GL_") && isDefined(name, dialect, target)) return "1";
    return std::nullopt;
}

bool isPlaceMacro(std::string_view name) {
    return name == "__LINE__" || name == "__FILE__";
}

bool isReservedMacro(std::string_view name) {
    return isPlaceMacro(name) || name == "__VERSION__" || name.starts_with("GL_");
}

}  // namespace glibra::glsl
