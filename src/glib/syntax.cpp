#include "glib/syntax.h"

#include <fmt/format.h>

#include <algorithm>
#include <cassert>
#include <charconv>
#include <iterator>
#include <limits>
#include <string_view>
#include <utility>

#include "glib/limits.h"
#include "glib/number.h"
#include "glib/text.h"

namespace glibra::glib {
namespace {

using NodeKind = SyntaxNode::Kind;

constexpr std::size_t kMostShownWords = 7;
constexpr std::string_view kRepeats = "...";

constexpr std::pair<std::string_view, ValueType> kTypes[] = {
    {"number", ValueType::number},
    {"name", ValueType::name},
    {"array", ValueType::array},
    {"object", ValueType::object},
    {"word", ValueType::word},
    {"file", ValueType::file},
    {"program", ValueType::program},
    {"key", ValueType::key},
    {"any", ValueType::any},
    {"constant", ValueType::constant},
    {"expression", ValueType::expression},
    {"list", ValueType::list},
    {"words", ValueType::words},
    {"color", ValueType::color},
    {"components", ValueType::components},
    {"size", ValueType::size},
    {"count", ValueType::count},
    {"integer", ValueType::integer},
    {"between", ValueType::between},
    {"positive", ValueType::positive},
    {"texels", ValueType::texels},
    {"component", ValueType::component},
    {"unit", ValueType::unit},
    {"points", ValueType::points},
    {"truth", ValueType::truth},
    {"line", ValueType::line},
};

/// Numbers that the notation calls by name.
constexpr std::pair<std::string_view, double> kNumbers[] = {
    {"side", kLargestTextureSide},   {"volume", kLargestVolumeSide},
    {"unit", kHighestUnit},          {"vertices", kMostVertices},
    {"red", kDefaultBackground[0]},  {"green", kDefaultBackground[1]},
    {"blue", kDefaultBackground[2]}, {"", std::numeric_limits<double>::infinity()},
};

/// Replaces every $name by its fragment.
std::string expanded(std::string_view syntax) {
    std::string text;
    for (std::size_t at = 0; at < syntax.size();) {
        if (syntax[at] != '$') {
            text += syntax[at++];
            continue;
        }
        std::size_t end = at + 1;
        while (end < syntax.size() && syntax[end] >= 'a' && syntax[end] <= 'z') ++end;
        const std::string_view fragment = syntaxFragment(syntax.substr(at + 1, end - at - 1));
        assert(!fragment.empty());
        text += expanded(fragment);
        at = end;
    }
    return text;
}

std::vector<std::string> split(std::string_view list) {
    std::vector<std::string> words;
    while (true) {
        const std::size_t comma = list.find(',');
        words.emplace_back(list.substr(0, comma));
        if (comma == std::string_view::npos) return words;
        list.remove_prefix(comma + 1);
    }
}

std::size_t readCount(std::string_view digits) {
    std::size_t count = 0;
    std::from_chars(digits.data(), digits.data() + digits.size(), count);
    return count;
}

double readNumberOf(std::string_view text) {
    if (const auto number = numberPrefix(text)) return number->value;
    const auto* const named = std::ranges::find(kNumbers, text, &std::pair<std::string_view, double>::first);
    assert(named != std::end(kNumbers));
    return named->second;
}

/// Cuts the text at the first of these bytes, and returns what follows it.
std::string_view cutAt(std::string_view& text, std::string_view bytes) {
    const std::size_t at = std::min(text.find_first_of(bytes), text.size());
    const std::string_view rest = text.substr(std::min(at + 1, text.size()));
    text = text.substr(0, at);
    return rest;
}

/// Reads =5~0/1..9/pixels after the type of a number, and removes it from the type.
void readRule(std::string_view& type, SyntaxNode& node) {
    std::string_view limits = cutAt(type, "/"), measure = cutAt(limits, "/"), filler = cutAt(type, "~");
    const std::string_view byDefault = cutAt(type, "=");
    if (!byDefault.empty()) node.byDefault = readNumberOf(byDefault);
    if (!filler.empty()) node.filler = readNumberOf(filler);
    const std::size_t dots = limits.find("..");
    if (dots == std::string_view::npos) {
        measure = limits;
    } else {
        node.low = readNumberOf(limits.substr(0, dots));
        node.high = readNumberOf(limits.substr(dots + 2));
    }
    node.measure = measure;
}

class Compiler {
  public:
    explicit Compiler(std::string_view text) : text_(text) {}

    SyntaxNode compile() {
        SyntaxNode root = alternatives(NodeKind::choice);
        assert(at_ >= text_.size());
        return root;
    }

  private:
    void skipBlanks() {
        while (at_ < text_.size() && text_[at_] == ' ') ++at_;
    }
    bool take(std::string_view expected) {
        if (!text_.substr(at_).starts_with(expected)) return false;
        at_ += expected.size();
        return true;
    }

    /// a | b | c up to a closing bracket. One sequence alone is that sequence, except in a set.
    SyntaxNode alternatives(NodeKind kind) {
        SyntaxNode node;
        node.kind = kind;
        do node.children.push_back(sequence());
        while (take("|"));
        if (kind == NodeKind::choice && node.children.size() == 1) return std::move(node.children.front());
        return node;
    }

    SyntaxNode sequence() {
        SyntaxNode node;
        for (skipBlanks(); at_ < text_.size(); skipBlanks()) {
            if (std::string_view("|)]}").find(text_[at_]) != std::string_view::npos) break;
            node.children.push_back(item());
        }
        return node;
    }

    SyntaxNode item() {
        SyntaxNode node;
        if (take("(")) {
            node = alternatives(NodeKind::choice);
            take(")");
        } else if (take("[")) {
            node.kind = NodeKind::optional;
            node.children.push_back(alternatives(NodeKind::choice));
            take("]");
        } else if (take("{")) {
            node = alternatives(NodeKind::set);
            take("}");
            node.needsOne = take("+");
        } else {
            node = word();
        }
        if (take(kRepeats)) node.repeats = true;
        return node;
    }

    SyntaxNode word() {
        std::size_t end = std::min(text_.find_first_of(" |()[]{}", at_), text_.size());
        if (const std::size_t dots = text_.find(kRepeats, at_); dots < end) end = dots;
        const std::string_view all = text_.substr(at_, end - at_);
        at_ = end;
        const std::size_t colon = all.find(':');
        if (colon != std::string_view::npos) return value(all.substr(0, colon), all.substr(colon + 1));
        SyntaxNode node;
        if (all.starts_with("pairs")) {
            node.kind = NodeKind::pairs;
            node.type = ValueType::any;
            node.text = "tags";
            node.needsOne = all.ends_with('+');
            return node;
        }
        node.kind = NodeKind::key;
        const std::size_t point = all.find('.');
        node.text = all.substr(0, point);
        if (point == std::string_view::npos) return node;
        node.hasNumberSuffix = all.substr(point + 1) == "#";
        if (!node.hasNumberSuffix) node.words = split(all.substr(point + 1));
        return node;
    }

    static SyntaxNode value(std::string_view name, std::string_view type) {
        SyntaxNode node;
        node.kind = NodeKind::value;
        node.text = name;
        std::ranges::replace(node.text, '_', ' ');
        readRule(type, node);
        const std::size_t count = type.find_first_of("*+");
        if (count != std::string_view::npos) {
            node.most = readCount(type.substr(count + 1));
            node.least = type[count] == '*' ? node.most : 1;
        }
        const auto* known = std::ranges::find_if(
            kTypes, [&](const auto& each) { return each.first == type.substr(0, count); });
        if (known != std::end(kTypes)) {
            node.type = known->second;
        } else {
            node.type = ValueType::oneOf;
            node.words = split(type);
        }
        return node;
    }

    std::string_view text_;
    std::size_t at_ = 0;
};

void addOnce(std::vector<std::string>& words, const std::string& word) {
    if (std::ranges::find(words, word) == words.end()) words.push_back(word);
}

/// Where a node stands.
struct Surroundings {
    bool isSkippable = false, isChosen = false;
    bool isAfterKey = false;  ///< of the same alternative
};

/// Sets isSkippable and isChosen, and collects the keys.
void finishNode(SyntaxNode& node, Surroundings around, Syntax& syntax) {
    node.isSkippable = around.isSkippable;
    node.isChosen = around.isChosen;
    if (node.kind == NodeKind::value || node.kind == NodeKind::pairs) syntax.arguments.push_back(&node);
    if (node.kind == NodeKind::key) {
        addOnce(syntax.keys, node.text);
        if (!around.isAfterKey) addOnce(syntax.outerKeys, node.text);
    }
    if (node.kind == NodeKind::optional || node.kind == NodeKind::set) around.isSkippable = true;
    if (node.kind == NodeKind::choice) around.isChosen = true;
    for (SyntaxNode& each : node.children) {
        finishNode(each, around, syntax);
        // What follows the key of an alternative belongs to it: it cannot be left out, nor be another's key.
        if (node.kind == NodeKind::sequence && each.kind == NodeKind::key) around = {false, false, true};
    }
}

std::string joined(const SyntaxNode& node, std::string_view between);

std::string shown(const SyntaxNode& node) {
    std::string text;
    switch (node.kind) {
        case NodeKind::key:
            text = node.text;
            if (node.hasNumberSuffix) text += "[.n]";
            if (!node.words.empty()) text += fmt::format("[.{}]", fmt::join(node.words, "|."));
            break;
        case NodeKind::value:
            if (node.type == ValueType::oneOf && node.words.size() <= kMostShownWords)
                text = fmt::format("{}", fmt::join(node.words, "|"));
            else
                text = node.text;
            if (node.type == ValueType::array) text += "[count]";
            if (node.type == ValueType::expression) text = "(" + text + ")";
            if (node.most > 1)
                text += fmt::format("{}{}", node.least < node.most ? " up to x" : " x", node.most);
            break;
        case NodeKind::sequence:
            text = joined(node, " ");
            break;
        case NodeKind::choice:
            text = "(" + joined(node, " | ") + ")";
            break;
        case NodeKind::optional:
            text = "[" + joined(node, " ") + "]";
            break;
        case NodeKind::set:
            text = "{" + joined(node, " | ") + "}";
            break;
        case NodeKind::pairs:
            text = node.needsOne ? "tag value ..." : "[tag value]...";
            break;
    }
    if (node.repeats) text += " ...";
    return text;
}

std::string joined(const SyntaxNode& node, std::string_view between) {
    std::string text;
    for (const SyntaxNode& each : node.children) {
        const std::string piece = shown(each);
        if (piece.empty()) continue;
        if (!text.empty()) text += between;
        text += piece;
    }
    return text;
}

template <class Visit>
void forEachNode(const SyntaxNode& node, const Visit& visit) {
    visit(node);
    for (const SyntaxNode& each : node.children) forEachNode(each, visit);
}

std::vector<Syntax> compiled(std::span<const StatementRow> rows) {
    std::vector<Syntax> all(rows.size());
    for (std::size_t i = 0; i < rows.size(); ++i) {
        all[i].root = Compiler(expanded(rows[i].syntax)).compile();
        finishNode(all[i].root, {}, all[i]);
    }
    return all;
}

}  // namespace

const Syntax& syntaxOf(const StatementRow& row) {
    static const std::span<const StatementRow> kClassicRows = commandTable();
    static const std::vector<Syntax> kClassic = compiled(kClassicRows), kModern = compiled(statementTable());
    const StatementRow* const first = kClassicRows.data();
    const bool isClassic = !std::less<>()(&row, first) && std::less<>()(&row, first + kClassicRows.size());
    return isClassic ? kClassic[static_cast<std::size_t>(&row - first)]
                     : kModern[static_cast<std::size_t>(&row - statementTable().data())];
}

bool hasNode(const StatementRow& row, const std::function<bool(const SyntaxNode&)>& isSuch) {
    bool found = false;
    forEachNode(syntaxOf(row).root, [&](const SyntaxNode& each) { found = found || isSuch(each); });
    return found;
}

std::vector<WordList> wordLists(const StatementRow& row) {
    std::vector<WordList> lists;
    forEachNode(syntaxOf(row).root, [&](const SyntaxNode& node) {
        if (node.type != ValueType::oneOf || node.words.size() <= kMostShownWords) return;
        if (std::ranges::none_of(lists, [&](const WordList& each) {
                return each.name == node.text && each.words == node.words;
            }))
            lists.push_back({node.text, node.words});
    });
    return lists;
}

std::vector<std::string> wordsOf(const StatementRow& row) {
    std::vector<std::string> words;
    forEachNode(syntaxOf(row).root, [&](const SyntaxNode& node) {
        if (node.kind == NodeKind::key) addOnce(words, node.text);
        if (node.kind == NodeKind::value)
            for (const std::string& each : node.words) addOnce(words, each);
    });
    return words;
}

std::string usage(const StatementRow& row) {
    const std::string arguments = shown(syntaxOf(row).root);
    return arguments.empty() ? std::string(row.name) : fmt::format("{} {}", row.name, arguments);
}

}  // namespace glibra::glib
