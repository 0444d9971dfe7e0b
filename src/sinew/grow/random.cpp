#include "sinew/grow/random.h"

#include <cmath>

#include "sinew/base/portable_math.h"

namespace sinew::lsystem {

double Random::normal(double mean, double deviation) {
    const double distance = std::sqrt(-2 * portable::logarithm(1 - uniform()));  // 1 - u is in (0, 1]
    return mean + deviation * distance * portable::cosine(360 * uniform());
}

}  // namespace sinew::lsystem
