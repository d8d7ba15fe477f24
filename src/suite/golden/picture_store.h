#pragma once
// Goldens of which a repository holds the hash and not the picture. The file of such a golden is a pointer in
// the format of Git LFS (https://github.com/git-lfs/git-lfs/blob/main/docs/spec.md): it states the SHA-256
// and the length of the picture's file. Git LFS brings the picture, or it lies in the `store` of the suite: a
// folder, or a web server, each with one file per hash.

#include <glibra/diagnostic.h>

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "image/image.h"

namespace glibra::suite {

struct Pointer {
    std::string sha256;      ///< 64 hexadecimal digits in lower case
    std::uint64_t size = 0;  ///< bytes of the picture's file
    friend bool operator==(const Pointer&, const Pointer&) = default;
};
/// The pointer that a file is; nothing if it is none, or one that Git LFS would not write.
std::optional<Pointer> parsePointer(std::span<const std::byte> file);
Pointer pointerTo(std::span<const std::byte> picture);
/// The text of its file.
std::string toText(const Pointer& pointer);
/// The file that a picture becomes as a golden in PNG, and whose hash a pointer has.
std::vector<std::byte> goldenBytes(const image::Image& picture);

/// In the folder of the results: the pictures that are to be uploaded to the store.
inline constexpr const char* kUploads = "upload";

/// The store of one suite.
class PictureStore {
  public:
    PictureStore() = default;
    /// `store`: an address or a folder, or empty. `uploads`: the folder that gets what is to be uploaded to
    /// an address.
    PictureStore(std::string store, std::filesystem::path uploads)
        : store_(std::move(store)), uploads_(std::move(uploads)) {}

    [[nodiscard]] bool isNamed() const { return !store_.empty(); }
    [[nodiscard]] bool isRemote() const;
    /// The file or the address of a picture; `ending` is that of its golden, such as ".png".
    [[nodiscard]] std::string placeOf(const Pointer& pointer, const std::string& ending) const;
    /// The picture's file from the folder, or from what was downloaded before; its hash is right. Nothing if
    /// it is not on this machine.
    [[nodiscard]] std::optional<std::vector<std::byte>> find(const Pointer& pointer,
                                                             const std::string& ending) const;
    /// Keeps the file of a picture: in the folder; or, for an address, among the uploads and the downloads.
    /// An upload is named by the end of its address, with '_' for what names of files lack on Windows.
    /// Error: file-E10.
    [[nodiscard]] Diagnostics keep(std::span<const std::byte> picture, const std::string& ending) const;

  private:
    std::string store_;
    std::filesystem::path uploads_;
};

/// A picture to download.
struct Download {
    Pointer pointer;
    std::string address;
    std::string whyNot{};  ///< why it could not be downloaded; empty if it was, or is there already
};
/// Downloads pictures with the program curl, eight at a time, into downloadFolder(). A picture has two
/// minutes, no more bytes than its pointer says, and its hash; redirections lead to http and https only, and
/// from https to https. After eight failures without a success the others are not tried. Ends early once
/// `stop` returns true.
void download(std::span<Download> wanted, const std::function<bool()>& stop);

/// The command with which Git LFS downloads the pictures of these pointers: all in one, from the current
/// folder.
std::string pullCommand(std::span<const std::filesystem::path> goldens);

}  // namespace glibra::suite
