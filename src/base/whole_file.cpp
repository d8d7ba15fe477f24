#include "base/whole_file.h"

namespace glibra::base {

std::optional<std::vector<std::byte>> bytesIn(const Descriptor& file, std::uint64_t largest) {
    std::vector<std::byte> bytes;
    if (!file || readAll(file, largest, bytes) != 0) return std::nullopt;
    return bytes;
}

std::optional<std::string> textIn(const Descriptor& file, std::uint64_t largest) {
    const auto bytes = bytesIn(file, largest);
    return bytes ? std::optional<std::string>(asText(*bytes)) : std::nullopt;
}

}  // namespace glibra::base
