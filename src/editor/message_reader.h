#pragma once
// The messages of a client of the language server: "Content-Length: N", an empty line, N bytes of JSON. A
// client may be cut off or wrong about the length; reading then goes on with the next header, unless the
// length is larger than any message.

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

namespace glibra::editor {

class MessageReader {
  public:
    /// Bytes as they arrive, in pieces of any size.
    void add(std::string_view bytes) { bytes_ += bytes; }
    /// The next whole message; nothing until more bytes arrive.
    std::optional<std::string> next();
    /// The last message is no JSON. If a header stands in it, its length was wrong, and what begins with that
    /// header is read again.
    void refuse(std::string_view message);

    /// A header states more than kLargestMessage bytes. No further message is read: nobody knows where the
    /// next one begins.
    [[nodiscard]] bool isLost() const { return length_ && *length_ > kLargestMessage; }

    static constexpr std::size_t kLargestMessage = std::size_t{64} << 20U;

  private:
    std::string bytes_;
    std::optional<std::size_t> length_;  ///< of the message that `bytes_` begins with
};

/// The message with its header.
std::string framed(std::string_view message);

}  // namespace glibra::editor
