#include "glsl/parse/tree.h"

#include <algorithm>
#include <initializer_list>
#include <tuple>
#include <utility>

#include "glsl/parse/visible_names.h"
#include "glsl/read/preprocessor.h"
#include "glsl/read/words.h"

namespace glibra::glsl {
namespace {

constexpr int kDeepestExpression = 700;
constexpr int kMostSuffixes = 32;                ///< what is longer is not read as one operand
constexpr std::size_t kDeepestStatement = 1000;  ///< what is nested deeper counts as if it were not nested

Type typeOfNumber(std::string_view text) {
    const bool hex = text.starts_with("0x") || text.starts_with("0X");
    if (text.ends_with("lf") || text.ends_with("LF")) return scalarType(BaseType::doublePrecision);
    if (!hex && text.find_first_of(".eEfF") != std::string_view::npos) return scalarType(BaseType::floating);
    if (text.ends_with("u") || text.ends_with("U")) return scalarType(BaseType::unsignedInteger);
    return scalarType(BaseType::integer);
}

/// Reads statements in the order of the text, with the open ones on a stack, since a source may nest
/// thousands of them; expressions by precedence climbing.
class BodyParser {
  public:
    BodyParser(std::span<const ViewToken> view, Bodies& bodies)
        : view_(view),
          bodies_(bodies),
          matches_(bodies.matches = matchBrackets(view, static_cast<std::uint32_t>(view.size()))),
          names_(view, bodies) {
        bodies_.roles.assign(view.size(), WordRole::none);
        bodies_.nodeOf.assign(view.size(), kNone);
        bodies_.meanings.assign(view.size(), kNone);
        bodies_.nodes.reserve(view.size());
    }

    void run(Syntax& syntax) {
        for (Declaration& declaration : syntax.declarations) fileScope(declaration);
    }

  private:
    [[nodiscard]] std::string_view text(std::uint32_t at) const {
        return at < view_.size() ? view_[at].text : std::string_view{};
    }
    [[nodiscard]] bool word(std::uint32_t at) const {
        return at < view_.size() && view_[at].kind == TokenKind::word;
    }

    // ---- Nodes

    std::uint32_t make(NodeKind kind, Range range, std::uint32_t token,
                       std::initializer_list<std::uint32_t> children = {}, Type type = {}) {
        const auto id = static_cast<std::uint32_t>(bodies_.nodes.size());
        Node& node = bodies_.nodes.emplace_back();
        node.kind = kind;
        node.first = range.first;
        node.end = range.end;
        node.token = token;
        node.type = type;
        for (const std::uint32_t each : children) append(id, each);
        return id;
    }
    void append(std::uint32_t parent, std::uint32_t child) {
        Node& node = bodies_.nodes[parent];
        (node.child == kNone ? node.child : bodies_.nodes[node.lastChild].next) = child;
        node.lastChild = child;
        bodies_.nodes[child].parent = parent;
    }
    [[nodiscard]] const Type& typeOf(std::uint32_t node) const { return bodies_.nodes[node].type; }

    // ---- File scope

    void markOther(Range range) {
        for (std::uint32_t i = range.first; i < range.end; ++i)
            if (word(i)) bodies_.roles[i] = WordRole::other;
    }
    void markUses(Range range) {
        for (std::uint32_t i = range.first; i < range.end; ++i) {
            if (view_[i].kind != TokenKind::word) continue;
            WordRole role = WordRole::global;
            if (i > 0 && view_[i - 1].text == ".")
                role = WordRole::member;
            else if (names_.isLocal(view_[i].text))
                role = WordRole::local;
            else if (isType(view_[i]) && !names_.isKnown(view_[i].text))
                role = WordRole::other;
            bodies_.roles[i] = role;
            if (role != WordRole::member) bodies_.meanings[i] = names_.meaningOf(view_[i].text);
        }
    }
    void markType(const TypeUse& type) {
        if (type.isStruct || type.tokens.empty()) return;
        bodies_.meanings[type.tokens.first] = names_.meaningOf(type.name);
        markSizes(type.dimensions);
    }
    void markSizes(const std::vector<Range>& dimensions) {
        for (const Range& each : dimensions) markUses(each);
    }

    void fileScope(Declaration& declaration) {
        markOther(declaration.tokens);
        for (const LayoutItem& item : declaration.qualifiers.layout) markUses(item.value);
        markType(declaration.type);
        if (declaration.kind == DeclarationKind::requalify) {
            for (const Declarator& each : declaration.declarators) {
                bodies_.roles[each.name] = WordRole::global;
                bodies_.meanings[each.name] = names_.meaningOf(text(each.name));
            }
            return;
        }
        if (declaration.kind == DeclarationKind::function || declaration.kind == DeclarationKind::prototype)
            return function(declaration);
        if (declaration.type.isStruct || declaration.kind == DeclarationKind::block) structure(declaration);
        const Type type = names_.typeOf(declaration.type);
        for (Declarator& each : declaration.declarators) {
            markSizes(each.dimensions);
            if (!each.initializer.empty()) each.value = expression(each.initializer);
            names_.declareGlobal(each.name, declaration, type, each.dimensions.size());
        }
        if (declaration.kind == DeclarationKind::block) names_.declareBlockMembers(declaration);
    }

    /// Of a struct or block.
    void structure(const Declaration& declaration) {
        names_.addStructure(declaration);
        for (const Declaration& member : declaration.members) {
            markType(member.type);
            for (const Declarator& each : member.declarators) {
                markSizes(each.dimensions);
                bodies_.memberNames.emplace(view_[each.name].text, each.name);
                bodies_.memberDeclarations.push_back(each.name);
            }
        }
    }

    void function(Declaration& declaration) {
        names_.addFunction(declaration);
        names_.push(kNone);
        for (const Parameter& parameter : declaration.parameters) {
            markType(parameter.type);
            markSizes(parameter.dimensions);
            if (parameter.name == kNone) continue;
            const Type type = arrayOf(names_.typeOf(parameter.type), parameter.dimensions.size());
            bodies_.locals.push_back({parameter.name, type, parameter.type.name, true, kNone, {}});
            names_.declareLocal();
        }
        returns_ = names_.typeOf(declaration.type);
        const Range body = declaration.body;
        if (!body.empty()) {
            root_ = kNone;
            for (std::uint32_t at = body.first; at < body.end;)
                at = std::max(statement(at, body.end), at + 1);
            while (!open_.empty()) abandon(body.end);
            declaration.code = root_;
        }
        names_.popAll(declaration.tokens.end);
    }

    // ---- Statements. Each function gets the index to begin at and gives the one to go on at.

    void open(std::uint32_t node, std::uint32_t close = kNone) {
        if (open_.size() < kDeepestStatement) open_.push_back({node, close});
    }

    /// A statement is whole, and so are those that it ends.
    std::uint32_t finish(std::uint32_t node, std::uint32_t at, std::uint32_t end) {
        while (!open_.empty()) {
            const std::uint32_t parent = open_.back().node;
            const NodeKind kind = bodies_.nodes[parent].kind;
            append(parent, node);
            if (kind == NodeKind::block) return at;
            const bool isThen = kind == NodeKind::branch && bodies_.child(parent, 1) == node;
            if (isThen && at < end && text(at) == "else" && isKeyword(at)) return at + 1;
            if (kind == NodeKind::doLoop && isHead(at, end) && text(at) == "while") {
                at = head(at, parent);
                if (text(at) == ";") at = pastEnd(at);
            }
            bodies_.nodes[parent].end = at;
            open_.pop_back();
            node = parent;
        }
        if (root_ == kNone) root_ = node;
        return at;
    }

    /// Takes away the last open statement, whose end is missing.
    void abandon(std::uint32_t at) {
        const std::uint32_t node = open_.back().node;
        if (bodies_.nodes[node].kind != NodeKind::block) append(node, make(NodeKind::empty, {at, at}, at));
        bodies_.nodes[node].end = at;
        open_.pop_back();
        if (!open_.empty())
            append(open_.back().node, node);
        else if (root_ == kNone)
            root_ = node;
    }

    std::uint32_t closeBlock(std::uint32_t at, std::uint32_t end) {
        names_.popTo(at);
        const bool isOpen = std::ranges::any_of(open_, [&](const Open& each) { return each.close == at; });
        if (!isOpen) return at + 1;
        while (open_.back().close != at) abandon(at);
        const std::uint32_t node = open_.back().node;
        bodies_.nodes[node].end = at + 1;
        open_.pop_back();
        return finish(node, at + 1, end);
    }
    std::uint32_t openBlock(std::uint32_t at) {
        open(make(NodeKind::block, {at, at}, at), matches_[at]);
        return at + 1;
    }

    /// The index after the ';' at `at`, if there is one.
    std::uint32_t pastEnd(std::uint32_t at) {
        if (text(at) != ";") return at;
        names_.popStatement(at);
        return at + 1;
    }

    std::uint32_t statement(std::uint32_t at, std::uint32_t end) {
        const std::string_view first = text(at);
        if (first == "{") {
            names_.push(matches_[at]);
            return openBlock(at);
        }
        if (first == "}") return closeBlock(at, end);
        if (first == ";") {
            const std::uint32_t next = pastEnd(at);
            return finish(make(NodeKind::empty, {at, next}, at), next, end);
        }
        if (isPrecision(at)) {
            const std::uint32_t stop = statementEnd(at, end);
            for (std::uint32_t i = at; i < stop; ++i) bodies_.roles[i] = WordRole::other;
            const std::uint32_t next = pastEnd(stop);
            return finish(make(NodeKind::empty, {at, next}, at), next, end);
        }
        if (isKeyword(at)) return keyword(at, end);
        if (isDeclaration(at)) {
            const std::uint32_t node = declaration(at, end);
            const std::uint32_t next = bodies_.nodes[node].end;
            // The ';' also ends the body of a `for` without braces.
            if (next > at && text(next - 1) == ";") names_.popStatement(next - 1);
            return finish(node, std::max(next, at + 1), end);
        }
        const std::uint32_t stop = statementEnd(at, end);
        const std::uint32_t value = expression({at, stop});
        const std::uint32_t next = pastEnd(stop);
        return finish(make(NodeKind::evaluation, {at, next}, at, {value}), std::max(next, at + 1), end);
    }

    [[nodiscard]] bool isKeyword(std::uint32_t at) const {
        return at < view_.size() && isStatement(view_[at]) && !names_.isKnown(text(at));
    }
    /// True for the statement `precision highp float;`, which may stand in every block.
    [[nodiscard]] bool isPrecision(std::uint32_t at) const {
        return text(at) == "precision" && !view_[at].isName && word(at + 1) && word(at + 2);
    }

    /// The index of the ';' or '}' that ends the statement.
    [[nodiscard]] std::uint32_t statementEnd(std::uint32_t at, std::uint32_t end) const {
        while (at < end) {
            const std::string_view each = text(at);
            if (each == ";" || each == "}") return at;
            at = opensBracket(each) && matches_[at] < end ? matches_[at] + 1 : at + 1;
        }
        return end;
    }

    /// True for `for (...)`, `if (...)` and their kin, also where the text ends before the ')'.
    [[nodiscard]] bool isHead(std::uint32_t at, std::uint32_t end) const {
        return at < end && isKeyword(at) && headKind(text(at)) != NodeKind::unknown && text(at + 1) == "(" &&
               (matches_[at + 1] < end || matches_[at + 1] == view_.size());
    }
    static NodeKind headKind(std::string_view word) {
        return word == "if"       ? NodeKind::branch
               : word == "for"    ? NodeKind::forLoop
               : word == "while"  ? NodeKind::whileLoop
               : word == "switch" ? NodeKind::choice
                                  : NodeKind::unknown;
    }

    std::uint32_t keyword(std::uint32_t at, std::uint32_t end) {
        const std::string_view first = text(at);
        if (isHead(at, end)) {
            const std::uint32_t node = make(headKind(first), {at, at}, at);
            const std::uint32_t body = head(at, node);
            open(node);
            const bool isScoped = first == "for" || first == "while";
            return isScoped && text(body) == "{" ? openBlock(body) : body;
        }
        if (first == "do") {
            open(make(NodeKind::doLoop, {at, at}, at));
            return at + 1;
        }
        if (first == "case" || first == "default") {
            std::uint32_t stop = at + 1;
            while (stop < end && text(stop) != ":" && text(stop) != ";" && text(stop) != "}") ++stop;
            return leaf(NodeKind::label, at, stop, stop < end && text(stop) == ":" ? stop + 1 : stop, end);
        }
        const bool isReturn = first == "return";
        if (!isReturn && first != "break" && first != "continue" && first != "discard") return at + 1;
        const bool hasValue = isReturn || (at + 1 < end && !isKeyword(at + 1) && !isDeclaration(at + 1));
        const std::uint32_t stop = hasValue ? statementEnd(at + 1, end) : at + 1;
        const std::uint32_t next = leaf(NodeKind::jump, at, stop, pastEnd(stop), end);
        return next;
    }

    /// A label or jump with what stands between its word and `stop`.
    std::uint32_t leaf(NodeKind kind, std::uint32_t at, std::uint32_t stop, std::uint32_t next,
                       std::uint32_t end) {
        const std::uint32_t node = make(kind, {at, next}, at);
        if (stop > at + 1) {
            const std::uint32_t value = expression({at + 1, stop});
            append(node, value);
            if (text(at) == "return") bodies_.returns.push_back({{at + 1, stop}, typeOf(value), returns_});
        }
        return finish(node, next, end);
    }

    /// Reads the parentheses after the word at `at` into `node`.
    std::uint32_t head(std::uint32_t at, std::uint32_t node) {
        const std::uint32_t close = matches_[at + 1];
        const bool isBraced = text(close + 1) == "{";
        if (text(at) == "for" || text(at) == "while")
            names_.push(isBraced ? matches_[close + 1] : kNone, !isBraced);
        std::vector<std::uint32_t> parts;
        for (std::uint32_t part = at + 2; part < close;) {
            std::uint32_t next = 0;
            if (isDeclaration(part)) {
                parts.push_back(declaration(part, close));
                next = bodies_.nodes[parts.back()].end;
            } else {
                next = statementEnd(part, close);
                parts.push_back(expression({part, next}));
                if (next < close) ++next;
            }
            part = std::max(next, part + 1);
        }
        if (text(close - 1) == ";" || parts.empty())
            parts.push_back(make(NodeKind::empty, {close, close}, close));
        const bool isFor = bodies_.nodes[node].kind == NodeKind::forLoop;
        std::uint32_t parent = node;
        if (!isFor && parts.size() > 1) append(node, parent = make(NodeKind::sequence, {at + 2, close}, at));
        for (const std::uint32_t each : parts) append(parent, each);
        return std::min(close + 1, static_cast<std::uint32_t>(view_.size()));
    }

    /// True for `type name`, `const type name` and `struct ...`: an expression cannot begin with two words.
    [[nodiscard]] bool isDeclaration(std::uint32_t at) const {
        if (!word(at) || isStatement(view_[at])) return false;
        if (text(at) == "struct") return true;
        if (text(at) == "layout" && text(at + 1) == "(" && !view_[at].isName) return true;
        std::uint32_t next = at + 1;
        while (text(next) == "[" && matches_[next] < view_.size()) next = matches_[next] + 1;
        return word(next) && (next == at + 1 || isType(view_[at]) || names_.isStructure(text(at)));
    }

    std::uint32_t declaration(std::uint32_t at, std::uint32_t end) {
        const std::uint32_t index = static_cast<std::uint32_t>(bodies_.declarations.size());
        Declaration& parsed = bodies_.declarations.emplace_back(parseVariable(view_, at, end));
        const std::uint32_t node = make(NodeKind::declaration, parsed.tokens, index);
        markOther(parsed.tokens);
        if (parsed.type.isStruct) {
            structure(parsed);
            if (parsed.name != kNone) bodies_.localNames.emplace(text(parsed.name), parsed.name);
        }
        markType(parsed.type);
        const Type type = names_.typeOf(parsed.type);
        for (Declarator& each : parsed.declarators) {
            markSizes(each.dimensions);
            const std::uint32_t own = make(NodeKind::declarator, {each.name, each.end}, each.name);
            if (!each.initializer.empty()) append(own, each.value = expression(each.initializer));
            append(node, own);
            const Type shaped = arrayOf(type, each.dimensions.size());
            const bool constant = parsed.qualifiers.storage == Storage::constant;
            bodies_.locals.push_back({each.name, shaped, parsed.type.name, false,
                                      constant ? parsed.qualifiers.storageToken : kNone, each.initializer,
                                      each.value});
            names_.declareLocal();
        }
        return node;
    }

    // ---- Expressions

    /// Also gives the words in the range their roles.
    std::uint32_t expression(Range range) {
        markUses(range);
        return parse(range);
    }

    std::uint32_t parse(Range range) {
        const auto saved = std::pair(at_, end_);
        at_ = range.first;
        end_ = std::max(range.first, range.end);
        std::uint32_t first = kNone, all = kNone;
        Type type;
        const auto add = [&](std::uint32_t node) {
            if (first == kNone) {
                first = node;
                return;
            }
            if (all == kNone) all = make(NodeKind::sequence, range, range.first, {first});
            append(all, node);
        };
        // After something that is not understood, the rest is still searched for calls.
        while (at_ < end_) {
            add(assignment());
            type = typeOf(all == kNone ? first : bodies_.nodes[all].lastChild);
            if (at_ < end_ && !accept(",")) {
                add(make(NodeKind::unknown, {at_, at_ + 1}, at_));
                ++at_;
                type = {};
            }
        }
        std::tie(at_, end_) = saved;
        if (first == kNone) return make(NodeKind::empty, range, range.first);
        if (all == kNone) return first;
        bodies_.nodes[all].type = type;
        return all;
    }

    [[nodiscard]] std::string_view peek(std::uint32_t ahead = 0) const {
        return at_ + ahead < end_ ? view_[at_ + ahead].text : std::string_view{};
    }
    bool accept(std::string_view text) {
        if (peek() != text) return false;
        ++at_;
        return true;
    }
    /// Goes to what follows the bracket that closes the one here.
    void skipBracket() { at_ = std::min(std::min(matches_[at_], end_) + 1, end_); }
    /// A node for what stands from `first` to here.
    std::uint32_t unknown(std::uint32_t first) { return make(NodeKind::unknown, {first, at_}, first); }
    std::uint32_t tooDeep() {
        const std::uint32_t first = std::exchange(at_, end_);
        return unknown(first);
    }

    std::uint32_t assignment() {
        if (depth_ > kDeepestExpression) return tooDeep();
        ++depth_;
        const std::uint32_t first = at_;
        std::uint32_t node = binary(0);
        const std::uint32_t op = at_;
        if (accept("?")) {
            const std::uint32_t yes = assignment();
            const std::uint32_t no = accept(":") ? assignment() : unknown(at_);
            const Type a = typeOf(yes), b = typeOf(no);
            Type type = a == b ? a : Type{};
            if (a.numeric() && b.numeric() && a.columns == b.columns && a.rows == b.rows)
                type = binaryType("+", a, b);
            node = make(NodeKind::selection, {first, at_}, op, {node, yes, no}, type);
        } else if (isAssignment(peek())) {
            ++at_;
            const std::uint32_t value = assignment();
            node = make(NodeKind::assignment, {first, at_}, op, {node, value}, typeOf(node));
        }
        --depth_;
        return node;
    }

    std::uint32_t binary(int lowest) {
        if (depth_ > kDeepestExpression) return tooDeep();
        ++depth_;
        const std::uint32_t first = at_;
        std::uint32_t node = unary();
        int level = 0;  // of the operators in `node`
        while (at_ < end_) {
            const std::string_view sign = peek();
            const int strength = levelOf(sign);
            if (strength <= lowest) break;
            const std::uint32_t op = at_++;
            const std::uint32_t operand = binary(strength);
            const Type left = typeOf(node), right = typeOf(operand);
            const Type joined = binaryType(sign, left, right);
            const bool compares = sign == "==" || sign == "!=";
            if (left.numeric() && right.numeric() &&
                (compares ? left.columns != right.columns || left.rows != right.rows : !joined.known()))
                bodies_.mismatches.push_back({op, left, right});
            if (level == strength) {
                append(node, operand);
                bodies_.nodes[node].end = at_;
            } else {
                node = make(NodeKind::chain, {first, at_}, op, {node, operand});
                level = strength;
            }
            bodies_.nodes[node].type = joined;
        }
        --depth_;
        return node;
    }

    std::uint32_t unary() {
        // Prefix operators are read in a loop, because a source may contain a million of them in a row.
        const std::uint32_t first = at_;
        bool logical = false;
        while (at_ < end_) {
            const std::string_view text = peek();
            if (text == "!")
                logical = true;
            else if (text != "-" && text != "+" && text != "~" && !isStep(text))
                break;
            ++at_;
        }
        const std::uint32_t node = postfix();
        if (bodies_.nodes[node].first == first) return node;
        return make(NodeKind::prefix, {first, at_}, first, {node},
                    logical ? scalarType(BaseType::boolean) : typeOf(node));
    }

    static Type elementOf(Type type) {
        if (type.arrayDepth > 0)
            --type.arrayDepth;
        else if (type.matrix())
            type = vectorType(type.base, type.rows);
        else
            type = type.vector() ? scalarType(type.base) : Type{};
        return type;
    }

    std::uint32_t postfix() {
        const std::uint32_t first = at_;
        std::uint32_t node = primary();
        for (int suffixes = 1; at_ < end_; ++suffixes) {
            if (suffixes % kMostSuffixes == 0)
                node = make(NodeKind::unknown, {first, at_}, first, {}, typeOf(node));
            const std::uint32_t op = at_;
            const Type type = typeOf(node);
            if (peek() == "[") {
                if (type.known()) bodies_.subscripts.push_back({{first, at_}, at_, type});
                const std::uint32_t inside = parse({at_ + 1, std::min(matches_[at_], end_)});
                skipBracket();
                node = make(NodeKind::subscript, {first, at_}, op, {node, inside}, elementOf(type));
            } else if (peek() == "." && at_ + 1 < end_) {
                const std::string_view member = peek(1);
                at_ += 2;
                const Type own = names_.memberType(type, op + 1);
                if (type.scalar() && own.known())
                    bodies_.scalarSwizzles.push_back({{first, op}, op + 1, type});
                if (peek() == "(") {
                    skipBracket();
                    node = make(NodeKind::method, {first, at_}, op + 1, {node},
                                member == "length" ? scalarType(BaseType::integer) : Type{});
                } else {
                    node = make(NodeKind::member, {first, at_}, op + 1, {node}, own);
                }
            } else if (isStep(peek())) {
                ++at_;
                node = make(NodeKind::step, {first, at_}, op, {node}, type);
            } else {
                break;
            }
        }
        return node;
    }

    std::uint32_t primary() {
        const std::uint32_t first = at_;
        if (at_ >= end_) return unknown(at_);
        const ViewToken& token = view_[at_];
        if (token.kind == TokenKind::number) {
            ++at_;
            return make(NodeKind::number, {first, at_}, first, {}, typeOfNumber(token.text));
        }
        if (token.text == "(" || token.text == "{") {
            std::uint32_t inside = kNone;
            if (depth_ <= kDeepestExpression) {
                ++depth_;
                inside = parse({at_ + 1, std::min(matches_[at_], end_)});
                --depth_;
            }
            skipBracket();
            if (inside == kNone) return unknown(first);
            const bool isGroup = token.text == "(";
            return make(isGroup ? NodeKind::group : NodeKind::list, {first, at_}, first, {inside},
                        isGroup ? typeOf(inside) : Type{});
        }
        if (token.kind != TokenKind::word) return unknown(first);
        const std::uint32_t name = at_++;
        if (token.text == "const") {
            while (accept("const")) {
            }
            return primary();
        }
        if (peek() == "(" && token.text != "true" && token.text != "false") return call(name);
        if (peek() == "[" && !names_.isKnown(token.text) && (isType(token) || names_.isStructure(token.text)))
            return arrayCall(name);
        const bool isTruth = token.text == "true" || token.text == "false";
        return bodies_.nodeOf[name] =
                   make(NodeKind::name, {first, at_}, name, {},
                        isTruth ? scalarType(BaseType::boolean) : names_.typeOfName(token.text));
    }

    /// vec3[2](a, b)
    std::uint32_t arrayCall(std::uint32_t name) {
        std::uint16_t dimensions = 0;
        for (; peek() == "["; ++dimensions) {
            parse({at_ + 1, std::min(matches_[at_], end_)});
            skipBracket();
        }
        const std::uint32_t node = peek() == "(" ? call(name) : unknown(name);
        bodies_.nodes[node].type.arrayDepth = dimensions;
        if (bodies_.nodes[node].kind == NodeKind::call) bodies_.nodes[node].kind = NodeKind::arrayCall;
        return node;
    }

    std::uint32_t call(std::uint32_t name) {
        if (depth_ > kDeepestExpression) {
            skipBracket();
            return unknown(name);
        }
        Call result;
        result.name = name;
        const std::uint32_t node = make(NodeKind::call, {name, name}, name);
        const auto saved = end_;
        const std::uint32_t close = std::min(matches_[at_], end_);
        ++depth_;
        end_ = close;
        for (std::uint32_t start = ++at_; at_ < end_; start = at_) {
            std::uint32_t argument = assignment();
            // If tokens before the next comma were not understood, the type of the argument is unknown.
            if (const std::uint32_t rest = at_; at_ < end_ && peek() != ",") {
                while (at_ < end_ && peek() != ",") {
                    if (opensBracket(peek()))
                        skipBracket();
                    else
                        ++at_;
                }
                argument = make(NodeKind::sequence, {start, at_}, start, {argument, unknown(rest)});
            }
            append(node, argument);
            result.arguments.push_back({start, at_});
            result.types.push_back(typeOf(argument));
            if (!accept(",")) break;
        }
        end_ = saved;
        at_ = std::min(close + 1, end_);
        --depth_;
        const std::string_view function = view_[name].text;
        Type type;
        if (names_.isFunction(function))
            type = names_.returnType(function, result.types);
        else if (names_.isStructure(function))
            type = names_.typeOfStructure(function);
        else
            type = callType(function, result.types);
        bodies_.nodes[node].end = at_;
        bodies_.nodes[node].type = type;
        result.function = names_.overloadOf(function, result.types);
        if (!isType(view_[name])) bodies_.calls.push_back(std::move(result));
        return node;
    }

    struct Open {
        std::uint32_t node;
        std::uint32_t close;  ///< of a block: its closing bracket
    };

    std::span<const ViewToken> view_;
    Bodies& bodies_;
    const std::vector<std::uint32_t>& matches_;
    VisibleNames names_;
    std::vector<Open> open_;      ///< statements around the current place
    std::uint32_t root_ = kNone;  ///< the body of the last function
    Type returns_;
    std::uint32_t at_ = 0, end_ = 0;  ///< of the expression that is being read
    int depth_ = 0;
};

}  // namespace

Bodies parseBodies(std::span<const ViewToken> view, Syntax& syntax) {
    Bodies bodies;
    BodyParser(view, bodies).run(syntax);
    return bodies;
}

}  // namespace glibra::glsl
