#include "classroom/code_tree.h"

#include "glsl/parse/syntax.h"
#include "glsl/parse/tree.h"

namespace glibra::classroom {

CodeTree::CodeTree(std::span<const CodeToken> code, Of of) : code_(code) {
    std::vector<glsl::ViewToken> view;
    view.reserve(code.size());
    for (const CodeToken& each : code)
        view.push_back({each.text, static_cast<std::uint32_t>(view.size()),
                        each.isWord     ? glsl::TokenKind::word
                        : each.isNumber ? glsl::TokenKind::number
                                        : glsl::TokenKind::punctuator});
    if (of == Of::text) {
        syntax_ = glsl::parseSyntax(view);
    } else {
        glsl::Declaration& around = syntax_.declarations.emplace_back();
        around.kind = glsl::DeclarationKind::function;
        around.body = around.tokens = {0, static_cast<std::uint32_t>(view.size())};
    }
    bodies_ = glsl::parseBodies(view, syntax_);
    for (const glsl::Declaration& each : syntax_.declarations)
        if (each.code != glsl::kNone) functions_.push_back(each.code);
}

std::map<std::uint32_t, std::uint32_t> CodeTree::initializers() const {
    std::map<std::uint32_t, std::uint32_t> found;
    const auto add = [&](const auto& each) {
        if (each.value != glsl::kNone) found.emplace(each.name, each.value);
    };
    for (const glsl::LocalVariable& each : bodies_.locals) add(each);
    for (const glsl::Declaration& each : syntax_.declarations)
        for (const glsl::Declarator& one : each.declarators) add(one);
    return found;
}

}  // namespace glibra::classroom
