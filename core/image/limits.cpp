#include "image/load.h"

namespace wrinkle {

ImageLimits image_limits_from_environment(Diagnostics& diagnostics) {
    report_limits(diagnostics);
    return {};
}

}  // namespace wrinkle
