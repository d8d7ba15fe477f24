#include <fmt/format.h>

#include <algorithm>
#include <cstddef>
#include <map>
#include <optional>
#include <set>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "classroom/normal_form.h"
#include "glsl/read/words.h"

namespace glibra::classroom {
namespace {

constexpr std::size_t kLargestBody = 2'000;             // tokens of a function that is written out
constexpr std::size_t kGrowth = 4, kLeastRoom = 2'000;  // how far a text may grow, in times and in tokens
constexpr std::size_t kDeepestCall = 60;
constexpr std::size_t kLargestValue = 500;  // tokens of a value that takes the place of its variable
constexpr std::size_t kFarthest = 200;      // statements between where a variable is set and its use
constexpr std::size_t kShortArgument = 3;   // tokens that are repeated rather than named

bool isControl(const Code& statement) {
    static const std::set<std::string_view> kWords{"if", "for", "while", "do", "switch", "{", "else"};
    return !statement.empty() && kWords.contains(statement.front().text);
}

/// "const vec3 a = b, c;" as "vec3 a = b;" and "vec3 c;"; nothing if it declares no variable.
std::vector<Code> declarations(const Code& statement) {
    const std::size_t type = !statement.empty() && statement[0].text == "const" ? 1 : 0;
    if (isControl(statement) || statement.size() < type + 3 || statement.back().text != ";" ||
        !statement[type].isWord || !isDeclaredName(statement, type + 1))
        return {};
    std::vector<Code> made;
    const std::span<const CodeToken> all(statement);
    for (const auto& part : splitAtCommas(all.subspan(type + 1, statement.size() - type - 2))) {
        Code& one = made.emplace_back(Code{statement[type]});
        one.insert(one.end(), part.begin(), part.end());
        one.push_back(statement.back());
    }
    return made;
}

/// The sign of the only assignment of "a.b = c;" or "a *= c;"; 0 if the statement is none.
std::size_t onlyAssignment(std::span<const CodeToken> statement) {
    std::size_t sign = 0;
    for (std::size_t i = 0; i < statement.size(); ++i) {
        if (!glsl::isAssignment(statement[i].text) && !glsl::isStep(statement[i].text)) continue;
        if (sign > 0 || glsl::isStep(statement[i].text)) return 0;
        sign = i;
    }
    const bool isWhole = sign > 0 && sign + 2 < statement.size() && statement.back().text == ";";
    return isWhole && !isDeclaredName(statement, 1) ? sign : 0;
}

/// "if (a) b = c; else b = d;" as "b = a ? c : d;"; nothing if it is another statement.
std::optional<Code> asConditional(const CodeTree& tree, std::uint32_t statement, int nested = 0) {
    constexpr int kMostNested = 16;
    const std::uint32_t otherwise = tree.child(statement, 2);
    if (nested > kMostNested || !tree.is(statement, glsl::NodeKind::branch) || otherwise == glsl::kNone)
        return std::nullopt;
    const auto inner = [&](std::uint32_t side) {
        const std::span<const CodeToken> code = tree.code(side);
        const bool isBlock = code.size() > 2 && code.front().text == "{" && code.back().text == "}";
        return isBlock ? code.subspan(1, code.size() - 2) : code;
    };
    const std::optional<Code> chain = asConditional(tree, otherwise, nested + 1);
    const std::span<const CodeToken> one = inner(tree.child(statement, 1));
    const std::span<const CodeToken> two = chain ? *chain : inner(otherwise);
    const std::size_t signOne = onlyAssignment(one), signTwo = onlyAssignment(two);
    const auto isSame = [](const CodeToken& a, const CodeToken& b) { return a.text == b.text; };
    if (signOne == 0 || signOne != signTwo ||
        !std::ranges::equal(one.first(signOne), two.first(signTwo), isSame))
        return std::nullopt;
    const CodeLine line = tree.code(statement).front().line;
    Code made(one.begin(), one.begin() + static_cast<std::ptrdiff_t>(signOne));
    const auto add = [&](std::span<const CodeToken> part) {
        made.insert(made.end(), part.begin(), part.end());
    };
    const auto value = [&](std::span<const CodeToken> of) {
        return assignedBy(of.first(signOne), of[signOne], of.subspan(signOne + 1, of.size() - signOne - 2));
    };
    made.push_back(sign("=", line));
    add(tree.code(tree.child(statement, 0)));
    made.push_back(sign("?", line));
    add(value(one));
    made.push_back(sign(":", line));
    add(value(two));
    made.push_back(two.back());
    return made;
}

std::optional<Code> asConditional(std::span<const CodeToken> statement) {
    if (statement.empty() || statement[0].text != "if") return std::nullopt;
    const CodeTree tree(statement, CodeTree::Of::statement);
    return tree.functions().empty() ? std::nullopt : asConditional(tree, tree.functions().front());
}

struct Parameter {
    CodeToken type;
    std::string_view name;
    bool isOut = false;
};

/// A function that can be written out.
struct Body {
    std::vector<Parameter> parameters;
    std::vector<Code> statements;  ///< without the return at the end
    Code result;                   ///< what it returns; empty: nothing
    std::size_t size = 0;          ///< tokens
};

class Detours {
  public:
    Detours(std::vector<CodeToken> tokens, const OwnFunctions& own,
            const std::function<bool(const CodeItem&)>& mayInline, std::deque<std::string>& names)
        : tokens_(std::move(tokens)),
          own_(own),
          mayInline_(mayInline),
          names_(names),
          items_(itemsOf(tokens_)),
          room_(kGrowth * tokens_.size() + kLeastRoom) {
        std::map<std::string_view, int> counts;
        for (std::size_t i = 0; i < items_.size(); ++i)
            if (items_[i].isFunction) {
                functions_[items_[i].names.front()] = i;
                ++counts[items_[i].names.front()];
            }
        for (const auto& [name, count] : counts)
            if (count > 1) functions_.erase(name);  // overloads are told apart by types
        bodies_.resize(items_.size());
        states_.resize(items_.size(), State::unread);
    }

    Code run() {
        Code made;
        for (std::size_t i = 0; i < items_.size(); ++i) {
            if (items_[i].isFunction) read(i, 0);
            const std::span<const CodeToken> code = items_[i].isFunction ? codes_[i] : codeOf(items_[i]);
            made.insert(made.end(), code.begin(), code.end());
        }
        return made;
    }

  private:
    enum class State { unread, isRead, done };

    [[nodiscard]] std::span<const CodeToken> codeOf(const CodeItem& item) const {
        return std::span(tokens_).subspan(item.begin, item.end - item.begin);
    }

    /// Simplifies a function, with the functions that it calls first.
    void read(std::size_t item, std::size_t depth) {
        if (states_[item] != State::unread) return;
        states_[item] = State::isRead;
        const Code inlined = withBlocks(codeOf(items_[item]), [&](std::vector<Code>& statements) {
            writeOut(statements, depth);
            declareWhereSet(statements);
        });
        std::map<std::string_view, std::size_t> counts;
        for (std::size_t i = 0; i < inlined.size(); ++i)
            if (isVariableName(inlined, i)) ++counts[inlined[i].text];
        codes_[item] =
            withBlocks(inlined, [&](std::vector<Code>& statements) { useOnce(statements, counts); });
        states_[item] = State::done;
        makeBody(item);
    }

    /// Finds out whether a function can be written out.
    void makeBody(std::size_t item) {
        const CodeItem& one = items_[item];
        const Code& code = codes_[item];
        if (!mayInline_ || !mayInline_(one) || code.size() > kLargestBody) return;
        Body body;
        for (const auto& part : splitAtCommas(one.parameters)) {
            if (part.size() == 1 && part[0].text == "void") continue;
            if (part.size() < 2 || !part[part.size() - 2].isWord || !isVariableName(part, part.size() - 1))
                return;  // an array, or one without a name
            Parameter& made =
                body.parameters.emplace_back(Parameter{part[part.size() - 2], part.back().text, false});
            made.isOut = std::ranges::any_of(
                part, [](const CodeToken& each) { return each.text == "out" || each.text == "inout"; });
        }
        const CodeTree tree(code);
        if (tree.functions().empty()) return;
        for (const std::uint32_t each : tree.children(tree.functions().front())) {
            const std::span<const CodeToken> statement = tree.code(each);
            body.statements.emplace_back(statement.begin(), statement.end());
        }
        const bool returnsNothing =
            one.parameters.data() - tokens_.data() >= 3 && (one.parameters.data() - 3)->text == "void";
        if (!body.statements.empty() && body.statements.back().front().text == "return") {
            Code& last = body.statements.back();
            if (last.size() > 2) body.result.assign(last.begin() + 1, last.end() - 1);
            body.statements.pop_back();
        }
        if (returnsNothing != body.result.empty()) return;
        for (const Code& each : body.statements)
            if (std::ranges::any_of(each, [](const CodeToken& token) { return token.text == "return"; }))
                return;
        body.size = code.size();
        bodies_[item] = std::move(body);
    }

    void writeOut(std::vector<Code>& statements, std::size_t depth) {
        std::vector<Code> made;
        const auto add = [&](const Code& statement) {
            std::vector<Code> before;
            Code own = substituted(statement, isControl(statement) ? nullptr : &before, depth);
            for (Code& each : before) made.push_back(std::move(each));
            if (!own.empty()) made.push_back(std::move(own));
        };
        for (const Code& each : statements) {
            const std::optional<Code> conditional = asConditional(each);
            add(conditional ? *conditional : each);
        }
        statements = std::move(made);
    }

    /// The function that the word at `i` calls, if that can be written out.
    const Body* calledAt(std::span<const CodeToken> code, std::size_t i, std::size_t depth) {
        if (!code[i].isWord || i + 1 >= code.size() || code[i + 1].text != "(") return nullptr;
        if (i > 0 &&
            (code[i - 1].text == "." || (code[i - 1].isWord && !glsl::isStatementWord(code[i - 1].text))))
            return nullptr;
        const auto function = functions_.find(code[i].text);
        if (function == functions_.end() || depth >= kDeepestCall) return nullptr;
        read(function->second, depth + 1);
        const std::optional<Body>& body = bodies_[function->second];
        return states_[function->second] == State::done && body ? &*body : nullptr;
    }

    /// The code with calls written out; `before` gets what has to stand before its statement. Without it
    /// only what needs nothing there is written out.
    Code substituted(std::span<const CodeToken> code, std::vector<Code>* before, std::size_t depth) {
        Code made;
        if (depth >= kDeepestCall) return {code.begin(), code.end()};
        for (std::size_t i = 0; i < code.size(); ++i) {
            const Body* const body = calledAt(code, i, depth);
            std::size_t close = i + 1;
            if (body)
                for (int open = 0; close < code.size(); ++close) {
                    open += code[close].text == "(" ? 1 : code[close].text == ")" ? -1 : 0;
                    if (open == 0) break;
                }
            if (!body || close >= code.size()) {
                made.push_back(code[i]);
                continue;
            }
            std::vector<Code> arguments;
            for (const auto& each : splitAtCommas(code.subspan(i + 2, close - i - 2)))
                arguments.push_back(substituted(each, before, depth + 1));
            const bool isStatement = i == 0 && close + 2 == code.size() && code[close + 1].text == ";";
            const std::optional<Code> value = writtenOut(*body, arguments, before, isStatement, code[i].line);
            if (!value) {
                made.push_back(code[i]);
                made.push_back(code[i + 1]);
                for (std::size_t k = 0; k < arguments.size(); ++k) {
                    if (k > 0) made.push_back(sign(",", code[i].line));
                    made.insert(made.end(), arguments[k].begin(), arguments[k].end());
                }
                made.push_back(code[close]);
            } else if (isStatement && value->empty()) {
                return {};
            } else {
                made.insert(made.end(), value->begin(), value->end());
            }
            i = close;
        }
        return made;
    }

    CodeToken freshName(const CodeToken& like) {
        CodeToken made = like;
        made.text = names_.emplace_back(fmt::format("{}.{}", like.text, names_.size()));
        return made;
    }

    using Replacements = std::map<std::string_view, Code>;
    static Code replaced(const Code& code, const Replacements& replacements) {
        Code made;
        for (std::size_t i = 0; i < code.size(); ++i) {
            const auto own = isVariableName(code, i) ? replacements.find(code[i].text) : replacements.end();
            if (own == replacements.end())
                made.push_back(code[i]);
            else
                made.insert(made.end(), own->second.begin(), own->second.end());
        }
        return made;
    }

    static Code inParentheses(const Code& code, CodeLine line) {
        if (code.size() == 1) return code;
        Code made{sign("(", line)};
        made.insert(made.end(), code.begin(), code.end());
        made.push_back(sign(")", line));
        return made;
    }

    /// What a call stands for; nothing if it has to stay.
    std::optional<Code> writtenOut(const Body& body, const std::vector<Code>& arguments,
                                   std::vector<Code>* before, bool isStatement, CodeLine line) {
        if (arguments.size() != body.parameters.size() || (!before && !body.statements.empty()) ||
            (body.result.empty() && !isStatement) || grown_ + body.size > room_)
            return std::nullopt;
        std::map<std::string_view, std::size_t> uses;
        std::set<std::string_view> written;
        Replacements replacements;
        const auto look = [&](const Code& code) {
            for (std::size_t i = 0; i < code.size(); ++i) {
                if (isVariableName(code, i)) ++uses[code[i].text];
                if (isVariableName(code, i) && isDeclaredName(code, i) &&
                    !replacements.contains(code[i].text))
                    replacements[code[i].text] = {freshName(code[i])};
                if (glsl::isAssignment(code[i].text) || glsl::isStep(code[i].text))
                    written.insert(targetOf(code, 0, i));
            }
        };
        for (const Code& each : body.statements) look(each);
        look(body.result);
        std::vector<Code> named;
        for (std::size_t i = 0; i < arguments.size(); ++i) {
            const auto& [type, name, isOut] = body.parameters[i];
            const Code& argument = arguments[i];
            const bool isShort = argument.size() <= kShortArgument;
            if (isOut && !isShort) return std::nullopt;
            const bool staysWhole = isOut || (!written.contains(name) && (isShort || uses[name] <= 1));
            if (staysWhole || !before) {
                replacements[name] = isOut ? argument : inParentheses(argument, line);
                continue;
            }
            CodeToken parameter = freshName({name, codeOfText("x"), line, true, false});
            parameter.code = kNameCode;
            replacements[name] = {parameter};
            Code& made = named.emplace_back(Code{type, parameter, sign("=", line)});
            made.insert(made.end(), argument.begin(), argument.end());
            made.push_back(sign(";", line));
        }
        grown_ += body.size;
        if (before) {
            for (Code& each : named) before->push_back(std::move(each));
            for (const Code& each : body.statements) before->push_back(replaced(each, replacements));
        }
        if (body.result.empty()) return Code{};
        return inParentheses(replaced(body.result, replacements), line);
    }

    static std::set<std::string_view> writesOf(const Code& code) {
        std::set<std::string_view> writes;
        for (std::size_t i = 0; i < code.size(); ++i) {
            if (glsl::isAssignment(code[i].text) || glsl::isStep(code[i].text))
                writes.insert(targetOf(code, 0, i));
            if (isVariableName(code, i) && isDeclaredName(code, i)) writes.insert(code[i].text);
        }
        return writes;
    }

    /// The first place of a variable in a statement; its end if there is none.
    static std::size_t placeOf(std::string_view name, const Code& statement) {
        std::size_t at = 0;
        while (at < statement.size() && !(statement[at].text == name && isVariableName(statement, at))) ++at;
        return at;
    }

    /// "vec3 a; b; a = c;" is "b; vec3 a = c;", also if a had a value that nothing reads.
    void declareWhereSet(std::vector<Code>& statements) const {
        for (std::size_t i = 0; i < statements.size(); ++i) {
            Code& declared = statements[i];
            if (declared.size() < 3 || !declared[0].isWord || !isDeclaredName(declared, 1) ||
                (declared[2].text != ";" && declared[2].text != "=") || callsWithEffect(declared, own_))
                continue;
            const std::string_view name = declared[1].text;
            std::size_t at = i + 1;
            const std::size_t last = std::min(statements.size(), i + 1 + kFarthest);
            while (at < last && placeOf(name, statements[at]) == statements[at].size()) ++at;
            if (at == last) continue;
            Code& set = statements[at];
            if (set[0].text != name || set.size() < 4 || set[1].text != "=" ||
                placeOf(name, {set.begin() + 1, set.end()}) + 1 != set.size())
                continue;
            set.insert(set.begin(), declared[0]);
            declared.clear();
        }
        std::erase_if(statements, [](const Code& each) { return each.empty(); });
    }

    /// Replaces variables that are set where they are declared and used once by their values.
    void useOnce(std::vector<Code>& statements, const std::map<std::string_view, std::size_t>& counts) {
        for (std::size_t i = 0; i < statements.size(); ++i) {
            const Code& set = statements[i];
            if (set.size() < 5 || set[2].text != "=" || set.back().text != ";" || !set[0].isWord ||
                !isDeclaredName(set, 1) || set[3].text == "{" || callsWithEffect(set, own_))
                continue;
            const auto count = counts.find(set[1].text);
            if (count == counts.end() || count->second != 2) continue;
            const Code value(set.begin() + 3, set.end() - 1);
            if (value.size() > kLargestValue) continue;
            std::set<std::string_view> read;
            bool isPlain = true;
            for (std::size_t k = 0; k < value.size(); ++k) {
                if (isVariableName(value, k)) read.insert(value[k].text);
                isPlain = isPlain && !glsl::isAssignment(value[k].text) && !glsl::isStep(value[k].text);
            }
            if (!isPlain || !replaceUse(statements, i, value, read)) continue;
            statements[i].clear();
        }
        std::erase_if(statements, [](const Code& each) { return each.empty(); });
    }

    /// Replaces the use of the variable that statement `from` declares. False: something that its value
    /// reads changes before.
    bool replaceUse(std::vector<Code>& statements, std::size_t from, const Code& value,
                    const std::set<std::string_view>& read) const {
        const CodeToken name = statements[from][1];
        const std::size_t last = std::min(statements.size(), from + 1 + kFarthest);
        for (std::size_t at = from + 1; at < last; ++at) {
            Code& statement = statements[at];
            const std::size_t use = placeOf(name.text, statement);
            const bool isUsed = use < statement.size();
            if (callsWithEffect(statement, own_)) return false;
            const std::set<std::string_view> writes = writesOf(statement);
            if (writes.contains(name.text)) return false;
            const bool changes =
                std::ranges::any_of(writes, [&](std::string_view each) { return read.contains(each); });
            if (changes && (!isUsed || isControl(statement))) return false;
            if (!isUsed) continue;
            const Code whole = inParentheses(value, name.line);
            statement.erase(statement.begin() + static_cast<std::ptrdiff_t>(use));
            statement.insert(statement.begin() + static_cast<std::ptrdiff_t>(use), whole.begin(),
                             whole.end());
            return true;
        }
        return false;
    }

    std::vector<CodeToken> tokens_;
    const OwnFunctions& own_;
    const std::function<bool(const CodeItem&)>& mayInline_;
    std::deque<std::string>& names_;
    std::vector<CodeItem> items_;
    std::map<std::string_view, std::size_t> functions_;  ///< that have no overload
    std::map<std::size_t, Code> codes_;                  ///< of functions that were read
    std::vector<std::optional<Body>> bodies_;
    std::vector<State> states_;
    std::size_t room_, grown_ = 0;  ///< tokens that may be written out, and those that were
};

}  // namespace

std::vector<CodeToken> withoutLists(std::span<const CodeToken> tokens) {
    return withBlocks(tokens, [](std::vector<Code>& statements) {
        std::vector<Code> made;
        for (Code& each : statements) {
            std::vector<Code> parts = declarations(each);
            if (parts.empty()) parts.push_back(std::move(each));
            for (Code& part : parts) made.push_back(std::move(part));
        }
        statements = std::move(made);
    });
}

std::vector<CodeToken> withLocalVariables(const std::vector<CodeToken>& tokens) {
    const std::vector<CodeItem> items = itemsOf(tokens);
    std::map<std::string_view, std::set<std::size_t>> users;
    for (std::size_t item = 0; item < items.size(); ++item) {
        std::set<std::string_view> used, own;
        for (std::size_t i = items[item].begin; i < items[item].end; ++i) {
            if (isVariableName(tokens, i)) used.insert(tokens[i].text);
            if (items[item].isFunction && isDeclaredName(tokens, i)) own.insert(tokens[i].text);
        }
        for (const std::string_view each : used)
            if (!own.contains(each)) users[each].insert(item);
    }
    std::map<std::size_t, Code> moved;  // to these functions
    std::vector<Code> made(items.size());
    for (std::size_t item = 0; item < items.size(); ++item) {
        made[item].assign(tokens.begin() + static_cast<std::ptrdiff_t>(items[item].begin),
                          tokens.begin() + static_cast<std::ptrdiff_t>(items[item].end));
        static const std::set<std::string_view> kAfterName{"=", ",", ";", "["};
        // Constants stay: declarations() has them without "const".
        if (items[item].parameters.data() || made[item].front().text == "const" || made[item].size() < 3 ||
            !kAfterName.contains(made[item][2].text))
            continue;
        const std::vector<Code> parts = declarations(made[item]);
        if (!parts.empty()) made[item].clear();
        for (const Code& each : parts) {
            std::set<std::size_t> of = users[each[1].text];
            of.erase(item);
            const bool moves = of.size() == 1 && items[*of.begin()].isFunction;
            Code& to = moves ? moved[*of.begin()] : made[item];
            to.insert(to.end(), each.begin(), each.end());
        }
    }
    for (const auto& [function, code] : moved) {
        const auto body = std::ranges::find(made[function], std::string_view("{"), &CodeToken::text);
        made[function].insert(body + (body == made[function].end() ? 0 : 1), code.begin(), code.end());
    }
    return joinedCode(made);
}

std::vector<CodeToken> withoutDetours(std::vector<CodeToken> tokens, const OwnFunctions& own,
                                      const std::function<bool(const CodeItem& function)>& mayInline,
                                      std::deque<std::string>& names) {
    return Detours(std::move(tokens), own, mayInline, names).run();
}

}  // namespace glibra::classroom
