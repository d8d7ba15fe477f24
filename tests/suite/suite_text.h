#pragma once
// A folder with scenes, and suites from text, for the tests of suite files.

#include <glibra/result.h>
#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <initializer_list>
#include <string>
#include <string_view>
#include <system_error>

#include "../support/new_folder.h"
#include "suite/file/suite_file.h"

namespace glibra::suite::test {

/// A new folder with empty scenes of these names. It is removed with the object.
class SceneFolder {
  public:
    explicit SceneFolder(std::initializer_list<std::string_view> scenes = {}) {
        path_ = glibra::test::newFolder("suite");
        for (const std::string_view each : scenes) write(each, "");
    }
    SceneFolder(const SceneFolder&) = delete;
    SceneFolder& operator=(const SceneFolder&) = delete;
    ~SceneFolder() {
        std::error_code ignored;
        std::filesystem::remove_all(path_, ignored);
    }

    [[nodiscard]] const std::filesystem::path& path() const { return path_; }

    void write(std::string_view name, std::string_view content) const {
        std::filesystem::create_directories((path_ / name).parent_path());
        std::ofstream(path_ / name, std::ios::binary) << content;
    }

    /// Reads the suite "s.toml" of this folder, which has this text.
    [[nodiscard]] Result<Suite> read(std::string_view text) const {
        return readSuiteText(text, path_ / "s.toml");
    }

    /// The names of its shots, one per line; or its errors, as "line:column id text" without the folder.
    [[nodiscard]] std::string show(std::string_view text) const { return shown(read(text)); }

    [[nodiscard]] std::string shown(const Result<Suite>& suite) const {
        std::string all;
        if (suite)
            for (const Shot& each : suite->shots) all += each.name + "\n";
        for (const Diagnostic& each : suite.diagnostics) {
            std::string line = std::to_string(each.place.line) + ":" + std::to_string(each.place.column) +
                               " " + each.id + " " + each.text + "\n";
            for (std::size_t at = 0; (at = line.find(path_.string() + "/", at)) != std::string::npos;)
                line.erase(at, path_.string().size() + 1);
            all += line;
        }
        return all;
    }

  private:
    std::filesystem::path path_;
};

}  // namespace glibra::suite::test
