#include "suite/file/store_name.h"

#include <algorithm>

namespace glibra::suite {

bool isAddress(std::string_view store) {
    return store.find("://") != std::string_view::npos;
}

std::string whyNoStore(std::string_view text) {
    if (!isAddress(text)) {
        if (text.find(kHashSlot) == std::string_view::npos) return {};
        return "expected a folder without {hash}, or an address as \"https://host/place/{hash}.png\"";
    }
    const auto scheme = text.substr(0, text.find("://"));
    if (scheme != "https" && scheme != "http")
        return "expected a folder, or an address that begins with https://, as buckets have one, too";
    const std::size_t at = text.find(kHashSlot);
    if (at == std::string_view::npos || text.find(kHashSlot, at + 1) != std::string_view::npos ||
        text.find('/', at) != std::string_view::npos || text.rfind('/', at) < scheme.size() + 3)
        return "expected {hash} once, after the last '/', as in \"https://host/place/{hash}.png\"";
    std::string rest(text);
    rest.erase(at, kHashSlot.size());
    if (std::ranges::any_of(rest, [](unsigned char c) {
            return c <= ' ' || c >= 0x7F ||
                   std::string_view("{}[]?#\"'\\<>@`^|").find(static_cast<char>(c)) != std::string_view::npos;
        }))
        return "expected an address of letters, digits and -._~%/:!$&()*+,;= only";
    return {};
}

}  // namespace glibra::suite
