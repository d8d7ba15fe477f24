#include "cli/language_page.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <limits>
#include <map>
#include <optional>
#include <span>
#include <vector>

#include "base/text.h"
#include "expression/functions.h"
#include "expression/known_names.h"
#include "glib/diagnostic_catalogue.h"
#include "glib/number.h"
#include "glib/script.h"
#include "glib/syntax.h"
#include "glib/text.h"
#include "image/format.h"
#include "scene/interpret.h"
#include "scene/primitives.h"
#include "scene/shader_names.h"
#include "suite/options/option_table.h"

namespace glibra::cli {
namespace {

using scene::ShaderName;
using scene::shaderNames;

/// Text as it stands in a cell of a table.
std::string cell(std::string_view text) {
    std::string escaped;
    for (const char c : text) {
        if (c == '|' || c == '<') escaped += '\\';
        escaped += c;
    }
    return escaped;
}

std::string joined(const std::vector<std::string>& parts, std::string_view between = ", ") {
    return fmt::format("{}", fmt::join(parts, between));
}

/// "1,048,576" for whole numbers, otherwise as a scene states it.
std::string numberCell(double value) {
    constexpr double kExact = 1e15;
    if (value == static_cast<double>(static_cast<long long>(std::clamp(value, -kExact, kExact))) &&
        value >= 10'000)
        return base::groupedText(static_cast<long long>(value));
    return glib::numberText(value);
}

// ---- Commands

/// "1 to 16,384", "above 0"; empty if every number is taken.
std::string limitsOf(const glib::SyntaxNode& argument) {
    const std::string low = numberCell(argument.low), high = numberCell(argument.high);
    switch (argument.type) {
        case glib::ValueType::size:
            return "0 draws nothing; the sign is ignored";
        case glib::ValueType::between:
            return fmt::format("above {}, below {}", low, high);
        case glib::ValueType::positive:
            return argument.high < std::numeric_limits<double>::max()
                       ? fmt::format("above 0, at most {}", high)
                       : "above 0";
        case glib::ValueType::component:
            return "0 to 1";
        default:
            return argument.high != 0 ? fmt::format("{} to {}", low, high) : std::string();
    }
}

std::string argumentCell(const glib::SyntaxNode& argument) {
    std::string text = fmt::format("`{}`", argument.text);
    if (argument.byDefault)
        text += fmt::format(" = {:g}", *argument.byDefault);
    else if (argument.filler)
        text += fmt::format(" ({:g})", *argument.filler);
    else if (argument.isSkippable)
        text = "[" + text + "]";
    std::vector<std::string> remarks;
    if (const std::string limits = limitsOf(argument); !limits.empty()) remarks.push_back(limits);
    if (!argument.measure.empty()) remarks.push_back(argument.measure);
    return remarks.empty() ? text : text + ": " + joined(remarks);
}

std::string commandSection() {
    std::string text =
        "A value after `=` is the default. A value in parentheses replaces a missing number, with the "
        "warning glib-W06. An argument in brackets may be left out.\n\n"
        "| Command | Arguments | Meaning |\n|---|---|---|\n";
    for (const glib::StatementRow& row : glib::commandTable()) {
        std::vector<std::string> names, arguments;
        for (const std::string_view each : row.names())
            if (!each.empty()) names.push_back(fmt::format("`{}`", each));
        for (const glib::SyntaxNode* each : glib::argumentsOf(row)) arguments.push_back(argumentCell(*each));
        if (const std::vector<std::string> known = glib::wordsOf(row); !known.empty()) {
            std::vector<std::string> words;
            for (const std::string& each : known) words.push_back(fmt::format("`{}`", each));
            arguments.push_back("one of " + joined(words));
        }
        text += fmt::format("| {} | {} | {} |\n", joined(names), cell(joined(arguments, "<br>")),
                            cell(row.summary));
    }
    for (std::size_t at = 0; (at = text.find("\\<br>", at)) != std::string::npos;) text.erase(at, 1);
    return text;
}

// ---- Primitives

/// Every command that draws something by itself, without a file or points, with the mesh of its defaults.
std::string primitiveSection() {
    std::string text =
        "The counts are those of the default arguments.\n\n"
        "| Command | Drawn as | Vertices | Attributes besides the position |\n|---|---|---|---|\n";
    for (const glib::StatementRow& row : glib::commandTable()) {
        if (glib::formOf(row) != glib::ArgumentForm::numbers) continue;
        const scene::Scene scene = scene::interpret(glib::parse(std::string(row.name) + "\n", "table"));
        if (scene.shapes.size() != 1) continue;
        const Result<geometry::Mesh> mesh = scene::makeMesh(scene, scene::ShapeIndex(0));
        if (!mesh) continue;
        std::vector<std::string> attributes;
        for (const geometry::Attribute& each : mesh->attributes)
            if (each.name != geometry::kPosition) attributes.push_back(each.name);
        text += fmt::format("| `{}` | {} | {} | {} |\n", row.name, geometry::wordsOf(mesh->topology),
                            base::groupedText(static_cast<long long>(mesh->vertexCount())),
                            attributes.empty() ? "none" : joined(attributes));
    }
    return text;
}

// ---- Formats

std::string formatSection() {
    std::string text =
        "Formats of empty textures; the first is the default:\n\n| Format | Bytes per texel |\n|---|---|\n";
    for (const glib::TextureFormat& each : glib::textureFormats())
        text += fmt::format("| `{}` | {} |\n", each.name, each.bytes);
    text += "\nKinds of picture files:\n\n| Kind | Endings |\n|---|---|\n";
    for (const image::FormatRow& each : image::formats()) {
        if (each.suffixes.empty()) continue;
        std::string kind(each.description);
        kind.erase(0, kind.find(' ') + 1);  // the article
        std::vector<std::string> endings;
        for (std::size_t at = 0; at < each.suffixes.size();) {
            const std::size_t end = each.suffixes.find(' ', at);
            endings.push_back(fmt::format("`{}`", each.suffixes.substr(at, end - at)));
            at = end + 1;
        }
        text += fmt::format("| {} | {} |\n", kind, joined(endings));
    }
    return text;
}

// ---- Names that shaders are given

std::string suppliedSection() {
    const auto cells = [](const ShaderName& each) {
        std::vector<std::string> names;
        for (const std::string& name : each.names)
            names.push_back(
                fmt::format("`{}`{}", name, name == "gl_Color" && !each.isInput ? " (fragment stage)" : ""));
        return joined(names);
    };
    const std::vector<ShaderName> all = shaderNames();
    std::string text = "Uniform variables:\n\n| Names | Type |\n|---|---|\n";
    for (const ShaderName& each : all)
        if (!each.isInput) text += fmt::format("| {} | `{}` |\n", cells(each), each.type);
    text += "\nVertex inputs:\n\n| Names | Type | Attribute of the mesh |\n|---|---|---|\n";
    for (const ShaderName& each : all)
        if (each.isInput)
            text += fmt::format("| {} | `{}` | {} |\n", cells(each), each.type,
                                each.attribute.empty() ? std::string("none: always (0, 0, 0, 1)")
                                                       : std::string(each.attribute));
    return text;
}

// ---- Diagnostics

std::string diagnosticSection() {
    std::string text = "| Id | Severity | Meaning | Example |\n|---|---|---|---|\n";
    for (const glib::CatalogueRow& each : glib::diagnosticCatalogue())
        text += fmt::format("| {} | {} | {} | {} |\n", each.id, name(severityOf(each.id)), cell(each.meaning),
                            cell(each.example));
    return text;
}

// ---- Options of a picture

std::string optionSection() {
    std::string text = "| Command line | In suites | Meaning | Allowed | Default |\n|---|---|---|---|---|\n";
    for (const suite::OptionRow& row : suite::optionTable()) {
        const std::string form = suite::placeholder(row);
        const std::string option =
            row.name.empty() ? "" : fmt::format("`--{}{}{}`", row.name, form.empty() ? "" : " ", form);
        const std::string key = row.key.empty() ? "" : fmt::format("`{}`", row.key);
        text += fmt::format("| {} | {} | {} | {} | {} |\n", cell(option), key, cell(row.help),
                            cell(suite::limits(row)), suite::defaultText(row));
    }
    return text;
}

// ---- Expressions

/// A table for each group; the forms of one function share a row.
std::string functionSection() {
    std::string text;
    std::span<const expression::FunctionRow> rows = expression::functionTable();
    std::optional<expression::FunctionGroup> group;
    while (!rows.empty()) {
        if (group != rows.front().group) {
            text += fmt::format("{}**{}**\n\n| Forms | Value |\n|---|---|\n", group ? "\n" : "",
                                expression::title(rows.front().group));
            group = rows.front().group;
        }
        // A row without a summary is another form of the row before.
        std::size_t forms = 1;
        while (forms < rows.size() && rows[forms].summary.empty()) ++forms;
        std::vector<std::string> prototypes;
        for (const expression::FunctionRow& each : rows.first(forms))
            prototypes.push_back(fmt::format("`{}`", each.prototype));
        text += fmt::format("| {} | {} |\n", joined(prototypes, "<br>"), cell(rows.front().summary));
        rows = rows.subspan(forms);
    }
    return text;
}

std::string nameSection() {
    std::string text = "| Name | Type | Value |\n|---|---|---|\n";
    for (const expression::NameRow& each : expression::sceneNames())
        text +=
            fmt::format("| `{}` | {} | {} |\n", each.path, expression::name(each.type), cell(each.summary));
    for (const expression::NameRow& each : expression::cameraFields())
        text += fmt::format("| `camera.{}` | {} | {} |\n", each.path, expression::name(each.type),
                            cell(each.summary));
    return text;
}

struct Section {
    std::string_view name;
    std::string (*make)();
};

constexpr std::array<Section, 8> kSections{{
    {"commands", commandSection},
    {"primitives", primitiveSection},
    {"formats", formatSection},
    {"supplied", suppliedSection},
    {"functions", functionSection},
    {"names", nameSection},
    {"diagnostics", diagnosticSection},
    {"options", optionSection},
}};

constexpr std::string_view kBegin = "<!-- generated: ";
constexpr std::string_view kBeginEnd = " -->";
constexpr std::string_view kEnd = "<!-- end -->";

std::string withMarkers(std::string_view name, std::string_view content) {
    return fmt::format("{}{}{}\n{}{}\n", kBegin, name, kBeginEnd, content, kEnd);
}

}  // namespace

std::optional<std::string> generatedSection(std::string_view name) {
    const auto* const found = std::find_if(kSections.begin(), kSections.end(),
                                           [&](const Section& each) { return each.name == name; });
    if (found == kSections.end()) return std::nullopt;
    return found->make();
}

std::string generatedSections() {
    std::string text;
    for (const Section& each : kSections)
        text += (text.empty() ? "" : "\n") + withMarkers(each.name, each.make());
    return text;
}

RefreshedPage refreshed(std::string_view page) {
    RefreshedPage result;
    std::optional<std::string_view> open;  // the section that the present line is in
    int line = 0, begun = 0;
    while (!page.empty()) {
        ++line;
        const std::size_t end = std::min(page.find('\n'), page.size() - 1) + 1;
        const std::string_view whole = page.substr(0, end);
        page.remove_prefix(end);
        std::string_view text = whole;
        while (text.ends_with('\n') || text.ends_with('\r')) text.remove_suffix(1);
        const bool begins = text.starts_with(kBegin) && text.ends_with(kBeginEnd);
        if (begins) {
            const std::string_view name =
                text.substr(kBegin.size(), text.size() - kBegin.size() - kBeginEnd.size());
            const auto content = generatedSection(name);
            if (open || !content) {
                result.problem = open ? fmt::format("line {}: the section that begins on line {} has no '{}'",
                                                    line, begun, kEnd)
                                      : fmt::format("line {}: no generated section '{}'", line, name);
                return result;
            }
            result.text += withMarkers(name, *content);
            open = name;
            begun = line;
        } else if (open && text == kEnd) {
            open.reset();
        } else if (!open) {
            result.text += whole;
        }
    }
    if (open) result.problem = fmt::format("the section that begins on line {} has no '{}'", begun, kEnd);
    return result;
}

}  // namespace glibra::cli
