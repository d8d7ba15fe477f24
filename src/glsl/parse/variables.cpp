#include "glsl/parse/variables.h"

#include <algorithm>
#include <cstdlib>
#include <string_view>
#include <utility>

#include "glsl/parse/types.h"
#include "glsl/parse/usage.h"

namespace glibra::glsl {
namespace {

std::vector<std::string> textsOf(const Unit& unit, const std::vector<Range>& ranges) {
    std::vector<std::string> texts;
    texts.reserve(ranges.size());
    for (const Range& each : ranges) texts.push_back(textOf(unit, each));
    return texts;
}

/// Qualifiers and type, as in "flat in vec3", in the order that all versions accept.
std::string headOf(const Variable& variable) {
    std::string text;
    const auto add = [&](std::string_view word) {
        if (word.empty()) return;
        if (!text.empty()) text += ' ';
        text += word;
    };
    if (variable.precise) add("precise");
    if (variable.invariant) add("invariant");
    add(variable.interpolation);
    if (!variable.layout.empty()) {
        std::string items;
        for (const auto& [key, value] : variable.layout) {
            if (!items.empty()) items += ", ";
            items += key;
            if (!value.empty()) items += " = " + value;
        }
        add("layout(" + items + ")");
    }
    if (variable.subroutine) add("subroutine");
    if (variable.centroid) add("centroid");
    if (variable.sample) add("sample");
    if (variable.patch) add("patch");
    for (const std::string& each : variable.memory) add(each);
    add(kStorageWords.at(static_cast<std::size_t>(variable.storage)));
    add(variable.precision);
    add(variable.type);
    return text + bracketed(variable.typeSizes);
}

/// Writes a declaration with at least one changed variable.
class Rewriter {
  public:
    Rewriter(Unit& unit, const Declaration& declaration, std::vector<Variable*> variables)
        : unit_(unit), declaration_(declaration), variables_(std::move(variables)) {}

    void run() {
        for (const Variable* each : variables_) details(*each);
        const bool any = std::ranges::any_of(variables_, [](const Variable* each) {
            return each->changed || each->removed || !each->after.empty();
        });
        if (any) head();
    }

  private:
    void details(const Variable& variable) {
        const Declarator& declarator = declaration_.declarators[variable.declarator];
        if (variable.removed) return;
        if (variable.sizesChanged) unit_.remove(declarator.dimensionTokens);
        if (variable.dropInitializer) unit_.remove({declarator.dimensionTokens.end, declarator.end});
        const bool behindSizes = !variable.sizesChanged && !declarator.dimensions.empty();
        const std::uint32_t last = behindSizes ? declarator.dimensionTokens.end - 1 : variable.nameToken;
        const std::string text =
            (variable.sizesChanged ? bracketed(variable.nameSizes) : "") + variable.initializer;
        if (!text.empty()) unit_.edits.after(unit_.view[last].raw, text);
    }

    void head() {
        const bool structure = declaration_.type.isStruct;
        const Range head = structure
                               ? declaration_.qualifiers.tokens
                               : Range{declaration_.tokens.first, declaration_.declarators.front().name};
        const std::string common = text(*variables_.front());
        const bool together = std::ranges::all_of(variables_, [&](const Variable* each) {
            return !each->removed && each->after.empty() && text(*each) == common;
        });
        unit_.remove(head);
        if (structure || together) {
            if (head.empty())
                unit_.edits.before(unit_.view[declaration_.type.tokens.first].raw, common);
            else
                unit_.edits.replace(unit_.view[head.first].raw, common.substr(0, common.size() - 1));
            if (structure) lastOfStructure();
            return;
        }
        for (const Variable* each : variables_) separate(*each);
    }

    /// `struct { } a;` cannot be split. Only what follows it can be written.
    void lastOfStructure() {
        const std::uint32_t end = declaration_.declarators.back().end;
        if (end >= unit_.view.size()) return;
        for (const Variable* each : variables_)
            if (!each->after.empty()) unit_.edits.after(unit_.view[end].raw, each->after);
    }

    void separate(const Variable& variable) {
        const Declarator& declarator = declaration_.declarators[variable.declarator];
        const bool ends = declarator.end < unit_.view.size();
        if (variable.removed) {
            unit_.remove({declarator.name, declarator.end});
            if (ends) unit_.edits.remove(unit_.view[declarator.end].raw);
        } else {
            unit_.edits.before(unit_.view[declarator.name].raw, text(variable));
            if (ends) unit_.edits.replace(unit_.view[declarator.end].raw, ";");
        }
        if (ends && !variable.after.empty())
            unit_.edits.after(unit_.view[declarator.end].raw, variable.after);
    }

    [[nodiscard]] std::string text(const Variable& variable) const {
        Variable copy = variable;
        copy.type = declaration_.type.isStruct ? "" : spelled(unit_, variable.type);
        const std::string words = headOf(copy);
        return words.empty() ? words : words + " ";
    }

    Unit& unit_;
    const Declaration& declaration_;
    std::vector<Variable*> variables_;
};

}  // namespace

std::vector<Variable> collectVariables(const Unit& unit) {
    std::vector<Variable> variables;
    for (std::size_t i = 0; i < unit.syntax.declarations.size(); ++i) {
        const Declaration& declaration = unit.syntax.declarations[i];
        if (declaration.kind != DeclarationKind::variable) continue;
        const Qualifiers& q = declaration.qualifiers;
        for (std::size_t k = 0; k < declaration.declarators.size(); ++k) {
            const Declarator& declarator = declaration.declarators[k];
            Variable variable;
            static_cast<ChangeableQualifiers&>(variable) = q;
            variable.declaration = i;
            variable.declarator = k;
            variable.name = unit.text(declarator.name);
            variable.nameToken = declarator.name;
            if (!declaration.type.isStruct) variable.type = declaration.type.name;
            variable.typeSizes = textsOf(unit, declaration.type.dimensions);
            variable.nameSizes = textsOf(unit, declarator.dimensions);
            for (const LayoutItem& item : q.layout)
                variable.layout.emplace_back(item.name, textOf(unit, item.value));
            variables.push_back(std::move(variable));
        }
    }
    return variables;
}

std::string bracketed(const std::vector<std::string>& sizes) {
    std::string text;
    for (const std::string& each : sizes) text += "[" + each + "]";
    return text;
}

std::string spelled(const Unit& unit, const std::string& word) {
    if (const auto found = unit.wordRenames.find(word); found != unit.wordRenames.end()) return found->second;
    const auto found = unit.renames.find(word);
    return found == unit.renames.end() ? word : found->second;
}

void renderVariables(Unit& unit) {
    std::size_t i = 0;
    while (i < unit.variables.size()) {
        const std::size_t declaration = unit.variables[i].declaration;
        std::vector<Variable*> together;
        for (; i < unit.variables.size() && unit.variables[i].declaration == declaration; ++i)
            together.push_back(&unit.variables[i]);
        Rewriter(unit, unit.syntax.declarations[declaration], std::move(together)).run();
    }
}

std::vector<std::string> Variable::sizes() const {
    std::vector<std::string> all = nameSizes;
    all.insert(all.end(), typeSizes.begin(), typeSizes.end());
    return all;
}

const std::string* Variable::layoutValue(std::string_view key) const {
    const auto found = std::ranges::find_if(layout, [&](const auto& each) { return each.first == key; });
    return found == layout.end() ? nullptr : &found->second;
}

void Variable::removeLayout(std::string_view key) {
    if (std::erase_if(layout, [&](const auto& each) { return each.first == key; }) > 0) changed = true;
}

void Variable::setLayout(std::string key, std::string value) {
    removeLayout(key);
    layout.emplace_back(std::move(key), std::move(value));
    changed = true;
}

// ---- Zeros

namespace {

class Zero {
  public:
    Zero(const Unit& unit, int mostElements) : unit_(unit), mostElements_(mostElements) {}

    [[nodiscard]] std::optional<std::string> of(const std::string& type, std::span<const std::string> sizes,
                                                int depth = 0) const {
        if (depth > 6 || type.empty()) return std::nullopt;
        if (sizes.empty()) return scalar(type, depth);
        const auto element = of(type, sizes.subspan(1), depth + 1);
        const int count = std::atoi(sizes.front().c_str());
        if (!element || count < 1 || count > mostElements_) return std::nullopt;
        std::string text = spelled(unit_, type);
        for (const std::string& each : sizes) text += "[" + each + "]";
        text += "(";
        for (int i = 0; i < count && text.size() < kLongest; ++i) text += (i ? ", " : "") + *element;
        if (text.size() >= kLongest) return std::nullopt;
        return text + ")";
    }

  private:
    static constexpr std::size_t kLongest = 1U << 16;

    [[nodiscard]] std::optional<std::string> scalar(const std::string& type, int depth) const {
        for (const Declaration& each : unit_.syntax.declarations) {
            if (!each.type.isStruct || each.type.name != type) continue;
            std::string text = spelled(unit_, type) + "(";
            for (const Declaration& member : each.members)
                for (const Declarator& name : member.declarators) {
                    const auto value =
                        of(std::string(member.type.name),
                           sizeTexts(unit_, name.dimensions, member.type.dimensions), depth + 1);
                    if (!value) return std::nullopt;
                    text += (text.back() == '(' ? "" : ", ") + *value;
                }
            return text + ")";
        }
        std::string zero = zeroOf(type);
        return zero.empty() ? std::nullopt : std::optional(std::move(zero));
    }

    const Unit& unit_;
    int mostElements_;
};

}  // namespace

std::optional<std::string> zeroValue(const Unit& unit, const std::string& type,
                                     std::span<const std::string> sizes, int mostElements) {
    return Zero(unit, mostElements).of(type, sizes);
}

std::vector<std::string> sizeTexts(const Unit& unit, const std::vector<Range>& ofName,
                                   const std::vector<Range>& ofType) {
    std::vector<std::string> sizes;
    for (const auto* ranges : {&ofName, &ofType})
        for (const Range& each : *ranges) sizes.push_back(sizeText(unit, each));
    return sizes;
}

}  // namespace glibra::glsl
