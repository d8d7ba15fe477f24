#pragma once
// The descriptors 0, 1 and 2.

#include <string>

namespace glibra::base {

/// Opens /dev/null on those of the descriptors 0, 1 and 2 that are closed, so that no file or pipe of the
/// program gets one of these numbers and is taken for standard output. Reading and writing still fail, as on
/// a closed descriptor. Call it first in main. Returns false if a descriptor stays closed.
bool openStandardFiles() noexcept;

/// Writes out what standard output still buffers. Returns why not all that was ever written to it has arrived
/// (a full disk, a closed descriptor), or an empty text. Call it last in main: only then is it known whether
/// the output is whole.
std::string endStandardOutput();

}  // namespace glibra::base
