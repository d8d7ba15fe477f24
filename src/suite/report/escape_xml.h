#pragma once

#include "base/escape_xml.h"

namespace glibra::suite {

using base::escapeXml;

}  // namespace glibra::suite
