#pragma once
// Libraries that are loaded while the program runs.

#include <filesystem>
#include <initializer_list>
#include <string>
#include <string_view>

namespace glibra::system {

/// A loaded library, which is never unloaded: drivers start threads and register exit handlers.
class Library {
  public:
    enum class When {
        allNow,  ///< every function must be found
        whenCalled
    };
    /// Loads a file, or a library that the system finds by its name. An empty value: `why` says what is
    /// missing.
    static Library open(const std::string& name, When when, std::string& why);
    explicit operator bool() const { return handle_ != nullptr; }

    /// Null if there is none of that name.
    [[nodiscard]] void* address(const char* name) const;
    template <class Function>
    [[nodiscard]] Function find(const char* name) const {
        return reinterpret_cast<Function>(address(name));
    }
    /// Sets `function` to the one of that name. False, with null, if there is none.
    template <class Function>
    [[nodiscard]] bool find(const char* name, Function& function) const {
        function = find<Function>(name);
        return function != nullptr;
    }

  private:
    void* handle_ = nullptr;
};

/// The file of a module of ours: "glibra_server" with the system's suffix for libraries.
std::string moduleName(std::string_view name);
/// The file of a program of ours: "glibra-view", on Windows with its suffix.
std::string programName(std::string_view name);
/// A function that this process has, in the common scope, or of a library that is loaded already; null if
/// there is none.
void* loadedFunction(const char* library, const char* name);
/// True if a library is loaded whose path has one of these words.
bool isLibraryLoaded(std::initializer_list<std::string_view> words);
/// What a window needs of this system. `noLibrary`: `library` is its name.
enum class Desktop { ready, noDisplay, noLibrary };
Desktop desktop(std::string& library);
/// The file of the program or library that this code is in; empty if the system does not tell.
std::filesystem::path fileOfThisCode();

}  // namespace glibra::system
