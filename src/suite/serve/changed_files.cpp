#include "suite/serve/changed_files.h"

#include <algorithm>
#include <array>
#include <cstdio>
#include <memory>
#include <system_error>

#include "system/process.h"

namespace glibra::suite {
namespace {

namespace fs = std::filesystem;

struct CloseFile {
    void operator()(std::FILE* each) const { std::fclose(each); }
};

/// What git prints, cut at its zero bytes or line ends; nothing if it fails or is not installed.
std::vector<std::string> git(const fs::path& folder, std::vector<std::string> arguments) {
    // Nothing that the settings of a repository name is started.
    std::vector<std::string> words{"git",       "-C", folder.generic_string(), "-c", "core.fsmonitor=false",
                                   "--no-pager"};
    words.insert(words.end(), arguments.begin(), arguments.end());
    const std::unique_ptr<std::FILE, CloseFile> output(std::tmpfile());
    if (!output) return {};
    using To = system::Stream::To;
    system::Process process = system::startProgram(words, {To::nothing, output.get(), To::nothing});
    if (!process || !waitFor(process).isGood() || std::fseek(output.get(), 0, SEEK_SET) != 0) return {};
    std::vector<std::string> parts;
    std::string part;
    std::array<char, 4096> buffer{};
    for (std::size_t count = 0; (count = std::fread(buffer.data(), 1, buffer.size(), output.get())) > 0;)
        for (const char c : std::span(buffer).first(count)) {
            if (c != '\0' && c != '\n') {
                part += c;
            } else if (!part.empty()) {
                parts.push_back(std::move(part));
                part.clear();
            }
        }
    if (!part.empty()) parts.push_back(std::move(part));
    return parts;
}

fs::path absolutePath(const fs::path& path) {
    std::error_code failed;
    return fs::weakly_canonical(fs::absolute(path, failed), failed);
}

}  // namespace

const ChangedFiles::Folder& ChangedFiles::folder(const fs::path& path) {
    const auto [at, isNew] = folders_.try_emplace(path);
    Folder& known = at->second;
    if (!isNew) return known;
    const std::vector<std::string> top = git(path, {"rev-parse", "--show-toplevel"});
    if (top.size() != 1) return known;
    known.top = top.front();
    std::string commit;
    for (const std::string& line :
         git(path, {"log", "-z", "--format=/%H", "--name-only", "--relative", "--", "."})) {
        if (line.starts_with('/'))  // as no relative path does
            commit = line.substr(1);
        else
            known.commits.emplace(line, commit);  // the latest comes first
    }
    return known;
}

const std::set<std::string>& ChangedFiles::changedSince(const fs::path& top, const std::string& commit) {
    const auto [at, isNew] = changed_.try_emplace(top.generic_string() + "\n" + commit);
    if (isNew) {
        std::vector<std::string> names =
            git(top, {"diff", "-z", "--name-only", "--no-renames", "--no-ext-diff", "--no-textconv", commit});
        at->second.insert(std::make_move_iterator(names.begin()), std::make_move_iterator(names.end()));
    }
    return at->second;
}

std::vector<fs::path> ChangedFiles::since(const fs::path& golden, std::span<const fs::path> files) {
    const fs::path whole = absolutePath(golden);
    const Folder& known = folder(whole.parent_path());
    const auto commit = known.commits.find(whole.filename().generic_string());
    std::vector<fs::path> changed(files.begin(), files.end());
    if (commit != known.commits.end()) {
        const std::set<std::string>& names = changedSince(known.top, commit->second);
        const auto isChanged = [&](const fs::path& file) {
            return names.contains(file.lexically_relative(known.top).generic_string());
        };
        if (!isChanged(whole)) {
            std::erase_if(changed, [&](const fs::path& each) { return !isChanged(absolutePath(each)); });
            return changed;
        }
    }
    std::error_code failed;
    const fs::file_time_type accepted = fs::last_write_time(whole, failed);
    std::erase_if(changed, [&](const fs::path& each) {
        std::error_code missing;
        const fs::file_time_type written = fs::last_write_time(each, missing);
        return failed || missing || written <= accepted;
    });
    return changed;
}

}  // namespace glibra::suite
