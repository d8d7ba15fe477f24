#include "glsl/parse/body_walk.h"

#include "glsl/parse/expression.h"
#include "glsl/parse/scope.h"
#include "glsl/read/words.h"

namespace glibra::glsl {
namespace {

/// Reads the statements of function bodies in order. `Expressions` reads the expressions in them.
class BodyWalker {
  public:
    BodyWalker(std::span<const ViewToken> view, const Syntax& syntax, Bodies& bodies)
        : view_(view),
          matches_(bodies.matches = matchBrackets(view, static_cast<std::uint32_t>(view.size()))),
          bodies_(bodies),
          names_(view, bodies),
          expressions_(view, matches_, names_, bodies),
          syntax_(syntax) {
        bodies_.roles.assign(view.size(), WordRole::none);
    }

    void run() {
        for (const Declaration& declaration : syntax_.declarations) fileScope(declaration);
    }

  private:
    [[nodiscard]] std::string_view text(std::uint32_t at) const {
        return at < view_.size() ? view_[at].text : std::string_view{};
    }
    [[nodiscard]] bool word(std::uint32_t at) const {
        return at < view_.size() && view_[at].kind == TokenKind::word;
    }

    void markOther(Range range) {
        for (std::uint32_t i = range.first; i < range.end; ++i)
            if (word(i)) bodies_.roles[i] = WordRole::other;
    }
    void markSizes(const std::vector<Range>& dimensions) {
        for (const Range& each : dimensions) expressions_.markUses(each);
    }

    void fileScope(const Declaration& declaration) {
        markOther(declaration.tokens);
        for (const LayoutItem& item : declaration.qualifiers.layout) expressions_.markUses(item.value);
        markSizes(declaration.type.dimensions);
        if (declaration.kind == DeclarationKind::requalify) {
            for (const Declarator& each : declaration.declarators)
                bodies_.roles[each.name] = WordRole::global;
            return;
        }
        if (declaration.kind == DeclarationKind::function || declaration.kind == DeclarationKind::prototype)
            return function(declaration);
        if (declaration.type.isStruct || declaration.kind == DeclarationKind::block) structure(declaration);
        const Type type = names_.typeOf(declaration.type);
        for (const Declarator& each : declaration.declarators) {
            markSizes(each.dimensions);
            if (!each.initializer.empty()) expressions_.typeOf(each.initializer);
            names_.declareGlobal(view_[each.name].text, declaration, type, each.dimensions.size());
        }
        if (declaration.kind == DeclarationKind::block) names_.declareBlockMembers(declaration);
    }

    /// Of a struct or block.
    void structure(const Declaration& declaration) {
        names_.addStructure(declaration);
        for (const Declaration& member : declaration.members) {
            markSizes(member.type.dimensions);
            for (const Declarator& each : member.declarators) {
                markSizes(each.dimensions);
                bodies_.memberNames.emplace(view_[each.name].text, each.name);
                bodies_.memberDeclarations.push_back(each.name);
            }
        }
    }

    void function(const Declaration& declaration) {
        names_.addFunction(declaration);
        names_.push(kNone);
        for (const Parameter& parameter : declaration.parameters) {
            markSizes(parameter.type.dimensions);
            markSizes(parameter.dimensions);
            if (parameter.name == kNone) continue;
            const Type type = arrayOf(names_.typeOf(parameter.type), parameter.dimensions.size());
            bodies_.locals.push_back({parameter.name, type, parameter.type.name, true, kNone, {}});
            names_.declareLocal(parameter.name, type);
        }
        returns_ = names_.typeOf(declaration.type);
        if (!declaration.body.empty()) body(declaration.body);
        names_.popAll();
    }

    void body(Range range) {
        std::uint32_t at = range.first;
        while (at < range.end) {
            const std::uint32_t next = statement(at, range.end);
            at = next > at ? next : at + 1;
        }
    }

    std::uint32_t statement(std::uint32_t at, std::uint32_t end) {
        const std::string_view first = text(at);
        if (first == "{") {
            names_.push(matches_[at]);
            return at + 1;
        }
        if (first == "}") {
            names_.popTo(at);
            return at + 1;
        }
        if (first == ";") {
            names_.popStatement();
            return at + 1;
        }
        if (isPrecision(at)) return precision(at, end);
        if (isStatement(view_[at]) && !names_.isKnown(first)) return keyword(at, end);
        if (isDeclaration(at)) return declaration(at, end, true);
        const std::uint32_t stop = statementEnd(at, end);
        expressions_.typeOf({at, stop});
        return stop;
    }

    /// True for the statement `precision highp float;`, which may stand in every block.
    [[nodiscard]] bool isPrecision(std::uint32_t at) const {
        return text(at) == "precision" && !view_[at].isName && word(at + 1) && word(at + 2);
    }
    std::uint32_t precision(std::uint32_t at, std::uint32_t end) {
        const std::uint32_t stop = statementEnd(at, end);
        for (std::uint32_t i = at; i < stop; ++i) bodies_.roles[i] = WordRole::other;
        return stop;
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

    std::uint32_t keyword(std::uint32_t at, std::uint32_t end) {
        const std::string_view first = text(at);
        if (first == "case" || first == "default") {
            std::uint32_t stop = at + 1;
            while (stop < end && text(stop) != ":" && text(stop) != ";" && text(stop) != "}") ++stop;
            expressions_.typeOf({at + 1, stop});
            return stop < end && text(stop) == ":" ? stop + 1 : stop;
        }
        if (first == "return") {
            const std::uint32_t stop = statementEnd(at + 1, end);
            const Type type = expressions_.typeOf({at + 1, stop});
            if (stop > at + 1) bodies_.returns.push_back({{at + 1, stop}, type, returns_});
            return stop;
        }
        const bool headed = first == "for" || first == "while" || first == "if" || first == "switch";
        if (!headed || text(at + 1) != "(" || matches_[at + 1] >= end) return at + 1;
        return header(at, matches_[at + 1]);
    }

    std::uint32_t header(std::uint32_t at, std::uint32_t close) {
        const bool scoped = text(at) == "for" || text(at) == "while";
        const bool braced = text(close + 1) == "{";
        if (scoped) names_.push(braced ? matches_[close + 1] : kNone, !braced);
        std::uint32_t part = at + 2;
        while (part < close) {
            std::uint32_t next = 0;
            if (isDeclaration(part)) {
                next = declaration(part, close, false);
            } else {
                next = statementEnd(part, close);
                expressions_.typeOf({part, next});
                if (next < close) ++next;
            }
            part = next > part ? next : part + 1;
        }
        return scoped && braced ? close + 2 : close + 1;
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

    std::uint32_t declaration(std::uint32_t at, std::uint32_t end, bool isStatement) {
        const Declaration parsed = parseVariable(view_, at, end);
        markOther(parsed.tokens);
        if (parsed.type.isStruct) {
            structure(parsed);
            if (parsed.name != kNone) bodies_.localNames.emplace(text(parsed.name), parsed.name);
        }
        markSizes(parsed.type.dimensions);
        const Type type = names_.typeOf(parsed.type);
        for (const Declarator& each : parsed.declarators) {
            markSizes(each.dimensions);
            if (!each.initializer.empty()) expressions_.typeOf(each.initializer);
            const Type own = arrayOf(type, each.dimensions.size());
            const bool constant = parsed.qualifiers.storage == Storage::constant;
            bodies_.locals.push_back({each.name, own, parsed.type.name, false,
                                      constant ? parsed.qualifiers.storageToken : kNone, each.initializer});
            names_.declareLocal(each.name, own);
        }
        const std::uint32_t stop = parsed.tokens.end;
        // The ';' also ends the body of a `for` without braces.
        if (isStatement && stop > at && text(stop - 1) == ";") names_.popStatement();
        return stop;
    }

    std::span<const ViewToken> view_;
    const std::vector<std::uint32_t>& matches_;
    Bodies& bodies_;
    Names names_;
    Expressions expressions_;
    const Syntax& syntax_;
    Type returns_;
};

}  // namespace

Bodies walkBodies(std::span<const ViewToken> view, const Syntax& syntax) {
    Bodies bodies;
    BodyWalker(view, syntax, bodies).run();
    return bodies;
}

}  // namespace glibra::glsl
