#include "editor/declared_names.h"

#include <algorithm>
#include <cstdlib>
#include <map>
#include <utility>

#include "base/text.h"
#include "glsl/parse/lexical.h"
#include "glsl/parse/syntax.h"
#include "glsl/parse/tree.h"
#include "glsl/parse/unit.h"
#include "glsl/read/token.h"
#include "glsl/read/words.h"

namespace glibra::editor {
namespace {

constexpr std::string_view kSpacesAndTabs = " \t";

/// The word after `#what` in a directive; empty if it is another directive.
std::string_view wordOfDirective(std::string_view line, std::string_view what) {
    line.remove_prefix(std::min(line.find_first_not_of(kSpacesAndTabs), line.size()));
    if (!line.starts_with('#')) return {};
    line.remove_prefix(1);
    line.remove_prefix(std::min(line.find_first_not_of(kSpacesAndTabs), line.size()));
    if (!line.starts_with(what)) return {};
    line.remove_prefix(what.size());
    const std::size_t begin = line.find_first_not_of(kSpacesAndTabs);
    if (begin == 0 || begin == std::string_view::npos) return {};
    line.remove_prefix(begin);
    const auto* const end = std::ranges::find_if_not(line, base::isOfName);
    return line.substr(0, static_cast<std::size_t>(end - line.begin()));
}

constexpr std::size_t kMostBytes = 4U << 20;  // language, 11; a longer text counts as empty

class Reader {
  public:
    explicit Reader(std::string_view glsl) : text_(glsl.size() > kMostBytes ? std::string_view{} : glsl) {
        for (std::size_t i = 0; i < text_.size(); ++i)
            if (text_[i] == '\0' || (text_[i] == '\r' && i + 1 < text_.size() && text_[i + 1] == '\n'))
                text_[i] = ' ';
            else if (text_[i] == '\r')
                text_[i] = '\n';
        lineBegins_.push_back(0);
        for (std::size_t i = 0; i < text_.size(); ++i)
            if (text_[i] == '\n') lineBegins_.push_back(i + 1);
        unit_.dialect.version = versionOf(text_);
        takeDirectives();
        unit_.tokens = glsl::lex(text_, unit_.storage);
        for (std::uint32_t i = 0; i < unit_.tokens.size(); ++i)
            if (const glsl::Token& each = unit_.tokens[i]; glsl::isSignificant(each.kind))
                unit_.view.push_back({each.text, i, each.kind, false});
        glsl::markNames(unit_);
        unit_.syntax = glsl::parseSyntax(unit_.view);
        unit_.bodies = glsl::parseBodies(unit_.view, unit_.syntax);
    }

    ShaderNames read() {
        findGlobals();
        for (const glsl::LocalVariable& each : unit_.bodies.locals) addLocal(each);
        std::ranges::stable_sort(found_, {}, [](const Found& each) { return each.name.place.begin; });
        ShaderNames names;
        for (std::size_t i = 0; i < found_.size(); ++i) {
            if (found_[i].at != glsl::kNone) index_[found_[i].at] = i;
            if (found_[i].name.isGlobal()) globals_.try_emplace(found_[i].name.name, i);
            names.names.push_back(std::move(found_[i].name));
        }
        addUses(names);
        return names;
    }

    std::vector<DeclaredName> members(std::size_t at) {
        findGlobals();
        const auto token = std::ranges::find_if(
            unit_.view, [&](const glsl::ViewToken& each) { return placeOf(each.raw).begin == at; });
        const auto index = static_cast<std::uint32_t>(token - unit_.view.begin());
        const auto node = std::ranges::find_if(unit_.bodies.nodes, [&](const glsl::Node& each) {
            return each.kind == glsl::NodeKind::member && each.token == index;
        });
        std::vector<DeclaredName> members;
        if (node == unit_.bodies.nodes.end() || node->child == glsl::kNone) return members;
        const glsl::Type& owner = unit_.bodies.nodes[node->child].type;
        if (owner.arrayDepth == 0 && owner.base == glsl::BaseType::structure) {
            for (const std::uint32_t each :
                 unit_.bodies.structures[static_cast<std::size_t>(owner.structure)])
                for (const Found& one : found_)
                    if (one.at == each) members.push_back(one.name);
        } else if (unit_.text(unit_.bodies.nodes[node->child].first).starts_with("gl_in") ||
                   unit_.text(unit_.bodies.nodes[node->child].first) == "gl_out") {
            for (const auto& [name, type] :
                 {std::pair("gl_Position", "vec4"), std::pair("gl_PointSize", "float"),
                  std::pair("gl_ClipDistance", "float[]")}) {
                members.emplace_back().name = name;
                members.back().type = type;
            }
        } else if (owner.vector()) {
            static constexpr std::string_view kSets[] = {"xyzw", "rgba", "stpq"};
            for (const std::string_view set : kSets) {
                const std::string_view letters = set.substr(0, owner.rows);
                for (std::size_t count = letters.size(); count > 1; --count)
                    addSwizzle(members, letters.substr(0, count), owner);
                for (std::size_t i = 0; i < letters.size(); ++i)
                    addSwizzle(members, letters.substr(i, 1), owner);
            }
        }
        return members;
    }

  private:
    struct Found {
        std::uint32_t at = glsl::kNone;  ///< view index of the name
        DeclaredName name;
    };
    struct DirectiveWord {
        TextRange place;
        std::string text;
    };

    void findGlobals() {
        for (const glsl::Declaration& each : unit_.syntax.declarations) add(each);
        for (const glsl::Declaration& each : unit_.bodies.declarations)
            if (each.type.isStruct) addStructure(each);
    }

    static void addSwizzle(std::vector<DeclaredName>& to, std::string_view letters, const glsl::Type& owner) {
        DeclaredName& name = to.emplace_back();
        name.name = letters;
        name.type = wordOf(glsl::vectorType(owner.base, static_cast<int>(letters.size())));
    }

    /// Takes the macros and the names in directives, and blanks the directives, so that the rest can be read
    /// as code.
    void takeDirectives() {
        for (std::size_t begin = 0; begin < text_.size();) {
            std::size_t end = std::min(text_.find('\n', begin), text_.size());
            const std::size_t first = text_.find_first_not_of(kSpacesAndTabs, begin);
            const bool isDirective = first < end && text_[first] == '#';
            while (isDirective && end > begin && end < text_.size() && text_[end - 1] == '\\')
                end = std::min(text_.find('\n', end + 1), text_.size());
            if (isDirective) takeDirective({first, end});
            begin = end + 1;
        }
    }
    void takeDirective(TextRange range) {
        const std::string line = text_.substr(range.begin, range.end - range.begin);
        if (const std::string_view name = wordOfDirective(line, "define"); !name.empty()) {
            Found& macro = found_.emplace_back();
            const std::size_t begin = range.begin + static_cast<std::size_t>(name.data() - line.data());
            macro.name.name = name;
            macro.name.type = "macro";
            macro.name.declaration = line;
            macro.name.place = {begin, begin + name.size()};
            macro.name.line = lineOf(begin);
        }
        static constexpr std::string_view kWithNames[] = {"define", "undef", "if", "ifdef", "ifndef", "elif"};
        std::string joined = line;
        for (char& c : joined)
            if (c == '\\' || c == '\n') c = ' ';
        std::deque<std::string> storage;
        bool isFirst = true;
        for (const glsl::Token& each : glsl::lex(joined, storage)) {
            if (each.kind != glsl::TokenKind::word) continue;
            const std::size_t begin = range.begin + static_cast<std::size_t>(each.column) - 1;
            if (isFirst && std::ranges::find(kWithNames, each.text) == std::end(kWithNames)) break;
            if (!isFirst && glsl::keywordSince(each.text) == 0)
                directiveWords_.push_back({{begin, begin + each.text.size()}, std::string(each.text)});
            isFirst = false;
        }
        for (std::size_t i = range.begin; i < range.end; ++i)
            if (text_[i] != '\n') text_[i] = ' ';
    }

    [[nodiscard]] int lineOf(std::size_t byte) const {
        return static_cast<int>(std::ranges::upper_bound(lineBegins_, byte) - lineBegins_.begin());
    }
    [[nodiscard]] TextRange placeOf(std::uint32_t token) const {
        if (token >= unit_.tokens.size()) return {text_.size(), text_.size()};
        const glsl::Token& each = unit_.tokens[token];
        const std::size_t begin =
            lineBegins_[static_cast<std::size_t>(each.line) - 1] + static_cast<std::size_t>(each.column) - 1;
        return {begin, std::min(begin + each.text.size(), text_.size())};
    }
    [[nodiscard]] TextRange placeAt(std::uint32_t view) const {
        return view < unit_.view.size() ? placeOf(unit_.view[view].raw)
                                        : TextRange{text_.size(), text_.size()};
    }

    /// The words of a range with a blank between them: "vec3 n, float r", "lights[2]".
    [[nodiscard]] std::string words(glsl::Range range) const {
        std::string text;
        for (std::uint32_t i = range.first; i < range.end; ++i) {
            const std::string_view each = unit_.text(i);
            const bool isJoined = text.empty() || each == "," || each == "[" || each == "]" ||
                                  unit_.text(i - 1) == "[" || each == ")" || each == "(" ||
                                  unit_.text(i - 1) == "(";
            text += (isJoined ? "" : " ") + std::string(each);
        }
        return text;
    }
    [[nodiscard]] std::string sizes(const std::vector<glsl::Range>& dimensions) const {
        std::string text;
        for (const glsl::Range& each : dimensions) text += "[" + words(each) + "]";
        return text;
    }
    [[nodiscard]] std::string typeText(const glsl::TypeUse& type) const {
        return (type.name.empty() ? "struct" : std::string(type.name)) + sizes(type.dimensions);
    }
    /// Without layout(...): "flat in ".
    [[nodiscard]] std::string qualifierText(const glsl::Qualifiers& qualifiers) const {
        std::string text;
        for (std::uint32_t i = qualifiers.tokens.first; i < qualifiers.tokens.end; ++i)
            if (std::ranges::none_of(qualifiers.layoutTokens,
                                     [&](const glsl::Range& each) { return each.contains(i); }))
                text += std::string(unit_.text(i)) + " ";
        return text;
    }

    DeclaredName& add(std::uint32_t at, std::string type, std::string declaration) {
        DeclaredName& name = found_.emplace_back(Found{at, {}}).name;
        name.name = unit_.text(at);
        name.type = std::move(type);
        name.declaration = std::move(declaration);
        name.place = placeAt(at);
        name.line = lineOf(name.place.begin);
        return name;
    }

    /// Of the file's scope.
    void add(const glsl::Declaration& each) {
        if (each.kind == glsl::DeclarationKind::function || each.kind == glsl::DeclarationKind::prototype) {
            const std::string type = typeText(each.type);
            DeclaredName& function =
                add(each.name, type,
                    type + " " + std::string(unit_.text(each.name)) + words(each.parameterTokens));
            function.isFunction = true;
            if (!each.body.empty())
                function.body = {placeAt(each.body.first).begin, placeAt(each.body.end - 1).end};
            return;
        }
        const bool isBlock = each.kind == glsl::DeclarationKind::block;
        if (isBlock || each.type.isStruct) addStructure(each);
        if (each.kind != glsl::DeclarationKind::variable && !isBlock) return;
        const std::string type = isBlock ? std::string(unit_.text(each.name)) : typeText(each.type);
        for (const glsl::Declarator& one : each.declarators) {
            const std::string whole = type + sizes(one.dimensions);
            add(one.name, whole,
                qualifierText(each.qualifiers) + type + " " + std::string(unit_.text(one.name)) +
                    sizes(one.dimensions))
                .isInterface = each.qualifiers.isInterface();
        }
    }

    void addStructure(const glsl::Declaration& each) {
        const bool isBlock = each.kind == glsl::DeclarationKind::block;
        if (each.name != glsl::kNone && each.body.empty()) return;
        if (each.name != glsl::kNone)
            add(each.name, isBlock ? "block" : "struct",
                (isBlock ? qualifierText(each.qualifiers) : "struct ") + std::string(unit_.text(each.name)))
                .isInterface = isBlock;
        for (const glsl::Declaration& member : each.members)
            for (const glsl::Declarator& one : member.declarators) {
                DeclaredName& name = add(one.name, typeText(member.type) + sizes(one.dimensions),
                                         qualifierText(member.qualifiers) + typeText(member.type) + " " +
                                             std::string(unit_.text(one.name)) + sizes(one.dimensions));
                if (each.name != glsl::kNone) name.owner = unit_.text(each.name);
                name.isMember = !isBlock || !each.declarators.empty();
                name.isInterface = !name.isMember;
            }
    }

    void addLocal(const glsl::LocalVariable& each) {
        // Its declaration is the last one that begins before it.
        const auto sizesAfter = [&](std::uint32_t at) {
            std::string text;
            while (unit_.text(at) == "[") {
                const std::uint32_t end =
                    closing(unit_.view, at, static_cast<std::uint32_t>(unit_.view.size()));
                text += "[" + words({at + 1, end}) + "]";
                at = end + 1;
            }
            return text;
        };
        std::string type(each.typeWord);
        const std::uint32_t before = each.name > 0 ? each.name - 1 : 0;
        if (unit_.text(before) == "]" && unit_.bodies.matches[before] < before)
            type += words({unit_.bodies.matches[before], each.name});
        type += sizesAfter(each.name + 1);
        DeclaredName& name =
            add(each.name, type,
                (each.constToken == glsl::kNone ? "" : "const ") + std::string(each.typeWord) + " " +
                    std::string(unit_.text(each.name)) + type.substr(each.typeWord.size()));
        name.isParameter = each.isParameter;
        name.scopeEnd = placeAt(each.scopeEnd).begin;
    }

    [[nodiscard]] std::size_t indexOf(std::uint32_t view) const {
        const auto found = index_.find(view);
        return found == index_.end() ? kNoName : found->second;
    }
    [[nodiscard]] std::size_t globalOf(std::string_view name) const {
        const auto found = globals_.find(name);
        return found == globals_.end() ? kNoName : found->second;
    }

    /// "f(vec3,float)" of "float f(vec3 n, float r)": the types of the parameters, without their names.
    static std::string signatureOf(const DeclaredName& function) {
        std::string text = function.name;
        const std::string& declaration = function.declaration;
        for (std::size_t at = declaration.find('('); at < declaration.size();) {
            const std::size_t end = std::min(declaration.find_first_of(",)", at + 1), declaration.size());
            const std::string one = declaration.substr(at + 1, end - at - 1);
            text += one.substr(0, one.find_last_of(' ')) + ",";
            at = end;
        }
        return text;
    }

    void addUses(ShaderNames& names) {
        std::map<std::string, std::size_t> bodies;  // of functions, by signature
        for (std::size_t i = 0; i < names.names.size(); ++i)
            if (const DeclaredName& each = names.names[i]; each.isFunction && each.body.end > 0)
                bodies.emplace(signatureOf(each), i);
        const auto withBody = [&](std::size_t name) {
            const DeclaredName& own = names.names[name];
            if (!own.isFunction || own.body.end > 0) return name;
            const auto body = bodies.find(signatureOf(own));
            return body == bodies.end() ? name : body->second;
        };
        std::map<std::uint32_t, std::uint32_t> called;
        for (const glsl::Call& each : unit_.bodies.calls) called[each.name] = each.function;
        for (std::uint32_t i = 0; i < unit_.view.size(); ++i) {
            const glsl::ViewToken& token = unit_.view[i];
            if (token.kind != glsl::TokenKind::word) continue;
            NameUse use{placeAt(i)};
            use.isMember = i > 0 && unit_.text(i - 1) == ".";
            use.name = indexOf(unit_.bodies.meanings[i]);
            if (use.name == kNoName && !use.isMember) {
                if (!token.isName && glsl::keywordSince(token.text) != 0) continue;
                use.name = globalOf(token.text);  // a macro, or declared further down
            }
            use.target = use.name;
            if (const auto call = called.find(i); call != called.end() && indexOf(call->second) != kNoName)
                use.target = indexOf(call->second);
            else if (const std::size_t own = indexOf(i); own != kNoName)
                use.target = own;
            if (use.target != kNoName) use.target = withBody(use.target);
            names.uses.push_back(use);
        }
        for (const DirectiveWord& each : directiveWords_)
            names.uses.push_back({each.place, globalOf(each.text), globalOf(each.text), false});
        std::ranges::sort(names.uses, {}, [](const NameUse& each) { return each.place.begin; });
    }

    std::string text_;
    std::vector<std::size_t> lineBegins_;
    glsl::Unit unit_;
    std::vector<Found> found_;
    std::vector<DirectiveWord> directiveWords_;
    std::map<std::uint32_t, std::size_t> index_;  ///< of names by view index
    std::map<std::string, std::size_t, std::less<>> globals_;
};

}  // namespace

const NameUse* ShaderNames::useAt(std::size_t byte) const {
    const auto found = std::ranges::find_if(
        uses, [&](const NameUse& each) { return each.place.begin <= byte && byte <= each.place.end; });
    return found == uses.end() ? nullptr : &*found;
}

ShaderNames namesOfShader(std::string_view glsl) {
    return Reader(glsl).read();
}

std::vector<DeclaredName> declaredNames(std::string_view glsl) {
    return Reader(glsl).read().names;
}

std::vector<DeclaredName> membersAt(std::string_view glsl, std::size_t point, std::size_t end) {
    // Something has to stand there.
    Reader reader(std::string(glsl.substr(0, point + 1)) + "x " + std::string(glsl.substr(end)));
    return reader.members(point + 1);
}

int versionOf(std::string_view glsl) {
    constexpr int kFirst = 110;
    for (std::size_t begin = 0; begin < glsl.size();) {
        const std::size_t end = std::min(glsl.find('\n', begin), glsl.size());
        const std::string_view word = wordOfDirective(glsl.substr(begin, end - begin), "version");
        if (!word.empty()) return std::atoi(std::string(word).c_str());
        begin = end + 1;
    }
    return kFirst;
}

}  // namespace glibra::editor
