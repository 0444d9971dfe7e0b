/// @file operation.h
/// The larger changes of the library (skeleton/edit.h) as one applies them here: at once, with figures that
/// can be adjusted while one sees the outcome.
#pragma once

#include <functional>
#include <span>
#include <string>
#include <vector>

#include "document/selection.h"
#include "sinew/base/result.h"

namespace sinew::modeler {

/// One figure of an operation.
struct Parameter {
    enum class Kind : std::uint8_t { length, factor, degrees, count, choice };
    std::string name;
    std::string tip;
    Kind kind = Kind::factor;
    double value = 0;
    double least = 0, most = 0;
    std::vector<std::string> choices{};  ///< of a choice, whose value is an index
};

struct Operation {
    std::string label;  ///< of the undo step
    std::vector<Parameter> parameters;
    /// The document after it. Pure; one value a parameter.
    std::function<Result<Document>(std::span<const double> values)> run;
    /// Said where the outcome is the document as it was.
    std::string nothing;
};

std::vector<double> values_of(const Operation& operation);

/// Puts a node near each leaf that is selected (near all where none is), so that tips are blunter.
Operation consolidating(Document document, const Selection& selection);

/// All selected nodes become one, at their mean.
Operation merging(Document document, const Selection& selection);

/// Leaves that are near one another become one, pair by pair.
Operation merging_close_leaves(Document document);

/// The bones on the way to the old root turn round.
Operation rerooting(Document document, std::int32_t node);

/// Images become nodes of their own; a symmetry that the document has is made real first.
Operation mirroring(Document document);
Operation copying_round(Document document);

/// What is selected (all where nothing is) moves onto the grid, or its bones turn to round angles.
Operation snapping_to_grid(Document document, const Selection& selection);
Operation snapping_to_angles(Document document, const Selection& selection);

/// The images that the symmetry stands for become nodes; the symmetry goes.
Operation making_symmetry_real(Document document);

}  // namespace sinew::modeler
