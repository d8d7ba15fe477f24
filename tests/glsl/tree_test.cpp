// The tree of statements and expressions (parse/tree.h).

#include <gtest/gtest.h>

#include <string>

#include "glsl/parse/tree.h"
#include "glsl/read/source.h"

namespace glibra::glsl::test {
namespace {

/// Nodes in brackets: their kinds as letters or signs, and the token of each leaf.
class Shown {
  public:
    explicit Shown(const std::string& body) {
        text_.request = &request_;
        Report report;
        readSource({Stage::fragment, "a.frag", "struct S { float s; };\nvoid main() {" + body + "}\n"}, text_,
                   report);
        syntax_ = parseSyntax(text_.view);
        bodies_ = parseBodies(text_.view, syntax_);
    }

    [[nodiscard]] std::string main() const {
        for (const Declaration& each : syntax_.declarations)
            if (each.code != kNone) return children(each.code);
        return "no main";
    }
    [[nodiscard]] std::size_t nodes() const { return bodies_.nodes.size(); }

  private:
    [[nodiscard]] std::string children(std::uint32_t node) const {
        std::string all;
        for (const std::uint32_t each : bodies_.children(node)) all += (all.empty() ? "" : " ") + shown(each);
        return all;
    }
    [[nodiscard]] std::string shown(std::uint32_t id) const {
        static constexpr const char* kNames[] = {
            "block", "if",   "for",    "while", "do",    "switch", "label", "jump",   "declare", "set",
            "do",    "none", "",       "",      "call",  "array",  "of",    "[]",     "of",      "prefix",
            "step",  "",     "choose", "",      "group", "list",   "all",   "unknown"};
        const Node& node = bodies_.nodes[id];
        std::string name = kNames[static_cast<std::size_t>(node.kind)];
        if (node.kind == NodeKind::evaluation) return children(id);
        const bool hasToken = node.kind >= NodeKind::number || node.kind == NodeKind::declarator ||
                              node.kind == NodeKind::jump || node.kind == NodeKind::label;
        const bool isList = node.kind == NodeKind::group || node.kind == NodeKind::list ||
                            node.kind == NodeKind::sequence || node.kind == NodeKind::subscript;
        if (hasToken && !isList) name += (name.empty() ? "" : " ") + std::string(text_.text(node.token));
        const std::string inside = children(id);
        const bool isLeaf = node.kind == NodeKind::number || node.kind == NodeKind::name;
        return isLeaf ? name : "(" + name + (inside.empty() ? "" : " " + inside) + ")";
    }

    ProgramRequest request_;
    StageText text_;
    Syntax syntax_;
    Bodies bodies_;
};

std::string tree(const std::string& body) {
    return Shown(body).main();
}

TEST(Tree, OperatorsBindByTheirStrength) {
    EXPECT_EQ(tree("a = b + c * d - e;"), "(= a (+ b (* c d) e))");
    EXPECT_EQ(tree("a = b < c && d || e ^^ f;"), "(= a (|| (&& (< b c) d) (^^ e f)))");
    EXPECT_EQ(tree("a += b ? c : d ? e : f;"), "(+= a (choose ? b c (choose ? d e f)))");
    EXPECT_EQ(tree("a = b = -c++;"), "(= a (= b (prefix - (step ++ c))))");
    EXPECT_EQ(tree("a[i + 1].xy = (b, c);"), "(= (of xy ([] a (+ i 1))) (group (all b c)))");
    EXPECT_EQ(tree("a = vec2[2](b, f(c)).length();"), "(= a (of length (array vec2 b (call f c))))");
}

TEST(Tree, StatementsHoldWhatTheyGovern) {
    EXPECT_EQ(tree("if (a) for (int i = 0; i < 3; ++i) b; else if (c) d; else e;"),
              "(if a (for (declare (set i 0)) (< i 3) (prefix ++ i) b) (if c d e))");
    EXPECT_EQ(tree("do a; while (b); while (c) { d; }"), "(do a b) (while c (block d))");
    EXPECT_EQ(tree("for (;;) { if (a) break; }"), "(for (none) (none) (none) (block (if a (jump break))))");
    EXPECT_EQ(tree("switch (a) { case 1: b; default: return c; }"),
              "(switch a (block (label case 1) b (label default) (jump return c)))");
}

TEST(Tree, WhatCannotBeReadIsANodeToo) {
    EXPECT_EQ(tree("a = ; b = 1;"), "(= a (unknown ;)) (= b 1)");
    EXPECT_EQ(tree("a b + 1; c = 2;"), "(declare (set b)) (= c 2)");
    EXPECT_EQ(tree("f(a @ b); c = 2;"), "(call f (all a (unknown @))) (= c 2)");
    EXPECT_EQ(tree("if (a) } b = 1;"), "(if a (none))");
    EXPECT_EQ(tree("else a = 1; { b = 2;"), "(= a 1) (block (= b 2))");
}

TEST(Tree, DeepNestingEndsInTime) {
    const auto repeated = [](std::string_view text, int count) {
        std::string all;
        for (int i = 0; i < count; ++i) all += text;
        return all;
    };
    for (const char* each : {"{", "if (a) ", "(", "a[", "- ", "for (;;) {", "f(", "do ", "a ? ", "a."}) {
        const Shown shown(repeated(each, 4000));
        EXPECT_LT(shown.nodes(), 60'000U) << each;
        EXPECT_FALSE(shown.main().empty()) << each;
    }
}

}  // namespace
}  // namespace glibra::glsl::test
