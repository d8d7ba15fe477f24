#pragma once
// What the page of a class and the page of one student have in common.

#include <functional>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "base/page_template.h"
#include "classroom/classroom.h"

namespace glibra::classroom {

std::string figureText(double value);
std::string percentText(double share);

/// The lines of files of submissions, each read once. No link is followed.
class SourceLines {
  public:
    /// The lines from..to of a file in the submission's folder; nothing if it cannot be read.
    std::optional<std::vector<std::string>> lines(const Submission& submission, const std::string& path,
                                                  int from, int to);

  private:
    std::map<std::string, std::optional<std::string>> texts_;
};

/// Where the pictures of a page are.
struct PictureSource {
    /// If given, pictures are read from this folder and are part of the page.
    std::optional<std::filesystem::path> embeddedFrom{};
    std::size_t most = 100;  ///< moments that are shown
};

// Fields of the templates in page/parts.html.

/// `lookOf` gives the class of a line by its number; `first` is that of the first line.
std::vector<base::Fields> lineRows(const std::vector<std::string>& lines, int first,
                                   const std::function<std::string(int)>& lookOf);
/// A picture with its caption. `shape` has the width and height of the place of a picture that is missing.
base::Fields figureFields(const PictureSource& source, const Picture& picture, const Picture& shape,
                          const std::string& alternative, const std::string& caption);
/// Name, state, messages, pictures beside the reference's, points and programs of a submission.
base::Fields entryFields(const PictureSource& source, const Classroom& room, const Entry& entry,
                         SourceLines& sources);

}  // namespace glibra::classroom
