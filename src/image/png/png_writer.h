#pragma once
// PNG files, written fast: filters chosen by a quick look at how well they pack, libdeflate, large pictures
// by several threads.

#include <string>
#include <utility>
#include <vector>

#include "image/image.h"

namespace glibra::image {

struct PngOptions {
    /// libdeflate's levels, 1 (fast) to 12 (smallest). 0: as quickly as possible, which suits the frames of
    /// animations; the files are larger.
    int level = 4;
    /// Keyword and text (UTF-8), stored as tEXt, or as iTXt where the text is not plain ASCII. Keywords
    /// are 1..79 printable ASCII characters; others are left out.
    std::vector<std::pair<std::string, std::string>> text;
    /// Large pictures are packed by as many; 0: by as many as there are processors. The file is the same for
    /// any number.
    unsigned threads = 0;
};

/// A PNG file of the image: 8 or 16 bits, 1 to 4 components as grey, grey + alpha, RGB, RGBA. Empty if PNG
/// cannot hold it: float components, no pixels, or data of another length than the size says.
std::vector<std::byte> encodePng(const Image& image, const PngOptions& options = {});

}  // namespace glibra::image
