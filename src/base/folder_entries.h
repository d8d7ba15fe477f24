#pragma once
// The content of folders that other programs may change, remove or forbid meanwhile.

#include <filesystem>
#include <system_error>
#include <vector>

namespace glibra::base {

/// The entries of a folder, in no order. After a failure, which `failure` then has, those that were found
/// before it. Does not throw for a folder: a loop over a directory_iterator throws when its increment fails.
std::vector<std::filesystem::directory_entry> entriesOf(const std::filesystem::path& folder,
                                                        std::error_code& failure);
/// The same where a failure does not matter.
std::vector<std::filesystem::directory_entry> entriesOf(const std::filesystem::path& folder);

}  // namespace glibra::base
