#include "program.h"

#include <stdlib.h>
#include <sys/wait.h>

#include <algorithm>
#include <fstream>
#include <iterator>
#include <stdexcept>
#include <vector>

namespace glibra::test {

namespace fs = std::filesystem;

Finished shell(const fs::path& folder, const std::string& shellCommand) {
    char name[] = "/tmp/glibra-run-XXXXXX";
    if (!::mkdtemp(name)) throw std::runtime_error("mkdtemp");
    const fs::path captured = name;
    const std::string command = "cd '" + folder.string() + "' && " + shellCommand + " >" +
                                (captured / "out").string() + " 2>" + (captured / "err").string() +
                                " </dev/null";
    const int status = std::system(command.c_str());  // NOLINT(cert-env33-c): a shell is what a user has
    Finished run;
    run.status = WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
    run.out = readFile(captured / "out");
    run.err = readFile(captured / "err");
    fs::remove_all(captured);
    return run;
}

Finished glibra(const fs::path& folder, const std::string& arguments, const std::string& environment) {
    return shell(folder, environment + " '" GLIBRA_PROGRAM "' " + arguments);
}

bool hasOsmesa() {
    static const bool has = glibra("/", "info --driver osmesa").status == 0;
    return has;
}

Folder::Folder() {
    char name[] = "/tmp/glibra-test-XXXXXX";
    if (!::mkdtemp(name)) throw std::runtime_error("mkdtemp");
    path_ = name;
}

Folder::~Folder() {
    std::error_code ignored;
    fs::remove_all(path_, ignored);
}

void Folder::write(std::string_view name, std::string_view content) const {
    const fs::path file = path_ / name;
    fs::create_directories(file.parent_path());
    std::ofstream(file, std::ios::binary) << content;
}

std::string Folder::listing() const {
    std::vector<std::string> names;
    for (const auto& each : fs::directory_iterator(path_)) names.push_back(each.path().filename().string());
    std::sort(names.begin(), names.end());
    std::string lines;
    for (const std::string& each : names) lines += each + "\n";
    return lines;
}

std::string preload(const fs::path& library) {
    static const Folder links;
    const fs::path link = links / library.filename().string();
    if (!fs::exists(link)) fs::create_symlink(library, link);
    return "LD_PRELOAD=" + link.string();
}

std::string readFile(const fs::path& file) {
    std::ifstream stream(file, std::ios::binary);
    return {std::istreambuf_iterator<char>(stream), {}};
}

}  // namespace glibra::test
