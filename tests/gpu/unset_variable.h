#pragma once
// A variable of the environment that is not set during a test.

#include <cstdlib>
#include <optional>
#include <string>

#include "system/places.h"

namespace glibra::gpu::test {

/// Unsets it. The destructor gives it back the value that it had, whatever the test has set.
class UnsetVariable {
  public:
    explicit UnsetVariable(const char* name) : name_(name) {
        if (const char* value = std::getenv(name)) before_ = value;
        system::removeVariable(name);
    }
    UnsetVariable(const UnsetVariable&) = delete;
    UnsetVariable& operator=(const UnsetVariable&) = delete;
    ~UnsetVariable() {
        if (before_)
            system::setVariable(name_, *before_, system::Replace::yes);
        else
            system::removeVariable(name_);
    }

  private:
    const char* name_;
    std::optional<std::string> before_;
};

}  // namespace glibra::gpu::test
