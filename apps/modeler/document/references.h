/// @file references.h
/// Pictures to draw after, as a document remembers them.
///
/// They stand under the document's key "modeler", which every other program keeps and passes on as one it
/// does not know: so they travel with the file, are undone like everything else, and no second file can get
/// lost.
#pragma once

#include <array>
#include <string>

#include "sinew/skeleton/document.h"

namespace sinew::modeler {

/// A picture that stands in the plane across one axis.
struct Reference {
    std::string file;      ///< empty: none
    double height = 4;     ///< in the document's units
    double opacity = 0.5;  ///< 0..1
    std::array<double, 2> offset{0,
                                 0};  ///< of its middle from the origin, to the right and up as one sees it

    bool operator==(const Reference&) const = default;
};

/// By the axis one looks along: x (side), y (front), z (above).
using References = std::array<Reference, 3>;

/// What cannot be understood is left out.
References references_of(const Document& document);

/// What else is kept under the key "modeler" stays.
Document with_references(Document document, const References& references);

/// @name File names, which a file has as seen from its folder where the pictures lie there or below
/// @{
Document with_absolute_files(Document document, const std::string& folder);
Document with_relative_files(Document document, const std::string& folder);
/// @}

}  // namespace sinew::modeler
