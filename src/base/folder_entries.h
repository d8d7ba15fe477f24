#pragma once
// The content of folders that other programs may change, remove or forbid meanwhile.

#include <filesystem>
#include <system_error>
#include <vector>

namespace glibra::base {

/// Returns the entries of a folder, in no order. If the folder cannot be read to its end, returns those that
/// were found, and `failure` says why. A plain loop over a directory_iterator throws then.
std::vector<std::filesystem::directory_entry> entriesOf(const std::filesystem::path& folder,
                                                        std::error_code& failure);
/// The same, without the reason of a failure.
std::vector<std::filesystem::directory_entry> entriesOf(const std::filesystem::path& folder);

}  // namespace glibra::base
