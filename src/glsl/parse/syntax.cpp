#include "glsl/parse/syntax.h"

#include <algorithm>
#include <utility>

#include "glsl/read/words.h"

namespace glibra::glsl {
namespace {

constexpr int kDeepestBlock = 32;  ///< nesting of structs and blocks

class Parser {
  public:
    Parser(std::span<const ViewToken> view, std::uint32_t at, std::uint32_t end)
        : view_(view), at_(at), end_(std::min<std::uint32_t>(end, static_cast<std::uint32_t>(view.size()))) {}

    Syntax fileScope() {
        Syntax syntax;
        while (at_ < end_) {
            const std::uint32_t start = at_;
            Declaration declaration = statement();
            if (at_ == start) ++at_;
            declaration.tokens = {start, at_};
            syntax.declarations.push_back(std::move(declaration));
        }
        return syntax;
    }

    Declaration variable() {
        Declaration declaration;
        const std::uint32_t start = at_;
        declaration.qualifiers = qualifiers();
        if (word() || peek() == "struct") afterQualifiers(declaration);
        declaration.tokens = {start, at_};
        return declaration;
    }

  private:
    [[nodiscard]] std::string_view peek(std::uint32_t ahead = 0) const {
        return at_ + ahead < end_ ? view_[at_ + ahead].text : std::string_view{};
    }
    [[nodiscard]] bool word(std::uint32_t ahead = 0) const {
        return at_ + ahead < end_ && view_[at_ + ahead].kind == TokenKind::word;
    }
    [[nodiscard]] std::uint32_t close(std::uint32_t open) const { return closing(view_, open, end_); }
    bool accept(std::string_view text) {
        if (peek() != text) return false;
        ++at_;
        return true;
    }
    /// Moves past the next ';' outside brackets, or past a closing brace that has no opening one.
    void skipStatement() {
        while (at_ < end_) {
            const std::string_view text = peek();
            if (opensBracket(text)) {
                const bool brace = text == "{";
                at_ = std::min(close(at_) + 1, end_);
                if (brace && peek() != ";" && peek() != ",") return;
                continue;
            }
            ++at_;
            if (text == ";" || text == "}") return;
        }
    }

    Declaration statement() {
        Declaration declaration;
        if (accept(";")) {
            declaration.kind = DeclarationKind::stray;
            return declaration;
        }
        if (peek() == "precision" && !view_[at_].isName) {
            declaration.kind = DeclarationKind::precision;
            skipStatement();
            return declaration;
        }
        declaration.qualifiers = qualifiers();
        if (peek() == ";") {
            ++at_;
            declaration.kind =
                declaration.qualifiers.tokens.empty() ? DeclarationKind::stray : DeclarationKind::layoutOnly;
            return declaration;
        }
        if (!word()) {
            skipStatement();
            return declaration;
        }
        afterQualifiers(declaration);
        return declaration;
    }

    /// True if the word here is a name although it may be a qualifier: `float flat`, `sample = 1.`
    [[nodiscard]] bool qualifierHere() const {
        if (!word() || !isQualifier(view_[at_])) return false;
        const std::string_view next = peek(1);
        if (peek() == "layout" || peek() == "subroutine") return true;
        return word(1) || next == ";" || next == "{";
    }

    Qualifiers qualifiers() {
        Qualifiers result;
        result.tokens.first = at_;
        while (at_ < end_ && qualifierHere()) qualifier(result);
        result.tokens.end = at_;
        return result;
    }

    void qualifier(Qualifiers& result) {
        const std::string_view text = peek();
        const std::uint32_t here = at_++;
        const auto storage = [&](Storage value) {
            if (result.storage == Storage::none) result.storageToken = here;
            if (result.storage == Storage::input && value == Storage::output)
                result.storage = Storage::inputOutput;
            else
                result.storage = value;
        };
        if (text == "layout") {
            layout(result, here);
        } else if (text == "subroutine") {
            result.subroutine = true;
            if (peek() == "(") {
                const std::uint32_t end = close(at_);
                result.subroutineTypes = {at_ + 1, end};
                at_ = std::min(end + 1, end_);
            }
        } else if (text == "const") {
            if (result.storage == Storage::none) storage(Storage::constant);
        } else if (const auto word = std::ranges::find(kStorageWords, text); word != kStorageWords.end()) {
            storage(static_cast<Storage>(word - kStorageWords.begin()));
        } else if (text == "attribute") {
            result.attributeWord = true;
            if (result.storage == Storage::none) result.storageToken = here;
        } else if (text == "varying") {
            result.varyingWord = true;
            if (result.storage == Storage::none && result.storageToken == kNone) result.storageToken = here;
        } else if (text == "flat" || text == "smooth" || text == "noperspective") {
            result.interpolation = text;
        } else if (text == "highp" || text == "mediump" || text == "lowp") {
            result.precision = text;
        } else if (text == "patch") {
            result.patch = true;
        } else if (text == "invariant") {
            result.invariant = true;
        } else if (text == "precise") {
            result.precise = true;
        } else if (text == "centroid") {
            result.centroid = true;
        } else if (text == "sample") {
            result.sample = true;
        } else {
            result.memory.emplace_back(text);
        }
    }

    void layout(Qualifiers& result, std::uint32_t start) {
        if (peek() != "(") return;
        const std::uint32_t end = close(at_);
        std::uint32_t i = at_ + 1;
        while (i < end) {
            LayoutItem item;
            item.name = view_[i].text;
            item.tokens.first = i++;
            if (i < end && view_[i].text == "=") {
                item.value.first = ++i;
                while (i < end && view_[i].text != ",") i = open(i) ? closing(view_, i, end) + 1 : i + 1;
                item.value.end = i = std::min(i, end);
            }
            while (i < end && view_[i].text != ",") ++i;
            item.tokens.end = i++;
            result.layout.push_back(std::move(item));
        }
        at_ = std::min(end + 1, end_);
        result.layoutTokens.push_back({start, at_});
    }
    [[nodiscard]] bool open(std::uint32_t at) const { return opensBracket(view_[at].text); }

    void afterQualifiers(Declaration& declaration) {
        const Qualifiers& q = declaration.qualifiers;
        if (peek() == "struct") return structure(declaration);
        const bool listOnly = (q.invariant || q.precise) && q.storage == Storage::none && !q.varyingWord;
        if (listOnly && (peek(1) == ";" || peek(1) == ",")) {
            declaration.kind = DeclarationKind::requalify;
            declarators(declaration);
            return;
        }
        if (peek(1) == "{" && q.storage != Storage::none) return block(declaration);
        type(declaration.type);
        if (word() && peek(1) == "(") return function(declaration);
        declaration.kind = DeclarationKind::variable;
        declarators(declaration);
    }

    void type(TypeUse& result) {
        result.tokens.first = at_;
        result.name = peek();
        ++at_;
        brackets(result.dimensions);
        result.tokens.end = at_;
    }

    void brackets(std::vector<Range>& dimensions) {
        while (peek() == "[") {
            const std::uint32_t end = close(at_);
            dimensions.push_back({at_ + 1, end});
            at_ = std::min(end + 1, end_);
        }
    }

    void members(Declaration& declaration) {
        const std::uint32_t end = close(at_);
        declaration.body = {at_, std::min(end + 1, end_)};
        ++at_;
        if (++depth_ <= kDeepestBlock)
            while (at_ < end) {
                const std::uint32_t start = at_;
                const std::uint32_t outer = std::exchange(end_, end);
                Declaration member;
                member.qualifiers = qualifiers();
                if (word())
                    afterQualifiers(member);
                else
                    skipStatement();
                end_ = outer;
                if (at_ == start) ++at_;
                member.tokens = {start, at_};
                declaration.members.push_back(std::move(member));
            }
        --depth_;
        at_ = declaration.body.end;
    }

    void structure(Declaration& declaration) {
        declaration.kind = DeclarationKind::variable;
        declaration.type.tokens.first = at_;
        declaration.type.isStruct = true;
        ++at_;
        if (word()) {
            declaration.name = at_;
            declaration.type.name = peek();
            ++at_;
        }
        if (peek() == "{") members(declaration);
        brackets(declaration.type.dimensions);
        declaration.type.tokens.end = at_;
        declarators(declaration);
    }

    void block(Declaration& declaration) {
        declaration.kind = DeclarationKind::block;
        declaration.name = at_++;
        members(declaration);
        declarators(declaration);
    }

    void declarators(Declaration& declaration) {
        while (word()) {
            Declarator declarator;
            declarator.name = at_++;
            declarator.dimensionTokens.first = at_;
            brackets(declarator.dimensions);
            declarator.dimensionTokens.end = at_;
            if (accept("=")) {
                declarator.initializer.first = at_;
                while (at_ < end_ && peek() != "," && peek() != ";") {
                    // A missing ';' must not swallow the next function.
                    if (peek() == "}") break;
                    at_ = open(at_) ? std::min(close(at_) + 1, end_) : at_ + 1;
                }
                declarator.initializer.end = at_;
            }
            declarator.end = at_;
            declaration.declarators.push_back(std::move(declarator));
            if (!accept(",")) break;
        }
        if (accept(";") || declaration.declarators.empty()) return;
        // The ';' is missing. The next declaration begins here, if this line looks like one.
        if (at_ < end_ && !word() && peek() != "}") skipStatement();
    }

    void function(Declaration& declaration) {
        declaration.name = at_++;
        std::uint32_t end = close(at_);
        // Where the ')' is missing, the body ends the parameters.
        for (std::uint32_t i = at_; i < end; ++i)
            if (view_[i].text == "{") end = i;
        const bool isClosed = end < end_ && view_[end].text != "{";
        declaration.parameterTokens = {at_, isClosed ? end + 1 : end};
        ++at_;
        while (at_ < end) {
            const std::uint32_t outer = std::exchange(end_, end);
            const std::uint32_t start = at_;
            declaration.parameters.push_back(parameter());
            while (at_ < end_ && peek() != ",") ++at_;
            accept(",");
            end_ = outer;
            if (at_ == start) ++at_;
        }
        if (declaration.parameters.size() == 1 && declaration.parameters[0].type.name == "void" &&
            declaration.parameters[0].name == kNone)
            declaration.parameters.clear();
        at_ = declaration.parameterTokens.end;
        declaration.kind = DeclarationKind::prototype;
        if (accept(";")) return;
        if (peek() != "{") return;
        declaration.kind = DeclarationKind::function;
        declaration.body = {at_, std::min(close(at_) + 1, end_)};
        at_ = declaration.body.end;
    }

    Parameter parameter() {
        Parameter result;
        result.qualifiers = qualifiers();
        if (!word()) return result;
        type(result.type);
        if (word()) result.name = at_++;
        brackets(result.dimensions);
        return result;
    }

    std::span<const ViewToken> view_;
    std::uint32_t at_;
    std::uint32_t end_;
    int depth_ = 0;
};

}  // namespace

const LayoutItem* Qualifiers::item(std::string_view name) const {
    const auto found =
        std::ranges::find_if(layout, [&](const LayoutItem& each) { return each.name == name; });
    return found == layout.end() ? nullptr : &*found;
}

Syntax parseSyntax(std::span<const ViewToken> view) {
    return Parser(view, 0, static_cast<std::uint32_t>(view.size())).fileScope();
}

Declaration parseVariable(std::span<const ViewToken> view, std::uint32_t at, std::uint32_t end) {
    return Parser(view, at, end).variable();
}

std::uint32_t closing(std::span<const ViewToken> view, std::uint32_t open, std::uint32_t end) {
    int depth = 0;
    end = std::min<std::uint32_t>(end, static_cast<std::uint32_t>(view.size()));
    for (std::uint32_t i = open; i < end; ++i) {
        const std::string_view text = view[i].text;
        if (opensBracket(text)) ++depth;
        if (closesBracket(text) && --depth == 0) return i;
    }
    return end;
}

}  // namespace glibra::glsl
