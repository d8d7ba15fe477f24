#include "classic/linked_program.h"

#include <mutex>
#include <utility>

namespace glibra::classic {
namespace {

struct Registry {
    std::mutex mutex;
    std::map<std::pair<void*, GLuint>, std::shared_ptr<const LinkedProgram>> programs;
    std::uint64_t last = 0;
};

Registry& registry() {
    static Registry all;
    return all;
}

}  // namespace

void remember(void* context, GLuint program, LinkedProgram facts) {
    Registry& all = registry();
    const std::lock_guard<std::mutex> lock(all.mutex);
    facts.serial = ++all.last;
    all.programs[{context, program}] = std::make_shared<const LinkedProgram>(std::move(facts));
}

void forget(void* context, GLuint program) {
    Registry& all = registry();
    const std::lock_guard<std::mutex> lock(all.mutex);
    all.programs.erase({context, program});
}

std::shared_ptr<const LinkedProgram> linkedProgram(void* context, GLuint program) {
    Registry& all = registry();
    const std::lock_guard<std::mutex> lock(all.mutex);
    const auto found = all.programs.find({context, program});
    return found != all.programs.end() ? found->second : nullptr;
}

std::string bookName(std::string_view emitted) {
    constexpr std::string_view kOwn = "glibra_";
    constexpr std::string_view kTexCoord = "glibra_MultiTexCoord";
    if (emitted.starts_with(kTexCoord)) return "aTexCoord" + std::string(emitted.substr(kTexCoord.size()));
    for (const std::string_view each : {"Vertex", "Normal", "Color"})
        if (emitted.starts_with(kOwn) && emitted.substr(kOwn.size()) == each) return "a" + std::string(each);
    return std::string(emitted);
}

}  // namespace glibra::classic
