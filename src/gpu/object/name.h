#pragma once

#include <glad/gl.h>

#include <type_traits>
#include <utility>

namespace glibra::gpu {

/// Owns one GL name. The destructor deletes it by the function of GL for its kind, such as glDeleteBuffers,
/// unless it is 0; the context that made the name must be current then.
template <auto& kDelete>
class Name {
  public:
    Name() = default;
    explicit Name(GLuint name) : name_(name) {}
    /// Owns a new name, which a function such as glGenBuffers gives.
    explicit Name(PFNGLGENBUFFERSPROC generate) { generate(1, &name_); }
    Name(Name&& other) noexcept : name_(std::exchange(other.name_, 0)) {}
    Name& operator=(Name&& other) noexcept {
        if (this != &other) {
            reset();
            name_ = std::exchange(other.name_, 0);
        }
        return *this;
    }
    ~Name() { reset(); }

    [[nodiscard]] GLuint get() const { return name_; }
    /// Releases the name; the caller deletes it.
    GLuint release() { return std::exchange(name_, 0); }
    explicit operator bool() const { return name_ != 0; }

  private:
    void reset() {
        if (name_ == 0) return;
        if constexpr (std::is_invocable_v<decltype(kDelete), GLuint>)
            kDelete(name_);
        else
            kDelete(1, &name_);
        name_ = 0;
    }
    GLuint name_ = 0;
};

}  // namespace glibra::gpu
