#pragma once
// How the files of this folder start programs.

#include <initializer_list>
#include <string>
#include <utility>
#include <vector>

#include "system/process.h"

namespace glibra::system {

/// As exec takes them, while `words` lives.
std::vector<char*> pointersTo(const std::vector<std::string>& words);

/// Null as `program`: the first word is searched in PATH. Each pair of descriptors is one of this process and
/// the number that it has in the program.
Process spawn(const char* program, const std::vector<std::string>& words, const Streams& streams,
              std::initializer_list<std::pair<int, int>> descriptors = {});

}  // namespace glibra::system
