#pragma once
// The image module, which is loaded for the first picture that needs it and stays loaded until the
// process ends.

#include <glibra/result.h>

#include <filesystem>
#include <initializer_list>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "base/contained_call.h"
#include "image/file.h"
#include "image/format.h"
#include "image/image.h"
#include "system/library.h"

namespace glibra::image {

/// The places of the modules for a program and for the library or Python module that has this code, in this
/// order: beside the program (a build tree), ../lib/glibra relative to it (an unpacked archive), `glibra`
/// beside the library, and in the folder of libraries that a Python package is installed below; where this
/// program was installed, and, for programs of a build tree only, that tree. A relative library adds none.
std::vector<std::filesystem::path> moduleFoldersOf(const std::filesystem::path& program,
                                                   const std::filesystem::path& library);
/// Those of this process.
std::vector<std::filesystem::path> defaultModuleFolders();

/// The first module of ours in the folders that says by its function `versionOf` that it is of this version,
/// and has all functions. Without one, `why` says "is not installed", or what keeps the first that is there
/// from being loaded, such as a library of the system that it needs. Loading a library that is loaded already
/// takes microseconds, so nothing is cached.
system::Library openModule(std::span<const std::filesystem::path> folders, std::string_view name,
                           const char* versionOf, int version, std::initializer_list<const char*> functions,
                           std::string& why);

/// What may be read, and by whom.
struct ReadOptions {
    Limits limits;
    std::vector<std::filesystem::path> moduleFolders = defaultModuleFolders();
    base::CallLimits decoder{};  ///< of a decoder that is not ours, outside of workers
};

/// Reads a picture with the module: RGBA, u8, u16 or f32. `path` may be empty if the bytes come from inside
/// another file. The decoders are foreign code, so they run in a process of their own within the limits of
/// `options.decoder`; in a worker (base::isWorker) also within the time that its step has left. A worker that
/// may start no process runs them in a thread, since it has limits itself. Errors: file-E03 the module is not
/// installed or cannot be loaded, naming the format; file-E04 damaged; file-E09 exceeds the limits; file-E11
/// the decoder crashed or took too long.
Result<Image> readByModule(Format format, std::span<const std::byte> file, const std::filesystem::path& path,
                           const FileLabel& label, const ReadOptions& options);

/// Writes a picture with the module to exactly this path; not atomic. EXR and HDR become float, JPEG has
/// quality 95; alpha and `comment` are dropped if the format has none. The encoder runs in a process of its
/// own as decoders do, but without limits. Errors: file-E03 as for reading; file-E10 not written. Both name
/// `label`.
Diagnostics writeByModule(const Image& image, Format format, const std::filesystem::path& path,
                          const FileLabel& label, const std::string& comment,
                          std::span<const std::filesystem::path> moduleFolders);

}  // namespace glibra::image
