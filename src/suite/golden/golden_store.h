#pragma once
// The golden pictures of a suite: SHOT.png for all drivers, SHOT.llvmpipe.png for one family of drivers,
// SHOT.also1.png ... for pictures that are accepted besides (.exr for float pictures), and SUITE.hashes
// beside them.

#include <glibra/result.h>

#include <filesystem>
#include <optional>
#include <set>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "image/image.h"
#include "suite/golden/hash_list.h"
#include "suite/golden/picture_store.h"
#include "suite/suite.h"

namespace glibra::suite {

/// The file of a golden.
struct Golden {
    std::filesystem::path file;
    std::string variant;               ///< empty: for all drivers
    std::vector<std::byte> bytes;      ///< of the picture's file
    Hash identity;                     ///< hash of the bytes and of the shot's tolerance
    std::optional<Pointer> pointer{};  ///< the golden's file is a pointer to the picture
    bool isAbsent = false;             ///< ... which is not on this machine: `bytes` are those of the pointer
    std::string awaited{};             ///< ... and where it is to come from, in words
};

/// All numbers of a tolerance, with blanks between them.
std::string toText(const image::Tolerance& tolerance);

/// The folder of a suite's file, or the folder that is the suite.
std::filesystem::path folderOf(const Suite& suite);
/// The folder of a suite's goldens; `folder` replaces the suite's own unless it is empty.
std::filesystem::path goldenFolder(const Suite& suite, const std::filesystem::path& folder = {});
/// The name of a shot's golden in that folder.
std::filesystem::path goldenName(const Shot& shot, std::string_view variant = {});
/// True if the picture of the shot is compared with a golden of its own.
bool hasOwnGolden(const Shot& shot);
/// True if the shot has a golden for any driver in that folder.
bool hasGolden(const std::filesystem::path& folder, const Shot& shot);

class GoldenStore {
  public:
    /// Reads the list of accepted pixels. `folder` replaces the folder of the suite unless it is empty. With
    /// `allowOutside` goldens may be links to any place; without it only to files of the golden folder or of
    /// the suite's folder. `uploads`: the folder for new pictures if their store is a web server.
    static Result<GoldenStore> open(const Suite& suite, const std::filesystem::path& folder = {},
                                    bool allowOutside = false, std::filesystem::path uploads = {});

    [[nodiscard]] const std::filesystem::path& folder() const { return folder_; }
    [[nodiscard]] const HashList& accepted() const { return accepted_; }
    [[nodiscard]] std::filesystem::path hashFile() const;
    [[nodiscard]] std::filesystem::path file(const Shot& shot, std::string_view variant) const;

    /// Returns the nearest golden for a family of drivers. Nothing without diagnostics means that there is
    /// none; nothing with diagnostics, that it cannot be read.
    [[nodiscard]] Result<Golden> find(const Shot& shot, std::string_view family) const;
    /// The golden of that variant, whose file exists.
    [[nodiscard]] Result<Golden> read(const Shot& shot, std::string variant) const;
    /// The variants that are further accepted pictures: SHOT.also1.png to SHOT.also9.png, those that exist.
    [[nodiscard]] std::vector<std::string> furtherVariants(const Shot& shot) const;
    /// The first of them that does not exist; empty if all do.
    [[nodiscard]] std::string freeVariant(const Shot& shot) const;
    /// The golden that the list of accepted pixels names for this shot and that is not there, or an empty
    /// path. Every shot lacks one while the list cannot be read.
    [[nodiscard]] std::filesystem::path lostGolden(const Shot& shot) const;
    /// True if a shot of the suite has a golden, or had one that the list of accepted pixels names: then each
    /// shot needs its own, also one whose scene checks itself.
    [[nodiscard]] bool hasAny(const Suite& suite) const;
    /// The pixels that were accepted for this golden with that driver, or null.
    [[nodiscard]] const Hash* acceptedPixels(const Shot& shot, const Golden& golden,
                                             const std::string& key) const;

    /// The families of the drivers that drew the golden for all drivers, as the list of accepted pixels has
    /// them: those that gave exactly `picture`, or else all that were accepted with it. Without a picture,
    /// for a golden that is new, the families of all goldens for all drivers. Empty if the list does not say.
    [[nodiscard]] std::set<std::string> familiesOf(const Shot& shot,
                                                   const std::optional<image::Image>& picture) const;

    [[nodiscard]] const PictureStore& pictures() const { return pictures_; }
    /// The golden that a rendering is, if the golden's file is a pointer to exactly the file that the
    /// rendering would become: its picture need not be there then. Nothing if it is not, and for float
    /// pictures.
    [[nodiscard]] std::optional<Golden> equalTo(const Golden& golden, const Shot& shot,
                                                const image::Image& picture) const;
    /// True if the golden's picture belongs into the store of the suite and lies in the folder of the
    /// goldens.
    [[nodiscard]] bool belongsIntoStore(const Golden& golden) const;
    /// Moves it there; its file becomes a pointer. Error: file-E10, as for replace().
    [[nodiscard]] Diagnostics moveIntoStore(const Shot& shot, const Golden& golden) const;

    /// Makes the picture the golden of that variant and returns the new golden. In a suite with a store, the
    /// picture goes there, and the golden's file is a pointer. The file is replaced when the new one is whole
    /// and on the disk; an error leaves everything as it was. Error: file-E10, also for a golden that is a
    /// link or is reached through one that leads out of the golden folder.
    [[nodiscard]] Result<Golden> replace(const Shot& shot, std::string_view variant,
                                         const image::Image& picture) const;
    /// Undoes replace(): the golden of that variant is these bytes again, or there is none. Error: file-E10,
    /// as for replace().
    [[nodiscard]] Diagnostics restore(const Shot& shot, std::string_view variant,
                                      const std::optional<std::vector<std::byte>>& bytes) const;

    /// Makes a golden of no shot, with its variants among `orphans` and its lines in the list of accepted
    /// pixels, that of the shot, which has none. Error: file-E10, as for replace(), also if the golden is
    /// gone.
    [[nodiscard]] Diagnostics rename(const std::filesystem::path& orphan, const Shot& shot,
                                     std::span<const std::filesystem::path> orphans) const;

  private:
    [[nodiscard]] Result<Golden> readFile(const Shot& shot, const std::filesystem::path& file,
                                          std::string variant) const;
    /// Why the file of a golden is not written; empty if it may be.
    [[nodiscard]] std::string whyNotWritten(const std::filesystem::path& path) const;
    std::string suite_;
    std::filesystem::path folder_, suiteFolder_;
    bool allowOutside_ = false;
    HashList accepted_;
    PictureStore pictures_;
};

/// Whether --update may write the goldens of a suite, whose folder `folder` replaces unless it is empty:
/// suite-E20 if the suite itself names a folder for them, or for their pictures, outside of its own (links
/// resolved). A suite of somebody else could overwrite any picture of the user otherwise.
Diagnostics checkGoldenFolder(const Suite& suite, const std::filesystem::path& folder = {});

/// The pixels of a golden. Errors name its file and say what to do; suite-E34: its picture is not on this
/// machine; suite-E32: other programs may show another picture, so nobody can have accepted this one by
/// looking at it.
Result<image::Image> decode(const Golden& golden);

}  // namespace glibra::suite
