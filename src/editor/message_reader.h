#pragma once
// The messages of a client of the language server: "Content-Length: N", an empty line, N bytes of JSON. A
// client may be cut off or wrong about the length; reading then goes on with the next header.

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

    static constexpr std::size_t kLargestMessage = std::size_t{64} << 20U;

  private:
    std::string bytes_;
    std::optional<std::size_t> length_;  ///< of the message that `bytes_` begins with
    std::size_t skip_ = 0;               ///< bytes of a message that is too large
};

/// The message with its header.
std::string framed(std::string_view message);

}  // namespace glibra::editor
