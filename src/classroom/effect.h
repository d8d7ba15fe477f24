#pragma once
// Compares what a value does to pictures. Where it changes a small part of them, as a lens over a photograph,
// two pictures look alike with and without the effect; what tells them apart is the change itself.

#include <optional>

#include "classroom/cut_objects.h"
#include "image/image.h"

namespace glibra::classroom {

/// How a change of a value changes the pictures of a submission, beside how it changes the reference's. Both
/// changes are differences of pictures that are reduced to at most 32 pixels on a side; how alike they are is
/// their cosine, 0 to 1.
struct Effect {
    double likeness = 0;  ///< at the best shift by up to a quarter of the picture
    double inside = 0;    ///< where the submission's own pictures change, without a shift
    double share = 0;     ///< the part of the reference's objects that changes
};

/// The means of the cells of a picture, of which its longer side has at most so many.
Colors reduced(const image::Image& picture, int most = 32);

/// True if a picture shows what a reduced one shows, perhaps upside down.
bool looksLike(const Colors& reference, const image::Image& picture);

/// True if a picture is a part of another one, pixel by pixel but for noise, perhaps upside down: at least a
/// 25th of it, 32 pixels wide and high, and with something to see.
bool isCutFrom(const image::Image& reference, const image::Image& picture);

/// The effect between two moments. Nothing: the reference does not change, or sizes differ.
std::optional<Effect> effectOf(const Colors& referenceBefore, const Colors& referenceAfter,
                               const Colors& before, const Colors& after);

/// The largest difference of a component of two reduced pictures, summed over the pixels: which of several
/// moments differs most from one.
double differenceOf(const Colors& one, const Colors& other);

/// The part that is left of the likeness of whole pictures: all of it where most of the reference's objects
/// change, and where less than 40 percent do, as much as the effect is alike: nothing up to 0.15, and all of
/// it from 0.6 on.
double keptLikeness(const Effect& effect);

/// True if the value changes a part of the reference, and the submission in another way.
bool changesOtherwise(const Effect& effect);

}  // namespace glibra::classroom
