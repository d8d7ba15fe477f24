#include "suite/golden/golden_store.h"

#include <fmt/format.h>

#include <algorithm>
#include <system_error>
#include <utility>

#include "base/contained.h"
#include "base/files.h"
#include "gpu/context/capabilities.h"
#include "image/file.h"
#include "image/format.h"
#include "image/read.h"
#include "image/write.h"
#include "suite/file/shot_name.h"
#include "suite/golden/ignored.h"
#include "suite/write_below.h"
#include "system/folder.h"
#include "system/process.h"

namespace glibra::suite {
namespace {

namespace fs = std::filesystem;

/// Pixels are accepted for one golden and one tolerance. Another tolerance needs another comparison.
Hash identityOf(std::span<const std::byte> bytes, const Shot& shot) {
    const std::string all = toText(hashOf(bytes)) + " " + toText(shot.tolerance) + ignoredText(shot);
    return hashOf(std::as_bytes(std::span(all)));
}

/// The same diagnostics, with the name of the file that was to be made.
Diagnostics refuseAs(Diagnostics problems, const fs::path& written, const fs::path& meant) {
    for (Diagnostic& each : problems)
        if (const std::size_t at = each.text.find(written.generic_string()); at != std::string::npos)
            each.text.replace(at, written.generic_string().size(), meant.generic_string());
    return problems;
}

/// Writes the picture as a golden is written.
Diagnostics writePicture(const image::Image& picture, const fs::path& file) {
    if (image::formatOfSuffix(file) == image::Format::png && image::isConsistent(picture)) {
        const std::vector<std::byte> bytes = goldenBytes(picture);
        if (bytes.empty()) return {image::cannotWrite(file, "there is not enough memory")};
        return image::writeFileAtomically(file, bytes, image::NamedBy::program);
    }
    return image::writeImage(picture, file, image::writtenAs(image::NamedBy::program));
}

}  // namespace

fs::path folderOf(const Suite& suite) {
    std::error_code failed;
    if (fs::is_directory(suite.file, failed)) return suite.file;
    return suite.file.has_parent_path() ? suite.file.parent_path() : fs::path(".");
}

std::string toText(const image::Tolerance& tolerance) {
    return fmt::format("{} {} {} {} {} {} {} {} {}", tolerance.largest, tolerance.fraction, tolerance.cluster,
                       tolerance.line, tolerance.bias, tolerance.flip.value_or(-1),
                       tolerance.structure.value_or(-1), tolerance.relative, tolerance.absolute);
}

fs::path goldenFolder(const Suite& suite, const fs::path& folder) {
    return folder.empty() ? suite.goldens : folder / suite.name;
}

fs::path goldenName(const Shot& shot, std::string_view variant) {
    return fmt::format("{}{}{}{}", shot.name, variant.empty() ? "" : ".", variant,
                       shot.options.floatPixels ? ".exr" : ".png");
}

bool hasOwnGolden(const Shot& shot) {
    return shot.golden && !shot.expectedError;
}

bool hasGolden(const fs::path& folder, const Shot& shot) {
    const fs::path golden = folder / goldenName(shot);
    std::error_code failure;
    if (fs::exists(golden, failure)) return true;
    return std::ranges::any_of(base::entriesOf(golden.parent_path()), [&](const fs::directory_entry& each) {
        return each.path().extension() == golden.extension() &&
               shotOfVariant(each.path().stem().generic_string()) == golden.stem().generic_string();
    });
}

Diagnostics checkGoldenFolder(const Suite& suite, const fs::path& folder) {
    Diagnostics problems;
    const auto check = [&](const char* key, const fs::path& named) {
        if (!system::isBelow(named, folderOf(suite)))
            problems.push_back(diagnose(
                "suite-E20",
                fmt::format("{}: '{}' is outside of the suite's folder '{}'; --allow-outside lets --update "
                            "write there",
                            key, named.generic_string(), folderOf(suite).generic_string()),
                {suite.file.generic_string(), 1, 1}));
    };
    if (folder.empty()) check("goldens", suite.goldens);
    if (!suite.store.empty() && !isAddress(suite.store)) check("store", suite.store);
    return problems;
}

Result<GoldenStore> GoldenStore::open(const Suite& suite, const fs::path& folder, bool allowOutside,
                                      fs::path uploads) {
    GoldenStore store;
    store.pictures_ = PictureStore(suite.store, std::move(uploads));
    store.suiteFolder_ = folderOf(suite);
    store.allowOutside_ = allowOutside;
    store.suite_ = suite.name;
    store.folder_ = goldenFolder(suite, folder);
    Result<HashList> list = HashList::read(store.hashFile());
    store.accepted_ = std::move(*list);
    return {std::move(store), std::move(list.diagnostics)};
}

fs::path GoldenStore::hashFile() const {
    return folder_ / (suite_ + ".hashes");
}

fs::path GoldenStore::file(const Shot& shot, std::string_view variant) const {
    return folder_ / goldenName(shot, variant);
}

Result<Golden> GoldenStore::find(const Shot& shot, std::string_view family) const {
    std::vector<std::string> variants = variantsFor(family);
    variants.emplace_back();
    for (std::string& each : variants) {
        std::error_code failure;
        if (fs::symlink_status(file(shot, each), failure).type() == fs::file_type::not_found) continue;
        return read(shot, std::move(each));
    }
    return {};
}

Result<Golden> GoldenStore::read(const Shot& shot, std::string variant) const {
    const fs::path path = file(shot, variant);
    std::error_code failure;
    const fs::file_type type = fs::status(path, failure).type();
    if (type == fs::file_type::not_found && fs::is_symlink(path, failure))
        return diagnose(
            "file-E01",
            fmt::format("cannot read '{}': it is a link to '{}', which is not there; fetch it, for "
                        "example with 'git annex get'",
                        path.generic_string(), fs::read_symlink(path, failure).generic_string()),
            {path.generic_string(), 1, 1});
    // What cannot be looked at, cannot be read either, and says why.
    if (type != fs::file_type::none && !allowOutside_ && !system::isBelow(path, folder_) &&
        !system::isBelow(path, suiteFolder_))
        return diagnose(
            "file-E14",
            fmt::format("cannot read '{0}': it is a link to a place outside of the golden folder; "
                        "--allow-outside follows it",
                        path.generic_string()),
            {path.generic_string(), 1, 1});
    return readFile(shot, path, std::move(variant));
}

Result<Golden> GoldenStore::readFile(const Shot& shot, const fs::path& file, std::string variant) const {
    Result<std::vector<std::byte>> bytes =
        image::readFile(file, {file.generic_string(), {file.generic_string(), 1, 1}});
    if (!bytes) return std::move(bytes.diagnostics);
    Golden golden{file, std::move(variant), std::move(*bytes), {}};
    golden.pointer = parsePointer(golden.bytes);
    if (golden.pointer) {
        const std::string ending = file.extension().generic_string();
        std::optional<std::vector<std::byte>> picture = pictures_.find(*golden.pointer, ending);
        golden.isAbsent = !picture;
        if (picture) golden.bytes = *std::move(picture);
        const std::string place = pictures_.placeOf(*golden.pointer, ending);
        if (!pictures_.isNamed())
            golden.awaited = fmt::format(
                "is a pointer of Git LFS, whose picture has not been downloaded; `{}` downloads it",
                pullCommand({&file, 1}));
        else if (pictures_.isRemote())
            golden.awaited = fmt::format("is a pointer, whose picture has to be downloaded from '{}'", place);
        else
            golden.awaited =
                fmt::format("is a pointer, whose picture '{}' is missing or cannot be read", place);
    }
    golden.identity = identityOf(golden.bytes, shot);
    return golden;
}

std::optional<Golden> GoldenStore::equalTo(const Golden& golden, const Shot& shot,
                                           const image::Image& picture) const {
    if (!golden.pointer || golden.file.extension() != ".png") return std::nullopt;
    std::vector<std::byte> bytes = goldenBytes(picture);
    if (pointerTo(bytes) != *golden.pointer) return std::nullopt;
    Golden equal = golden;
    equal.bytes = std::move(bytes);
    equal.identity = identityOf(equal.bytes, shot);
    equal.isAbsent = false;
    return equal;
}

bool GoldenStore::belongsIntoStore(const Golden& golden) const {
    return pictures_.isNamed() && !golden.pointer;
}

Diagnostics GoldenStore::moveIntoStore(const Shot& shot, const Golden& golden) const {
    if (Diagnostics problems = pictures_.keep(golden.bytes, golden.file.extension().generic_string());
        hasError(problems))
        return problems;
    const std::string text = toText(pointerTo(golden.bytes));
    const auto bytes = std::as_bytes(std::span(text));
    return restore(shot, golden.variant, std::vector<std::byte>(bytes.begin(), bytes.end()));
}

std::vector<std::string> GoldenStore::furtherVariants(const Shot& shot) const {
    std::vector<std::string> variants;
    for (int i = 1; i <= kMostFurther; ++i) {
        std::string variant = fmt::format("{}{}", kFurtherVariant, i);
        std::error_code failure;
        if (fs::exists(file(shot, variant), failure)) variants.push_back(std::move(variant));
    }
    return variants;
}

std::string GoldenStore::freeVariant(const Shot& shot) const {
    for (int i = 1; i <= kMostFurther; ++i) {
        std::string variant = fmt::format("{}{}", kFurtherVariant, i);
        std::error_code failure;
        if (!fs::exists(file(shot, variant), failure)) return variant;
    }
    return {};
}

fs::path GoldenStore::lostGolden(const Shot& shot) const {
    if (accepted_.isUnknown()) return file(shot, "");
    for (const AcceptedHash& line : accepted_.linesOf(shot.name)) {
        fs::path golden = file(shot, line.variant);
        std::error_code failure;
        if (fs::status(golden, failure).type() == fs::file_type::not_found) return golden;
    }
    return {};
}

bool GoldenStore::hasAny(const Suite& suite) const {
    return !accepted_.shots().empty() || std::ranges::any_of(suite.shots, [&](const Shot& each) {
        return hasOwnGolden(each) && hasGolden(folder_, each);
    });
}

const Hash* GoldenStore::acceptedPixels(const Shot& shot, const Golden& golden,
                                        const std::string& key) const {
    return accepted_.find(shot.name, golden.variant, golden.identity, key);
}

std::set<std::string> GoldenStore::familiesOf(const Shot& shot,
                                              const std::optional<image::Image>& picture) const {
    std::set<std::string> all, exact;
    const auto add = [&](const std::string& name, const std::optional<Hash>& pixels) {
        for (const AcceptedHash& line : accepted_.linesOf(name)) {
            if (!line.variant.empty()) continue;
            all.insert(gpu::familyOf(line.key));
            if (pixels && line.pixels == *pixels) exact.insert(gpu::familyOf(line.key));
        }
    };
    if (!picture)
        for (const std::string& name : accepted_.shots()) add(name, {});
    else  // a file that was read has an alpha, which a rendering need not have
        for (const int components : {3, 4})
            add(shot.name, hashOf(image::withComponents(*picture, components)));
    return exact.empty() ? all : exact;
}

Result<Golden> GoldenStore::replace(const Shot& shot, std::string_view variant,
                                    const image::Image& picture) const {
    const fs::path path = file(shot, variant);
    std::error_code ignored;  // reported with the file that cannot be written
    fs::create_directories(path.parent_path(), ignored);
    if (const std::string why = whyNotWritten(path); !why.empty()) return image::cannotWrite(path, why);
    // The new golden is on the disk before it takes the place of the old one.
    const fs::path whole = path.parent_path() / fmt::format(".glibra-{}-golden{}", system::ownNumber(),
                                                            path.extension().generic_string());
    Diagnostics problems = writePicture(picture, whole);
    if (!hasError(problems) && pictures_.isNamed()) {
        const auto bytes = image::readFile(whole, {path.generic_string(), {}});
        if (bytes)
            problems = pictures_.keep(*bytes, path.extension().generic_string());
        else
            problems = bytes.diagnostics;
        if (!hasError(problems)) {
            const std::string text = toText(pointerTo(*bytes));
            append(problems, image::writeFileAtomically(whole, std::as_bytes(std::span(text)),
                                                        image::NamedBy::program));
        }
    }
    if (hasError(problems)) {
        fs::remove(whole, ignored);
        return refuseAs(std::move(problems), whole, path);
    }
    if (const int problem = system::renameDurably(whole, path); problem != 0) {
        fs::remove(whole, ignored);
        return cannotWrite(path, problem);
    }
    return readFile(shot, path, std::string(variant));
}

Diagnostics GoldenStore::restore(const Shot& shot, std::string_view variant,
                                 const std::optional<std::vector<std::byte>>& bytes) const {
    const fs::path path = file(shot, variant);
    if (const std::string why = whyNotWritten(path); !why.empty()) return {image::cannotWrite(path, why)};
    const int problem = bytes ? base::writeBeneath(path.parent_path(), path.filename(), *bytes)
                              : base::removeBeneath(path.parent_path(), path.filename());
    if (problem == 0) return {};
    return {cannotWrite(path, problem)};
}

Diagnostics GoldenStore::rename(const fs::path& orphan, const Shot& shot,
                                std::span<const fs::path> orphans) const {
    const auto nameOf = [&](const fs::path& file) {
        return file.lexically_relative(folder_).replace_extension().generic_string();
    };
    // "a.llvmpipe" is a variant of "a" if that is there, too.
    std::string former = nameOf(orphan);
    if (const std::string of(shotOfVariant(former));
        !of.empty() && std::ranges::find(orphans, of, nameOf) != orphans.end())
        former = of;
    for (const fs::path& each : orphans) {
        const std::string name = nameOf(each);
        if (name != former && shotOfVariant(name) != former) continue;
        const fs::path to =
            folder_ / (shot.name + name.substr(former.size()) + each.extension().generic_string());
        std::error_code failure;
        fs::create_directories(to.parent_path(), failure);
        if (const std::string why = whyNotWritten(to); !why.empty()) return {image::cannotWrite(to, why)};
        if (fs::exists(to, failure)) return {image::cannotWrite(to, "it is there already")};
        if (const int problem = system::renameDurably(each, to); problem != 0)
            return {cannotWrite(to, problem)};
    }
    return renameHashes(hashFile(), former, shot.name);
}

std::string GoldenStore::whyNotWritten(const fs::path& path) const {
    std::error_code ignored;
    if (fs::is_symlink(path, ignored))
        return "it is a symbolic link, and its target would be overwritten; remove the link";
    if (!allowOutside_ && !system::isBelow(path, folder_))
        return "its folder is a link that leads out of the golden folder; --allow-outside follows it";
    return {};
}

Result<image::Image> decode(const Golden& golden) {
    const Place place{golden.file.generic_string(), 1, 1};
    if (golden.isAbsent)
        return diagnose("suite-E34", fmt::format("'{}' {}", golden.file.generic_string(), golden.awaited),
                        place);
    Result<image::Image> picture =
        image::decodeImage(golden.bytes, golden.file, place, {.limits = image::kDrawnLimits});
    if (picture)
        if (std::optional<Diagnostic> why = shownOtherwise("golden", golden.file, golden.bytes, place))
            picture = *std::move(why);
    if (!picture && image::placeholderOf(golden.bytes).empty())
        for (Diagnostic& each : picture.diagnostics)
            each.text +=
                "; restore the golden from version control, or replace it with --update "
                "--replace-unreadable";
    return picture;
}

}  // namespace glibra::suite
