#include "glsl/parse/variables.h"

#include <algorithm>

#include "glsl/parse/unit.h"

namespace glibra::glsl {
namespace {

std::vector<std::string> textsOf(const Unit& unit, const std::vector<Range>& ranges) {
    std::vector<std::string> texts;
    texts.reserve(ranges.size());
    for (const Range& each : ranges) texts.push_back(textOf(unit, each));
    return texts;
}

std::string bracketed(const std::vector<std::string>& sizes) {
    std::string text;
    for (const std::string& each : sizes) text += "[" + each + "]";
    return text;
}

/// Writes a declaration with at least one changed variable.
class Rewriter {
  public:
    Rewriter(Unit& unit, const Declaration& declaration, std::vector<Variable*> variables)
        : unit_(unit), declaration_(declaration), variables_(std::move(variables)) {}

    void run() {
        for (const Variable* each : variables_) details(*each);
        const bool any = std::any_of(variables_.begin(), variables_.end(), [](const Variable* each) {
            return each->changed || each->removed || !each->after.empty();
        });
        if (any) head();
    }

  private:
    void details(const Variable& variable) {
        const Declarator& declarator = declaration_.declarators[variable.declarator];
        if (variable.removed) return;
        if (variable.sizesChanged) blank(declarator.dimensionTokens);
        if (variable.dropInitializer) blank({declarator.dimensionTokens.end, declarator.end});
        const bool behindSizes = !variable.sizesChanged && !declarator.dimensions.empty();
        const std::uint32_t last = behindSizes ? declarator.dimensionTokens.end - 1 : variable.nameToken;
        const std::string text =
            (variable.sizesChanged ? bracketed(variable.nameSizes) : "") + variable.initializer;
        if (!text.empty()) unit_.edits.after(unit_.view[last].site, text);
    }

    void blank(Range range) {
        std::vector<std::uint32_t> tokens;
        if (!editableTokens(unit_, range, tokens)) return;
        for (const std::uint32_t each : tokens) unit_.edits.remove(each);
    }

    void head() {
        const bool structure = declaration_.type.isStruct;
        const Range head = structure
                               ? declaration_.qualifiers.tokens
                               : Range{declaration_.tokens.first, declaration_.declarators.front().name};
        std::vector<std::uint32_t> tokens;
        if (!editableTokens(unit_, head, tokens)) return;
        const Variable& first = *variables_.front();
        const std::string common = text(first);
        const bool together = std::all_of(variables_.begin(), variables_.end(), [&](const Variable* each) {
            return !each->removed && each->after.empty() && text(*each) == common;
        });
        for (const std::uint32_t each : tokens) unit_.edits.remove(each);
        const std::uint32_t start =
            tokens.empty() ? unit_.view[declaration_.declarators.front().name].site : tokens.front();
        if (structure || together) {
            if (tokens.empty())
                unit_.edits.before(unit_.view[declaration_.type.tokens.first].site, common);
            else
                unit_.edits.replace(start,
                                    together || structure ? common.substr(0, common.size() - 1) : common);
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
            if (!each->after.empty()) unit_.edits.after(unit_.view[end].site, each->after);
    }

    void separate(const Variable& variable) {
        const Declarator& declarator = declaration_.declarators[variable.declarator];
        const bool ends = declarator.end < unit_.view.size();
        if (variable.removed) {
            blank({declarator.name, declarator.end});
            if (ends) unit_.edits.remove(unit_.view[declarator.end].site);
        } else {
            unit_.edits.before(unit_.view[declarator.name].site, text(variable));
            if (ends) unit_.edits.replace(unit_.view[declarator.end].site, ";");
        }
        if (ends && !variable.after.empty())
            unit_.edits.after(unit_.view[declarator.end].site, variable.after);
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

std::vector<std::string> Variable::sizes() const {
    std::vector<std::string> all = nameSizes;
    all.insert(all.end(), typeSizes.begin(), typeSizes.end());
    return all;
}

const std::string* Variable::layoutValue(std::string_view key) const {
    const auto found =
        std::find_if(layout.begin(), layout.end(), [&](const auto& each) { return each.first == key; });
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

std::vector<Variable> collectVariables(const Unit& unit) {
    std::vector<Variable> variables;
    for (std::size_t i = 0; i < unit.syntax.declarations.size(); ++i) {
        const Declaration& declaration = unit.syntax.declarations[i];
        if (declaration.kind != DeclarationKind::variable) continue;
        const Qualifiers& q = declaration.qualifiers;
        for (std::size_t k = 0; k < declaration.declarators.size(); ++k) {
            const Declarator& declarator = declaration.declarators[k];
            Variable variable;
            variable.declaration = i;
            variable.declarator = k;
            variable.name = unit.text(declarator.name);
            variable.nameToken = declarator.name;
            variable.storage = q.storage;
            if (!declaration.type.isStruct) variable.type = declaration.type.name;
            variable.typeSizes = textsOf(unit, declaration.type.dimensions);
            variable.nameSizes = textsOf(unit, declarator.dimensions);
            variable.interpolation = q.interpolation;
            for (const LayoutItem& item : q.layout)
                variable.layout.emplace_back(item.name, textOf(unit, item.value));
            variable.patch = q.patch;
            variable.invariant = q.invariant;
            variable.precise = q.precise;
            variable.centroid = q.centroid;
            variable.sample = q.sample;
            variable.subroutine = q.subroutine;
            variable.memory = q.memory;
            variable.precision = q.precision;
            variables.push_back(std::move(variable));
        }
    }
    return variables;
}

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
    switch (variable.storage) {
        case Storage::none:
            break;
        case Storage::constant:
            add("const");
            break;
        case Storage::input:
            add("in");
            break;
        case Storage::output:
            add("out");
            break;
        case Storage::inputOutput:
            add("inout");
            break;
        case Storage::uniform:
            add("uniform");
            break;
        case Storage::buffer:
            add("buffer");
            break;
        case Storage::shared:
            add("shared");
            break;
    }
    add(variable.precision);
    add(variable.type);
    return text + bracketed(variable.typeSizes);
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

bool editableTokens(const Unit& unit, Range range, std::vector<std::uint32_t>& tokens) {
    tokens.clear();
    for (std::uint32_t i = range.first; i < range.end; ++i) {
        const ViewToken& token = unit.view[i];
        if (token.body && !token.objectSite) return false;
        const std::uint32_t at = token.body ? token.site : token.raw;
        if (tokens.empty() || tokens.back() != at) tokens.push_back(at);
    }
    // A macro whose text extends beyond the range cannot be replaced by a part of it.
    for (const std::uint32_t beyond : {range.first - 1, range.end}) {
        if (beyond >= unit.view.size() || tokens.empty()) continue;
        const ViewToken& token = unit.view[beyond];
        const std::uint32_t edge = beyond == range.end ? tokens.back() : tokens.front();
        if (token.body && token.site == edge) return false;
    }
    return true;
}

}  // namespace glibra::glsl
