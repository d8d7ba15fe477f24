#pragma once
// Example arguments of modern statements, made from their rows.

#include <initializer_list>
#include <string>
#include <string_view>
#include <vector>

#include "glib/statement_table.h"
#include "glib/syntax.h"

namespace glibra::glib::test {

/// A piece of a statement, and the node that it was made for.
struct Sample {
    std::string text;
    const SyntaxNode* node = nullptr;
    bool isTag = false;  ///< the tag of a pair; its value is the next sample
};
using Samples = std::vector<Sample>;

inline std::string sampleOf(const SyntaxNode& node) {
    std::string text;
    switch (node.type) {
        case ValueType::number:
            for (std::size_t i = 0; i < node.most; ++i) text += i == 0 ? "1.5" : " 2";
            return text;
        case ValueType::file:
            for (std::size_t i = 0; i < node.most; ++i) text += i == 0 ? "a.bmp" : " b.bmp";
            return text;
        case ValueType::name:
        case ValueType::array:
        case ValueType::object:
            return "thing";
        case ValueType::word:
        case ValueType::program:
            return "Brick";
        case ValueType::key:
            return "k";
        case ValueType::any:
        case ValueType::constant:
            return "7";
        case ValueType::expression:
            return "(2*time)";
        case ValueType::list:
            return "[1 2 3]";
        case ValueType::words:
            return "[add sub]";
        case ValueType::color:
            return "{1 0 .5}";
        case ValueType::components:
            return "[1 0 .5 1]";
        case ValueType::oneOf:
            return node.words.front();
        default:  // of classic statements alone
            break;
    }
    return text;
}

/// Arguments that together have every alternative of the syntax at least once.
inline std::vector<Samples> samplesOf(const SyntaxNode& node) {
    using Kind = SyntaxNode::Kind;
    std::vector<Samples> all;
    const auto add = [&](const std::vector<Samples>& more) {
        all.insert(all.end(), more.begin(), more.end());
    };
    switch (node.kind) {
        case Kind::key:
            all = {{{node.text, &node}}};
            if (node.hasNumberSuffix) all.push_back({{node.text + ".1", &node}});
            for (const std::string& each : node.words) all.push_back({{node.text + "." + each, &node}});
            break;
        case Kind::value:
            if (node.type != ValueType::oneOf) return {{{sampleOf(node), &node}}};
            for (const std::string& each : node.words) all.push_back({{each, &node}});
            break;
        case Kind::sequence:
            all = {{}};
            for (const SyntaxNode& child : node.children) {
                // The first form of what stands before, with each form of this child; then the other way
                // round.
                const std::vector<Samples> forms = samplesOf(child);
                std::vector<Samples> next;
                for (std::size_t i = 0; i < all.size() || i < forms.size(); ++i) {
                    Samples one = all[i < all.size() ? i : 0];
                    const Samples& tail = forms[i < forms.size() ? i : 0];
                    one.insert(one.end(), tail.begin(), tail.end());
                    next.push_back(std::move(one));
                }
                all = std::move(next);
            }
            break;
        case Kind::choice:
            for (const SyntaxNode& child : node.children) add(samplesOf(child));
            break;
        case Kind::optional:
            add(samplesOf(node.children.front()));
            all.push_back({});
            break;
        case Kind::set:
            for (const SyntaxNode& child : node.children) add(samplesOf(child));
            if (!node.needsOne) all.push_back({});
            break;
        case Kind::pairs:
            all = {{{"uKd", &node, true}, {".5", &node}}};
            if (!node.needsOne) all.push_back({});
            break;
    }
    return all;
}

/// A statement in a scene of its own in which it may stand, and the place of each sample.
struct SampleScene {
    std::string text;
    int line = 1;
    std::vector<int> columns;
    int end = 1;  ///< the column after the last sample
};

inline SampleScene sceneOf(const StatementRow& row, const Samples& samples) {
    SampleScene scene;
    if (row.sharesWord() && row.name == std::string_view("Clear")) scene.text = "Fps 60\n";
    if (row.role == BlockRole::closes || row.role == BlockRole::divides) {
        const StatementRow& opener = *statementOf(row.opener);
        scene.text += std::string(opener.name);
        const Samples arguments = samplesOf(syntaxOf(opener).root).front();
        for (const Sample& each : arguments) scene.text += " " + each.text;
        scene.text += "\n";
    }
    for (const char c : scene.text)
        if (c == '\n') ++scene.line;
    std::string line(row.name);
    bool isInline = false;
    for (const Sample& each : samples) {
        line += ' ';
        scene.columns.push_back(static_cast<int>(line.size()) + 1);
        line += each.text;
        isInline = isInline || each.text == "inline";
    }
    scene.end = static_cast<int>(line.size()) + 1;
    scene.text += line + "\n";
    if (isInline) scene.text += "void main() {}\nEnd" + std::string(row.name) + "\n";
    if (row.role == BlockRole::opens || row.role == BlockRole::divides)
        for (const StatementRow& each : statementTable())
            if (each.role == BlockRole::closes &&
                each.opener == (row.role == BlockRole::opens ? row.id : row.opener))
                scene.text += std::string(each.name) + "\n";
    return scene;
}

}  // namespace glibra::glib::test
