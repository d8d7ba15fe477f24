#pragma once
// Reads members of JSON files that somebody may have edited. What is wrong is thrown as a text that names the
// members which lead there: "'ana': 'points': 'r': expected number, found string".

#include <fmt/format.h>

#include <nlohmann/json.hpp>
#include <stdexcept>
#include <string>
#include <string_view>

#include "base/text.h"

namespace glibra::classroom {

/// What the work returns, which reads this member.
auto inMember(std::string_view key, const auto& work) try {
    return work();
} catch (const std::exception& problem) {
    throw std::runtime_error(fmt::format("'{}': {}", key, base::reasonOf(problem)));
}

template <class Json>
const Json& objectIn(const Json& json) {
    if (!json.is_object()) throw std::runtime_error("expected an object");
    return json;
}

template <class Value>
Value valueOf(const auto& json, const std::string& key) {
    if (!objectIn(json).contains(key))
        throw std::runtime_error(fmt::format("the member '{}' is missing", key));
    return inMember(key, [&] { return json.at(key).template get<Value>(); });
}

/// Says what is wrong in a file, with its place if it is no JSON at all.
inline Diagnostic wrongFile(const char* id, const std::string& what, const std::exception& problem,
                            std::string_view text, const std::string& file) {
    const auto* const ofParser = dynamic_cast<const nlohmann::json::parse_error*>(&problem);
    return diagnose(id, what + (ofParser ? "it is not JSON" : base::reasonOf(problem)),
                    base::placeOfByte(text, ofParser ? ofParser->byte : 0, file));
}

}  // namespace glibra::classroom
