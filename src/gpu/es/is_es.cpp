#include "gpu/es/is_es.h"

namespace glibra::gpu {
namespace {

bool isLoaded = false;
bool isWide = false;

}  // namespace

bool isEs() {
    return isLoaded;
}

bool hasWideTexels() {
    return isWide;
}

void setEs(bool is, bool hasWide) {
    isLoaded = is;
    isWide = hasWide;
}

}  // namespace glibra::gpu
