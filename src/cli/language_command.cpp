#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "base/suggest.h"
#include "base/texel_format.h"
#include "cli/command_line.h"
#include "cli/commands.h"
#include "cli/language_page.h"
#include "editor/grammar.h"
#include "expression/functions.h"
#include "expression/known_names.h"
#include "glib/messages.h"
#include "glib/syntax.h"
#include "glsl/types/builtins.h"
#include "image/file.h"
#include "plan/uniforms.h"
#include "scene/shader_names.h"

namespace glibra::cli {
namespace {

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
        if (row.path == word)
            text += fmt::format("{:<38} {}\n{:<38} {}\n", fmt::format("{}{}", owner, row.path), row.summary,
                                "", expression::name(row.type));
    };
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
    const glib::StatementRow* command = glib::findCommand(arguments.word);
    const glib::StatementRow* statement =
        command != nullptr ? glib::modernFormOf(arguments.word) : glib::findStatement(arguments.word);
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
    command.flag("--diagnostics", arguments->diagnostics,
                 "list all diagnostics with their ids and an example");
    command.flag("--words", arguments->words, "list all command words, one per line, for editors");
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
