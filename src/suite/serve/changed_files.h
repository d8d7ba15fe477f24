#pragma once
// Which files have changed since a golden was accepted: the likely causes of a difference.

#include <filesystem>
#include <map>
#include <set>
#include <span>
#include <string>
#include <vector>

namespace glibra::suite {

class ChangedFiles {
  public:
    /// Those of `files` that have changed since the golden: since the commit that changed it last, if git has
    /// it and it has not been changed since; otherwise those that were written later than it. Files that are
    /// missing count as unchanged. Git is asked once per folder of goldens and once per commit.
    std::vector<std::filesystem::path> since(const std::filesystem::path& golden,
                                             std::span<const std::filesystem::path> files);

  private:
    /// What git knows about a folder of goldens.
    struct Folder {
        std::filesystem::path top;  ///< of the working tree; empty: git does not know the folder
        std::map<std::string, std::string>
            commits;  ///< the last one of each golden, by its path below the folder
    };
    const Folder& folder(const std::filesystem::path& path);
    /// The files of the working tree that differ from a commit, from the top.
    const std::set<std::string>& changedSince(const std::filesystem::path& top, const std::string& commit);

    std::map<std::filesystem::path, Folder> folders_;
    std::map<std::string, std::set<std::string>> changed_;
};

}  // namespace glibra::suite
