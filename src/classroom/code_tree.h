#pragma once
// Code as a tree of statements and expressions, for what changes it.

#include <cstddef>
#include <cstdint>
#include <map>
#include <span>
#include <string_view>
#include <vector>

#include "classroom/normal_form.h"
#include "glsl/parse/tree.h"

namespace glibra::classroom {

using Code = std::vector<CodeToken>;

/// The tree of glsl/parse/tree.h, whose places are the indices of the tokens.
class CodeTree {
  public:
    /// Of a text, or of one statement. `code` has to outlive the tree.
    enum class Of { text, statement };
    explicit CodeTree(std::span<const CodeToken> code, Of of = Of::text);

    /// What stands outside of functions.
    [[nodiscard]] std::span<const glsl::Declaration> declarations() const { return syntax_.declarations; }
    /// In the order of the text.
    [[nodiscard]] std::span<const glsl::LocalVariable> locals() const { return bodies_.locals; }
    /// The bodies of the functions, with their braces, in the order of the text; the statement.
    [[nodiscard]] const std::vector<std::uint32_t>& functions() const { return functions_; }
    /// The variables with an initialiser, local ones too, by the index of their name: its node.
    [[nodiscard]] std::map<std::uint32_t, std::uint32_t> initializers() const;

    [[nodiscard]] const glsl::Node& node(std::uint32_t id) const { return bodies_.nodes[id]; }
    [[nodiscard]] glsl::Bodies::Children children(std::uint32_t id) const { return bodies_.children(id); }
    [[nodiscard]] std::uint32_t child(std::uint32_t id, int number) const {
        return bodies_.child(id, number);
    }
    [[nodiscard]] bool is(std::uint32_t id, glsl::NodeKind kind) const {
        return id != glsl::kNone && node(id).kind == kind;
    }
    /// Of the token that a node stands for.
    [[nodiscard]] std::string_view text(std::uint32_t id) const { return code_[node(id).token].text; }
    /// Of the token before a node: the operator before an operand of a chain.
    [[nodiscard]] std::string_view before(std::uint32_t id) const {
        return node(id).first > 0 ? code_[node(id).first - 1].text : std::string_view{};
    }
    [[nodiscard]] std::span<const CodeToken> code(std::uint32_t id) const {
        return code_.subspan(node(id).first, node(id).end - node(id).first);
    }

    /// The tokens first ... end - 1, with what `change` makes of each of these nodes in their place.
    template <class Nodes, class Change>
    [[nodiscard]] Code changed(std::size_t first, std::size_t end, const Nodes& nodes,
                               const Change& change) const {
        Code made;
        const auto add = [&](std::span<const CodeToken> more) {
            made.insert(made.end(), more.begin(), more.end());
        };
        for (const std::uint32_t each : nodes) {
            if (node(each).first < first || node(each).end > end) continue;  // what is no code
            add(code_.subspan(first, node(each).first - first));
            add(change(each));
            first = node(each).end;
        }
        add(code_.subspan(first, end - first));
        return made;
    }

  private:
    std::span<const CodeToken> code_;
    glsl::Syntax syntax_;
    glsl::Bodies bodies_;
    std::vector<std::uint32_t> functions_;
};

}  // namespace glibra::classroom
