#include "system/spelling.h"

namespace glibra::system {

std::filesystem::path nameInFolder(const std::filesystem::path& path) {
    return path.filename();
}

}  // namespace glibra::system
