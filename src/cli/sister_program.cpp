#include "cli/sister_program.h"

#include <cstdio>
#include <cstring>
#include <filesystem>
#include <system_error>

#include "cli/commands.h"
#include "system/library.h"
#include "system/places.h"
#include "system/process.h"

namespace glibra::cli {
namespace {

namespace fs = std::filesystem;

/// Empty if the program is missing. GLIBRA_PROGRAMS_DIR may be one folder deeper than lib, as in
/// lib/x86_64-linux-gnu.
fs::path find(const char* program) {
    std::error_code failure;
    const std::string name = system::programName(program);
    const fs::path folder = system::programFile().parent_path();
    for (const fs::path& each :
         {folder / name, folder / "../lib/glibra" / name, folder / ".." / GLIBRA_PROGRAMS_DIR / name})
        if (fs::is_regular_file(each, failure) && system::isProgram(each)) return each;
    return {};
}

}  // namespace

int becomeProgram(const SisterProgram& program, const std::vector<std::string>& arguments) {
    const fs::path file = find(program.name);
    if (file.empty()) {
        std::fprintf(stderr, "glibra: error: the program %s is missing; %s\n", program.name, program.missing);
        return kNoDriver;
    }
    const int problem = system::becomeProgram(file, arguments);
    std::fprintf(stderr, "glibra: error: cannot start %s: %s\n", file.generic_string().c_str(),
                 std::strerror(problem));
    return kNoDriver;
}

}  // namespace glibra::cli
