#include "system/spelling.h"

namespace glibra::system {

std::filesystem::path asInFolders(const std::filesystem::path& path) {
    return path;
}

}  // namespace glibra::system
