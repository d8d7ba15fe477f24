#include "cli/language_page.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <limits>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "base/page_template.h"
#include "base/text.h"
#include "embedded/command_pages.h"
#include "expression/functions.h"
#include "expression/known_names.h"
#include "glib/messages.h"
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

/// Text as it stands in a cell of a table.
std::string cell(std::string_view text) {
    std::string escaped;
    for (const char c : text) {
        if (c == '|' || c == '<') escaped += '\\';
        escaped += c;
    }
    return escaped;
}

/// "1,048,576" for whole numbers, otherwise as a scene states it.
std::string numberCell(double value) {
    constexpr double kExact = 1e15;
    if (value == static_cast<double>(static_cast<long long>(std::clamp(value, -kExact, kExact))) &&
        value >= 10'000)
        return base::groupedText(static_cast<long long>(value));
    return glib::numberText(value);
}

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
    return remarks.empty() ? text : fmt::format("{}: {}", text, fmt::join(remarks, ", "));
}

base::Fields commands() {
    return {{"rows", base::rowsOf(glib::commandTable(), [](const glib::StatementRow& row) -> base::Fields {
                 std::vector<std::string> names, arguments;
                 for (const std::string_view each : row.names())
                     if (!each.empty()) names.emplace_back(each);
                 for (const glib::SyntaxNode* each : glib::argumentsOf(row))
                     arguments.push_back(argumentCell(*each));
                 if (const std::vector<std::string> known = glib::wordsOf(row); !known.empty())
                     arguments.push_back(fmt::format("one of `{}`", fmt::join(known, "`, `")));
                 return {{"names", names}, {"arguments", arguments}, {"meaning", row.summary}};
             })}};
}

/// Every command that draws something by itself, without a file or points, with the mesh of its defaults.
base::Fields primitives() {
    std::vector<base::Fields> rows;
    for (const glib::StatementRow& row : glib::commandTable()) {
        if (!glib::takesNumbers(row)) continue;
        const scene::Scene scene = scene::interpret(glib::parse(std::string(row.name) + "\n", "table"));
        if (scene.shapes.size() != 1) continue;
        const Result<geometry::Mesh> mesh = scene::makeMesh(scene, scene::ShapeIndex(0));
        if (!mesh) continue;
        std::vector<std::string> attributes;
        for (const geometry::Attribute& each : mesh->attributes)
            if (each.name != geometry::kPosition) attributes.push_back(each.name);
        rows.push_back({{"name", row.name},
                        {"topology", geometry::wordsOf(mesh->topology)},
                        {"vertices", base::groupedText(static_cast<long long>(mesh->vertexCount()))},
                        {"attributes", attributes}});
    }
    return {{"rows", rows}};
}

base::Fields formats() {
    std::vector<base::Fields> pictures;
    for (const image::FormatRow& each : image::formats()) {
        if (each.suffixes.empty()) continue;
        std::vector<std::string> endings;
        for (std::size_t at = 0; at < each.suffixes.size();) {
            const std::size_t end = each.suffixes.find(' ', at);
            endings.emplace_back(each.suffixes.substr(at, end - at));
            at = end + 1;
        }
        const std::string_view kind = each.description;
        pictures.push_back({{"kind", kind.substr(kind.find(' ') + 1)}, {"endings", endings}});  // no article
    }
    const auto texture = [](const glib::TextureFormat& each) {
        return base::Fields{{"name", each.name}, {"bytes", each.bytes}};
    };
    return {{"textures", base::rowsOf(glib::textureFormats(), texture)}, {"pictures", pictures}};
}

/// Names that shaders are given.
base::Fields supplied() {
    std::vector<base::Fields> uniforms, inputs;
    for (const scene::ShaderName& each : scene::shaderNames()) {
        std::vector<std::string> names;
        for (const std::string& name : each.names)
            names.push_back(
                fmt::format("`{}`{}", name, name == "gl_Color" && !each.isInput ? " (fragment stage)" : ""));
        (each.isInput ? inputs : uniforms)
            .push_back({{"names", names}, {"type", each.type}, {"attribute", each.attribute}});
    }
    return {{"uniforms", uniforms}, {"inputs", inputs}};
}

/// A table for each group; the forms of one function share a row.
base::Fields functions() {
    std::vector<base::Fields> groups, all;
    std::span<const expression::FunctionRow> rows = expression::functionTable();
    while (!rows.empty()) {
        const expression::FunctionGroup group = rows.front().group;
        // A row without a summary is another form of the row before.
        std::size_t forms = 1;
        while (forms < rows.size() && rows[forms].summary.empty()) ++forms;
        std::vector<std::string> prototypes;
        for (const expression::FunctionRow& each : rows.first(forms)) prototypes.emplace_back(each.prototype);
        all.push_back({{"forms", prototypes}, {"meaning", rows.front().summary}});
        rows = rows.subspan(forms);
        if (rows.empty() || rows.front().group != group)
            groups.push_back({{"title", expression::title(group)}, {"rows", std::exchange(all, {})}});
    }
    return {{"groups", groups}};
}

base::Fields names() {
    std::vector<base::Fields> rows;
    const auto add = [&](const char* owner, std::span<const expression::NameRow> known) {
        for (const expression::NameRow& each : known)
            rows.push_back({{"name", fmt::format("{}{}", owner, each.path)},
                            {"type", expression::name(each.type)},
                            {"meaning", each.summary}});
    };
    add("", expression::sceneNames());
    add("camera.", expression::cameraFields());
    return {{"rows", rows}};
}

base::Fields diagnostics() {
    return {{"rows", base::rowsOf(glib::diagnosticCatalogue(), [](const glib::CatalogueRow& each) {
                 return base::Fields{{"id", each.id},
                                     {"severity", name(severityOf(each.id))},
                                     {"meaning", each.meaning},
                                     {"example", each.example}};
             })}};
}

/// The options of a picture.
base::Fields options() {
    return {{"rows", base::rowsOf(suite::optionTable(), [](const suite::OptionRow& row) {
                 return base::Fields{{"name", row.name},
                                     {"form", suite::placeholder(row)},
                                     {"key", row.key},
                                     {"meaning", row.help},
                                     {"limits", suite::limits(row)},
                                     {"default", suite::defaultText(row)}};
             })}};
}

/// The sections, which have their names in the template.
struct Section {
    std::string_view name;
    base::Fields (*fields)();
};

constexpr Section kSections[] = {
    {"commands", commands},       {"primitives", primitives}, {"formats", formats},
    {"supplied", supplied},       {"functions", functions},   {"names", names},
    {"diagnostics", diagnostics}, {"options", options},
};

std::string textOf(const Section& section) {
    return base::filled(fmt::format("{}{{{{>{}}}}}", command_pages::language_txt(), section.name),
                        section.fields(), cell);
}

constexpr std::string_view kBegin = "<!-- generated: ";
constexpr std::string_view kBeginEnd = " -->";
constexpr std::string_view kEnd = "<!-- end -->";

std::string withMarkers(std::string_view name, std::string_view content) {
    return fmt::format("{}{}{}\n{}{}\n", kBegin, name, kBeginEnd, content, kEnd);
}

}  // namespace

std::optional<std::string> generatedSection(std::string_view name) {
    const auto* const found = std::ranges::find(kSections, name, &Section::name);
    return found != std::end(kSections) ? std::optional(textOf(*found)) : std::nullopt;
}

std::string generatedSections() {
    std::string text;
    for (const Section& each : kSections)
        text += (text.empty() ? "" : "\n") + withMarkers(each.name, textOf(each));
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
