#include "suite/golden/golden_store.h"

#include <fmt/format.h>

#include <system_error>

#include "image/file.h"
#include "image/read.h"
#include "image/write.h"
#include "suite/golden/hash_key.h"

namespace glibra::suite {
namespace {

namespace fs = std::filesystem;

/// A golden is written once and kept for years in a repository, so it may take longer to write and should be
/// small.
constexpr int kCompression = 9;

/// Pixels are accepted for one golden and one tolerance. Another tolerance needs another comparison.
Hash identityOf(std::span<const std::byte> bytes, const image::Tolerance& tolerance) {
    const Hash content = hashOf(bytes);
    const std::string all =
        fmt::format("{} {} {} {} {} {} {} {} {} {}", toText(content), tolerance.largest, tolerance.fraction,
                    tolerance.cluster, tolerance.line, tolerance.bias, tolerance.flip.value_or(-1),
                    tolerance.structure.value_or(-1), tolerance.relative, tolerance.absolute);
    return hashOf(std::as_bytes(std::span(all)));
}

Result<Golden> readGolden(const Shot& shot, const fs::path& file, std::string variant) {
    Result<std::vector<std::byte>> bytes = image::readFile(file, {file.string(), {file.string(), 1, 1}});
    if (!bytes) return std::move(bytes.diagnostics);
    const Hash identity = identityOf(*bytes, shot.tolerance);
    return Golden{file, std::move(variant), std::move(*bytes), identity};
}

}  // namespace

Result<GoldenStore> GoldenStore::open(const Suite& suite, const fs::path& folder) {
    GoldenStore store;
    store.suite_ = suite.name;
    store.folder_ = folder.empty() ? suite.goldens : folder / suite.name;
    Result<HashList> list = HashList::read(store.hashFile());
    store.accepted_ = std::move(*list);
    return {std::move(store), std::move(list.diagnostics)};
}

fs::path GoldenStore::hashFile() const {
    return folder_ / (suite_ + ".hashes");
}

fs::path GoldenStore::file(const Shot& shot, std::string_view variant) const {
    return folder_ / fmt::format("{}{}{}{}", shot.name, variant.empty() ? "" : ".", variant,
                                 shot.options.floatPixels ? ".exr" : ".png");
}

Result<Golden> GoldenStore::find(const Shot& shot, std::string_view family) const {
    std::vector<std::string> variants = variantsFor(family);
    variants.emplace_back();
    for (std::string& each : variants) {
        const fs::path path = file(shot, each);
        std::error_code failure;
        const fs::file_status status = fs::status(path, failure);
        if (status.type() == fs::file_type::not_found) continue;
        return readGolden(shot, path, std::move(each));
    }
    return {};
}

const Hash* GoldenStore::acceptedPixels(const Shot& shot, const Golden& golden,
                                        const std::string& key) const {
    return accepted_.find(shot.name, golden.variant, golden.identity, key);
}

Result<Golden> GoldenStore::replace(const Shot& shot, std::string_view variant,
                                    const image::Image& picture) const {
    const fs::path path = file(shot, variant);
    std::error_code ignored;  // reported with the file that cannot be written
    fs::create_directories(path.parent_path(), ignored);
    image::WriteOptions options;
    options.png.level = kCompression;
    Diagnostics problems = image::writeImage(picture, path, options);
    if (hasError(problems)) return problems;
    return readGolden(shot, path, std::string(variant));
}

Result<image::Image> decode(const Golden& golden) {
    const Place place{golden.file.string(), 1, 1};
    Result<image::Image> picture = image::decodeImage(golden.bytes, golden.file, place);
    if (!picture)
        for (Diagnostic& each : picture.diagnostics)
            each.text += "; restore the golden from version control, or make it anew with --update";
    return picture;
}

}  // namespace glibra::suite
