// Measures of the difference of two images, per pixel: angles of normals and steps of 8 bits.
// Precondition of all functions: equal sizes, finite values.
#pragma once

#include "image/image.h"

namespace wrinkle::report {

// Returns true for images that can be normal maps: two channels without alpha, or more.
bool has_normals(const Image& image);

// Returns the angles in degrees between the normals of two normal maps; one channel. A normal is
// 2c - 1 of the stored color c, of any length; of two channels z is sqrt(1 - x^2 - y^2). The
// direction of green has no effect if it is the same in both. The angle to a vector of length zero
// is 180, or 0 if both are zero. Precondition: has_normals() of both.
Image degrees_apart(const Image& reference, const Image& test);

// Returns the root mean square, over r, g, b and alpha (expand_texel()), of the differences in
// units of 1 / 255; one channel.
Image steps_apart(const Image& reference, const Image& test);

}  // namespace wrinkle::report
