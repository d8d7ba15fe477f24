#include "glsl/parse/variable.h"

#include <algorithm>

namespace glibra::glsl {

std::vector<std::string> Variable::sizes() const {
    std::vector<std::string> all = nameSizes;
    all.insert(all.end(), typeSizes.begin(), typeSizes.end());
    return all;
}

const std::string* Variable::layoutValue(std::string_view key) const {
    const auto found = std::ranges::find_if(layout, [&](const auto& each) { return each.first == key; });
    return found == layout.end() ? nullptr : &found->second;
}

void Variable::removeLayout(std::string_view key) {
    if (std::erase_if(layout, [&](const auto& each) { return each.first == key; }) > 0) changed = true;
}

void Variable::setLayout(std::string key, std::string value) {
    removeLayout(key);
    layout.emplace_back(std::move(key), std::move(value));
    changed = true;
}

}  // namespace glibra::glsl
