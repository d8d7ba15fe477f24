#include "gpu/context/library.h"

namespace glibra::gpu {

std::variant<Library, std::string> Library::open(const std::string& name) {
    std::string why;
    const auto opened = system::Library::open(name, system::Library::When::whenCalled, why);
    if (opened) return Library(opened);
    return why;
}

}  // namespace glibra::gpu
