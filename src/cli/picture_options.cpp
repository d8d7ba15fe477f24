#include "cli/picture_options.h"

#include <fmt/format.h>
#include <system_error>
#include <utility>
#include <variant>

#include "cli/commands.h"
#include "cli/file_access.h"
#include "plan/overrides.h"
#include "suite/options/option_table.h"
#include "suite/options/option_words.h"

namespace glibra::cli {
namespace {

std::string dashed(std::string_view name) {
    return "--" + std::string(name);
}

/// "samples per pixel (1 to 64)"
std::string helpOf(const suite::OptionRow& row) {
    std::string text(row.help);
    if (const std::string allowed = suite::limits(row); !allowed.empty()) text += " (" + allowed + ")";
    const std::string byDefault = suite::defaultText(row);
    if (!byDefault.empty() && !std::holds_alternative<suite::FlagValue>(row.value))
        text += "; default " + byDefault;
    return text;
}

/// Why a folder that an option names cannot be searched; empty if it can.
std::string whyNoFolder(const std::string& folder) {
    std::error_code failed;
    const std::filesystem::file_status status = std::filesystem::status(folder, failed);
    if (std::filesystem::is_directory(status)) return {};
    if (std::filesystem::exists(status)) return "'" + folder + "' is not a folder";
    return "there is no folder '" + folder + "'";
}

bool mayBeRepeated(const suite::OptionRow& row) {
    return std::holds_alternative<suite::UniformsValue>(row.value) ||
           std::holds_alternative<suite::ObjectsValue>(row.value) ||
           std::holds_alternative<suite::FoldersValue>(row.value);
}

void add(CommandLine& command, const suite::OptionRow& row, suite::Shot& to) {
    const std::string name =
        row.former.empty() ? dashed(row.name) : dashed(row.name) + "," + dashed(row.former);
    const auto read = [&row, &to](const std::string& text) {
        const std::string wrong = suite::readOptionText(row, text, to);
        const bool isFolder = std::holds_alternative<suite::FoldersValue>(row.value);
        return wrong.empty() && isFolder ? whyNoFolder(text) : wrong;
    };
    const auto added = [&] {
        if (std::holds_alternative<suite::FlagValue>(row.value))
            return command.flag(name, [read] { read(""); }, helpOf(row));
        Option option = mayBeRepeated(row) ? command.repeated(name, read, helpOf(row))
                                           : command.option(name, read, helpOf(row));
        if (const auto* const value = std::get_if<suite::WordValue>(&row.value))
            option.offering({value->words.begin(), value->words.end()});
        return option.placeholder(suite::placeholder(row));
    };
    Option option = added();
    if (row.isRare) option.rare();
}

/// Call it after all options have been added.
void addNeeds(CommandLine& command, const suite::OptionRow& row) {
    if (!row.needs.empty()) command.find(dashed(row.name)).needs(command.find(dashed(row.needs)));
}

}  // namespace

void addPictureOption(CommandLine& command, std::string_view name, suite::Shot& to) {
    add(command, suite::optionNamed(name), to);
}

void addPictureOptions(CommandLine& command, suite::Shot& to) {
    for (const suite::OptionRow& row : suite::optionTable())
        if (!row.name.empty()) add(command, row, to);
    for (const suite::OptionRow& row : suite::optionTable())
        if (!row.name.empty()) addNeeds(command, row);
}

bool acceptsSet(const std::vector<std::string>& set) {
    for (const std::string& each : set) {
        const Result<plan::Override> parsed = plan::parseOverride(each);
        print(parsed.diagnostics);
        if (!parsed) return false;
    }
    return true;
}

void excludePictureOptions(CommandLine& command, Option& suite) {
    for (const suite::OptionRow& row : suite::optionTable())
        if (!row.name.empty() && !row.withSuite) suite.excludes(command.find(dashed(row.name)));
}

namespace fs = std::filesystem;

void addSiteOptions(CommandLine& command, SiteOptions& to, const char* siteHelp,
                    std::initializer_list<const char*> picture) {
    command.option("-o,--output", to.site, siteHelp).written().withDefault();
    for (const char* each : picture) addPictureOption(command, each, to.picture);
    command.option("--timeout", to.timeout, "seconds that one picture may take; 0 means no limit")
        .within(0, 1e6)
        .withDefault();
    command.driver(to.driver);
    command.jobs(to.jobs);
    addUntrustedOption(command, to.untrusted);
}

bool mayWriteSite(const SiteOptions& options) {
    std::error_code failure;
    if (options.siteIsNamed || !fs::is_symlink(options.site, failure)) return true;
    print({linkedFolder(options.site, "-o")});
    return false;
}

Confinement confinement(system::Sandbox drawing, const fs::path& site) {
    Confinement made;
    made.reading = drawing;
    made.reading->readable.emplace_back(site, fs::path("pictures"));
    drawing.writable.emplace_back(site, fs::path("pictures"));
    makeWritableFolders(drawing);
    made.drawing = std::move(drawing);
    return made;
}

suite::SiteWorkers siteWorkers(const SiteOptions& options, const Confinement& confined) {
    suite::SiteWorkers workers;
    workers.driver = options.driver;
    workers.jobs = options.jobs;
    workers.timeout = options.timeout;
    workers.memory = options.picture.memory;
    workers.drawing = confined.drawing ? &*confined.drawing : nullptr;
    workers.reading = confined.reading ? &*confined.reading : nullptr;
    return workers;
}

}  // namespace glibra::cli
