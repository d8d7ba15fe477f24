#pragma once
// A shared library opened at run time.

#include <string>
#include <variant>

namespace glibra::gpu {

/// Stays loaded until the process ends: drivers start threads and register handlers at exit, so that
/// unloading them is neither safe nor quick.
class Library {
  public:
    /// The library, or the loader's own words why not.
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
