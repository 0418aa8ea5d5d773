// Choices and documentation of ports that several nodes share.
#pragma once

#define FRAME_METHODS \
    { "auto", "vertex", "derived", "exact", "guess" }
#define FRAME_DOC                                                                               \
    "What turns slopes into a bump: vertex tangents of uv0, derived from the uv, exact (keeps " \
    "stretch and skew), or guessed from a direction"
#define SCALES \
    { "surface", "unit" }
#define SCALE_DOC                                                                             \
    "surface: slopes are lengths of object space per uv unit; unit: slopes do not depend on " \
    "the size of the surface or on tiling. On a projection of the position, surface is the bump " \
    "that triplanar nodes make"
#define BASE_DOC                                                                              \
    "The normal to put the bump on: the surface's, or that of a resolve, to bump its result " \
    "further"
#define DIRECTION_DOC "Tangent of the frame `guess`, in object space, any length"
