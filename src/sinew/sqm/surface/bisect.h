/// @file bisect.h
/// Where along a line something ends, by halving.
#pragma once

#include <utility>

namespace sinew::sqm {

/// Halves the stretch between a value where `holds` is true and one where it is not, so many times.
/// @param inside,outside  in either order; `holds` changes between them, and is not asked about them
/// @return the two ends of what is left, 2^-halvings of the stretch: the inner one, the outer one
template <class Holds>
std::pair<double, double> bisect(double inside, double outside, int halvings, Holds holds) {
    for (int i = 0; i < halvings; ++i) {
        const double middle = 0.5 * (inside + outside);
        (holds(middle) ? inside : outside) = middle;
    }
    return {inside, outside};
}

}  // namespace sinew::sqm
