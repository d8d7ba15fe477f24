#pragma once
// Open files of the system, and all bytes of a transfer.

#include <cstddef>
#include <span>
#include <string_view>

namespace glibra::base {

/// A file descriptor that closes itself.
class Descriptor {
  public:
    Descriptor() = default;
    explicit Descriptor(int number) : number_(number) {}
    Descriptor(Descriptor&& other) noexcept : number_(other.number_) { other.number_ = -1; }
    Descriptor& operator=(Descriptor&& other) noexcept;
    ~Descriptor();
    [[nodiscard]] int number() const { return number_; }
    explicit operator bool() const { return number_ >= 0; }

  private:
    int number_ = -1;
};

/// Writes all bytes. Returns 0 or an error number.
int writeAll(int file, std::span<const std::byte> bytes);
inline int writeAll(int file, std::string_view text) {
    return writeAll(file, std::as_bytes(std::span(text)));
}

/// Fills `bytes` from a pipe. False if it ends before, or cannot be read.
bool receiveAll(int pipe, std::span<std::byte> bytes);

}  // namespace glibra::base
