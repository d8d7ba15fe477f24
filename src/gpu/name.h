#pragma once

#include <glad/gl.h>

#include <utility>

namespace glibra::gpu {

/// One GL name and who deletes it. `Remove` is called once, with the name, when its owner goes; 0 is no name.
/// The context that made it must be current then.
template <auto Remove>
class Name {
  public:
    Name() = default;
    explicit Name(GLuint name) : name_(name) {}
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
    /// Gives the name away; somebody else deletes it.
    GLuint release() { return std::exchange(name_, 0); }
    explicit operator bool() const { return name_ != 0; }

  private:
    void reset() {
        if (name_ != 0) Remove(name_);
        name_ = 0;
    }
    GLuint name_ = 0;
};

}  // namespace glibra::gpu
