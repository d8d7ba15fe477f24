#pragma once
// Writes the content of a buffer as a table: a record for each element, a field for each member that shaders
// declare.

#include <glibra/result.h>

#include <filesystem>

#include "image/file.h"
#include "render/load/device_buffers.h"

namespace glibra::render {

/// True for the suffixes of tables: .csv and .npy.
bool isTableFile(const std::filesystem::path& file);

/// .csv: text (RFC 4180) with a line of names; a vector has the fields p.x, p.y ..., other members of several
/// numbers p[0], p[1] ...; numbers are the shortest that give the same value again. .npy: a structured array
/// of NumPy (NEP 1, version 1.0 or 2.0) with the members' types. Members before the array are repeated in
/// each record; a buffer without an array is one record. The file appears when it is complete. Error file-E10
/// for other suffixes, and for a file that cannot be written.
Diagnostics writeBuffer(const BufferContent& content, const std::filesystem::path& file,
                        image::NamedBy named);

}  // namespace glibra::render
