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

    /// The function of that name, or null.
    template <class Function>
    [[nodiscard]] Function function(const char* name) const {
        return reinterpret_cast<Function>(address(name));
    }

  private:
    explicit Library(void* handle) : handle_(handle) {}
    [[nodiscard]] void* address(const char* name) const;
    void* handle_ = nullptr;
};

}  // namespace glibra::gpu
