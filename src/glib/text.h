#pragma once
// Letters and words of the language are those of all texts.

#include "base/text.h"

namespace glibra::glib {

using base::beginsName;
using base::counted;
using base::inQuotes;
using base::isDigit;
using base::isLetter;
using base::isOfName;
using base::lower;
using base::sameWord;

}  // namespace glibra::glib
