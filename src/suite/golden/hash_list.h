#pragma once
// The side file of a suite's goldens: which exact pixels were accepted, by driver. A text file of sorted
// lines, one a shot and driver, so that git merges it; a lost line costs time and nothing else.
//
//     teapot - 0f3c...golden 9a41...pixels llvmpipe (LLVM 15.0.6, 256 bits); 4.5 ...
//
// A line holds only together with the very golden file that stood beside it and the tolerance that then was
// asked for: whoever replaces a golden by hand, merges two branches or narrows a tolerance voids its lines.

#include <glibra/result.h>

#include <filesystem>
#include <map>
#include <span>
#include <string>
#include <vector>

#include "suite/golden/hash.h"

namespace glibra::suite {

struct AcceptedHash {
    std::string shot;
    std::string variant;  ///< of the golden; empty: the one for everybody
    Hash golden;          ///< of the golden's file and the shot's tolerance
    Hash pixels;          ///< of the picture that was rendered
    std::string key;      ///< driverKey()
};

/// One line without line end, and back.
std::string toLine(const AcceptedHash& accepted);
Result<AcceptedHash> parseLine(std::string_view line, const Place& place);

class HashList {
  public:
    HashList() = default;
    /// A file that is not there is an empty list. Lines that cannot be read are left out and reported as
    /// suite-W01; an unreadable file is an empty list with the reason as a warning.
    static Result<HashList> read(const std::filesystem::path& file);

    /// The pixels accepted with that driver for the golden of that content, or null.
    [[nodiscard]] const Hash* find(const std::string& shot, const std::string& variant, const Hash& golden,
                                   const std::string& key) const;
    /// Adds lines; those they replace go, and those of other content of the same golden.
    void accept(std::span<const AcceptedHash> accepted);
    [[nodiscard]] std::string toText() const;

  private:
    std::map<std::string, std::vector<AcceptedHash>> ofShot_;
};

/// Adds lines to the file, which other processes may be changing at the same time. Empty if that worked.
Diagnostics acceptHashes(const std::filesystem::path& file, std::span<const AcceptedHash> accepted);

}  // namespace glibra::suite
