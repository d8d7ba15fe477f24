#pragma once
// A shared library opened at run time.

#include <string>
#include <variant>

#include "system/library.h"

namespace glibra::gpu {

/// A library stays loaded until the process ends: drivers start threads and register exit handlers, so
/// unloading them is neither safe nor quick.
class Library {
  public:
    /// Opens the library; a text is the loader's reason for a failure.
    static std::variant<Library, std::string> open(const std::string& name);

    /// Sets `function` to the one of that name. False, with null, if there is none.
    template <class Function>
    [[nodiscard]] bool find(const char* name, Function& function) const {
        function = library_.find<Function>(name);
        return function != nullptr;
    }

  private:
    explicit Library(system::Library library) : library_(library) {}
    system::Library library_;
};

}  // namespace glibra::gpu
