#include "support.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <memory>

#include "glsl/read/token.h"

namespace glibra::glsl::test {
namespace {

constexpr std::array<const char*, kStageCount> kSuffixes = {"vert", "tesc", "tese", "geom", "frag", "comp"};

std::vector<std::string> tokensOf(std::string_view text) {
    std::deque<std::string> storage;
    const std::string normal = normalizeLines(text);
    std::vector<std::string> result;
    for (const Token& each : lex(normal, storage))
        if (isSignificant(each.kind)) result.emplace_back(each.text);
    return result;
}

}  // namespace

ProgramRequest program(Stages stages) {
    ProgramRequest request;
    request.name = "Test";
    request.place = {"test.glib", 7, 1};
    for (std::pair<Stage, std::string>& each : stages)
        request.stages.push_back({each.first,
                                  std::string("a.") + kSuffixes[static_cast<std::size_t>(each.first)],
                                  std::move(each.second)});
    return request;
}

TranslatedProgram translateStages(Stages stages) {
    return translate(program(std::move(stages)));
}

ProgramRequest single(Stage stage, std::string text) {
    if (text.find("#version") == std::string::npos) text.insert(0, "#version 330\n");
    return program({{stage, std::move(text)}});
}

TranslatedProgram translateSingle(Stage stage, std::string text) {
    return translate(single(stage, std::move(text)));
}

std::string sourceOf(const TranslatedProgram& translated, Stage stage) {
    for (const TranslatedStage& each : translated.stages)
        if (each.stage == stage) return each.source;
    return {};
}

std::string userPart(const TranslatedProgram& translated, Stage stage) {
    const std::string source = sourceOf(translated, stage);
    const std::size_t start = source.find("#line 1 0\n");
    return start == std::string::npos ? std::string{} : source.substr(start + 10);
}

std::string userFragment(const std::string& text) {
    return userPart(translateSingle(Stage::fragment, text), Stage::fragment);
}

bool hasTokens(std::string_view text, std::string_view wanted) {
    const std::vector<std::string> all = tokensOf(text);
    const std::vector<std::string> part = tokensOf(wanted);
    return std::search(all.begin(), all.end(), part.begin(), part.end()) != all.end();
}

std::string ids(const Diagnostics& diagnostics) {
    std::string result;
    for (const Diagnostic& each : diagnostics) result += (result.empty() ? "" : " ") + each.id;
    return result;
}

std::string textOf(const Diagnostics& diagnostics, std::string_view id) {
    for (const Diagnostic& each : diagnostics)
        if (each.id == id) return each.text;
    return {};
}

Place placeOf(const Diagnostics& diagnostics, std::string_view id) {
    for (const Diagnostic& each : diagnostics)
        if (each.id == id) return each.place;
    return {"", 0, 0};
}

bool has(const Diagnostics& diagnostics, std::string_view id) {
    for (const Diagnostic& each : diagnostics)
        if (each.id == id) return true;
    return false;
}

std::string glslangOutput(const TranslatedProgram& translated, const std::string& options,
                          std::string* folderName) {
    static int counter = 0;
    const std::filesystem::path folder =
        std::filesystem::temp_directory_path() /
        ("glibra-glsl-" + std::to_string(getpid()) + "-" + std::to_string(counter++));
    std::filesystem::create_directories(folder);
    std::string command = "glslangValidator -l " + options;
    for (const TranslatedStage& each : translated.stages) {
        const std::filesystem::path file =
            folder / (std::string("t.") + kSuffixes[static_cast<std::size_t>(each.stage)]);
        std::ofstream(file, std::ios::binary) << each.source;
        command += " " + file.string();
    }
    command += " 2>&1";
    std::string output;
    const std::unique_ptr<FILE, int (*)(FILE*)> pipe(popen(command.c_str(), "r"), &pclose);
    if (!pipe) return "cannot run glslangValidator";
    std::array<char, 4096> buffer{};
    while (const std::size_t count = std::fread(buffer.data(), 1, buffer.size(), pipe.get()))
        output.append(buffer.data(), count);
    std::filesystem::remove_all(folder);
    if (folderName) *folderName = folder.string();
    return output;
}

std::string glslangErrors(const TranslatedProgram& translated) {
    if (translated.stages.empty()) return "nothing was emitted: " + ids(translated.diagnostics);
    std::string folder;
    const std::string output = glslangOutput(translated, "", &folder);
    if (output.find("not found") != std::string::npos) return "glslangValidator is not installed: " + output;
    // If there is no error, it prints only the file names.
    if (output.find(folder) == std::string::npos) return "glslangValidator said nothing: " + output;
    if (output.find("ERROR") == std::string::npos && output.find("WARNING") == std::string::npos) return {};
    std::string sources;
    for (const TranslatedStage& each : translated.stages) sources += each.source;
    return output + "\n" + sources;
}

}  // namespace glibra::glsl::test
