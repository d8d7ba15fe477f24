#pragma once
// The pages of a gallery. They name each other and their pictures by relative links, load nothing from the
// network, and show whatever a scene contains as text.

#include <glibra/diagnostic.h>

#include <filesystem>
#include <string>

#include "gallery/gallery.h"

namespace glibra::gallery {

/// All scenes by the folders that they are in.
std::string indexPage(const Gallery& gallery);

/// All scenes that have chapters, by chapters; empty if none has.
std::string chaptersPage(const Gallery& gallery);

/// One scene: picture and film, what it says about itself, its messages, ranges and sources.
std::string scenePage(const Gallery& gallery, std::size_t scene);

/// Writes all pages, index.html last. Returns nothing, or one file-E10.
Diagnostics writePages(const Gallery& gallery, const std::filesystem::path& site);

}  // namespace glibra::gallery
