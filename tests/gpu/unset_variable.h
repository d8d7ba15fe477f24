#pragma once
// A variable of the environment that is not set during a test.

#include <stdlib.h>

#include <optional>
#include <string>

namespace glibra::gpu::test {

/// Unsets it. The destructor gives it back the value that it had, whatever the test has set.
class UnsetVariable {
  public:
    explicit UnsetVariable(const char* name) : name_(name) {
        if (const char* value = ::getenv(name)) before_ = value;
        ::unsetenv(name);
    }
    UnsetVariable(const UnsetVariable&) = delete;
    UnsetVariable& operator=(const UnsetVariable&) = delete;
    ~UnsetVariable() { before_ ? ::setenv(name_, before_->c_str(), 1) : ::unsetenv(name_); }

  private:
    const char* name_;
    std::optional<std::string> before_;
};

}  // namespace glibra::gpu::test
