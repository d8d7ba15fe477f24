#include "base/page_template.h"

namespace glibra::base {

std::string filled(std::string_view page, std::span<const Slot> slots) {
    std::string text;
    while (true) {
        const std::size_t open = page.find("{{"), close = page.find("}}", open);
        text += page.substr(0, open);
        if (open == std::string_view::npos || close == std::string_view::npos) return text;
        const std::string_view wanted = page.substr(open + 2, close - open - 2);
        for (const Slot& slot : slots)
            if (slot.name == wanted) text += slot.text;
        page.remove_prefix(close + 2);
    }
}

}  // namespace glibra::base
