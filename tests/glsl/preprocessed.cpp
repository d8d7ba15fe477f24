#include "preprocessed.h"

#include <unistd.h>

#include <array>
#include <cstdio>
#include <deque>
#include <filesystem>
#include <fstream>
#include <memory>

#include "glsl/read/source.h"
#include "support.h"

namespace glibra::glsl::test {
namespace {

/// The tokens of lines that are no directives.
Tokens tokensOf(const std::string& text) {
    std::deque<std::string> storage;
    const std::string normal = normalizeLines(text);
    Tokens result;
    bool isDirective = false;
    bool atStart = true;
    for (const Token& each : lex(normal, storage)) {
        if (each.kind == TokenKind::newline) {
            isDirective = false;
            atStart = true;
        }
        if (!isSignificant(each.kind)) continue;
        // glslang also writes its warnings there.
        if (atStart && (each.text == "#" || each.text == "WARNING")) isDirective = true;
        atStart = false;
        if (!isDirective) result.emplace_back(each.text);
    }
    return result;
}

std::string outputOf(const std::string& command, const std::string& text) {
    static int counter = 0;
    const std::filesystem::path file =
        std::filesystem::temp_directory_path() /
        ("glibra-glsl-" + std::to_string(getpid()) + "-p" + std::to_string(counter++) + ".frag");
    std::ofstream(file, std::ios::binary) << text;
    std::string output;
    const std::string whole = command + " '" + file.string() + "' 2>&1";
    const std::unique_ptr<FILE, int (*)(FILE*)> pipe(popen(whole.c_str(), "r"), &pclose);
    std::array<char, 4096> buffer{};
    while (const std::size_t count = pipe ? std::fread(buffer.data(), 1, buffer.size(), pipe.get()) : 0)
        output.append(buffer.data(), count);
    std::filesystem::remove(file);
    return output;
}

}  // namespace

Preprocessed preprocessed(const std::string& text) {
    const ProgramRequest request;
    StageText stage;
    stage.request = &request;
    Report report;
    readSource({Stage::fragment, "a.frag", text}, stage, report);
    Preprocessed result;
    result.messages = report.take();
    for (const Diagnostic& each : result.messages)
        if (each.id != "glsl-W01" && each.id != "glsl-W03" && each.id != "glsl-W18")
            result.ids += (result.ids.empty() ? "" : " ") + each.id;
    for (const ViewToken& each : stage.view) result.tokens.emplace_back(each.text);
    // Read again, as the driver does: no token may have grown.
    std::string emitted;
    for (const Token& each : stage.tokens) emitted += each.text;
    const Tokens again = tokensOf(emitted);
    if (again != result.tokens) result.tokens.push_back("read again: " + emitted);
    return result;
}

Tokens glslangTokens(const std::string& text) {
    const std::string output = outputOf("glslangValidator -E", text);
    if (output.find("ERROR") != std::string::npos || output.find("not found") != std::string::npos)
        return {"error: " + output};
    return tokensOf(output);
}

Tokens cppTokens(const std::string& text) {
    return tokensOf(outputOf("cpp -P -undef -w -x c", text));
}

}  // namespace glibra::glsl::test
