#include "editor/message_reader.h"

#include <algorithm>
#include <charconv>
#include <limits>
#include <system_error>
#include <utility>

#include "glib/text.h"

namespace glibra::editor {
namespace {

constexpr std::string_view kLength = "content-length:";
constexpr std::size_t kLongestHeader = 4096;

/// The length that a header states; nothing without one.
std::optional<std::size_t> lengthIn(std::string_view header) {
    const std::size_t at = glib::lower(header).rfind(kLength);
    if (at == std::string::npos) return std::nullopt;
    header.remove_prefix(at + kLength.size());
    header.remove_prefix(std::min(header.find_first_not_of(" \t"), header.size()));
    std::size_t length = 0;
    const auto [end, problem] = std::from_chars(header.data(), header.data() + header.size(), length);
    if (problem == std::errc::result_out_of_range) return std::numeric_limits<std::size_t>::max();
    return problem == std::errc() ? std::optional(length) : std::nullopt;
}

}  // namespace

std::optional<std::string> MessageReader::next() {
    for (;;) {
        if (length_) {
            if (isLost() || bytes_.size() < *length_) return std::nullopt;
            std::string message = bytes_.substr(0, *length_);
            bytes_.erase(0, *length_);
            length_.reset();
            return message;
        }
        std::size_t end = bytes_.find("\r\n\r\n");
        std::size_t after = end + 4;
        if (const std::size_t bare = bytes_.find("\n\n"); bare < end) {
            end = bare;
            after = bare + 2;
        }
        if (end == std::string::npos) {
            // No header is that long. Its beginning may be at the end.
            if (bytes_.size() > 2 * kLongestHeader) bytes_.erase(0, bytes_.size() - kLongestHeader);
            return std::nullopt;
        }
        length_ = lengthIn(std::string_view(bytes_).substr(0, end));
        bytes_.erase(0, after);
    }
}

void MessageReader::refuse(std::string_view message) {
    const std::size_t at = glib::lower(message).find(kLength);
    if (at == std::string::npos) return;
    std::string again(message.substr(at));
    again += bytes_;
    // The bytes that follow were taken for the header of the next message.
    bytes_ = std::move(again);
    length_.reset();
}

std::string framed(std::string_view message) {
    return "Content-Length: " + std::to_string(message.size()) + "\r\n\r\n" + std::string(message);
}

}  // namespace glibra::editor
