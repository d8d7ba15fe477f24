#pragma once
// The pieces that the page of a class and the page of one student have in common, as HTML.

#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "classroom/classroom.h"

namespace glibra::classroom {

/// A name that a stranger chose. <bdi> keeps its direction to itself.
std::string nameHtml(std::string_view name);
std::string figureText(double value);
std::string percentText(double share);
/// The words of a state, and its class in report.css.
std::string stateHtml(const Entry& entry);

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

/// `shape` has the width and height of the place of a picture that is missing.
std::string pictureHtml(const PictureSource& source, const Picture& picture, const Picture& shape,
                        const std::string& alternative, const std::string& caption);
/// Each picture beside the reference's. Nothing for a submission without any picture: the reference is on the
/// page once.
std::string picturesHtml(const PictureSource& source, const Classroom& room, const Entry& entry);
/// The errors with the lines that they name, then the warnings, one line for each kind.
std::string messagesHtml(const Entry& entry, SourceLines& sources);
/// The points by check, with reasons; `picturePrefix` begins the link to the picture that shows one.
std::string marksHtml(const Classroom& room, const Entry& entry, std::string_view picturePrefix);
/// "uTol yes, uAd no", with the figures of both as a title.
std::string reactionsHtml(const Classroom& room, const Entry& entry);
std::string programsHtml(const Entry& entry);

}  // namespace glibra::classroom
