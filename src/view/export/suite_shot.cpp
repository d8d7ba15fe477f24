#include "view/export/suite_shot.h"

#include <fmt/format.h>

#include <algorithm>
#include <span>

#include "base/files.h"
#include "image/file.h"
#include "suite/file/shot_name.h"
#include "suite/file/suite_file.h"
#include "suite/options/option_words.h"

namespace glibra::view {
namespace {

namespace fs = std::filesystem;

std::string fileText(const fs::path& file) {
    const auto bytes = image::readFile(file, {file.generic_string(), {}});
    return bytes ? std::string(base::asText(*bytes)) : std::string();
}

}  // namespace

std::string shotText(const Session& session, const std::string& name, const fs::path& folder) {
    suite::Shot shot;
    shot.options = session.renderOptions();
    if (!session.live().isAnimated()) shot.options.time = 0;
    std::string text = fmt::format("[[shot]]\nname = {}\nscript = {}\n", suite::tomlText(name),
                                   suite::tomlText(session.path(), folder));
    if (const std::string without = session.onlyOnScreen(); !without.empty())
        text += fmt::format("# The picture as glibra render draws it, without {}.\n", without);
    return text + suite::optionLines(shot, folder);
}

Diagnostics appendShot(const fs::path& suite, const std::string& name, const Session& session) {
    std::string text = fileText(suite);
    if (!text.empty()) text += text.ends_with('\n') ? "\n" : "\n\n";
    const fs::path folder = suite.parent_path().empty() ? fs::path(".") : suite.parent_path();
    text += shotText(session, name, folder);
    const Result<suite::Suite> read = suite::readSuiteText(text, suite);
    if (!read) return read.diagnostics;
    return image::writeFileAtomically(suite, std::as_bytes(std::span(text)));
}

std::string freeShotName(const fs::path& suite, const Session& session) {
    std::string name = suite::nameOfScene(session.path().filename().generic_string());
    const Result<suite::Suite> read = suite::readSuiteText(fileText(suite), suite);
    const auto isTaken = [&](const std::string& wanted) {
        return read && std::ranges::find(read->shots, wanted, &suite::Shot::name) != read->shots.end();
    };
    const std::string scene = name;
    for (int number = 2; isTaken(name); ++number) name = fmt::format("{}-{}", scene, number);
    return name;
}

}  // namespace glibra::view
