#pragma once
// The HTML report: what a browser shows, and the files of it.

#include <glibra/diagnostic.h>

#include <filesystem>
#include <map>
#include <set>
#include <span>
#include <string>
#include <vector>

#include "base/contained.h"
#include "base/contained_call.h"
#include "image/image.h"
#include "suite/results/results.h"

namespace glibra::suite {

// The pictures, pixels and scene texts of an HTML report.

/// What the page shows of a shot besides its result. Paths are relative to the page; an empty path means that
/// there is no file.
struct ShownShot {
    std::string expected, got, difference;
    std::string pixels;                ///< script with the values of `expected` and `got`
    std::vector<std::size_t> sources;  ///< indices into ReportFiles::sources()
    std::vector<std::string> remarks;  ///< what could not be shown, and why
};

/// A text file that diagnostics may point into.
struct Source {
    std::string file;  ///< as results and diagnostics name it
    std::string text;  ///< UTF-8
};

/// True for a shot that is shown as a small picture only: a pass without changes, or a shot that was not run.
bool isPlain(const ShotResult& shot);

/// The folders, besides that of the results, whose files a report may show.
struct ReportRoots {
    base::Roots texts;           ///< scenes and shaders
    base::Roots pictures;        ///< goldens
    base::CallLimits decoder{};  ///< of a decoder of pictures that is not ours
    /// The results come from elsewhere and no folder is named for what they do not have themselves: one
    /// warning says how, instead of one per picture.
    bool areUnnamed = false;
};

class ReportFiles {
  public:
    /// Pictures and texts are taken from the results folder and from below `roots` only; see readNamed.
    ReportFiles(std::filesystem::path resultsFolder, std::filesystem::path reportFolder, ReportRoots roots);

    /// Writes the pictures and pixels of a shot. `number` counts from 1 and names its files.
    ShownShot add(const ShotResult& shot, std::size_t number);

    /// Removes the files of an earlier report from the folders.
    void removeOthers() const;

    /// The texts of the scenes and shaders of all shots that are not plain, each once.
    [[nodiscard]] const std::vector<Source>& sources() const { return sources_; }
    /// What went wrong so far.
    [[nodiscard]] Diagnostics problems() const;

  private:
    /// A picture in the report. `pixels` is set if it was asked for or had to be decoded.
    struct Copy {
        std::string file;
        image::Image pixels;
    };
    Copy addPicture(const std::filesystem::path& picture, const ShotResult& shot, std::size_t number,
                    std::string_view ending, bool wantsPixels, ShownShot& shown);
    std::string addPixels(const Copy& expected, const Copy& got, std::size_t number, ShownShot& shown);
    void addSource(const std::filesystem::path& file, ShownShot& shown);
    /// Where readNamed found a picture. Some formats are decoded by a library that opens the file itself.
    [[nodiscard]] std::filesystem::path foundAt(const std::filesystem::path& picture) const;
    bool write(const std::string& name, std::span<const std::byte> bytes);
    void remark(ShownShot& shown, const ShotResult& shot, const std::string& text);

    std::filesystem::path resultsFolder_, reportFolder_;
    ReportRoots roots_;
    std::set<std::string> written_;
    std::map<std::string, std::size_t> sourceOf_;
    std::vector<Source> sources_;
    Diagnostics problems_;
    std::size_t unnamedCount_ = 0;  ///< pictures that lie outside of the results
};

// The report for a browser: a folder that needs neither network nor server.

// The part of a report for browsers without scripts.

/// The page with `loading="lazy"` removed from its first 24 pictures. Browsers leave grey boxes for pictures
/// that load late in a screenshot without a window and on paper; a page of thousands still opens at once.
std::string loadingFirstScreen(std::string html);

/// Writes REPORT/index.html, REPORT/pictures (copies, as PNG where a browser cannot show the format) and
/// REPORT/pixels. The latter has, for every shot that is not a plain pass, the values of its pixels as a
/// script, because a page may not read the pixels of picture files. The folder is made if it does not exist.
/// Pictures and pixels of an earlier report are removed. The page is written last, when everything that it
/// needs exists.
///
/// The report shows files of the results folder, and what lies below `roots`: scenes, shaders,
/// goldens. No link is followed, and no other file is read, whatever the results name.
///
/// The warning result-W02 names a picture or a scene that cannot be read (at most 20 of them); the report
/// mentions it too. Errors: file-E10.
Diagnostics writeHtmlReport(const RunResult& run, const std::filesystem::path& resultsFolder,
                            const std::filesystem::path& reportFolder, const ReportRoots& roots = {});

}  // namespace glibra::suite
