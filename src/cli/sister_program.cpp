#include "cli/sister_program.h"

#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <system_error>

#include "cli/commands.h"

namespace glibra::cli {
namespace {

namespace fs = std::filesystem;

/// Empty if the program is missing. GLIBRA_PROGRAMS_DIR may be one folder deeper than lib, as in
/// lib/x86_64-linux-gnu.
fs::path find(const char* name) {
    std::error_code failure;
    const fs::path folder = fs::read_symlink("/proc/self/exe", failure).parent_path();
    for (const fs::path& each :
         {folder / name, folder / "../lib/glibra" / name, folder / ".." / GLIBRA_PROGRAMS_DIR / name})
        if (fs::is_regular_file(each, failure) && ::access(each.c_str(), X_OK) == 0) return each;
    return {};
}

}  // namespace

int becomeProgram(const SisterProgram& program, const std::vector<std::string>& arguments) {
    const fs::path file = find(program.name);
    if (file.empty()) {
        std::fprintf(stderr, "glibra: error: the program %s is missing; %s\n", program.name, program.missing);
        return kNoDriver;
    }
    std::vector<std::string> words{file.string()};
    words.insert(words.end(), arguments.begin(), arguments.end());
    std::vector<char*> pointers;
    pointers.reserve(words.size() + 1);
    for (std::string& each : words) pointers.push_back(each.data());
    pointers.push_back(nullptr);
    ::execv(file.c_str(), pointers.data());
    std::fprintf(stderr, "glibra: error: cannot start %s: %s\n", file.c_str(), std::strerror(errno));
    return kNoDriver;
}

}  // namespace glibra::cli
