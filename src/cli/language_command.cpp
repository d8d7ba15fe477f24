#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cstdio>
#include <filesystem>
#include <limits>
#include <memory>
#include <numbers>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "base/page_template.h"
#include "base/suggest.h"
#include "base/texel_format.h"
#include "base/text.h"
#include "cli/command_line.h"
#include "cli/commands.h"
#include "editor/grammar.h"
#include "embedded/command_pages.h"
#include "expression/functions.h"
#include "expression/known_names.h"
#include "glib/messages.h"
#include "glib/number.h"
#include "glib/script.h"
#include "glib/syntax.h"
#include "glib/text.h"
#include "glsl/types/builtins.h"
#include "image/file.h"
#include "image/format.h"
#include "plan/uniforms.h"
#include "scene/interpret.h"
#include "scene/primitives.h"
#include "scene/shader_names.h"
#include "source/inline_shaders.h"
#include "suite/options/option_table.h"

namespace glibra::cli {
namespace {

// The parts of the documentation that are generated from the program's tables.

struct RefreshedPage {
    std::string text;
    std::string problem;  ///< what is wrong with the markers, with the line; empty if nothing is
};

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

/// The content of one section, as Markdown that ends with a line end. Sections: commands, primitives,
/// formats, supplied, diagnostics, options (of a picture). Nothing for another name.
std::optional<std::string> generatedSection(std::string_view name) {
    const auto* const found = std::ranges::find(kSections, name, &Section::name);
    return found != std::end(kSections) ? std::optional(textOf(*found)) : std::nullopt;
}

/// All sections, each between its two marker lines:
///
///     <!-- generated: commands -->
///     ...
///     <!-- end -->
std::string generatedSections() {
    std::string text;
    for (const Section& each : kSections)
        text += (text.empty() ? "" : "\n") + withMarkers(each.name, textOf(each));
    return text;
}

/// A page with the content of all its generated sections replaced by the present one. A page needs only the
/// sections that it wants; everything outside the markers stays as it is.
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

using scene::ShaderName;
using scene::shaderNames;

struct LanguageArguments {
    std::string word;
    bool diagnostics = false;
    bool words = false;
    bool markdown = false;
    std::vector<std::string> update;
    std::optional<editor::GrammarEditor> grammar;
    std::filesystem::path output;
};

constexpr std::array<std::pair<std::string_view, editor::GrammarEditor>, 3> kEditors{
    {{"vscode", editor::GrammarEditor::vscode},
     {"vim", editor::GrammarEditor::vim},
     {"kate", editor::GrammarEditor::kate}}};

/// An argument as the reference shows it: "radius [1]", "angle", "unit".
std::string shown(const glib::SyntaxNode& argument) {
    std::string text = argument.text;
    if (argument.byDefault)
        text += fmt::format(" [{:g}]", *argument.byDefault);
    else if (argument.filler)
        text += fmt::format(" ({:g})", *argument.filler);
    else if (argument.isSkippable)
        text = "[" + text + "]";
    return text;
}

std::string classicReference(const glib::StatementRow& row) {
    std::string head(row.name);
    if (!row.alias.empty()) head += fmt::format(", {}", row.alias);
    std::string arguments;
    for (const glib::SyntaxNode* each : glib::argumentsOf(row))
        arguments += (arguments.empty() ? "" : "  ") + shown(*each);
    return fmt::format("{:<38} {}\n{:<38} {}\n", head, row.summary, "", arguments);
}

std::string reference(const glib::StatementRow& row) {
    std::string text = fmt::format("{:<38} {}\n{:<38} {}\n", row.name, row.summary, "", glib::usage(row));
    for (const glib::WordList& each : glib::wordLists(row))
        text += fmt::format("{:<38}   {}: {}\n", "", each.name, fmt::join(each.words, " "));
    return text;
}

std::string reference(const ShaderName& row) {
    return fmt::format("{:<38} {}\n{:<38} {} {}\n", row.names.front(), row.meaning, "", row.type,
                       row.isInput ? "vertex input" : "uniform");
}

/// The rows of a name that shaders read, with that name first: gl_Color is an input and a uniform.
std::vector<ShaderName> findShaderNames(std::string_view name) {
    std::vector<ShaderName> rows = shaderNames();
    std::erase_if(rows, [&](ShaderName& each) {
        const auto found = std::find(each.names.begin(), each.names.end(), name);
        if (found != each.names.end()) std::iter_swap(each.names.begin(), found);
        return found == each.names.end();
    });
    return rows;
}

/// What expressions know by that name: a function, a name of every scene, a field of cameras.
std::string expressionReference(std::string_view word) {
    std::string text, summary;
    for (const expression::FunctionRow& each : expression::functionsNamed(word)) {
        if (!each.summary.empty()) summary = each.summary;
        text += fmt::format("{:<38} {}\n", each.prototype, summary);
    }
    const auto add = [&](std::string_view owner, const expression::NameRow& row) {
        const std::string path = fmt::format("{}{}", owner, row.path);
        if (row.path == word || path == word)
            text += fmt::format("{:<38} {}\n{:<38} {}\n", path, row.summary, "", expression::name(row.type));
    };
    if (word == "pi") text += fmt::format("{:<38} {}\n{:<38} number\n", word, std::numbers::pi, "");
    for (const expression::NameRow& each : expression::sceneNames()) add("", each);
    for (const expression::NameRow& each : expression::cameraFields()) add("camera.", each);
    return text;
}

/// What a uniform or vertex input of that name reads in a modern scene that sets it nowhere
/// (language, 12.10).
std::string wellKnownReference(std::string_view word) {
    std::string text;
    for (const char* type : {"mat4", "mat3", "vec3"})
        if (const auto value = glsl::wellKnownUniform(word, type))
            text += fmt::format("{:<38} {}\n{:<38} {} uniform, in modern scenes\n", word,
                                plan::describeValue(*value), "", type);
    for (const char* type : {"vec4", "vec3"}) {
        const std::string_view attribute = glsl::wellKnownAttribute(word, type);
        if (attribute.empty()) continue;
        text += fmt::format("{:<38} the {} of the vertex\n{:<38} {} vertex input, in modern scenes\n", word,
                            attribute, "", type);
        break;
    }
    for (const expression::PartRow& each : expression::partTable())
        if (each.word == word) text += fmt::format("{:<38} {}\n", each.form, each.summary);
    if (word == "vST")
        text += fmt::format("{:<38} {}\n", "in vec2 vST;",
                            "the place in the target, 0 to 1, in a fragment stage of Fill");
    return text;
}

/// A format of textures, the id of a message, or the statements that have the word as a key.
std::string wordReference(std::string_view word) {
    std::string text;
    if (const auto format = base::texelFormatNamed(word))
        text += fmt::format("{:<38} texture format, {} bytes per texel\n", base::name(*format),
                            base::bytesPerTexel(*format));
    if (const glib::CatalogueRow* row = glib::findDiagnostic(word))
        text += fmt::format("{:<38} {}: {}\n  for example: {}\n", row->id, name(row->severity()),
                            row->meaning, row->example);
    for (const glib::StatementRow& each : glib::statementTable()) {
        const std::vector<std::string> words = glib::wordsOf(each);
        if (std::find(words.begin(), words.end(), word) != words.end()) text += reference(each);
    }
    return text;
}

/// "; did you mean 'aVertex'?", with the nearest command or name that shaders read.
std::string suggestionFor(std::string_view word) {
    const std::vector<ShaderName> rows = shaderNames();
    std::vector<std::string_view> names;
    if (const std::string_view command = glib::nearestCommand(word); !command.empty())
        names.push_back(command);
    for (const ShaderName& each : rows) names.insert(names.end(), each.names.begin(), each.names.end());
    return base::suggestion(word, names);
}

/// Refreshes the generated sections of a page in place.
Diagnostics refresh(const std::string& file) {
    const auto bytes = image::readFile(file, {file, {}});
    if (!bytes) return bytes.diagnostics;
    const std::string_view old(reinterpret_cast<const char*>(bytes->data()), bytes->size());
    const RefreshedPage page = refreshed(old);
    if (!page.problem.empty()) return {withoutId(Severity::error, file + ": " + page.problem)};
    if (page.text == old) return {};
    return image::writeFileAtomically(file, std::as_bytes(std::span(page.text)));
}

/// Prints the grammar, or writes it and what belongs to it into the folder.
int writeGrammar(editor::GrammarEditor editor, const std::filesystem::path& folder) {
    const std::vector<editor::GrammarFile> files = editor::grammarOf(editor, GLIBRA_VERSION);
    if (folder.empty()) {
        fmt::print("{}", files.front().text);
        return kDone;
    }
    int status = kDone;
    for (const editor::GrammarFile& each : files) {
        const std::filesystem::path file = folder / each.path;
        std::error_code ignored;  // reported with the file
        std::filesystem::create_directories(file.parent_path(), ignored);
        if (printErrors(image::writeFileAtomically(file, std::as_bytes(std::span(each.text)))))
            status = kSceneIsWrong;
    }
    return status;
}

int runLanguageCommand(const LanguageArguments& arguments) {
    if (arguments.grammar) return writeGrammar(*arguments.grammar, arguments.output);
    if (!arguments.update.empty()) {
        int status = kDone;
        for (const std::string& each : arguments.update) {
            if (printErrors(refresh(each))) status = kSceneIsWrong;
        }
        return status;
    }
    if (arguments.markdown) {
        fmt::print("{}", generatedSections());
        return kDone;
    }
    if (arguments.diagnostics) {
        for (const glib::CatalogueRow& each : glib::diagnosticCatalogue())
            fmt::print("{:<9} {:<8} {} For example: {}\n", each.id, name(each.severity()), each.meaning,
                       each.example);
        return kDone;
    }
    if (arguments.words) {
        for (const glib::StatementRow& row : glib::commandTable())
            for (const std::string_view each : row.names())
                if (!each.empty()) fmt::print("{}\n", each);
        for (const glib::StatementRow& row : glib::statementTable())
            if (!row.sharesWord()) fmt::print("{}\n", row.name);
        return kDone;
    }
    if (arguments.word.empty()) {
        for (const glib::StatementRow& row : glib::commandTable()) fmt::print("{}", classicReference(row));
        for (const glib::StatementRow& row : glib::statementTable()) fmt::print("{}", reference(row));
        fmt::print("\nNames that shaders read without declaring them\n\n");
        for (const ShaderName& each : shaderNames()) fmt::print("{}", reference(each));
        return kDone;
    }
    // EndVertex is described with Vertex.
    const bool isEnd = source::stageOfEndWord(arguments.word) || glib::sameWord(arguments.word, "EndGlsl");
    const std::string word = arguments.word.substr(isEnd ? 3 : 0);
    const glib::StatementRow* command = isEnd ? nullptr : glib::findCommand(word);
    const glib::StatementRow* statement = command != nullptr || glib::findStatement(word) == nullptr
                                              ? glib::modernFormOf(word)
                                              : glib::findStatement(word);
    if (command != nullptr) fmt::print("{}", classicReference(*command));
    if (statement != nullptr) fmt::print("{}", reference(*statement));
    const std::vector<ShaderName> names = findShaderNames(arguments.word);
    for (const ShaderName& each : names) fmt::print("{}", reference(each));
    std::string others = expressionReference(arguments.word) + wellKnownReference(arguments.word);
    if (command == nullptr && statement == nullptr) others += wordReference(arguments.word);
    fmt::print("{}", others);
    if (command != nullptr || statement != nullptr || !names.empty() || !others.empty()) return kDone;
    return refuse(
        fmt::format("the language has no word '{}'{}", arguments.word, suggestionFor(arguments.word)));
}

}  // namespace

void addLanguage(CommandLine& program, int& status) {
    auto arguments = std::make_shared<LanguageArguments>();
    CommandLine command = program.subcommand(
        "language",
        "lists the commands of the scene language, with defaults in [ ], and the names that shaders read",
        "glibra language Sphere             # a command, function, format, key, message or name of shaders\n"
        "glibra language                    # all commands, and all names that shaders read\n"
        "glibra language --diagnostics      # all messages with their ids");
    command.option("WORD", arguments->word, "show only this command, name, function, format, key or message");
    const Option diagnostics = command.flag("--diagnostics", arguments->diagnostics,
                                            "list all diagnostics with their ids and an example");
    command.flag("--words", arguments->words, "list all command words, one per line, for editors")
        .excludes(diagnostics);
    const Option markdown = command.flag("--markdown", arguments->markdown,
                                         "print the generated sections of the documentation as Markdown");
    command
        .list("--update", arguments->update, "with --markdown: replace the generated sections of these pages")
        .needs(markdown);
    for (const char* each : {"--markdown", "--update"}) command.find(each).rare();
    const Option grammar =
        command.choice("--grammar", arguments->grammar, kEditors,
                       "print the grammar for syntax colours of an editor: vscode, vim or kate");
    command.option("-o,--output", arguments->output, "with --grammar: a folder for all files of the grammar")
        .placeholder("FOLDER")
        .written()
        .needs(grammar);
    command.onRun([arguments, &status] { status = runLanguageCommand(*arguments); });
}

}  // namespace glibra::cli
