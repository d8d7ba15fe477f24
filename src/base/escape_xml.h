#pragma once
// Makes text of unknown origin (messages, names, scenes) valid for XML and HTML.

#include <string>
#include <string_view>

namespace glibra::base {

/// For XML 1.0 and HTML, in element content and in attributes with double quotes. The characters & < > " '
/// are escaped. What XML cannot contain (most control characters, U+FFFE, U+FFFF, bytes that are not UTF-8)
/// becomes U+FFFD.
std::string escapeXml(std::string_view text);

}  // namespace glibra::base
