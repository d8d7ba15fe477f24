#pragma once
// A folder for the files of one process, made once and removed when the process ends.

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <string>
#include <string_view>
#include <system_error>

#include "check.h"

namespace glibra::fuzz {

class ScratchFolder {
  public:
    ScratchFolder() {
        std::string name = (std::filesystem::temp_directory_path() / "glibra-fuzz-XXXXXX").string();
        check(mkdtemp(name.data()) != nullptr, "a temporary folder can be made");
        path_ = name;
    }
    ScratchFolder(const ScratchFolder&) = delete;
    ScratchFolder& operator=(const ScratchFolder&) = delete;
    ~ScratchFolder() {
        std::error_code ignored;
        std::filesystem::remove_all(path_, ignored);
    }

    [[nodiscard]] const std::filesystem::path& path() const { return path_; }

    /// Writes a file below the folder, with the folders on its way.
    void write(const std::filesystem::path& name, std::string_view text) const {
        std::error_code ignored;
        std::filesystem::create_directories((path_ / name).parent_path(), ignored);
        std::ofstream(path_ / name, std::ios::binary) << text;
    }

  private:
    std::filesystem::path path_;
};

}  // namespace glibra::fuzz
