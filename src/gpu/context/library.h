#pragma once
// A shared library opened at run time.

#include <string>
#include <variant>

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
        function = reinterpret_cast<Function>(address(name));
        return function != nullptr;
    }

  private:
    explicit Library(void* handle) : handle_(handle) {}
    [[nodiscard]] void* address(const char* name) const;
    void* handle_ = nullptr;
};

}  // namespace glibra::gpu
