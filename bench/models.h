/// @file models.h
/// Skeletons to measure with: made by formula, or read from the folder of real ones if it is there.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "sinew/skeleton/document.h"

namespace sinew::bench {

struct Model {
    std::string name;
    std::function<Document()> make;  ///< large ones are made only when they are measured
    bool repair = false;             ///< measured: nodes are thinned before skinning
};

/// The monopodial tree of figure 2.6a of "The Algorithmic Beauty of Plants", grown by
/// examples/lsystems/honda_a.lsys, its bones in the order of their depth, cut off at a number of nodes; 2^n
/// of them are n derivation steps.
Document monopodial_tree(std::int32_t nodes);

/// A body-centred cubic lattice of cells^3 cells of side 1: corners, centres, and a strut from each centre to
/// its eight corners.
Document bcc_lattice(int cells, double radius = 0.08);

/// The largest files of each kind under data/graph of the shared folder; none where there is no such folder.
std::vector<Model> real_models();

}  // namespace sinew::bench
