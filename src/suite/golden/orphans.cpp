#include "suite/golden/orphans.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <numeric>
#include <set>
#include <system_error>

#include "base/files.h"
#include "base/suggest.h"
#include "image/file.h"
#include "image/read.h"
#include "suite/file/shot_name.h"
#include "suite/file/suite_file.h"
#include "suite/golden/golden_store.h"
#include "suite/golden/hash_list.h"
#include "suite/golden/picture_store.h"
#include "system/folder.h"

namespace glibra::suite {
namespace {

namespace fs = std::filesystem;

bool isPicture(const fs::path& file) {
    return file.extension() == ".png" || file.extension() == ".exr";
}

/// The name of the shot of a golden "NAME.png" or "NAME.VARIANT.png" among `shots`, or empty.
bool belongsTo(const std::set<std::string>& shots, const std::string& stem) {
    return shots.contains(stem) || shots.contains(std::string(shotOfVariant(stem)));
}

/// The shots that are compared with a golden of their own.
std::set<std::string> shotNames(const Suite& suite) {
    std::set<std::string> names;
    for (const Shot& each : suite.shots)
        if (hasOwnGolden(each)) names.insert(each.name);
    return names;
}

/// Reads the other suites in the folder of the suite's file, which may have their goldens in the same folder.
/// Returns false if one of the TOML files there cannot be read as a suite, so that its goldens are unknown.
bool suitesBeside(const Suite& suite, std::vector<Suite>& beside) {
    std::error_code failure;
    if (!fs::is_regular_file(suite.file, failure)) return true;
    bool allRead = true;
    for (const fs::directory_entry& each :
         base::entriesOf(suite.file.has_parent_path() ? suite.file.parent_path() : ".")) {
        const fs::path& file = each.path();
        if (file.extension() != ".toml" || !each.is_regular_file(failure) ||
            fs::equivalent(file, suite.file, failure))
            continue;
        Result<Suite> read = readSuite(file);
        allRead = allRead && read;
        if (read) beside.push_back(std::move(*read));
    }
    return allRead;
}

/// A golden that was read has an alpha, which a rendering need not have.
std::string keyOf(const image::Image& picture) {
    return toText(hashOf(image::withComponents(picture, 4)));
}

}  // namespace

std::vector<fs::path> orphanGoldens(const Suite& suite, const fs::path& folder,
                                    std::span<const Suite> others) {
    const fs::path root = goldenFolder(suite, folder);
    const std::set<std::string> shots = shotNames(suite);
    std::vector<std::pair<fs::path, std::string>> found;  // with the name that a shot would have
    bool hasOthers = false;
    std::error_code failure;
    for (fs::recursive_directory_iterator each(root, failure), end; !failure && each != end;
         each.increment(failure)) {
        const fs::path& file = each->path();
        if (file.filename().generic_string().starts_with('.') || each->is_symlink(failure) ||
            !each->is_regular_file(failure))
            continue;
        if (file.extension() == ".hashes") {
            if (file.stem() != suite.name) return {};
        } else if (!isPicture(file)) {
            hasOthers = hasOthers || (file.extension() != ".md" && file.extension() != ".txt");
        } else {
            const std::string name = file.lexically_relative(root).replace_extension().generic_string();
            if (!belongsTo(shots, name)) found.emplace_back(file, name);
        }
    }
    if (found.empty()) return {};
    std::vector<Suite> beside;
    if (folder.empty() && !suitesBeside(suite, beside)) hasOthers = true;
    for (const std::span<const Suite> some : {others, std::span<const Suite>(beside)})
        for (const Suite& other : some) {
            const fs::path otherRoot = goldenFolder(other, folder);
            const std::set<std::string> names = shotNames(other);
            std::erase_if(found, [&](const auto& each) {
                return belongsTo(names, system::realPath(each.first)
                                            .lexically_relative(system::realPath(otherRoot))
                                            .replace_extension()
                                            .generic_string());
            });
        }
    if (hasOthers) {
        const Result<HashList> list = HashList::read(root / (suite.name + ".hashes"));
        const std::set<std::string> known = list ? list->shots() : std::set<std::string>();
        std::erase_if(found, [&](const auto& each) { return !belongsTo(known, each.second); });
    }
    std::vector<fs::path> orphans;
    for (auto& [file, name] : found) orphans.push_back(std::move(file));
    std::ranges::sort(orphans);
    return orphans;
}

Orphans::Gist Orphans::gistOf(const image::Image& picture) {
    constexpr int kSide = 16;
    constexpr std::size_t kComponents = 3;
    const image::Image colors = image::withComponents(image::withType(picture, image::Component::u8), 3);
    Gist sums(kSide * kSide * kComponents), counts(kSide * kSide);
    for (int y = 0; y < colors.height; ++y) {
        const std::span<const std::byte> row = colors.row(y);
        for (int x = 0; x < colors.width; ++x) {
            const auto cell =
                static_cast<std::size_t>(y * kSide / colors.height * kSide + x * kSide / colors.width);
            ++counts[cell];
            for (std::size_t k = 0; k < kComponents; ++k)
                sums[kComponents * cell + k] +=
                    std::to_integer<int>(row[kComponents * static_cast<std::size_t>(x) + k]);
        }
    }
    for (std::size_t i = 0; i < sums.size(); ++i) sums[i] /= std::max(1., counts[i / kComponents]);
    for (std::size_t k = 0; k < kComponents; ++k) {
        double mean = 0;
        for (std::size_t i = k; i < sums.size(); i += kComponents) mean += sums[i] / (kSide * kSide);
        for (std::size_t i = k; i < sums.size(); i += kComponents) sums[i] -= mean;
    }
    return sums;
}

void Orphans::read() const {
    std::call_once(isRead_, [&] {
        for (const fs::path& file : files_) {
            if (const auto bytes = image::readFile(file, {file.generic_string(), {}}))
                if (const std::optional<Pointer> pointer = parsePointer(*bytes))
                    ofPointer_.emplace(pointer->sha256, file);
            if (const Result<image::Image> golden =
                    image::readImage(file, {}, {.limits = image::kDrawnLimits})) {
                ofPixels_.emplace(keyOf(*golden), file);
                gists_.emplace_back(file, gistOf(*golden));
            }
        }
    });
}

fs::path Orphans::find(const image::Image& picture) const {
    if (isEmpty()) return {};
    read();
    if (const auto found = ofPixels_.find(keyOf(picture)); found != ofPixels_.end()) return found->second;
    if (ofPointer_.empty()) return {};
    const auto found = ofPointer_.find(pointerTo(goldenBytes(picture)).sha256);
    return found == ofPointer_.end() ? fs::path() : found->second;
}

fs::path Orphans::findNear(const image::Image& picture, std::string_view shot) const {
    constexpr double kAlike = .75;       // correlation; of 200 pairs of unrelated pictures one has it
    constexpr double kSimilar = 2. / 3;  // part of a name that stays
    constexpr std::size_t kLongestComparedName = 200;  // of those that are compared
    if (isEmpty()) return {};
    read();
    const auto product = [](const Gist& a, const Gist& b) {
        return std::inner_product(a.begin(), a.end(), b.begin(), 0.);
    };
    const Gist own = gistOf(picture);
    fs::path best;
    double most = 0;
    for (const auto& [file, gist] : gists_) {
        const double norm = std::sqrt(product(own, own) * product(gist, gist));
        const double alike = norm > 0 ? product(own, gist) / norm : 0;
        // The folder of goldens is not known here: the parts of the path that a name would have.
        fs::path name = file.stem();
        for (fs::path above = file.parent_path();
             std::count(shot.begin(), shot.end(), '/') > std::distance(name.begin(), name.end()) - 1 &&
             above.has_filename();
             above = above.parent_path())
            name = above.filename() / name;
        const std::string text = name.generic_string();
        const std::size_t longer = std::max(text.size(), shot.size());
        const double similar =
            longer > kLongestComparedName || longer == 0
                ? 0
                : 1 - static_cast<double>(base::editDistance(text, shot)) / static_cast<double>(longer);
        if ((alike >= kAlike || similar >= kSimilar) && alike + similar > most) {
            most = alike + similar;
            best = file;
        }
    }
    return best;
}

Diagnostics removeOrphans(const std::vector<fs::path>& orphans) {
    Diagnostics problems;
    for (const fs::path& each : orphans) {
        std::error_code failure;
        if (!fs::remove(each, failure) || failure) {
            problems.push_back(diagnose(
                "file-E10", fmt::format("cannot remove '{}': {}", each.generic_string(), failure.message())));
            continue;
        }
        // Fails for a folder that is not empty, and so never removes the golden folder of a suite with
        // goldens.
        for (fs::path folder = each.parent_path();
             !folder.empty() && fs::remove(folder, failure) && !failure;)
            folder = folder.parent_path();
    }
    return problems;
}

}  // namespace glibra::suite
