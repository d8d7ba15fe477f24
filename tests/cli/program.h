#pragma once
// Runs the glibra program as a user does and returns what it printed. Each test has a folder of its own.

#include <filesystem>
#include <string>
#include <string_view>

namespace glibra::test {

struct Finished {
    int status = -1;  ///< exit status; 128 + n if signal n ended it
    std::string out;
    std::string err;
};

/// Runs `glibra ARGUMENTS` through the shell in `folder`; `environment` is put before it ("A=1 B=2").
Finished glibra(const std::filesystem::path& folder, const std::string& arguments,
                const std::string& environment = {});

/// True if the system has OSMesa, which Mesa has dropped in version 25.1, and this driver may be had through
/// it.
bool hasOsmesa();
inline constexpr const char* kNoOsmesa = "no OSMesa here; all other ways to the driver were tried";

/// Runs `command` through the shell in `folder`.
Finished shell(const std::filesystem::path& folder, const std::string& command);

/// A new folder, which is removed with the object.
class Folder {
  public:
    Folder();
    ~Folder();
    Folder(const Folder&) = delete;
    Folder& operator=(const Folder&) = delete;

    [[nodiscard]] const std::filesystem::path& path() const { return path_; }
    [[nodiscard]] std::filesystem::path operator/(std::string_view name) const { return path_ / name; }
    /// Writes a file and makes its folders.
    void write(std::string_view name, std::string_view content) const;
    /// The names of all files in the folder, sorted, one per line.
    [[nodiscard]] std::string listing() const;

  private:
    std::filesystem::path path_;
};

std::string readFile(const std::filesystem::path& file);

inline bool contains(const std::string& text, std::string_view part) {
    return text.find(part) != std::string::npos;
}

/// A vertex shader that places vertices by the view.
inline constexpr const char* kVertexShader =
    "#version 330 core\nvoid main() { gl_Position = uModelViewProjectionMatrix * aVertex; }\n";

/// The setting that loads a library before all others: "LD_PRELOAD=...". The path in it is that of a link
/// without blanks, which would separate libraries.
std::string preload(const std::filesystem::path& library);

}  // namespace glibra::test
