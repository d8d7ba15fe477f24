#include "cli/store_downloads.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <string>

#include "base/files.h"
#include "base/text.h"
#include "cli/commands.h"
#include "image/file.h"
#include "suite/file/shot_name.h"
#include "suite/golden/golden_store.h"
#include "suite/golden/picture_store.h"

namespace glibra::cli {

namespace fs = std::filesystem;

bool mayDownload(const suite::ShotResult& shot, const Selection& selection,
                 const suite::RunOptions& options) {
    if (shot.awaits.empty() || !shot.awaitsStore || options.sandbox != nullptr) return false;
    const auto found = std::ranges::find(selection.suites, shot.suite, &suite::Suite::name);
    return found != selection.suites.end() && suite::isAddress(found->store);
}

std::set<suite::ShotKey> downloadFor(std::vector<suite::ShotResult>& waiting, const Selection& selection,
                                     const suite::RunOptions& options, const std::function<bool()>& stop) {
    std::map<std::string, std::size_t> known;  // by address
    std::vector<suite::Download> wanted;
    std::map<suite::ShotKey, std::vector<std::string>> addressesOf;
    for (const suite::ShotResult& shot : waiting) {
        const suite::Suite& suite = *std::ranges::find(selection.suites, shot.suite, &suite::Suite::name);
        const suite::PictureStore store(suite.store, {});
        for (const fs::path& golden : shot.awaits) {
            const fs::path inside = golden.lexically_relative(suite::goldenFolder(suite, options.goldens));
            if (inside.empty() || *inside.begin() == "..") continue;
            constexpr std::uint64_t kLongest = 4096;
            const auto bytes = image::readFile(golden, {golden.generic_string(), {}}, kLongest);
            const auto pointer = bytes ? suite::parsePointer(*bytes) : std::nullopt;
            if (!pointer) continue;
            const std::string address = store.placeOf(*pointer, golden.extension().generic_string());
            if (known.try_emplace(address, wanted.size()).second) wanted.push_back({*pointer, address});
            addressesOf[{shot.suite, shot.shot}].push_back(address);
        }
    }
    printLine(fmt::format("downloading {} of goldens", base::counted(wanted.size(), "picture")));
    suite::download(wanted, stop);
    std::set<suite::ShotKey> ready;
    for (suite::ShotResult& shot : waiting) {
        const suite::ShotKey key(shot.suite, shot.shot);
        std::string why;
        for (const std::string& each : addressesOf[key])
            if (const suite::Download& one = wanted[known.at(each)]; why.empty() && !one.whyNot.empty())
                why = fmt::format("the picture of its golden cannot be downloaded from '{}': {}", each,
                                  one.whyNot);
        if (why.empty()) {
            ready.insert(key);
            continue;
        }
        shot.reason = why;
        std::erase_if(shot.diagnostics, [](const Diagnostic& each) { return each.id == "suite-E34"; });
        shot.diagnostics.push_back(diagnose("suite-E34", why, {shot.awaits.front().generic_string(), 1, 1}));
    }
    return ready;
}

void noteUploads(const std::vector<suite::Suite>& suites, const fs::path& results) {
    const fs::path folder = results / suite::kUploads;
    const std::size_t count = base::entriesOf(folder).size();
    std::set<std::string> stores;
    for (const suite::Suite& each : suites)
        if (suite::isAddress(each.store)) stores.insert(each.store);
    for (const std::string& each : stores)
        if (count > 0)
            print({withoutId(Severity::note,
                             fmt::format("'{}' has {} for {}: upload {}, then commit the pointers",
                                         folder.generic_string(), base::counted(count, "picture"), each,
                                         count == 1 ? "it" : "them"))});
}

}  // namespace glibra::cli
